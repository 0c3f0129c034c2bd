// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/depth.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <queue>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/queries/feet_on_face.h"
#include "adapters/occt/queries/solid_rays.h"
#include "core/base/unbounded.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom::occt {
namespace {

constexpr double kNotKnown = kInfinity;
constexpr double kAddedPart = 0.1;
constexpr int kWireHalvings = 20;   // as deep as cells of a patch go within kDepthCells
constexpr long kProofPairs = 1000;  // of cells; halving the cell is cheaper than more of them

struct DepthPiece {
  TopoDS_Face face;
  BezierSurface surface;
  FaceTrims trims;
  std::optional<double> upper{};  // no point of it lies deeper, once that was asked for
};

// A rectangle of a patch, in its local parameters.
struct DepthCell {
  DepthPiece* piece = nullptr;
  int i = 0, j = 0;
  Interval u{0, 1}, v{0, 1};
  double upper = 0;  // no point of it lies deeper, model units

  bool operator<(const DepthCell& other) const { return upper < other.upper; }
};

Interval own_range(ParameterLaw law, const std::vector<double>& knots, int span,
                   const Interval& local) {
  const auto k = static_cast<std::size_t>(span);
  const Interval of{knots[k], knots[k + 1]};
  return {parameter_at(law, of, local.from), parameter_at(law, of, local.to)};
}

// The control points of a cell with their weights, and what follows from them.
struct CellNet {
  RationalBezierPatch patch;
  Vec3 middle;        // a point of the surface
  double radius = 0;  // of the ball round it that holds the cell
  double width_u = 0, width_v = 0;

  explicit CellNet(const DepthCell& cell)
      : patch(sub_patch(cell.piece->surface.patches(cell.i, cell.j), cell.u, cell.v)) {
    const RationalBezierPatch point = sub_patch(patch, {0.5, 0.5}, {0.5, 0.5});
    middle = projected(point.points(0, 0));
    const auto at = [&](int i, int j) { return projected(patch.points(i, j)); };
    for (int i = 0; i < patch.points.rows(); ++i)
      for (int j = 0; j < patch.points.columns(); ++j) {
        radius = std::max(radius, distance(middle, at(i, j)));
        if (i > 0) width_u = std::max(width_u, patch.degree_u() * distance(at(i, j), at(i - 1, j)));
        if (j > 0) width_v = std::max(width_v, patch.degree_v() * distance(at(i, j), at(i, j - 1)));
      }
  }

  DistanceOperand moved(const Vec3& by) const {
    BezierSurface surface;
    surface.u_knots = surface.v_knots = {0, 1};
    surface.patches = Grid<RationalBezierPatch>(1, 1);
    surface.patches(0, 0) = patch;
    for (Vec4& p : surface.patches(0, 0).points.values()) {
      surface.rational = surface.rational || p[3] != 1;
      for (int k = 0; k < 3; ++k) p[k] += p[3] * by[k];
    }
    return measured(surface);
  }
};

class DepthSearch {
 public:
  DepthSearch(const std::vector<TopoDS_Face>& faces, const MeasuredShape& boundary,
              double tolerance, double known)
      : boundary_(boundary),
        rays_(boundary.faces(), tolerance),
        tolerance_(tolerance),
        best_(known) {
    for (const TopoDS_Face& face : boundary.faces()) {
      boundary_faces_.push_back(face);
      TopExp::MapShapes(face, parts_.emplace_back());
    }
    for (const TopoDS_Face& face : faces) {
      pieces_.push_back({face, bezier_surface(face, tolerance), face_trims(face)});
      error_ = std::max(error_, pieces_.back().surface.error);
    }
  }

  Depth found(const std::function<bool()>& stop) {
    for (DepthPiece& piece : pieces_)
      for (int i = 0; i < piece.surface.patches.rows(); ++i)
        for (int j = 0; j < piece.surface.patches.columns(); ++j) enter({&piece, i, j});
    for (int count = 0; !cells_.empty() && count < kDepthCells && !(stop && stop()); count += 2) {
      const DepthCell cell = cells_.top();
      if (cell.upper <= goal()) break;
      cells_.pop();
      const double upper = upper_of(*cell.piece);
      if (upper <= goal())
        done_ = std::max(done_, std::min(upper, cell.upper));
      else
        halve(cell);
    }
    const double upper = std::max(done_, cells_.empty() ? 0.0 : cells_.top().upper);
    return {std::max(0.0, best_ - error_), std::max(upper, best_) + error_, deepest_};
  }

 private:
  double goal() const { return best_ * (1 + kDepthAccuracy) + tolerance_; }

  void halve(const DepthCell& cell) {
    const CellNet net(cell);
    DepthCell first = cell, second = cell;
    const bool along_u = net.width_u >= net.width_v;
    const Interval& of = along_u ? cell.u : cell.v;
    const double middle = 0.5 * (of.from + of.to);
    (along_u ? first.u : first.v).to = middle;
    (along_u ? second.u : second.v).from = middle;
    enter(first);
    enter(second);
  }

  PartSide side(const DepthCell& cell, const Interval& u, const Interval& v) const {
    const BezierSurface& surface = cell.piece->surface;
    const FaceTrims& trims = cell.piece->trims;
    const Interval on_u = own_range(surface.u_law, surface.u_knots, cell.i, u),
                   on_v = own_range(surface.v_law, surface.v_knots, cell.j, v);
    const PartSide place = part_side(trims, on_u, on_v);
    if (place != PartSide::Mixed || trims.period[0] > 0 || trims.period[1] > 0) return place;
    return fine_side(trims, {{on_u.from * trims.scale[0], on_v.from * trims.scale[1]},
                             {on_u.to * trims.scale[0], on_v.to * trims.scale[1]}});
  }

  // `part_side` halves wires as often for small cells as for large ones: these would stay as they
  // are, however small, in the boxes of pieces that run aslant.
  static PartSide fine_side(const FaceTrims& trims, const PlanarBox& box) {
    if (coedge_near(trims, box, kOnWire + trims.largest_gap, kWireHalvings) != nullptr)
      return PartSide::Mixed;
    return is_inside(trims, 0.5 * (box.low + box.high)) ? PartSide::Inside : PartSide::Outside;
  }

  // Takes a cell among those that may hold the deepest point, unless it does not.
  void enter(DepthCell cell) {
    const PartSide place = side(cell, cell.u, cell.v);
    if (place == PartSide::Outside) return;
    const CellNet net(cell);
    const ShapeDistance near =
        nearest_point(boundary_, net.middle, {.resolution = 0.1 * kDepthAccuracy * best_});
    const double u = 0.5 * (cell.u.from + cell.u.to), v = 0.5 * (cell.v.from + cell.v.to);
    if (near.lower > best_ && side(cell, {u, u}, {v, v}) != PartSide::Outside) {
      best_ = near.lower;
      deepest_ = net.middle;
    }
    cell.upper = near.upper + net.radius;
    if (cell.upper > goal()) cell.upper = std::min(cell.upper, to_one_face(net, near.b.on));
    if (cell.upper > goal() && place == PartSide::Inside)  // others are halved anyway
      cell.upper = std::min(cell.upper, way_out(net, near));
    if (cell.upper > goal())
      cells_.push(cell);
    else
      done_ = std::max(done_, cell.upper);
  }

  // Of a piece in a plane, from one of the faces next to a point of it.
  double upper_of(DepthPiece& piece) {
    if (piece.upper) return *piece.upper;
    double& least = piece.upper.emplace(kNotKnown);
    const std::optional<gp_Pnt> point = point_inside(piece.face);
    if (!point) return least;
    const Vec3 place{point->X(), point->Y(), point->Z()};
    const TopoDS_Shape nearest = nearest_point(boundary_, place).b.on;
    for (std::size_t i = 0; i < boundary_faces_.size(); ++i)
      if (parts_[i].Contains(nearest))
        if (const auto bound = feet_on(i).farthest_in_plane(piece.face, piece.trims, within()))
          least = std::min(least, *bound);
    return least;
  }

  const FeetOnFace& feet_on(std::size_t face) {
    return feet_.try_emplace(face, boundary_faces_[face]).first->second;
  }

  double within() const { return std::max(tolerance_, 0.1 * kDepthAccuracy * best_); }

  // The largest distance of the cell from one of the faces that have the middle's nearest point;
  // infinite if no bound is known.
  double to_one_face(const CellNet& net, const TopoDS_Shape& nearest) {
    double least = kNotKnown;
    for (std::size_t i = 0; i < boundary_faces_.size(); ++i) {
      if (!parts_[i].Contains(nearest)) continue;
      if (const std::optional<double> bound = feet_on(i).farthest(net.patch, within()))
        least = std::min(least, *bound);
    }
    return least;
  }

  // The length of a way on which all of the cell leaves the body; infinite if none is proven.
  double way_out(const CellNet& net, const ShapeDistance& near) {
    const Vec3 way = near.b.point - net.middle;
    const double length = norm(way);
    if (!(length > tolerance_)) return kNotKnown;
    const double s = std::max(goal(), length * (1 + 0.5 * kDepthAccuracy));
    if (s >= near.upper + net.radius) return kNotKnown;
    const Vec3 by = way * (s / length);
    const std::optional<bool> inside = rays_.is_inside(net.middle + by);
    if (!inside || *inside) return kNotKnown;
    // What comes nearer than a part of the way that is added is not worth a longer proof.
    const double enough = kAddedPart * (s - length) + boundary_.error();
    const DistanceResult apart = least_distance(PreparedSet(net.moved(by)), boundary_.set(),
                                                {.budget = kProofPairs, .enough = enough});
    return apart.lower > enough ? s : kNotKnown;
  }

  const MeasuredShape& boundary_;
  SolidRays rays_;
  double tolerance_;
  std::vector<DepthPiece> pieces_{};
  std::vector<TopoDS_Face> boundary_faces_{};
  std::deque<TopTools_IndexedMapOfShape> parts_{};  // of each of these
  std::map<std::size_t, FeetOnFace> feet_{};        // likewise, once asked for
  double error_ = 0;                                // of approximated pieces
  std::priority_queue<DepthCell> cells_{};
  double best_, done_ = 0;
  Vec3 deepest_;
};

}  // namespace

Depth depth_of(const std::vector<TopoDS_Face>& pieces, const MeasuredShape& boundary,
               double tolerance, double known, const std::function<bool()>& stop) {
  return guarded("measuring how deep a body lies in another one", [&] {
    DepthSearch search(pieces, boundary, tolerance, known);
    return search.found(stop);
  });
}

}  // namespace blossom::occt
