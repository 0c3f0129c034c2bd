// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/bulk/bulk_matrices.h"

#include <array>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/forms/detail/checks.h"
#include "core/subdivision/bulk/detail/bulk_kernels.h"
#include "core/subdivision/detail/cuts.h"

namespace blossom {
namespace {

constexpr std::size_t kLevels = kMaxDyadicLevel + 1;
constexpr std::size_t kSizes = kMaxDegree + 1;

struct KeptStack {
  std::once_flag made;
  std::unique_ptr<const MatrixStack> stack;
};

}  // namespace

MatrixStack::MatrixStack(int degree, std::span<const double> cuts, NetForm form, SimdLevel level)
    : degree_(degree), pieces_(static_cast<int>(cuts.size()) - 1), stride_(0), form_(form) {
  detail::check_degree("MatrixStack", degree);
  detail::check_cuts("MatrixStack", "cuts", cuts);
  const int size = degree + 1, count = pieces_ * size;
  stride_ = (count + kLanes - 1) / kLanes * kLanes;
  rows_.resize(static_cast<std::size_t>(count * size));
  columns_.resize(static_cast<std::size_t>(size * stride_));
  std::array<double, kSizes * detail::kMatrixStride> transposed;
  for (int piece = 0; piece < pieces_; ++piece) {
    const std::size_t cut = static_cast<std::size_t>(piece);
    detail::kernels(level).matrix(form, degree, cuts[cut], cuts[cut + 1], transposed.data());
    for (int k = 0; k < size; ++k)
      for (int i = 0; i < size; ++i) {
        const double entry = transposed[static_cast<std::size_t>(i * detail::kMatrixStride + k)];
        const int row = piece * size + k;
        rows_[static_cast<std::size_t>(row * size + i)] = entry;
        columns_[static_cast<std::size_t>(i * stride_ + row)] = entry;
      }
  }
}

const MatrixStack& dyadic_matrices(int degree, int level, NetForm form) {
  static std::array<std::array<std::array<KeptStack, kLevels>, kSizes>, 2> kept;
  detail::check_degree("dyadic_matrices", degree);
  if (level < 0 || level > kMaxDyadicLevel)
    throw InvalidInput("dyadic_matrices: the level must be 0.." + std::to_string(kMaxDyadicLevel) +
                       ", got " + std::to_string(level));
  KeptStack& place = kept[form == NetForm::Bezier ? 0 : 1][static_cast<std::size_t>(degree)]
                         [static_cast<std::size_t>(level)];
  std::call_once(place.made, [&] {
    std::vector<double> cuts;
    const int pieces = 1 << level;
    for (int k = 0; k <= pieces; ++k) cuts.push_back(static_cast<double>(k) / pieces);
    place.stack = std::make_unique<const MatrixStack>(degree, cuts, form);
  });
  return *place.stack;
}

}  // namespace blossom
