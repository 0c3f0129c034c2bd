// SPDX-License-Identifier: LGPL-2.1-or-later
// A dense rectangular array, stored by rows.

#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(int rows, int columns, const T& value = T{})
      : rows_(rows),
        columns_(columns),
        values_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns), value) {}

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  bool empty() const { return values_.empty(); }

  T& operator()(int row, int column) { return values_[index(row, column)]; }
  const T& operator()(int row, int column) const { return values_[index(row, column)]; }

  /// All values, row after row.
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }

  friend bool operator==(const Grid&, const Grid&) = default;

 private:
  std::size_t index(int row, int column) const {
    assert(0 <= row && row < rows_ && 0 <= column && column < columns_);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int rows_ = 0;
  int columns_ = 0;
  std::vector<T> values_;
};

/// The values of a row.
template <class T>
std::span<T> row_of(Grid<T>& grid, int row) {
  const auto width = static_cast<std::size_t>(grid.columns());
  return grid.values().subspan(static_cast<std::size_t>(row) * width, width);
}
template <class T>
std::span<const T> row_of(const Grid<T>& grid, int row) {
  const auto width = static_cast<std::size_t>(grid.columns());
  return grid.values().subspan(static_cast<std::size_t>(row) * width, width);
}

}  // namespace blossom
