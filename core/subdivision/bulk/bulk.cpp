// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/bulk/bulk.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/forms/detail/checks.h"
#include "core/subdivision/bulk/detail/bulk_checks.h"
#include "core/subdivision/bulk/detail/bulk_kernels.h"

namespace blossom {
namespace {

using detail::check_count;
using detail::check_finite;

detail::StackView view(const MatrixStack& stack) {
  return {stack.degree() + 1, stack.pieces(), stack.rows().data(), stack.columns().data(),
          stack.stride()};
}

void check_stack(const char* function, const char* name, const MatrixStack& stack, int size,
                 NetForm form) {
  if (stack.degree() == size - 1 && stack.form() == form) return;
  const std::string place = std::string(function) + ": the matrices of " + name;
  if (stack.form() != form) throw InvalidInput(place + " are for another form than those of u");
  throw InvalidInput(place + " must be of degree " + std::to_string(size - 1) + ", got " +
                     std::to_string(stack.degree()));
}

std::size_t check_ends(const char* function, const PieceEnds& ends) {
  const std::size_t count = ends.u_from.size();
  if (count % kLanes != 0)
    throw InvalidInput(std::string(function) + ": the number of pieces must be a multiple of " +
                       std::to_string(kLanes) + ", got " + std::to_string(count));
  check_count(function, "u_to", ends.u_to.size(), count);
  check_count(function, "v_from", ends.v_from.size(), count);
  check_count(function, "v_to", ends.v_to.size(), count);
  check_finite(function, "u_from", ends.u_from);
  check_finite(function, "u_to", ends.u_to);
  check_finite(function, "v_from", ends.v_from);
  check_finite(function, "v_to", ends.v_to);
  return count / kLanes;
}

// One net for all, or one block of nets for each block of pieces.
detail::LaneNets check_nets(const char* function, const NetShape& shape, std::size_t count,
                            std::size_t blocks) {
  if (count == static_cast<std::size_t>(shape.size())) return detail::LaneNets::Shared;
  check_count(function, "nets", count, blocks * block_size(shape));
  return detail::LaneNets::Blocks;
}

// The ends of the blocks of pieces from a block on.
detail::EndsView view(const PieceEnds& ends, std::size_t block = 0) {
  const std::size_t from = block * kLanes;
  return {ends.u_from.data() + from, ends.u_to.data() + from, ends.v_from.data() + from,
          ends.v_to.data() + from};
}

// The farthest reach of the kLanes pieces of a block.
double farthest_reach(const double* from, const double* to) {
  double reach = 0;
  for (int lane = 0; lane < kLanes; ++lane)
    reach = std::max(reach, pyramid_reach({from[lane], to[lane]}));
  return reach;
}

PiecePath block_path(const NetShape& shape, const NetSizes& sizes, const PieceEnds& ends,
                     std::size_t block, double tolerance) {
  const detail::EndsView of_block = view(ends, block);
  return piece_path(shape.rows - 1, shape.columns - 1, sizes,
                    farthest_reach(of_block.u_from, of_block.u_to),
                    farthest_reach(of_block.v_from, of_block.v_to), tolerance);
}

}  // namespace

void subdivide_grid(const NetShape& shape, std::span<const double> net, const MatrixStack& u,
                    const MatrixStack& v, std::span<double> sheet, SimdLevel level) {
  const char* const name = "subdivide_grid";
  detail::check_shape(name, shape);
  check_stack(name, "u", u, shape.rows, u.form());
  check_stack(name, "v", v, shape.columns, u.form());
  check_count(name, "net", net.size(), static_cast<std::size_t>(shape.size()));
  check_count(name, "sheet", sheet.size(), SheetShape{shape, u.pieces(), v.pieces()}.size());
  detail::kernels(level).grid(shape, net.data(), view(u), view(v), sheet.data());
}

void subdivide_blocks(const NetShape& shape, std::span<const double> nets, const MatrixStack& u,
                      const MatrixStack& v, std::span<double> sheets, SimdLevel level) {
  const char* const name = "subdivide_blocks";
  detail::check_shape(name, shape);
  check_stack(name, "u", u, shape.rows, u.form());
  check_stack(name, "v", v, shape.columns, u.form());
  const std::size_t blocks = nets.size() / block_size(shape);
  check_count(name, "nets", nets.size(), blocks * block_size(shape));
  check_count(name, "sheets", sheets.size(),
              nets.size() * static_cast<std::size_t>(u.pieces() * v.pieces()));
  detail::kernels(level).grid_of_blocks(shape, nets.data(), static_cast<int>(blocks), view(u),
                                        view(v), sheets.data());
}

void subdivide_pieces(NetForm form, const NetShape& shape, std::span<const double> nets,
                      const PieceEnds& ends, std::span<double> out, SimdLevel level) {
  const char* const name = "subdivide_pieces";
  detail::check_shape(name, shape);
  const std::size_t blocks = check_ends(name, ends);
  const detail::LaneNets source = check_nets(name, shape, nets.size(), blocks);
  check_count(name, "out", out.size(), blocks * block_size(shape));
  detail::kernels(level).pieces(form, source, shape, nets.data(), view(ends),
                                static_cast<int>(blocks), out.data());
}

void subdivide_pieces_by_pyramid(const NetShape& shape, std::span<const double> coefficients,
                                 const PieceEnds& ends, std::span<double> out, SimdLevel level) {
  const char* const name = "subdivide_pieces_by_pyramid";
  detail::check_shape(name, shape);
  const std::size_t blocks = check_ends(name, ends);
  const detail::LaneNets source = check_nets(name, shape, coefficients.size(), blocks);
  check_count(name, "out", out.size(), blocks * block_size(shape));
  detail::kernels(level).pyramid(source, shape, coefficients.data(), view(ends),
                                 static_cast<int>(blocks), out.data());
}

void subdivide_pieces_within(double tolerance, const NetShape& shape, const BothForms& net,
                             const PieceEnds& ends, std::span<double> out, SimdLevel level) {
  const char* const name = "subdivide_pieces_within";
  detail::check_shape(name, shape);
  const std::size_t blocks = check_ends(name, ends);
  if (!(tolerance >= 0))
    throw InvalidInput(std::string(name) + ": the tolerance must be 0 or above");
  check_count(name, "bezier", net.bezier.size(), static_cast<std::size_t>(shape.size()));
  check_count(name, "coefficients", net.coefficients.size(), net.bezier.size());
  check_count(name, "out", out.size(), blocks * block_size(shape));
  // Runs of blocks on one path go together: what a kernel prepares for a net, it prepares once.
  std::size_t first = 0;
  PiecePath path{};
  const auto cut_until = [&](std::size_t end) {
    const detail::EndsView run = view(ends, first);
    const int count = static_cast<int>(end - first);
    double* const to = out.data() + first * block_size(shape);
    const detail::BulkKernels& kernels = detail::kernels(level);
    if (path == PiecePath::MonomialPyramid)
      kernels.pyramid(detail::LaneNets::Shared, shape, net.coefficients.data(), run, count, to);
    else
      kernels.pieces(NetForm::Bezier, detail::LaneNets::Shared, shape, net.bezier.data(), run,
                     count, to);
    first = end;
  };
  for (std::size_t block = 0; block < blocks; ++block) {
    const PiecePath wanted = block_path(shape, net.sizes, ends, block, tolerance);
    if (block > first && wanted != path) cut_until(block);
    path = wanted;
  }
  if (first < blocks) cut_until(blocks);
}

void subdivide_piece(NetForm form, const NetShape& shape, std::span<const double> net,
                     const Interval& u, const Interval& v, std::span<double> out, SimdLevel level) {
  const char* const name = "subdivide_piece";
  detail::check_shape(name, shape);
  detail::check_interval(name, "in u", u);
  detail::check_interval(name, "in v", v);
  check_count(name, "net", net.size(), static_cast<std::size_t>(shape.size()));
  check_count(name, "out", out.size(), static_cast<std::size_t>(shape.size()));
  detail::kernels(level).piece(form, shape, net.data(), u, v, out.data());
}

NetSizes net_sizes(const NetShape& shape, std::span<const double> bezier,
                   std::span<const double> coefficients) {
  const char* const name = "net_sizes";
  detail::check_shape(name, shape);
  check_count(name, "bezier", bezier.size(), static_cast<std::size_t>(shape.size()));
  check_count(name, "coefficients", coefficients.size(), static_cast<std::size_t>(shape.size()));
  NetSizes sizes;
  for (double value : bezier) sizes.largest = std::max(sizes.largest, std::abs(value));
  const std::size_t plane = static_cast<std::size_t>(shape.plane_size());
  for (std::size_t from = 0; from < coefficients.size(); from += plane) {
    double sum = 0;
    for (double value : coefficients.subspan(from, plane)) sum += std::abs(value);
    sizes.sum = std::max(sizes.sum, sum);
  }
  sizes.conversion = monomial_from_bezier_error(shape.rows - 1, shape.columns - 1) * sizes.largest;
  return sizes;
}

}  // namespace blossom
