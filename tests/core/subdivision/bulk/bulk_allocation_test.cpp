// SPDX-License-Identifier: LGPL-2.1-or-later
// Bulk subdivision does not allocate: counted by the program's own operator new, which
// ThreadSanitizer of clang has, too, and does not give up.

#include "core/base/sanitizers.h"
#if !defined(BLOSSOM_THREAD_SANITIZER)

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/subdivision/bulk/bulk.h"
#include "core/subdivision/bulk/bulk_triangles.h"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  // aligned_alloc wants a multiple of the alignment.
  void* place = std::aligned_alloc(alignment, (size + alignment) / alignment * alignment);
  if (place == nullptr) throw std::bad_alloc();
  return place;
}
}  // namespace

// Not in line: GCC would see one of a pair without the other, and warn of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* place) noexcept { std::free(place); }
[[gnu::noinline]] void operator delete(void* place, std::size_t) noexcept { std::free(place); }
[[gnu::noinline]] void operator delete(void* place, std::align_val_t) noexcept { std::free(place); }
[[gnu::noinline]] void operator delete(void* place, std::size_t, std::align_val_t) noexcept {
  std::free(place);
}

namespace blossom {
namespace {

class BulkAllocation : public ::testing::TestWithParam<int> {};

TEST_P(BulkAllocation, NoneWhileCutting) {
  const int degree = GetParam();
  const NetShape shape{degree + 1, degree + 1, 3};
  const MatrixStack& stack = dyadic_matrices(degree, 2);
  const TrianglePlan plan(degree, degree);
  const LaneVector net(static_cast<std::size_t>(shape.size()), 1), nets(block_size(shape), 1);
  const LaneVector from(kLanes, 0.25), to(kLanes, 0.5);
  const PieceEnds ends{from, to, from, to};
  const TriangleLists triangles{from, from, to, from, from, to};
  LaneVector sheet(SheetShape{shape, 4, 4}.size()), sheets(16 * nets.size()), pieces(nets.size()),
      piece(net.size()), points(static_cast<std::size_t>(3 * plan.points() * kLanes));

  const long before = allocations;
  subdivide_grid(shape, net, stack, stack, sheet);
  subdivide_blocks(shape, nets, stack, stack, sheets);
  subdivide_pieces(NetForm::Bezier, shape, net, ends, pieces);
  subdivide_pieces_by_pyramid(shape, net, ends, pieces);
  subdivide_pieces_within(1, shape, {net, net, {1, 1, 0}}, ends, pieces);
  subdivide_piece(NetForm::Bezier, shape, net, {0.25, 0.5}, {0.25, 0.5}, piece);
  subdivide_triangles(NetForm::Bezier, plan, 3, net, triangles, points);
  subdivide_triangles_by_differences(plan, 3, net, triangles, points);
  const long after = allocations;

  EXPECT_EQ(after - before, 0);
  EXPECT_GT(before, 0);  // the counter is the one in use
}

INSTANTIATE_TEST_SUITE_P(Degrees, BulkAllocation, ::testing::Values(1, 3, 5, 9, 12, 25));

}  // namespace
}  // namespace blossom

#endif
