// SPDX-License-Identifier: LGPL-2.1-or-later
// Storage for values that are worked on in full vectors.

#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace blossom {

/// Pieces or patches that bulk subdivision takes side by side.
inline constexpr int kLanes = 8;

/// Allocates at multiples of a cache line, so that no vector lies across two. Bulk subdivision
/// takes any storage; results in lines of their own are written twice as fast.
template <class T>
struct LaneAllocator {
  using value_type = T;
  static constexpr std::align_val_t kLine{64};

  LaneAllocator() = default;
  template <class U>
  LaneAllocator(const LaneAllocator<U>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), kLine));
  }
  void deallocate(T* place, std::size_t) { ::operator delete(place, kLine); }
  friend bool operator==(const LaneAllocator&, const LaneAllocator&) { return true; }
};

using LaneVector = std::vector<double, LaneAllocator<double>>;

}  // namespace blossom
