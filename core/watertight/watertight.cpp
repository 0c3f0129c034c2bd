// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/watertight.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/errors.h"
#include "core/blossom/triangle_composition.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/algebra/interpolation.h"
#include "core/math/index.h"
#include "core/regions/border_arcs.h"
#include "core/regions/cleaning/pole_ends.h"
#include "core/regions/cleaning/polynomial_surface.h"
#include "core/regions/cleaning/short_spans.h"
#include "core/regions/triangulated_region.h"
#include "core/watertight/border_fitting.h"
#include "core/watertight/equal_degrees.h"
#include "core/watertight/fold_repair.h"
#include "core/watertight/limits.h"
#include "core/watertight/lower_degrees.h"
#include "core/watertight/paired_parameters.h"
#include "core/watertight/piece_sides.h"
#include "core/watertight/two_triangle_vertices.h"

namespace blossom {
namespace {

constexpr int kSideDegree = 5;  // of the curves that take the place of edges
constexpr int kMaxRounds = 12;  // of dividing edges until all faces agree

void check(const CommonModel& model, const WatertightOptions& options) {
  const auto in = [](int i, std::size_t count) { return 0 <= i && index(i) < count; };
  for (const CommonEdge& edge : model.edges)
    if (!in(edge.from, model.vertices.size()) || !in(edge.to, model.vertices.size()))
      throw InvalidInput("watertight: an edge ends at no vertex");
  for (const CommonFace& face : model.faces) {
    if (face.edges.size() != face.chart.borders.size())
      throw InvalidInput("watertight: a face needs one edge for each border");
    if (!face.parameters.empty() && face.parameters.size() != face.edges.size())
      throw InvalidInput("watertight: parameters of all borders of a face or of none");
    for (const int edge : face.edges)
      if (!in(edge, model.edges.size())) throw InvalidInput("watertight: there is no such edge");
  }
  if (!(options.tolerance > 0)) throw InvalidInput("watertight: the tolerance must be positive");
}

class Builder {
 public:
  Builder(const CommonModel& model, const WatertightOptions& options)
      : model_(model),
        options_(options),
        parameters_(model_),
        stops_(model.edges.size()),
        regions_(model.faces.size()),
        done_(model.faces.size(), false),
        uneven_(model.edges.size(), false) {
    for (const CommonFace& face : model.faces)
      for (std::size_t b = 0; b < face.parameters.size(); ++b)
        if (face.parameters[b].to_edge) uneven_[index(face.edges[b])] = true;
  }

  WatertightPieces built() {
    try {
      make_surfaces();
      agree();
    } catch (const Ended&) {
      result_ = {};
      result_.obstacle = "it was ended before all faces were done";
      for (std::size_t f = 0; f < done_.size(); ++f)
        if (!done_[f]) result_.open.push_back(static_cast<int>(f));
    }
    return std::move(result_);
  }

 private:
  struct Ended {};

  void ask() const {
    if (options_.ask && !options_.ask()) throw Ended{};
  }

  void make_surfaces() {
    for (const CommonFace& face : model_.faces) {
      ask();
      surfaces_.push_back(polynomial_surface(face.surface, kSurfacePart * options_.tolerance));
      surface_error_ = std::max(surface_error_, surfaces_.back().error);
      TrimmedChart chart = face.chart;
      for (std::size_t b = 0; b < chart.borders.size(); ++b)
        chart.borders[b].is_point = model_.edges[index(face.edges[b])].is_point;
      const double within = kArcPart * options_.tolerance;
      chart = with_straight_pole_ends(surfaces_.back(), std::move(chart), within);
      add_poles(charts_.size(), chart);
      charts_.push_back(without_short_spans(surfaces_.back(), std::move(chart), within));
    }
  }

  // Borders that the chart has beyond its face's are points in space: at the vertex of the borders
  // that begin where they end.
  void add_poles(std::size_t number, const TrimmedChart& chart) {
    CommonFace& face = model_.faces[number];
    for (std::size_t b = face.edges.size(); b < chart.borders.size(); ++b) {
      const int vertex = vertex_at_start(number, chart, chart.borders[b].to);
      const int edge = static_cast<int>(model_.edges.size());
      model_.edges.push_back({{}, chart.borders[b].curve.domain(), vertex, vertex, true});
      face.edges.push_back(edge);
      if (!face.parameters.empty()) face.parameters.emplace_back();
      stops_.emplace_back();
      uneven_.push_back(false);
    }
  }

  // The vertex of the border that starts at a corner.
  int vertex_at_start(std::size_t face, const TrimmedChart& chart, int corner) {
    const auto starts = [&](const RegionBorder& border) { return border.from == corner; };
    const auto found = std::ranges::find_if(chart.borders, starts);
    const auto number = static_cast<std::size_t>(found - chart.borders.begin());
    const Interval own = found->curve.domain();
    const double start = parameters_.on_edge(face, number, found->reversed ? own.to : own.from);
    const CommonEdge& edge = model_.edges[index(model_.faces[face].edges[number])];
    return start - edge.domain.from < edge.domain.to - start ? edge.from : edge.to;
  }

  void agree() {
    std::vector<bool> stale(model_.faces.size(), true);
    for (int round = 0; round < kMaxRounds; ++round) {
      if (!make_regions(stale)) return;
      if (agree_on_stops(stale)) continue;
      make_pieces();
      if (!divide_moved_sides(stale)) return finish();
    }
    // The last pieces agree; they are only farther from the surfaces than was wished.
    if (result_.pieces.empty())
      result_.obstacle = "the faces do not agree on pieces of an edge";
    else
      finish();
  }

  // ---- regions with equal stops

  bool make_regions(const std::vector<bool>& stale) {
    RegionOptions region_options;
    region_options.common_borders = true;
    region_options.tolerance = kArcPart * options_.tolerance;
    region_options.highest_degree = options_.highest_degree;
    for (std::size_t f = 0; f < stale.size(); ++f) done_[f] = !stale[f];
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      if (!stale[f]) continue;
      ask();
      TrimmedChart chart = charts_[f];
      for (std::size_t b = 0; b < chart.borders.size(); ++b) settle(chart.borders[b], f, b);
      regions_[f] = triangulated_region(surfaces_[f], chart, region_options);
      if (!regions_[f].obstacle.empty()) {
        result_ = {};
        result_.obstacle = "face " + std::to_string(f + 1) + ": " + regions_[f].obstacle;
        return false;
      }
      beyond_ = std::max(beyond_, regions_[f].beyond_lines);
      done_[f] = true;
      add_stops_of(f);
    }
    return true;
  }

  // At once, so that the next faces divide an edge where this one has, and no more than it takes.
  void add_stops_of(std::size_t face) {
    for (std::size_t b = 0; b < regions_[face].stops.size(); ++b) {
      const auto edge = index(model_.faces[face].edges[b]);
      std::ranges::copy(stops_on_edge(face, b), std::back_inserter(stops_[edge]));
      tidy(stops_[edge], model_.edges[edge].domain);
    }
  }

  // A point is divided by each face as it likes.
  void settle(RegionBorder& border, std::size_t face, std::size_t number) {
    const auto edge = index(model_.faces[face].edges[number]);
    if (border.is_point) return;
    border.tolerance = kApartPart * model_.edges[edge].apart;
    for (const double stop : stops_[edge])
      border.stops.push_back(parameters_.on_border(face, number, stop));
  }

  // The edge's parameters at the stops of a border of a region, increasing.
  std::vector<double> stops_on_edge(std::size_t face, std::size_t border) {
    std::vector<double> stops;
    for (const double stop : regions_[face].stops[border])
      stops.push_back(parameters_.on_edge(face, border, stop));
    std::ranges::sort(stops);
    return stops;
  }

  Interval place_on_edge(std::size_t face, const RegionArc& arc) {
    return {parameters_.on_edge(face, index(arc.border), arc.place.from),
            parameters_.on_edge(face, index(arc.border), arc.place.to)};
  }

  // Increasing, from end to end of the edge; near ones are one.
  static void tidy(std::vector<double>& stops, const Interval& domain) {
    const double same = kShortestArc * length(domain);
    std::ranges::sort(stops);
    std::vector<double> kept{domain.from};
    for (const double stop : stops)
      if (stop > kept.back() + same && stop < domain.to - same) kept.push_back(stop);
    kept.push_back(domain.to);
    stops = std::move(kept);
  }

  // Marks the faces whose borders have to be divided further.
  bool agree_on_stops(std::vector<bool>& stale) {
    stale.assign(model_.faces.size(), false);
    for (std::size_t f = 0; f < model_.faces.size(); ++f)
      for (std::size_t b = 0; b < regions_[f].stops.size(); ++b) {
        const int edge = model_.faces[f].edges[b];
        if (!model_.edges[index(edge)].is_point && stops_on_edge(f, b) != stops_[index(edge)])
          stale[f] = true;
      }
    return std::ranges::find(stale, true) != stale.end();
  }

  // ---- pieces

  void make_pieces() {
    result_ = {};
    result_.vertices = model_.vertices;
    stop_vertex_.clear();
    arc_side_.clear();
    side_place_.clear();
    done_.assign(model_.faces.size(), false);
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      add_face(static_cast<int>(f));
      done_[f] = true;
    }
    lowering_.lower(result_, surfaces_, options_.highest_degree,
                    kTrianglePart * options_.tolerance);
    divide_two_triangle_vertices(result_);
    divide_facing_chords(result_);
    find_coarse_sides();
    unmoved_ = result_;
    raise_degrees(result_);
    moves_ = move_sides(result_, uneven_);
  }

  void finish() {
    done_.assign(model_.faces.size(), false);  // none is as long as its pieces may change
    spare_turns(unmoved_, result_, kFoldPart * options_.tolerance, [this] { ask(); });
    done_.assign(model_.faces.size(), true);
    result_.deviation = 0;
    for (const WatertightPiece& piece : result_.pieces)
      result_.deviation = std::max(result_.deviation, piece.moved);
    result_.deviation += surface_error_ + 2 * beyond_;  // both patches part from a common line
  }

  // Sides of triangles that did not come down to the highest degree within the tolerance.
  void find_coarse_sides() {
    coarse_.clear();
    for (const WatertightPiece& piece : result_.pieces)
      if (piece.moved > 2 * kTrianglePart * options_.tolerance)
        coarse_.insert(piece.sides.begin(), piece.sides.end());
  }

  int vertex_on(int edge, double parameter) {
    const CommonEdge& on = model_.edges[index(edge)];
    if (on.is_point || parameter == on.domain.from) return on.from;
    if (parameter == on.domain.to) return on.to;
    const auto [known, is_new] =
        stop_vertex_.try_emplace({edge, parameter}, static_cast<int>(result_.vertices.size()));
    if (is_new) result_.vertices.push_back(on.point(parameter));
    return known->second;
  }

  // Through points of the edge, of the lowest degree that is hardly farther from them. Where the
  // edge misses its vertices, that is spread over the piece: a polynomial that makes up for it at
  // once would swing several times as far.
  BezierCurve curve_on(const CommonEdge& edge, const Interval& place, const Vec3& from,
                       const Vec3& to) const {
    const Vec3 at_from = from - edge.point(place.from), at_to = to - edge.point(place.to);
    std::vector<Vec3> points;
    for (const double t : extreme_points(kSideDegree))
      points.push_back(edge.point(at(place, t)) + (1 - t) * at_from + t * at_to);
    points.front() = from;
    points.back() = to;
    const BezierCurve curve = bezier_through(points);
    for (int degree = 1; degree < kSideDegree; ++degree) {
      const auto lower = reduced(curve, degree);
      if (lower.error > kSideLoweringPart * options_.tolerance) continue;
      return lower.form;
    }
    return curve;
  }

  // The side on a piece of an edge; its curve runs as the edge does.
  int side_on(int edge, Interval place) {
    if (place.from > place.to) std::swap(place.from, place.to);
    const auto [known, is_new] =
        arc_side_.try_emplace({edge, place.from, place.to}, static_cast<int>(result_.sides.size()));
    if (!is_new) return known->second;
    const CommonEdge& on = model_.edges[index(edge)];
    WatertightSide side{edge, vertex_on(edge, place.from), vertex_on(edge, place.to), {}};
    if (!on.is_point) {
      side.curve =
          curve_on(on, place, result_.vertices[index(side.from)], result_.vertices[index(side.to)]);
    }
    side_place_[static_cast<int>(result_.sides.size())] = place;
    result_.sides.push_back(std::move(side));
    return known->second;
  }

  // Numbers of a region's vertices in the model; those inside get new ones.
  std::vector<int> vertices_of(int face) {
    const TriangulatedRegion& region = regions_[index(face)];
    std::vector<int> names(region.vertices.size(), -1);
    for (const RegionArc& arc : region.arcs) {
      const int edge = model_.faces[index(face)].edges[index(arc.border)];
      const Interval place = place_on_edge(index(face), arc);
      names[index(arc.from)] = vertex_on(edge, place.from);
      names[index(arc.to)] = vertex_on(edge, place.to);
    }
    return names;
  }

  void add_face(int face) {
    ask();
    const TriangulatedRegion& region = regions_[index(face)];
    std::vector<int> names = vertices_of(face);
    std::map<std::pair<int, int>, int> inner;  // sides by the region's vertices
    std::map<std::pair<int, int>, int> arc_between;
    for (std::size_t k = 0; k < region.arcs.size(); ++k)
      arc_between[{region.arcs[k].from, region.arcs[k].to}] = static_cast<int>(k);
    for (const RegionPiece& piece : region.pieces) {
      const auto* triangle = std::get_if<CurvedTriangle>(&piece.shape);
      std::vector<int> corners;
      if (triangle)
        corners.assign(triangle->vertices.begin(), triangle->vertices.end());
      else
        std::ranges::copy(std::get<RegionCell>(piece.shape).vertices, std::back_inserter(corners));
      WatertightPiece made{face, polynomial_form(surfaces_[index(face)], piece), {}, {}, {}, 0};
      name_corners(made, corners, names);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto arc = arc_between.find({corners[k], corners[(k + 1) % corners.size()]});
        made.sides.push_back(arc != arc_between.end()
                                 ? side_under(face, region.arcs[index(arc->second)])
                                 : inner_side(made, static_cast<int>(k), corners, inner));
      }
      result_.pieces.push_back(std::move(made));
    }
  }

  int side_under(int face, const RegionArc& arc) {
    return side_on(model_.faces[index(face)].edges[index(arc.border)],
                   place_on_edge(index(face), arc));
  }

  static std::variant<BezierPatch, BezierTriangle> polynomial_form(const BezierSurface& surface,
                                                                   const RegionPiece& piece) {
    const RegionForm form = bezier_form(surface, piece);
    if (const auto* given = std::get_if<RationalBezierTriangle>(&form)) {
      BezierTriangle own{given->degree, {}};
      for (const Vec4& p : given->points) own.points.push_back(head(p));
      return flat_if_it_is(own);
    }
    const Grid<Vec4>& net = std::get<RationalBezierPatch>(form).points;
    BezierPatch own{Grid<Vec3>(net.rows(), net.columns())};
    std::ranges::transform(net.values(), own.points.values().begin(), head);
    return own;
  }

  // ---- corners and sides of one piece

  // Corners of a piece that are not on an edge get the next numbers, at the piece's own points.
  void name_corners(WatertightPiece& piece, const std::vector<int>& corners,
                    std::vector<int>& names) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      int& name = names[index(corners[k])];
      if (name < 0) {
        name = static_cast<int>(result_.vertices.size());
        result_.vertices.push_back(side_curve(piece, static_cast<int>(k)).points.front());
      }
      piece.vertices.push_back(name);
    }
  }

  int inner_side(const WatertightPiece& piece, int k, const std::vector<int>& corners,
                 std::map<std::pair<int, int>, int>& inner) {
    const std::size_t next = (index(k) + 1) % corners.size();
    const int a = corners[index(k)], b = corners[next];
    if (const auto known = inner.find({b, a}); known != inner.end()) return known->second;
    const int number = inner[{a, b}] = static_cast<int>(result_.sides.size());
    result_.sides.push_back(
        {-1, piece.vertices[index(k)], piece.vertices[next], side_curve(piece, k)});
    return number;
  }

  // ---- what is too far from the surfaces

  // Halves the pieces of edges whose triangles are coarse or moved too far for other reasons than
  // the edge's own distance from the surfaces.
  bool divide_moved_sides(std::vector<bool>& stale) {
    std::vector<bool> divided(model_.edges.size(), false);
    for (const auto& [number, place] : side_place_) {
      const WatertightSide& side = result_.sides[index(number)];
      if (side.curve.points.empty()) continue;
      const double moved = moves_.way[index(number)];
      const bool coarse = coarse_.contains(number);
      const double apart =
          std::max(moves_.edge_gap[index(number)], model_.edges[index(side.edge)].apart);
      if (!coarse && moved <= std::max(options_.tolerance, kEdgePart * apart)) continue;
      stops_[index(side.edge)].push_back(at(place, 0.5));
      divided[index(side.edge)] = true;
    }
    for (std::size_t f = 0; f < model_.faces.size(); ++f)
      stale[f] = std::ranges::any_of(model_.faces[f].edges,
                                     [&](int edge) { return divided[index(edge)]; });
    return std::ranges::find(divided, true) != divided.end();
  }

  CommonModel model_;  // with edges at poles that have none
  WatertightOptions options_;
  PairedParameters parameters_;
  std::vector<std::vector<double>> stops_;  // of each edge
  std::vector<BezierSurface> surfaces_;
  std::vector<TrimmedChart> charts_;
  double surface_error_ = 0, beyond_ = 0;
  std::vector<TriangulatedRegion> regions_;
  std::vector<bool> done_;  // of each face: whether its region, or its pieces are made
  // Edges with borders that run otherwise than they do. How far they are apart along the edge is a
  // matter of parameters, and passes when it is divided.
  std::vector<bool> uneven_;
  std::map<std::pair<int, double>, int> stop_vertex_;
  std::map<std::tuple<int, double, double>, int> arc_side_;
  std::map<int, Interval> side_place_;
  DegreeLowering lowering_;
  std::set<int> coarse_;
  WatertightPieces unmoved_;  // before their sides were
  SideMoves moves_;
  WatertightPieces result_;
};

}  // namespace

WatertightPieces watertight_pieces(const CommonModel& model, const WatertightOptions& options) {
  check(model, options);
  return Builder(model, options).built();
}

}  // namespace blossom
