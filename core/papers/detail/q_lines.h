// SPDX-License-Identifier: LGPL-2.1-or-later
// A function of lines of points, applied to all rows or all columns of a net.

#pragma once

#include <vector>

#include "core/math/detail/bernstein.h"
#include "core/math/grid.h"

namespace blossom::detail {

template <class Point>
std::vector<Point> row(const Grid<Point>& net, int i) {
  std::vector<Point> line;
  for (int j = 0; j < net.columns(); ++j) line.push_back(net(i, j));
  return line;
}

template <class Point>
std::vector<Point> column(const Grid<Point>& net, int j) {
  std::vector<Point> line;
  for (int i = 0; i < net.rows(); ++i) line.push_back(net(i, j));
  return line;
}

/// convert: n + 1 points -> n + 1 points, for each column.
template <class Point, class Function>
Grid<Point> along_u(const Grid<Point>& net, Function convert) {
  Grid<Point> result(net.rows(), net.columns());
  for (int j = 0; j < net.columns(); ++j) {
    const std::vector<Point> line = convert(column(net, j));
    for (int i = 0; i < net.rows(); ++i) result(i, j) = line[index(i)];
  }
  return result;
}

/// convert: m + 1 points -> m + 1 points, for each row.
template <class Point, class Function>
Grid<Point> along_v(const Grid<Point>& net, Function convert) {
  Grid<Point> result(net.rows(), net.columns());
  for (int i = 0; i < net.rows(); ++i) {
    const std::vector<Point> line = convert(row(net, i));
    for (int j = 0; j < net.columns(); ++j) result(i, j) = line[index(j)];
  }
  return result;
}

/// fold: m + 1 points -> one point, for each row.
template <class Point, class Function>
std::vector<Point> fold_rows(const Grid<Point>& net, Function fold) {
  std::vector<Point> result;
  for (int i = 0; i < net.rows(); ++i) result.push_back(fold(row(net, i)));
  return result;
}

}  // namespace blossom::detail
