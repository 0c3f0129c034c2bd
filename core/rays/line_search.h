// SPDX-License-Identifier: LGPL-2.1-or-later
// All points that a line has in common with a cell of a surface.
//
// A line is two planes: f = a . (X - w o) and g = b . (X - w o) vanish, with a and b across the
// line and (X, w) the homogeneous surface. Both are Bernstein forms in two variables. A piece is
// left out when f or g has one sign on its net, settled when its Jacobian proves that there is at
// most one root, and halved otherwise; what is left at the size of the tolerance is a contact.
// Source: Krawczyk 1969 for the proof, Sederberg and Nishita 1990 for the two planes.

#pragma once

#include <array>
#include <vector>

#include "core/forms/evaluation.h"
#include "core/rays/flat_cell.h"
#include "core/rays/flat_cells.h"
#include "core/rays/ray.h"
#include "core/rays/two_forms.h"

namespace blossom {

/// Pieces of one cell that are looked at before the rest is reported as Status::Stopped.
inline constexpr int kPieceBudget = 4096;

class LineSearch {
 public:
  /// cells      live as long as this
  /// tolerance  distance that counts as meeting, model units
  LineSearch(const FlatCells& cells, double tolerance);

  /// Prepares for a ray; its parameters' limits are not looked at.
  void aim(const Ray& ray);

  /// Appends what the line hits in a cell. A root on a border is found from both sides.
  void examine(const FlatCell& cell, std::vector<RayHit>& hits);

 private:
  /// Nets in the stack; three more serve as scratch. 80 halvings in each direction.
  static constexpr int kPlaces = 160;

  // A rectangle of the cell; its net is that of its place in the stack.
  struct Piece {
    Interval u, v;
    int depth = 0;
  };
  // A piece, or the whole cell, on which the Jacobian is known.
  struct Region {
    Interval u, v;
    Matrix2 spread{};
    Vec2 rounding;                // of the values below, in the region's own parameters
    Vec2 slack;                   // how far outside of it a root still belongs to it, likewise
    const double* net = nullptr;  // of a piece; null for the cell
    Matrix2 inverse{};            // takes values of the net to parameters of the piece
  };
  enum class Verdict { Empty, Root, Open };

  struct Guess {
    Vec2 root;
    bool excluded = false;
    bool contracts = false;
    Region region;
  };
  Guess guess(const FlatCell& cell) const;
  static double clamped_slack(double tolerance, double rounding);

  Verdict settle(const Region& region, const Vec2& start, std::vector<RayHit>& hits);
  Vec2 offset_at(const Region& region, const Vec2& local) const;

  struct Newton {
    bool converged = false;
    Vec2 local;
    Vec3 point;
    PatchJet jet;
  };
  Newton newton(const Region& region, const Vec2& start) const;

  // In line_pieces.cpp: the search by halving.
  enum class Next { Done, Contact, Stop, HalveU, HalveV };

  void search(std::vector<RayHit>& hits);
  void halve(const Piece& piece, int place, bool along_u);
  void load_net();
  void load_heights(const Vec3& direction, double* plane) const;
  void restrict_net(double* net, const Interval& u, const Interval& v);
  Next look_at(const Piece& piece, const double* net, std::vector<RayHit>& hits);
  Guess guess(const Piece& piece, const double* net, const TwoForms& forms) const;
  bool add_hit(const Newton& root, std::vector<RayHit>& hits) const;
  void add_contact(const Piece& piece, Status status, std::vector<RayHit>& hits);
  Interval stretch_of(const Piece& piece);
  Interval clipped(const Piece& piece, Interval stretch) const;
  Vec2 foot(const Piece& piece, const PatchJet& centre, double parameter) const;
  bool runs_along(const Piece& piece, double height) const;
  double extent(const Piece& piece) const;
  double* net_at(int place) { return nets_.data() + place * net_size_; }
  const PlacedPatch& placed() const {
    return cells_.patches()[static_cast<std::size_t>(cell_->patch)];
  }

  const FlatCells& cells_;
  double tolerance_;
  Ray ray_;
  double square_ = 1;           // of the direction
  double direction_scale_ = 1;  // largest absolute coordinate of the direction

  // The cell under examination.
  const FlatCell* cell_ = nullptr;
  const RationalBezierPatch* patch_ = nullptr;
  Vec3 anchor_;                 // a point of the line near the cell
  std::array<Vec3, 2> across_;  // a and b
  double margin_ = 0;           // of a value of the nets, at the top of the search
  double net_scale_ = 0;        // largest absolute value in the cell
  int rows_ = 0, columns_ = 0, net_size_ = 0;

  std::vector<double> nets_;
  std::vector<Piece> stack_;
};

}  // namespace blossom
