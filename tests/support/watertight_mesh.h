// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangle meshes of watertight pieces: each side is sampled once, by its curve, for all its
// pieces.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include "core/forms/algebra/de_casteljau.h"
#include "core/watertight/watertight.h"

namespace blossom::testing {

struct Mesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> piece;  // of each triangle, where they come from pieces

  void add(int a, int b, int c) {
    if (a != b && b != c && c != a) triangles.push_back({a, b, c});
  }
};

/// Samples pieces at some points along each side, and inside as at the finest of their sides. Where
/// another side has fewer, points along it fall together.
class WatertightSampler {
 public:
  /// reversed   for each face of the model, whether its pieces face the other way
  /// parts      of the sides of each piece at least; powers of two times one number
  WatertightSampler(const WatertightPieces& pieces, const std::vector<bool>& reversed,
                    const std::vector<int>& parts)
      : made_(pieces), parts_of_side_(pieces.sides.size(), 1) {
    for (std::size_t p = 0; p < made_.pieces.size(); ++p)
      for (const int side : made_.pieces[p].sides) {
        int& own = parts_of_side_[static_cast<std::size_t>(side)];
        own = std::max(own, parts[p]);
      }
    mesh_.points = made_.vertices;
    for (std::size_t s = 0; s < made_.sides.size(); ++s) {
      const WatertightSide& side = made_.sides[s];
      first_of_side_.push_back(static_cast<int>(mesh_.points.size()));
      for (int k = 1; k < parts_of_side_[s] && !side.curve.points.empty(); ++k)
        mesh_.points.push_back(point_at(side.curve, static_cast<double>(k) / parts_of_side_[s]));
    }
    for (const WatertightPiece& piece : made_.pieces) {
      reversed_ = reversed[static_cast<std::size_t>(piece.face)];
      parts_ = 1;
      for (const int side : piece.sides)
        parts_ = std::max(parts_, parts_of_side_[static_cast<std::size_t>(side)]);
      if (const auto* triangle = std::get_if<BezierTriangle>(&piece.form))
        add(piece, *triangle);
      else
        add(piece, std::get<BezierPatch>(piece.form));
      mesh_.piece.resize(mesh_.triangles.size(), static_cast<int>(&piece - made_.pieces.data()));
    }
  }

  /// The same number of parts everywhere.
  WatertightSampler(const WatertightPieces& pieces, const std::vector<bool>& reversed, int parts)
      : WatertightSampler(pieces, reversed, std::vector<int>(pieces.pieces.size(), parts)) {}

  const Mesh& mesh() const { return mesh_; }

 private:
  // Sample k of a side as the piece walks it.
  int on_side(const WatertightPiece& piece, std::size_t side, int k) const {
    const std::size_t next = (side + 1) % piece.vertices.size();
    if (k == 0) return piece.vertices[side];
    if (k == parts_) return piece.vertices[next];
    const auto number = static_cast<std::size_t>(piece.sides[side]);
    if (made_.sides[number].curve.points.empty()) return piece.vertices[side];
    const int own = parts_of_side_[number], step = parts_ / own;
    const int along = (piece.along[side] ? k : parts_ - k) / step;
    if (along == 0) return piece.vertices[piece.along[side] ? side : next];
    return first_of_side_[number] + along - 1;
  }

  void add(int a, int b, int c) { reversed_ ? mesh_.add(a, c, b) : mesh_.add(a, b, c); }

  int inside(const Vec3& p) {
    mesh_.points.push_back(p);
    return static_cast<int>(mesh_.points.size()) - 1;
  }

  void add(const WatertightPiece& piece, const BezierTriangle& triangle) {
    std::map<std::pair<int, int>, int> at;  // by the shares of a and b
    for (int i = 0; i <= parts_; ++i)
      for (int j = 0; i + j <= parts_; ++j) {
        const int k = parts_ - i - j;
        at[{i, j}] = k == 0   ? on_side(piece, 0, j)
                     : i == 0 ? on_side(piece, 1, k)
                     : j == 0 ? on_side(piece, 2, i)
                              : inside(point_at(triangle, static_cast<double>(i) / parts_,
                                                static_cast<double>(j) / parts_));
      }
    // Facets at a corner would hide samples inside where its sides have fewer than the piece; there
    // they are flipped with those behind them.
    const bool a = has_coarse_corner(piece, 0), b = has_coarse_corner(piece, 1);
    const bool c = has_coarse_corner(piece, 2);
    const auto corner_at = [&](int i, int j) {
      return (a && i == parts_ - 1) || (b && j == parts_ - 1) || (c && i + j == 0);
    };
    const auto behind_corner = [&](int i, int j) {
      return (a && i == parts_ - 2) || (b && j == parts_ - 2) || (c && i + j == 0);
    };
    for (int i = 0; i < parts_; ++i)
      for (int j = 0; i + j < parts_; ++j) {
        if (!corner_at(i, j)) add(at[{i, j}], at[{i + 1, j}], at[{i, j + 1}]);
        if (i + j + 1 < parts_ && !behind_corner(i, j))
          add(at[{i + 1, j}], at[{i + 1, j + 1}], at[{i, j + 1}]);
      }
    const auto add_corner = [this](int tip, int before, int after, int inner) {
      add(tip, inner, before);
      add(tip, after, inner);
    };
    const int p = parts_;
    if (a) add_corner(at[{p, 0}], at[{p - 1, 0}], at[{p - 1, 1}], at[{p - 2, 1}]);
    if (b) add_corner(at[{0, p}], at[{1, p - 1}], at[{0, p - 1}], at[{1, p - 2}]);
    if (c) add_corner(at[{0, 0}], at[{0, 1}], at[{1, 0}], at[{1, 1}]);
  }

  // Whether a side at a corner has fewer samples than the piece, which has some inside.
  bool has_coarse_corner(const WatertightPiece& piece, std::size_t corner) const {
    const std::size_t count = piece.sides.size();
    const auto is_coarse = [&](std::size_t side) {
      return parts_of_side_[static_cast<std::size_t>(piece.sides[side])] < parts_;
    };
    return parts_ > 2 && (is_coarse(corner) || is_coarse((corner + count - 1) % count));
  }

  void add(const WatertightPiece& piece, const BezierPatch& patch) {
    Grid<int> at(parts_ + 1, parts_ + 1);
    for (int i = 0; i <= parts_; ++i)
      for (int j = 0; j <= parts_; ++j)
        at(i, j) = j == 0        ? on_side(piece, 0, i)
                   : i == parts_ ? on_side(piece, 1, j)
                   : j == parts_ ? on_side(piece, 2, parts_ - i)
                   : i == 0      ? on_side(piece, 3, parts_ - j)
                                 : inside(point_at(patch, static_cast<double>(i) / parts_,
                                                   static_cast<double>(j) / parts_));
    const int last = parts_ - 1;
    const bool right = has_coarse_corner(piece, 1), left = has_coarse_corner(piece, 3);
    for (int i = 0; i < parts_; ++i)
      for (int j = 0; j < parts_; ++j) {
        // Diagonals run into corners, or facets there would hide samples inside.
        if ((right && i == last && j == 0) || (left && i == 0 && j == last)) {
          add(at(i, j), at(i + 1, j), at(i, j + 1));
          add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
          continue;
        }
        add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }

  const WatertightPieces& made_;
  std::vector<int> parts_of_side_;
  int parts_ = 1;  // of the piece at hand
  bool reversed_ = false;
  std::vector<int> first_of_side_;
  Mesh mesh_;
};

}  // namespace blossom::testing
