// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/face_facets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/base/errors.h"
#include "core/math/index.h"
#include "core/math/segment.h"
#include "core/regions/delaunay/constrained_delaunay.h"
#include "core/tessellation/inner_points.h"

namespace blossom {
namespace {

using Face = ConstrainedDelaunay::Face;

// Rounds in which all curved borders are halved where they do not go round a region.
constexpr int kCoarseRounds = 5;
// In facets: points of rows that are nearer to others or to borders are left out.
constexpr double kNearPoint = 0.55;
constexpr double kNearSide = 0.4;
// Of the distance of a border from its chord: so far points are from the chord at least.
constexpr double kSagitta = 2.5;
// Of the deviation: sides are not made shorter than this to undo folds.
constexpr double kShortFold = 0.5;
// In facets: so long may borders be, where these have an aspect. Halves are not too short then.
constexpr double kLongBorder = 1.5;
// Of a side: corners that are nearer to its middle, or to a border, make a flat facet.
constexpr double kFlat = 0.05;
// Of the distance of a facet: sides that are farther than this are worth dividing.
constexpr double kLongSide = 0.4;
constexpr int kAskEvery = 4096;  // points

struct Stop {};

class FacetBuilder {
 public:
  FacetBuilder(const ModelFace& face, const ShapeModel& model,
               const std::vector<EdgePolyline>& polylines, const ChartSurface& surface,
               const FacetOptions& options, const std::set<CommonSide>& parted,
               const std::function<bool()>& ask)
      : ask_(ask),
        parted_(parted),
        surface_(surface),
        options_(options),
        polygon_(face, polylines),
        density_(surface.density(polygon_.low, polygon_.high)),
        corners_(model, polylines, surface, polygon_) {}

  FaceAttempt attempt(int round) {
    const bool last = round == kLastRound;
    if (polygon_.sides.empty()) return refused("its borders have no length");
    std::vector<EdgeSegment> far = polygon_.too_far(surface_, surface_.allowed());
    // Facets at a side that halving does not shorten would be divided for ever.
    if (last && !far.empty()) return refused("its borders have gaps on its surface");
    if (!last) {
      if (!far.empty()) return {std::move(far), {}};
      std::vector<EdgeSegment> longer = long_sides();
      if (!longer.empty()) return {std::move(longer), {}};
    }
    std::vector<Vec2> scaled_points;
    for (const Vec2& uv : polygon_.points) scaled_points.push_back(scaled(uv));
    ConstrainedDelaunay mesh(std::move(scaled_points));
    const Conflicts conflicts = fix_sides(mesh);
    if (conflicts.any)
      return last || conflicts.splits.empty() ? refused("its borders cross each other")
                                              : FaceAttempt{conflicts.splits, {}};
    if (!mesh.mark_region(windings())) {
      std::vector<EdgeSegment> curved;
      if (round < kCoarseRounds) curved = curved_sides();
      return curved.empty() ? refused("its borders do not go round a region")
                            : FaceAttempt{std::move(curved), {}};
    }
    // By the numbers of the triangulation; its far corners are nowhere.
    corners_.take_polygon(index(mesh.point_count()));
    add_rows(mesh);
    divides_borders_ = !last;
    refine(mesh, faces_inside(mesh));
    if (!far_borders_.empty()) return {std::move(far_borders_), {}};
    if (!parted_.empty()) part_sides(mesh);
    FaceAttempt made{last ? std::vector<EdgeSegment>{} : folding_sides(mesh), {}};
    if (made.splits.empty()) made.facets = collected(mesh);
    return made;
  }

 private:
  struct Conflicts {
    bool any = false;
    std::vector<EdgeSegment> splits;
  };

  static FaceAttempt refused(const char* why) {
    FaceAttempt attempt;
    attempt.facets.obstacle = why;
    return attempt;
  }

  Vec2 scaled(const Vec2& uv) const {
    return {uv[0] * density_.scale[0], uv[1] * density_.scale[1]};
  }

  Conflicts fix_sides(ConstrainedDelaunay& mesh) const {
    Conflicts conflicts;
    std::map<std::pair<int, int>, std::size_t> known;
    const auto divide = [&](const PolygonSide& side) {
      if (side.segment.edge >= 0 && !side.straight) conflicts.splits.push_back(side.segment);
    };
    for (std::size_t k = 0; k < polygon_.sides.size(); ++k) {
      const PolygonSide& side = polygon_.sides[k];
      const bool is_new = known.try_emplace({side.from, side.to}, k).second;
      std::pair<int, int> obstacle{ConstrainedDelaunay::kNone, ConstrainedDelaunay::kNone};
      if (is_new && mesh.fix(side.from, side.to, obstacle)) continue;
      conflicts.any = true;
      divide(side);
      for (const PolygonSide& other : polygon_.sides) {
        const bool at_point = obstacle.second == ConstrainedDelaunay::kNone &&
                              (other.from == obstacle.first || other.to == obstacle.first);
        const bool same = (other.from == obstacle.first && other.to == obstacle.second) ||
                          (other.to == obstacle.first && other.from == obstacle.second);
        if (at_point || same) divide(other);
      }
    }
    return conflicts;
  }

  // A hole beyond the chord of another border crosses nothing.
  std::vector<EdgeSegment> curved_sides() const {
    std::vector<EdgeSegment> curved;
    for (const PolygonSide& side : polygon_.sides)
      if (side.segment.edge >= 0 && !side.straight) curved.push_back(side.segment);
    return curved;
  }

  // Where facets have an aspect, straight borders are divided as often as the facets beside them.
  std::vector<EdgeSegment> long_sides() const {
    std::vector<EdgeSegment> splits;
    if (!(options_.aspect > 0)) return splits;
    for (const PolygonSide& side : polygon_.sides) {
      const Vec2& a = polygon_.points[index(side.from)];
      const Vec2& b = polygon_.points[index(side.to)];
      const Vec2 facets = facets_at(density_, 0.5 * (a + b));
      const Vec2 d{(b[0] - a[0]) * facets[0], (b[1] - a[1]) * facets[1]};
      if (side.segment.edge >= 0 && norm(d) > kLongBorder) splits.push_back(side.segment);
    }
    return splits;
  }

  SideWindings windings() const {
    SideWindings result;
    for (const PolygonSide& side : polygon_.sides) {
      ++result[{side.from, side.to}];
      --result[{side.to, side.from}];
    }
    return result;
  }

  int add_inner(ConstrainedDelaunay& mesh, const Vec2& uv, int face) {
    if (ask_ && ++added_ % kAskEvery == 0 && !ask_()) throw Stop{};
    corners_.add_inner(uv);
    return mesh.insert(scaled(uv), face);
  }

  void add_rows(ConstrainedDelaunay& mesh) {
    for (const Vec2& uv : points_in_rows(density_, polygon_.low, polygon_.high)) {
      const int face = mesh.locate(scaled(uv));
      if (mesh.faces()[index(face)].inside && is_clear(mesh, uv, face)) add_inner(mesh, uv, face);
    }
  }

  // Of the corners and borders of the face that it lies in.
  bool is_clear(const ConstrainedDelaunay& mesh, const Vec2& uv, int number) const {
    const Face& face = mesh.faces()[index(number)];
    const Vec2 facets = facets_at(density_, uv);
    const auto counted = [&](int corner) {
      const Vec2 d = corners_.uv(corner) - uv;
      return Vec2{d[0] * facets[0], d[1] * facets[1]};
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = face.corner[k], to = face.corner[(k + 1) % 3];
      const Vec2 a = counted(from), b = counted(to);
      if (norm(a) < kNearPoint) return false;
      if (!face.fixed[(k + 2) % 3]) continue;
      if (segment_gap(Vec2{}, a, b) < kNearSide || !is_beside(uv, from, to)) return false;
    }
    return true;
  }

  // Whether a point is farther from a border's chord than the border is: behind the chord, or
  // hardly before it, facets would fold over.
  bool is_beside(const Vec2& uv, int from, int to) const {
    const FaceCorner& a = corners_[from];
    const FaceCorner& b = corners_[to];
    const Vec3 middle = surface_.frame_at(0.5 * (a.uv + b.uv)).point;
    return segment_gap(surface_.frame_at(uv).point, a.point, b.point) >
           kSagitta * segment_gap(middle, a.point, b.point);
  }

  double distance_of(const FacetTriangle& facet) const {
    return surface_.facet_distance(corners_.parameters_of(facet), corners_.normal_at(facet));
  }

  double rough_distance(const FacetTriangle& facet) const {
    return surface_.rough_distance(corners_.parameters_of(facet), corners_.normal_at(facet));
  }

  Vec2 uv_of(const Face& face, std::size_t k) const { return corners_.uv(face.corner[k % 3]); }

  Vec2 middle_of(const Face& face) const {
    return (1.0 / 3) * (uv_of(face, 0) + uv_of(face, 1) + uv_of(face, 2));
  }

  // The middle of the side inside of the face that is farthest from the surface; or of the facet,
  // if only its borders are far. Where three corners are about on a line, as those of a border that
  // is nearly straight, that middle is beside the third: the middle of the facet across the side
  // takes the flat one away.
  Vec2 dividing_point(const ConstrainedDelaunay& mesh, const Face& face) const {
    double most = kLongSide * rough_distance(face.corner);
    Vec2 best = middle_of(face);
    for (std::size_t k = 0; k < 3; ++k) {
      if (face.fixed[k]) continue;
      const int a = face.corner[(k + 1) % 3], b = face.corner[(k + 2) % 3];
      const double far = rough_distance({a, b, b});
      if (far <= most) continue;
      most = far;
      const Vec2 from = scaled(uv_of(face, k + 1)), to = scaled(uv_of(face, k + 2));
      const bool flat = norm(scaled(uv_of(face, k)) - 0.5 * (from + to)) < kFlat * norm(to - from);
      const Face& across = mesh.faces()[index(face.beside[k])];
      best = flat && across.inside ? middle_of(across)
                                   : 0.5 * (uv_of(face, k + 1) + uv_of(face, k + 2));
    }
    return best;
  }

  static std::vector<int> faces_inside(const ConstrainedDelaunay& mesh) {
    std::vector<int> inside;
    for (std::size_t i = 0; i < mesh.faces().size(); ++i)
      if (mesh.faces()[i].inside) inside.push_back(static_cast<int>(i));
    return inside;
  }

  // Points in the middles of what is not to be a side.
  void part_sides(ConstrainedDelaunay& mesh) {
    std::vector<int> open;
    for (const int number : faces_inside(mesh)) {
      const Face face = mesh.faces()[index(number)];
      if (corners_.is_flat(face.corner)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::optional<FacetSide> side = common_side(face, k);
        if (!side || !side->across || !parted_.contains(side->ends)) continue;
        const int made = add_near(mesh, 0.5 * (uv_of(face, k + 1) + uv_of(face, k + 2)));
        if (made == ConstrainedDelaunay::kNone) continue;
        mesh.for_each_face_at(made, [&](int changed) { open.push_back(changed); });
        break;
      }
    }
    refine(mesh, std::move(open));
  }

  // That opposite to a corner, if both its ends are on edges.
  std::optional<FacetSide> common_side(const Face& face, std::size_t k) const {
    const PolylinePoint& a = corners_[face.corner[(k + 1) % 3]].origin;
    const PolylinePoint& b = corners_[face.corner[(k + 2) % 3]].origin;
    if (a.edge < 0 || b.edge < 0) return {};
    const auto [low, high] = std::minmax({corners_.common_point(a), corners_.common_point(b)});
    return FacetSide{{low, high}, !face.fixed[k]};
  }

  void refine(ConstrainedDelaunay& mesh, std::vector<int> open) {
    far_.resize(mesh.faces().size());
    while (!open.empty()) {
      const int number = open.back();
      const Face face = mesh.faces()[index(number)];
      open.pop_back();
      const double far = distance_of(face.corner);
      far_[index(number)] = far;
      const bool is_far = far > surface_.allowed();
      if ((!is_far && !folds_inside(face)) || corners_.is_small(face.corner) ||
          corners_.is_flat(face.corner))
        continue;
      if (is_far && divides_borders_ && note_flat_over_border(face)) continue;
      const Vec2 uv = is_far ? dividing_point(mesh, face) : middle_of_most_bent_side(face);
      if (!is_far && is_crowded(mesh, uv)) continue;
      const int made = add_near(mesh, uv);
      if (made == ConstrainedDelaunay::kNone) continue;
      far_.resize(mesh.faces().size());
      if (mesh.faces()[index(number)].corner == face.corner) open.push_back(number);
      mesh.for_each_face_at(made, [&](int changed) { open.push_back(changed); });
    }
  }

  // Adds a point in a face, or beside it, where rounding may put it; kNone if that is past a
  // border, on one, or in a point that is there.
  int add_near(ConstrainedDelaunay& mesh, const Vec2& uv) {
    const int holder = mesh.locate(scaled(uv));
    return mesh.may_insert(scaled(uv), holder) ? add_inner(mesh, uv, holder)
                                               : ConstrainedDelaunay::kNone;
  }

  // Where parameters turn round in space within little, as in the sections of a pipe, a facet may
  // be near to the surface and turned over: its corners are beside each other along the surface
  // otherwise than in the parameters, whose second derivatives within the surface count in no
  // distance. They do so by the square of a side: half as long sides are turned less. Beside
  // borders it is these that are divided, see folding_sides.
  bool folds_inside(const Face& face) const {
    return std::ranges::find(face.fixed, true) == face.fixed.end() && is_long(face.corner) &&
           corners_.is_folded(face.corner);
  }

  bool is_long(const FacetTriangle& facet) const {
    return corners_.longest_side(facet) > kShortFold * options_.deviation;
  }

  // Of the side over which parameters turn most: there it is farthest from where it is in the
  // parameters.
  Vec2 middle_of_most_bent_side(const Face& face) const {
    double most = -1;
    Vec2 best;
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = face.corner[(k + 1) % 3], to = face.corner[(k + 2) % 3];
      const FaceCorner &a = corners_[from], &b = corners_[to];
      const Vec2 middle = 0.5 * (a.uv + b.uv);
      const double off = distance(surface_.frame_at(middle).point, 0.5 * (a.point + b.point));
      if (off <= most || !is_long({from, to, to})) continue;
      most = off;
      best = middle;
    }
    return best;
  }

  // Whether a place is as near to a corner of the face that holds it as halves of the shortest
  // sides are that get divided: so points that are added cannot crowd, as at a pole.
  bool is_crowded(ConstrainedDelaunay& mesh, const Vec2& uv) const {
    const Vec3 place = surface_.frame_at(uv).point;
    const Face& holder = mesh.faces()[index(mesh.locate(scaled(uv)))];
    return std::ranges::any_of(holder.corner, [&](int corner) {
      return distance(corners_[corner].point, place) < 0.5 * kShortFold * options_.deviation;
    });
  }

  // A facet that is too far and flat over a border is as far as that along its own normal, which is
  // not the one that `too_far` took: points inside would come ever nearer to the border, for
  // nothing.
  bool note_flat_over_border(const Face& face) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!face.fixed[k] || !is_flat_over(face, k)) continue;
      const int from = face.corner[(k + 1) % 3], to = face.corner[(k + 2) % 3];
      const std::optional<EdgeSegment> segment = segment_of(from, to);
      if (!segment || corners_.is_small({from, to, to})) continue;
      far_borders_.push_back(*segment);
      return true;
    }
    return false;
  }

  // Whether a corner is about on the side opposite to it.
  bool is_flat_over(const Face& face, std::size_t k) const {
    const Vec2 from = scaled(uv_of(face, k + 1)), side = scaled(uv_of(face, k + 2)) - from;
    return std::abs(cross(side, scaled(uv_of(face, k)) - from)) < kFlat * dot(side, side);
  }

  // Of the edge along which the region's border goes from one corner to another.
  std::optional<EdgeSegment> segment_of(int from, int to) {
    if (segments_.empty())
      for (const PolygonSide& side : polygon_.sides) segments_[{side.from, side.to}] = side.segment;
    const auto found = segments_.find({from, to});
    if (found == segments_.end() || found->second.edge < 0) return {};
    return found->second;
  }

  // Borders whose chords are behind the other corner of a facet, though it is in front of them in
  // the parameters; those round its corners if it has none itself. Halving a chord brings it nearer
  // to the border by a factor of 4. Round a pole are all facets, most of which have no part in it.
  std::vector<EdgeSegment> folding_sides(const ConstrainedDelaunay& mesh) {
    std::vector<EdgeSegment> splits;
    const auto take_sides = [&](const Face& face) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = face.corner[k], to = face.corner[(k + 1) % 3];
        if (!face.fixed[(k + 2) % 3] || !face.inside) continue;
        const std::optional<EdgeSegment> segment = segment_of(from, to);
        if (!segment) continue;
        if (is_long({from, to, to})) splits.push_back(*segment);
      }
    };
    for (const Face& face : mesh.faces()) {
      if (!face.inside || corners_.is_flat(face.corner) || !corners_.is_folded(face.corner))
        continue;
      const std::size_t before = splits.size();
      take_sides(face);
      if (splits.size() > before) continue;
      for (const int corner : face.corner)
        if (corners_[corner].origin.edge >= 0 && !corners_.is_at_pole(corner))
          mesh.for_each_face_at(corner, [&](int at) { take_sides(mesh.faces()[index(at)]); });
    }
    return splits;
  }

  FaceFacets collected(const ConstrainedDelaunay& mesh) {
    FaceFacets result;
    std::vector<int> places(corners_.size(), -1);
    result.corners.reserve(corners_.size());
    result.triangles.reserve(mesh.faces().size());
    for (std::size_t number = 0; number < mesh.faces().size(); ++number) {
      const Face& face = mesh.faces()[number];
      if (!face.inside || corners_.is_flat(face.corner)) continue;
      const double moved = corners_.moved_of(face.corner);
      result.moved = std::max(result.moved, moved);
      result.distance = std::max(result.distance, far_[number] + moved);
      result.folded += corners_.is_folded(face.corner);
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        if (const auto side = common_side(face, k)) result.sides.push_back(*side);
        int& place = places[index(face.corner[k])];
        if (place < 0) {
          place = static_cast<int>(result.corners.size());
          result.corners.push_back(corners_[face.corner[k]]);
        }
        triangle[k] = place;
      }
      result.triangles.push_back(triangle);
    }
    result.distance += surface_.error();
    return result;
  }

  const std::function<bool()>& ask_;
  const std::set<CommonSide>& parted_;
  int added_ = 0;  // points inside
  const ChartSurface& surface_;
  const FacetOptions& options_;
  FacePolygon polygon_;
  FacetDensity density_;
  FacetCorners corners_;
  std::vector<double> far_;  // of each face inside, since it was refined last
  std::map<std::pair<int, int>, EdgeSegment> segments_;  // of sides, once they are asked for
  std::vector<EdgeSegment> far_borders_;
  bool divides_borders_ = false;  // or it is the last round
};

}  // namespace

FaceAttempt facets_of(const ModelFace& face, const ShapeModel& model,
                      const std::vector<EdgePolyline>& polylines, const ChartSurface& surface,
                      const FacetOptions& options, const std::set<CommonSide>& parted, int round,
                      const std::function<bool()>& ask) {
  try {
    return FacetBuilder(face, model, polylines, surface, options, parted, ask).attempt(round);
  } catch (const InvalidInput& error) {
    FaceAttempt attempt;
    attempt.facets.obstacle = error.what();
    return attempt;
  } catch (const Stop&) {
    return {};
  }
}

}  // namespace blossom
