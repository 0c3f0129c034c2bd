// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/coincidence/overlaps.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"
#include "core/math/periods.h"
#include "core/surfaces/coincidence/border_overlaps.h"

namespace blossom {
namespace {

constexpr double kJoinTolerances = 100;  // ends this near are one
constexpr double kJoinPart = 1e-6;       // or this part of the size
constexpr double kOnOther = 1e-3;        // of the tolerance: borders this near lie on the surface
constexpr double kGrown = 1.0;           // of a cell's width, when a boundary is sought in it

// A directed piece of the boundary of a region.
struct Piece {
  std::vector<ContactPoint> path;
  BorderOverlap stretch;
  bool of_a = true;              // whose border it is
  std::size_t from = 0, to = 0;  // vertices
  bool used = false;
};

Vec2 over_surface(const SurfaceCells& own, const ContactPoint& p, bool of_a) {
  const int patch = of_a ? p.patch_a : p.patch_b;
  const std::size_t u = of_a ? 0 : 2;
  return {own.span_u(patch) + p.x[u], own.span_v(patch) + p.x[u + 1]};
}

// Spans of a closed direction, 0 of an open one.
Vec2 periods(const BezierSurface& surface) {
  return {surface.closed_u ? static_cast<double>(surface.patches.rows()) : 0.0,
          surface.closed_v ? static_cast<double>(surface.patches.columns()) : 0.0};
}

using Polygon = std::vector<Vec2>;

Polygon unwrapped(const SurfaceCells& own, const std::vector<ContactPoint>& path,
                  bool of_a = true) {
  const Vec2 period = periods(own.surface());
  Polygon polygon;
  polygon.reserve(path.size());
  for (const ContactPoint& p : path) {
    const Vec2 x = over_surface(own, p, of_a);
    polygon.push_back(polygon.empty() ? x : unwrapped(x, polygon.back(), period));
  }
  return polygon;
}

std::vector<Polygon> unwrapped(const SurfaceCells& a, const std::vector<BoundaryLoop>& loops) {
  std::vector<Polygon> polygons;
  for (const BoundaryLoop& loop : loops) polygons.push_back(unwrapped(a, loop));
  return polygons;
}

// Crossings of a polygon with the ray from a point along the positive direction `axis`.
int crossings(const Polygon& polygon, const Vec2& from, int axis) {
  int count = 0;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[i + 1];
    const double c = from[1 - axis];
    if ((p[1 - axis] > c) == (q[1 - axis] > c)) continue;
    const double f = (c - p[1 - axis]) / (q[1 - axis] - p[1 - axis]);
    if (p[axis] + f * (q[axis] - p[axis]) > from[axis]) ++count;
  }
  return count;
}

// True if a point of the chart lies between the loops.
bool encloses(const std::vector<Polygon>& loops, const Vec2& period, const Vec2& point) {
  const int axis = period[1] > 0 && period[0] == 0 ? 0 : 1;
  const double shift = period[1 - axis];
  const int most = shift > 0 ? 2 : 0;
  int count = 0;
  for (const Polygon& loop : loops)
    for (int i = -most; i <= most; ++i) {
      Vec2 moved = point;
      moved[1 - axis] += i * shift;
      count += crossings(loop, moved, axis);
    }
  return count % 2 == 1;
}

bool meets_box(const Vec2& p, const Vec2& q, const Vec2& low, const Vec2& high) {
  double from = 0, to = 1;
  for (int k = 0; k < 2; ++k)
    if (std::max(p[k], q[k]) < low[k] || std::min(p[k], q[k]) > high[k]) return false;
  for (int k = 0; k < 2; ++k) {
    const double d = q[k] - p[k];
    if (d == 0) continue;
    const double s = (low[k] - p[k]) / d, t = (high[k] - p[k]) / d;
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  return from <= to;
}

// The place of a pair over one of the surfaces.
struct Footprint {
  Footprint(const SurfaceCells& own, const CriticalPair& pair, bool of_a) {
    const int patch = of_a ? pair.patch_a : pair.patch_b;
    const Vec2 span{static_cast<double>(own.span_u(patch)), static_cast<double>(own.span_v(patch))};
    for (int k = 0; k < 2; ++k) {
      const Interval& box = pair.box[static_cast<std::size_t>(of_a ? k : k + 2)];
      low[k] = span[k] + box.from;
      high[k] = span[k] + box.to;
      middle[k] = span[k] + at(box, 0.5);
    }
  }

  Vec2 low, high, middle;
};

// True if a path runs through the grown cell of a pair.
bool runs_through(const Polygon& path, const Vec2& period, const Footprint& place) {
  const Vec2 margin = kGrown * (place.high - place.low);
  const Vec2 low = place.low - margin, high = place.high + margin;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 p = unwrapped(path[i], place.middle, period);
    if (meets_box(p, p + (path[i + 1] - path[i]), low, high)) return true;
  }
  return false;
}

class OverlapFinder {
 public:
  OverlapFinder(SurfaceCells& a, SurfaceCells& b, const std::vector<CriticalPair>& coincident,
                double tolerance, double size, const WorkLimit& limit)
      : a_(a),
        b_(b),
        coincident_(coincident),
        tolerance_(tolerance),
        join_(std::max(kJoinTolerances * tolerance, kJoinPart * size)),
        limit_(limit),
        on_b_(a, b, partners(a.patches(), &CriticalPair::patch_a, &CriticalPair::patch_b),
              tolerance, size, limit_),
        on_a_(b, a, partners(b.patches(), &CriticalPair::patch_b, &CriticalPair::patch_a),
              tolerance, size, limit_) {}

  Overlaps run() {
    // What one surface's stretches end on may be too short for the other's samples: look twice.
    find_stretches();
    if (!junctions_a_.empty() || !junctions_b_.empty()) find_stretches();
    take(on_b_, stretches_a_, junctions_a_, true);
    take(on_a_, stretches_b_, junctions_b_, false);
    if (limit_.reached()) return {{}, {}, limit_.reason()};
    for (Piece& piece : pieces_) {
      piece.from = vertex(piece.path.front());
      piece.to = vertex(piece.path.back());
    }
    drop_loose_pieces();
    group(loops());
    return std::move(result_);
  }

 private:
  using Junctions = std::vector<BorderJunction>;

  std::vector<std::vector<int>> partners(int count, int CriticalPair::*own,
                                         int CriticalPair::*other) const {
    std::vector<std::set<int>> sets(static_cast<std::size_t>(count));
    for (const CriticalPair& pair : coincident_)
      sets[static_cast<std::size_t>(pair.*own)].insert(pair.*other);
    std::vector<std::vector<int>> lists;
    for (const auto& set : sets) lists.emplace_back(set.begin(), set.end());
    return lists;
  }

  static std::vector<double> places_on(const BorderLine& line, const Junctions& junctions) {
    std::vector<double> places;
    for (const BorderJunction& junction : junctions)
      if (junction.line == line) places.push_back(junction.along);
    std::sort(places.begin(), places.end());
    return places;
  }

  static std::vector<BorderOverlap> stretches_of(BorderFollower& follower,
                                                 const BezierSurface& surface, StretchKind kind,
                                                 const Junctions& junctions) {
    std::vector<BorderOverlap> all;
    for (const BorderLine& line : border_lines(surface)) {
      const auto found = follower.stretches(line, kind, places_on(line, junctions));
      all.insert(all.end(), found.begin(), found.end());
    }
    return all;
  }

  static Junctions junctions_of(const BorderFollower& follower,
                                const std::vector<BorderOverlap>& stretches) {
    Junctions all;
    for (const BorderOverlap& stretch : stretches)
      for (const BorderJunction& junction : follower.junctions(stretch)) all.push_back(junction);
    return all;
  }

  // Borders of b count only inside a: where both surfaces have a border, it is a's.
  void find_stretches() {
    stretches_a_ = stretches_of(on_b_, a_.surface(), StretchKind::Any, junctions_a_);
    stretches_b_ = stretches_of(on_a_, b_.surface(), StretchKind::Interior, junctions_b_);
    junctions_b_ = junctions_of(on_b_, stretches_a_);
    junctions_a_ = junctions_of(on_a_, stretches_b_);
  }

  static ContactPoint contact_point(const BorderProbe& p, bool of_a) {
    const Vec2 &x = of_a ? p.x : p.foot.x, &y = of_a ? p.foot.x : p.x;
    return {of_a ? p.patch : p.foot.patch,
            of_a ? p.foot.patch : p.patch,
            {x[0], x[1], y[0], y[1]},
            p.foot.gap};
  }

  static std::vector<ContactPoint> contact_path(const std::vector<BorderProbe>& probes, bool of_a) {
    std::vector<ContactPoint> path;
    for (const BorderProbe& p : probes) path.push_back(contact_point(p, of_a));
    return path;
  }

  void take(BorderFollower& follower, const std::vector<BorderOverlap>& stretches,
            const Junctions& junctions, bool of_a) {
    for (const BorderOverlap& whole : stretches)
      for (const BorderOverlap& part : follower.cut(whole, places_on(whole.line, junctions))) {
        if (part.points.size() < 2) continue;
        auto path = contact_path(part.points, of_a);
        if (length_of(path) <= join_ && !(of_a && is_pole(part))) continue;
        if (follower.bounds_coincidence(part)) {
          if (!runs_with_region_left(part.line, path, of_a)) std::reverse(path.begin(), path.end());
          pieces_.push_back({std::move(path), part, of_a});
        } else {
          add_edge(part, of_a, false);
        }
      }
  }

  // Nothing where the surface goes on, or where the search met no coincidence.
  void add_edge(const BorderOverlap& stretch, bool of_a, bool wide) {
    const int across = stretch.line.across + (of_a ? 0 : 2);
    if (span_beyond((of_a ? a_ : b_).surface(), stretch.line) ||
        !is_held({contact_path(stretch.points, of_a), across}))
      return;
    BorderFollower& follower = of_a ? on_b_ : on_a_;
    result_.edges.push_back({contact_path(follower.links(stretch), of_a), across, wide});
  }

  // A pole bounds a region round it in a's chart as any other border does: what is one point there
  // closes the band.
  bool is_pole(const BorderOverlap& stretch) const {
    const BezierSurface& surface = a_.surface();
    const bool across_u = stretch.line.across == 0;
    const int spans = across_u ? surface.patches.columns() : surface.patches.rows();
    return (across_u ? surface.closed_v : surface.closed_u) && stretch.points.front().along == 0 &&
           stretch.points.back().along == spans;
  }

  // The search met a coincidence along the path, at its middle and quarters.
  bool is_held(const SharedBorder& border) const {
    const auto& path = border.path;
    for (const std::size_t quarter : {1, 2, 3}) {
      const std::size_t i = std::min(quarter * path.size() / 4, path.size() - 2);
      const Coincidence part({{path[i], path[i + 1]}, border.across}, a_, b_);
      if (std::none_of(coincident_.begin(), coincident_.end(),
                       [&](const CriticalPair& pair) { return part.holds(pair); }))
        return false;
    }
    return true;
  }

  // Anticlockwise round the surface whose border it is, turned when the normals are opposite.
  bool runs_with_region_left(const BorderLine& line, const std::vector<ContactPoint>& path,
                             bool of_a) {
    const bool left = (line.across == 0) == line.upper;
    const ContactPoint& p = path[path.size() / 2];
    return left == (of_a || dot(normal_of_a(p), normal_of_b(p)) > 0);
  }

  Vec3 normal_of_a(const ContactPoint& p) {
    const PatchJet jet = jet_at(a_.tree(p.patch_a).patch(), p.x[0], p.x[1], 1);
    return cross(jet.u, jet.v);
  }

  Vec3 normal_of_b(const ContactPoint& p) {
    const PatchJet jet = jet_at(b_.tree(p.patch_b).patch(), p.x[2], p.x[3], 1);
    return cross(jet.u, jet.v);
  }

  Vec3 point(const ContactPoint& p) { return point_at(a_.tree(p.patch_a).patch(), p.x[0], p.x[1]); }

  double length_of(const std::vector<ContactPoint>& path) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      sum += distance(point(path[i]), point(path[i + 1]));
    return sum;
  }

  std::size_t vertex(const ContactPoint& p) {
    const Vec3 x = point(p);
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      if (distance(vertices_[i], x) <= join_) return i;
    vertices_.push_back(x);
    return vertices_.size() - 1;
  }

  // Pieces that no other one continues bound nothing: where surfaces part slowly, a border stays
  // within tolerance of the other surface beyond the region. One that lies on it all along is an
  // edge from which they part.
  void drop_loose_pieces() {
    const auto loose = [&](const Piece& piece) {
      const auto any = [&](auto&& meets) {
        return std::any_of(pieces_.begin(), pieces_.end(), meets);
      };
      return !any([&](const Piece& other) { return other.to == piece.from; }) ||
             !any([&](const Piece& other) { return other.from == piece.to; });
    };
    while (true) {
      const auto found = std::find_if(pieces_.begin(), pieces_.end(), loose);
      if (found == pieces_.end()) return;
      if (lies_on_other(*found)) add_edge(found->stretch, found->of_a, true);
      pieces_.erase(found);
    }
  }

  bool lies_on_other(const Piece& piece) const {
    return std::ranges::all_of(
        piece.path, [&](const ContactPoint& p) { return p.gap <= kOnOther * tolerance_; });
  }

  // The angle by which the boundary turns left from one piece to the next.
  double turn(const Piece& in, const Piece& out) {
    const ContactPoint& corner = in.path.back();
    const Vec3 n = unit(normal_of_a(corner));
    const Vec3 x = point(corner);
    const Vec3 before = x - point(far_from(in.path, x, true));
    const Vec3 after = point(far_from(out.path, x, false)) - x;
    return std::atan2(dot(n, cross(before, after)), dot(before, after));
  }

  // The first point of a path, from one end, clearly apart from x.
  const ContactPoint& far_from(const std::vector<ContactPoint>& path, const Vec3& x,
                               bool from_back) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const ContactPoint& p = path[from_back ? path.size() - 1 - i : i];
      if (distance(point(p), x) > 10 * join_) return p;
    }
    return from_back ? path.front() : path.back();
  }

  // Walks round the boundaries, turning left where several pieces go on; so regions that meet in
  // a corner stay apart.
  std::vector<BoundaryLoop> loops() {
    std::vector<BoundaryLoop> found;
    for (Piece& first : pieces_) {
      if (first.used) continue;
      BoundaryLoop loop;
      Piece* piece = &first;
      while (piece) {
        piece->used = true;
        loop.insert(loop.end(), piece->path.begin(), piece->path.end());
        if (piece->to == first.from) break;
        Piece* next = nullptr;
        for (Piece& other : pieces_)
          if (!other.used && other.from == piece->to &&
              (!next || turn(*piece, other) > turn(*piece, *next)))
            next = &other;
        piece = next;
      }
      if (!piece) continue;  // no closed boundary: nothing is claimed
      loop.push_back(loop.front());
      found.push_back(std::move(loop));
    }
    return found;
  }

  struct ChartLoop {
    BoundaryLoop loop;
    double area = 0;
    Vec2 winding;  // in spans
    Vec2 inside;   // a point of it
    bool pole = false;
  };

  ChartLoop charted(BoundaryLoop loop) {
    const Polygon polygon = unwrapped(a_, loop);
    ChartLoop chart;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
      chart.area += 0.5 * (polygon[i][0] * polygon[i + 1][1] - polygon[i][1] * polygon[i + 1][0]);
    chart.winding = polygon.back() - polygon.front();
    chart.inside = polygon.front();
    chart.pole = length_of(loop) <= join_;
    chart.loop = std::move(loop);
    return chart;
  }

  // Loops into regions: outer loops, pairs of loops round a closed direction, and holes.
  void group(std::vector<BoundaryLoop> all) {
    std::vector<ChartLoop> holes, bands;
    std::vector<double> areas;
    for (BoundaryLoop& loop : all) {
      ChartLoop chart = charted(std::move(loop));
      if (max_norm(chart.winding) > 0.5) {
        bands.push_back(std::move(chart));
      } else if (chart.area > 0) {
        result_.regions.push_back({{std::move(chart.loop)}});
        areas.push_back(chart.area);
      } else {
        holes.push_back(std::move(chart));
      }
    }
    pair_bands(bands);
    areas.resize(result_.regions.size(), kUnbounded);
    for (ChartLoop& hole : holes) {
      int best = -1;
      for (std::size_t i = 0; i < result_.regions.size(); ++i)
        if (encloses(unwrapped(a_, result_.regions[i].loops), periods(a_.surface()), hole.inside) &&
            (best < 0 || areas[i] < areas[static_cast<std::size_t>(best)]))
          best = static_cast<int>(i);
      if (best >= 0)
        result_.regions[static_cast<std::size_t>(best)].loops.push_back(std::move(hole.loop));
    }
  }

  // A band lies to the left of both its loops: one that runs along +u below one along -u, or one
  // along -v left of one along +v. Between two poles it has no boundary.
  void pair_bands(std::vector<ChartLoop>& bands) {
    const auto axis = [](const ChartLoop& c) {
      return std::abs(c.winding[0]) > std::abs(c.winding[1]) ? 0 : 1;
    };
    const auto is_low = [&](const ChartLoop& c) {
      return axis(c) == 0 ? c.winding[0] > 0 : c.winding[1] < 0;
    };
    std::sort(bands.begin(), bands.end(), [&](const ChartLoop& c, const ChartLoop& d) {
      return c.inside[1 - axis(c)] < d.inside[1 - axis(d)];
    });
    for (std::size_t i = 0; i + 1 < bands.size(); ++i)
      if (is_low(bands[i]) && !is_low(bands[i + 1]) && !(bands[i].pole && bands[i + 1].pole))
        result_.regions.push_back({{std::move(bands[i].loop), std::move(bands[i + 1].loop)}});
  }

  SurfaceCells& a_;
  SurfaceCells& b_;
  const std::vector<CriticalPair>& coincident_;
  double tolerance_, join_;
  PolledLimit limit_;
  BorderFollower on_b_;  // borders of a
  BorderFollower on_a_;  // borders of b
  std::vector<BorderOverlap> stretches_a_, stretches_b_;
  Junctions junctions_a_, junctions_b_;
  std::vector<Piece> pieces_;
  std::vector<Vec3> vertices_;
  Overlaps result_;
};

}  // namespace

Overlaps find_overlaps(SurfaceCells& a, SurfaceCells& b,
                       const std::vector<CriticalPair>& coincident, double tolerance, double size,
                       const WorkLimit& limit) {
  return OverlapFinder(a, b, coincident, tolerance, size, limit).run();
}

Coincidence::Coincidence(const OverlapRegion& region, const SurfaceCells& a)
    : own_(a), paths_(unwrapped(a, region.loops)), of_a_(true), is_region_(true) {}

Coincidence::Coincidence(const SharedBorder& border, const SurfaceCells& a, const SurfaceCells& b)
    : own_(border.across < 2 ? a : b),
      paths_{unwrapped(own_, border.path, border.across < 2)},
      of_a_(border.across < 2),
      is_region_(false) {}

bool Coincidence::holds(const CriticalPair& pair) const {
  const Vec2 period = periods(own_.surface());
  const Footprint place(own_, pair, of_a_);
  return std::ranges::any_of(
             paths_, [&](const Polygon& path) { return runs_through(path, period, place); }) ||
         (is_region_ && encloses(paths_, period, place.middle));
}

}  // namespace blossom
