// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/neighbour_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <queue>
#include <utility>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/faces/face_trims_detail.h"
#include "core/bounds/patch_boxes.h"
#include "core/cells/cell_pair.h"
#include "core/cells/direction_cones.h"
#include "core/cells/known_curves.h"
#include "core/cells/surface_cells.h"
#include "core/surfaces/contacts/path_reach.h"
#include "core/surfaces/search/start_pairs.h"

namespace blossom::occt {
namespace {

constexpr double kCut = 0.4865;       // cells are halved off their middle, as in every search
constexpr int kDeepest = 60;          // halvings of a patch
constexpr long kMaxPairs = 30'000;    // of cells, for each pair of patches
constexpr double kReach = 4;          // tolerances: what is so near an edge or a vertex is it
constexpr double kPast = 0.1;         // of a cell: so far beside it an edge is known, if it goes on
constexpr int kMaxHalvings = 40;      // of a span of a wire, to see whether it meets a cell
constexpr double kTooSmall = 0x1p-8;  // of a cell: so small pieces of a wire beside it may meet it
constexpr double kFootPiece = 0x1p-8;  // of a wire, in which its point nearest to a cell is sought
constexpr double kMinPiece = 0x1p-40;  // of a span, likewise
constexpr int kNewtonSteps = 8;
constexpr double kFar = 4;  // cells: what is so far from an edge has to be apart without it
constexpr int kBisections = 60;
constexpr double kRounding = 0x1p-44;  // of the coordinates, by which ends of paths may be off
constexpr Axes kAxes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

double width(const PlanarBox& box, int k) { return box.high[k] - box.low[k]; }

bool apart(const PlanarBox& a, const PlanarBox& b) {
  for (int k = 0; k < 2; ++k)
    if (a.low[k] > b.high[k] || a.high[k] < b.low[k]) return true;
  return false;
}

bool holds(const PlanarBox& box, const Vec2& p) {
  return box.low[0] <= p[0] && p[0] <= box.high[0] && box.low[1] <= p[1] && p[1] <= box.high[1];
}

bool meets(const PlanarBezier& piece, const PlanarBox& box, int halvings) {
  const PlanarBox own = box_of(piece.points);
  if (apart(own, box)) return false;
  if (halvings == 0 || holds(box, projected(piece.points.front())) ||
      holds(box, projected(piece.points.back())) ||
      distance(own.low, own.high) < kTooSmall * distance(box.low, box.high))
    return true;
  return meets(bezier_piece(piece, {0, 0.5}), box, halvings - 1) ||
         meets(bezier_piece(piece, {0.5, 1}), box, halvings - 1);
}

// Whether an edge between two of its parameters may meet a box.
bool meets(const Coedge& edge, const Interval& range, const PlanarBox& box) {
  for (std::size_t i = 0; i < edge.curve.spans.size(); ++i) {
    const PlanarSpan& span = edge.curve.spans[i];
    const Interval common{std::max(range.from, span.place.from), std::min(range.to, span.place.to)};
    if (!(common.from < common.to) || apart(edge.boxes[i], box)) continue;
    const Interval local{local_parameter(span.law, span.place, common.from),
                         local_parameter(span.law, span.place, common.to)};
    if (meets(bezier_piece(span.curve, local), box, kMaxHalvings)) return true;
  }
  return false;
}

// The derivative of a rational curve lies in the convex cone of all differences of its control
// points, later ones minus earlier ones.
bool grows(const PlanarBezier& piece, int k, double sign) {
  const auto& points = piece.points;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if (!(sign * (projected(points[j])[k] - projected(points[i])[k]) > 0)) return false;
  return true;
}

double distance_to(const PlanarBox& box, const Vec2& p) {
  const auto off = [&](int k) { return std::max({box.low[k] - p[k], p[k] - box.high[k], 0.0}); };
  return std::hypot(off(0), off(1));
}

// Newton's method for the nearest point, from a parameter near its own.
double improved_foot(const PlanarCurve& curve, const Vec2& target, double t) {
  const Interval domain = curve.domain();
  for (int i = 0; i < kNewtonSteps; ++i) {
    const PlanarJet jet = jet_at(curve, t);
    const Vec2 off = jet.point - target;
    const double slope = dot(jet.first, jet.first) + std::max(0.0, dot(off, jet.second));
    if (!(slope > 0)) break;
    t = std::clamp(t - dot(off, jet.first) / slope, domain.from, domain.to);
  }
  return t;
}

// The parameter of an edge's point that is nearest to another point, or as near as it but for
// little: pieces that may hold a nearer one are halved, nearest boxes first.
double foot_on(const Coedge& edge, const Vec2& target) {
  struct Piece {
    double least = 0;  // distance of its box
    double size = 0;   // of its box
    std::size_t span = 0;
    Interval local{0, 1};
  };
  const auto is_farther = [](const Piece& a, const Piece& b) { return a.least > b.least; };
  std::priority_queue<Piece, std::vector<Piece>, decltype(is_farther)> pieces(is_farther);
  const auto add = [&](const PlanarBox& box, std::size_t span, const Interval& local) {
    pieces.push({distance_to(box, target), distance(box.low, box.high), span, local});
  };
  double largest = 0;
  for (std::size_t i = 0; i < edge.boxes.size(); ++i) {
    add(edge.boxes[i], i, {0, 1});
    largest = std::max(largest, distance(edge.boxes[i].low, edge.boxes[i].high));
  }
  for (;;) {
    const Piece piece = pieces.top();
    pieces.pop();
    const PlanarSpan& span = edge.curve.spans[piece.span];
    const double middle = 0.5 * (piece.local.from + piece.local.to);
    if (piece.size <= kFootPiece * largest || length(piece.local) < kMinPiece)
      return improved_foot(edge.curve, target, parameter_at(span.law, span.place, middle));
    for (const Interval& half :
         {Interval{piece.local.from, middle}, Interval{middle, piece.local.to}})
      add(box_of(bezier_piece(span.curve, half).points), piece.span, half);
  }
}

// --- an edge in space

// Where a face has an edge: the image of its chart curve.
class EdgeOnFace {
 public:
  EdgeOnFace(const FaceTrims& trims, const Coedge& coedge)
      : surface_(trims.face, false), coedge_(coedge), scale_(trims.scale) {}

  Vec3 point(double t) const {
    const Vec2 x = point_at(coedge_.curve, t);
    const gp_Pnt p = surface_.Value(x[0] / scale_[0], x[1] / scale_[1]);
    return {p.X(), p.Y(), p.Z()};
  }

  Vec3 tangent(double t) const {
    const PlanarJet x = jet_at(coedge_.curve, t);
    gp_Pnt p;
    gp_Vec du, dv;
    surface_.D1(x.point[0] / scale_[0], x.point[1] / scale_[1], p, du, dv);
    const gp_Vec d = du * (x.first[0] / scale_[0]) + dv * (x.first[1] / scale_[1]);
    return {d.X(), d.Y(), d.Z()};
  }

 private:
  BRepAdaptor_Surface surface_;
  const Coedge& coedge_;
  const Vec2 scale_;
};

// An edge as the first face has it: that is where paths lead along it.
class CommonEdge {
 public:
  CommonEdge(const FaceTrims& trims_a, const FaceTrims& trims_b, const SharedEdge& shared,
             const Coedge& a, const Coedge& b)
      : on_a(a),
        on_b(b),
        shared_(shared),
        image_(trims_a, a),
        gap_(largest_gap(image_, EdgeOnFace(trims_b, b), shared.curve.sample_parameters)) {
    const std::vector<double>& at = shared.curve.sample_parameters;
    for (std::size_t i = 0; i + 1 < at.size(); ++i)
      directions_.push_back({image_.tangent(at[i]), image_.point(at[i + 1]) - image_.point(at[i]),
                             image_.tangent(at[i + 1])});
  }

  /// Of the pieces between samples that meet a range.
  std::vector<Vec3> directions(const Interval& range) const {
    const std::vector<double>& at = shared_.curve.sample_parameters;
    std::vector<Vec3> along;
    for (std::size_t i = 0; i + 1 < at.size(); ++i)
      if (at[i] <= range.to && range.from <= at[i + 1])
        along.insert(along.end(), directions_[i].begin(), directions_[i].end());
    return along;
  }

  /// Of the two faces' images, at samples.
  double gap() const { return gap_; }
  double tolerance() const { return shared_.tolerance; }
  Vec3 point(double t) const { return image_.point(t); }

  const Coedge& on_a;
  const Coedge& on_b;

 private:
  static double largest_gap(const EdgeOnFace& a, const EdgeOnFace& b, const std::vector<double>& at) {
    double gap = 0;
    for (std::size_t i = 0; i + 1 < at.size(); ++i)
      for (const double part : {0.0, 0.3, 0.5, 0.8, 1.0}) {
        const double t = blossom::at(Interval{at[i], at[i + 1]}, part);
        gap = std::max(gap, distance(a.point(t), b.point(t)));
      }
    return gap;
  }

  const SharedEdge& shared_;
  EdgeOnFace image_;
  double gap_;
  std::vector<std::array<Vec3, 3>> directions_;
};

// --- a face

// Parameter lines that lead from all points of a cell which count to an edge.
struct WaysToEdge {
  Interval on_edge;                      // where they may end
  std::vector<VectorBounds> directions;  // in space
  double shortfall = 0;                  // by so much they may miss the edge's end
};

class CellsOfFace {
 public:
  CellsOfFace(const FaceData& data, const Vec3& origin)
      : data_(data),
        cells_(data.surface, origin, CellForm::Auto, kCut, part_test(data.trims)),
        slopes_(static_cast<std::size_t>(cells_.patches())) {}

  SurfaceCells& cells() { return cells_; }

  /// Whether nothing of a cell counts, looked at more closely than cells are.
  bool is_outside(int patch, const Cell& cell) const {
    if (cell.part != PartSide::Mixed) return cell.part == PartSide::Outside;
    const PlanarBox box = chart_box(patch, cell);
    return !meets_gap(box) &&
           coedge_near(data_.trims, box, 0, kMaxHalvings, Wires::AsTheyAre) == nullptr &&
           !is_inside(data_.trims, 0.5 * (box.low + box.high));
  }

  double nearest_on(const Coedge& edge, int patch, const Cell& cell) const {
    return foot_of(edge, chart_box(patch, cell));
  }

  std::optional<WaysToEdge> ways(const Coedge& edge, int patch, const Cell& cell) {
    const PlanarBox box = chart_box(patch, cell);
    const std::optional<Stretch> stretch = stretch_over(edge, box);
    if (!stretch || !is_beside(edge, *stretch, box)) return {};
    const int across = 1 - stretch->along;
    PlanarBox swept = box;
    swept.low[across] = std::min(box.low[across], stretch->box.low[across]);
    swept.high[across] = std::max(box.high[across], stretch->box.high[across]);
    return WaysToEdge{stretch->range, directions(swept, across, -stretch->inner),
                      stretch->shortfall};
  }

 private:
  // A stretch of an edge that is a graph over one chart coordinate of a cell.
  struct Stretch {
    Interval range;
    int along = 0;         // the coordinate that grows or falls all along it
    double inner = 0;      // sign: the face is there by the other coordinate
    PlanarBox box;         // of the stretch
    double shortfall = 0;  // its end does not reach the cell's by so much
  };

  // Whether a box meets what closes a gap between the ends of coedges.
  bool meets_gap(const PlanarBox& box) const {
    if (data_.trims.largest_gap == 0) return false;
    const auto is_in_gap = [&](const Coedge& coedge, int corner, bool start) {
      const Interval domain = coedge.curve.domain();
      const Vec2 end = point_at(coedge.curve, start == coedge.reversed() ? domain.to : domain.from);
      const Vec2& joint = data_.trims.corners[static_cast<std::size_t>(corner)];
      return !apart(box, united({end, end}, {joint, joint}));
    };
    for (const auto& loop : data_.trims.loops)
      for (const Coedge& coedge : loop)
        if (is_in_gap(coedge, coedge.from, true) || is_in_gap(coedge, coedge.to, false))
          return true;
    return false;
  }

  PlanarBox chart_box(int patch, const Cell& cell) const {
    const BezierSurface& s = data_.surface;
    const Interval u = cells_.knots_u(patch), v = cells_.knots_v(patch);
    const Vec2& scale = data_.trims.scale;
    return {{parameter_at(s.u_law, u, cell.u.from) * scale[0],
             parameter_at(s.v_law, v, cell.v.from) * scale[1]},
            {parameter_at(s.u_law, u, cell.u.to) * scale[0],
             parameter_at(s.v_law, v, cell.v.to) * scale[1]}};
  }

  static double foot_of(const Coedge& edge, const PlanarBox& box) {
    return foot_on(edge, 0.5 * (box.low + box.high));
  }

  std::optional<Stretch> stretch_over(const Coedge& edge, const PlanarBox& box) const {
    const double foot = foot_of(edge, box);
    const PlanarJet at_foot = jet_at(edge.curve, foot);
    if (distance_to(box, at_foot.point) > kFar * distance(box.low, box.high)) return {};
    const Vec2 way = at_foot.first;
    Stretch stretch;
    stretch.along = std::abs(way[0]) >= std::abs(way[1]) ? 0 : 1;
    const int k = stretch.along;
    if (way[k] == 0) return {};
    const double sign = way[k] > 0 ? 1 : -1;
    const double past = kPast * width(box, k);
    const double low = box.low[k] - past, high = box.high[k] + past;
    stretch.range.from = reached(edge.curve, foot, k, sign > 0 ? low : high, 0.5 * past, -1);
    stretch.range.to = reached(edge.curve, foot, k, sign > 0 ? high : low, 0.5 * past, 1);
    if (!(stretch.range.from < stretch.range.to)) return {};
    const std::vector<PlanarBezier> pieces = bezier_pieces(edge.curve, stretch.range);
    if (pieces.empty()) return {};
    stretch.box = box_of(pieces.front().points);
    for (const PlanarBezier& piece : pieces) {
      if (!grows(piece, k, sign)) return {};
      stretch.box = united(stretch.box, box_of(piece.points));
    }
    stretch.shortfall =
        std::max({0.0, stretch.box.low[k] - box.low[k], box.high[k] - stretch.box.high[k]});
    const double walk = edge.reversed() ? -sign : sign;
    stretch.inner = k == 0 ? walk : -walk;  // a face is on the left of its wires
    return stretch;
  }

  // A parameter at which a coordinate has got past a value by no more than `precision`, going on
  // from `start`; the end of the curve if it does not get there.
  static double reached(const PlanarCurve& curve, double start, int k, double value,
                        double precision, int way) {
    const Interval domain = curve.domain();
    const double end = way > 0 ? domain.to : domain.from;
    const bool above = point_at(curve, start)[k] > value;
    const auto is_there = [&](double t) { return (point_at(curve, t)[k] > value) != above; };
    const double slope = std::abs(jet_at(curve, start).first[k]);
    double step = std::abs(point_at(curve, start)[k] - value) / slope, last = start;
    for (;;) {
      double next = start + way * step;
      if ((end - next) * way <= 0) next = end;
      if (is_there(next)) {
        const auto is_exact = [&] {
          return std::abs(point_at(curve, next)[k] - value) <= precision;
        };
        for (int i = 0; i < kBisections && !is_exact(); ++i) {
          const double middle = 0.5 * (last + next);
          (is_there(middle) ? next : last) = middle;
        }
        return next;
      }
      if (next == end) return end;
      last = next;
      step = std::max(2 * step, 1e-12 * length(domain));
    }
  }

  // Whether all of the cell that counts is on the face's side of the stretch.
  bool is_beside(const Coedge& edge, const Stretch& stretch, const PlanarBox& box) const {
    const Interval domain = edge.curve.domain();
    if (coedge_near(data_.trims, box, 0, kMaxHalvings, Wires::AsTheyAre, &edge) != nullptr ||
        meets(edge, {domain.from, stretch.range.from}, box) ||
        meets(edge, {stretch.range.to, domain.to}, box))
      return false;
    if (meets(edge, stretch.range, box)) return true;
    const Vec2 centre = 0.5 * (box.low + box.high);
    if (!is_inside(data_.trims, centre)) return true;
    const int k = stretch.along;
    const double t = where(edge.curve, stretch.range, k, centre[k]);
    return stretch.inner * (centre[1 - k] - point_at(edge.curve, t)[1 - k]) > 0;
  }

  // Of a curve that is a graph over a coordinate: the parameter at a value of it.
  static double where(const PlanarCurve& curve, Interval range, int k, double value) {
    const bool rising = point_at(curve, range.to)[k] > point_at(curve, range.from)[k];
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (range.from + range.to);
      ((point_at(curve, middle)[k] > value) == rising ? range.to : range.from) = middle;
    }
    return range.from;
  }

  // Of the derivatives across, over all patches that a rectangle of the chart meets.
  std::vector<VectorBounds> directions(const PlanarBox& box, int across, double sign) {
    const BezierSurface& s = data_.surface;
    std::vector<VectorBounds> all;
    for (int patch = 0; patch < cells_.patches(); ++patch) {
      const auto u = local(s.u_law, cells_.knots_u(patch), box, 0);
      const auto v = local(s.v_law, cells_.knots_v(patch), box, 1);
      if (!u || !v) continue;
      const DirectionCones cones = cones_of(slopes(patch), *u, *v, kAxes);
      const VectorBounds& bounds = across == 0 ? cones.u : cones.v;
      all.push_back({sign * bounds.middle, bounds.radius});
    }
    return all;
  }

  std::optional<Interval> local(ParameterLaw law, const Interval& span, const PlanarBox& box,
                                int k) const {
    const double from = box.low[k] / data_.trims.scale[k], to = box.high[k] / data_.trims.scale[k];
    if (from > span.to || to < span.from) return {};
    const auto at = [&](double t) {
      return std::clamp(local_parameter(law, span, std::clamp(t, span.from, span.to)), 0.0, 1.0);
    };
    return Interval{at(from), at(to)};
  }

  const SlopeNets& slopes(int patch) {
    auto& nets = slopes_[static_cast<std::size_t>(patch)];
    if (!nets) {
      const CellTree& tree = cells_.tree(patch);
      nets = slope_nets(tree.patch(), tree.shape().planes == 4, tree.given_rounding());
    }
    return *nets;
  }

  const FaceData& data_;
  SurfaceCells cells_;
  std::vector<std::optional<SlopeNets>> slopes_;
};

// --- the proof

const Coedge* only_use(const FaceTrims& trims, const TopoDS_Edge& edge) {
  const Coedge* use = nullptr;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      if (!coedge.edge.IsSame(edge)) continue;
      if (use != nullptr) return nullptr;
      use = &coedge;
    }
  return use;
}

std::vector<KnownCurve> common_vertices(const FaceData& a, const FaceData& b, double tolerance) {
  TopTools_IndexedMapOfShape of_a, of_b;
  TopExp::MapShapes(a.trims.face, TopAbs_VERTEX, of_a);
  TopExp::MapShapes(b.trims.face, TopAbs_VERTEX, of_b);
  std::vector<KnownCurve> balls;
  for (int i = 1; i <= of_a.Extent(); ++i) {
    if (!of_b.Contains(of_a(i))) continue;
    const TopoDS_Vertex vertex = TopoDS::Vertex(of_a(i));
    const gp_Pnt p = BRep_Tool::Pnt(vertex);
    const Vec3 point{p.X(), p.Y(), p.Z()};
    const double radius = kReach * std::max(tolerance, BRep_Tool::Tolerance(vertex));
    balls.push_back({{point, point}, radius, 0});
  }
  return balls;
}

class Proof {
 public:
  Proof(const FaceData& a, const FaceData& b, double tolerance, const WorkLimit& limit)
      : a_data_(a),
        b_data_(b),
        tolerance_(tolerance),
        limit_(limit),
        origin_(0.5 * (a.box.low + a.box.high)),
        rounding_(kRounding * (max_norm(origin_) + diagonal(a.box))),
        balls_(common_vertices(a, b, tolerance), origin_),
        a_(a, origin_),
        b_(b, origin_) {}

  bool add_edges(const std::vector<SharedEdge>& edges) {
    for (const SharedEdge& edge : edges) {
      const Coedge* on_a = only_use(a_data_.trims, edge.edge);
      const Coedge* on_b = only_use(b_data_.trims, edge.edge);
      if (on_a == nullptr || on_b == nullptr) return false;
      edges_.emplace_back(a_data_.trims, b_data_.trims, edge, *on_a, *on_b);
    }
    return true;
  }

  bool holds() {
    const PatchBoxes boxes_a(a_data_.surface), boxes_b(b_data_.surface);
    for (const auto& [i, j] : meeting_patches(boxes_a, boxes_b)) {
      pairs_ = 0;
      if (!holds(i, 0, j, 0)) return false;
    }
    return true;
  }

  const Certificate& certificate() const { return certificate_; }

 private:
  bool holds(int patch_a, int cell_a, int patch_b, int cell_b) {
    if (++pairs_ > kMaxPairs || (pairs_ % 64 == 0 && limit_.reached() != nullptr)) return false;
    CellTree &tree_a = a_.cells().tree(patch_a), &tree_b = b_.cells().tree(patch_b);
    const Cell a = tree_a[cell_a], b = tree_b[cell_b];
    if (are_apart(tree_a, a, tree_b, b) ||
        separated_across(a, b, tree_a.shape().plane_size(), tree_b.shape().plane_size()) ||
        balls_.hold_common({a.low, a.high}, {b.low, b.high}) || a_.is_outside(patch_a, a) ||
        b_.is_outside(patch_b, b) || std::ranges::any_of(edges_, [&](const CommonEdge& edge) {
          return meet_beside(edge, patch_a, a, patch_b, b);
        })) {
      ++certificate_.excluded;
      certificate_.depth = std::max({certificate_.depth, a.depth, b.depth});
      certificate_.rounding_bound = std::max({certificate_.rounding_bound, a.margin, b.margin});
      return true;
    }
    if (a.depth >= kDeepest && b.depth >= kDeepest) return false;
    const bool of_a = b.depth >= kDeepest || (a.depth < kDeepest && a.extent >= b.extent);
    const int child = of_a ? tree_a.split(cell_a) : tree_b.split(cell_b);
    return of_a ? holds(patch_a, child, patch_b, cell_b) &&
                      holds(patch_a, child + 1, patch_b, cell_b)
                : holds(patch_a, cell_a, patch_b, child) &&
                      holds(patch_a, cell_a, patch_b, child + 1);
  }

  // In the tube round the edge, or such that paths lead from one to the other.
  bool meet_beside(const CommonEdge& edge, int patch_a, const Cell& a, int patch_b, const Cell& b) {
    const double reach = kReach * std::max(tolerance_, edge.tolerance());
    if (std::min(a.extent, b.extent) < reach && is_in_tube(edge, reach, patch_a, a, b)) return true;
    const std::optional<WaysToEdge> to = a_.ways(edge.on_a, patch_a, a);
    if (!to) return false;
    const std::optional<WaysToEdge> from = b_.ways(edge.on_b, patch_b, b);
    if (!from) return false;
    std::vector<VectorBounds> across = to->directions;
    for (const VectorBounds& way : from->directions) across.push_back({-way.middle, way.radius});
    const Interval range{std::min(to->on_edge.from, from->on_edge.from),
                         std::max(to->on_edge.to, from->on_edge.to)};
    const double jumps = edge.gap() + to->shortfall + from->shortfall + a_data_.surface.error +
                         b_data_.surface.error + rounding_;
    return path_reach(across, edge.directions(range)) * jumps <= reach;
  }

  bool is_in_tube(const CommonEdge& edge, double reach, int patch_a, const Cell& a,
                  const Cell& b) const {
    Box common;
    for (int k = 0; k < 3; ++k) {
      common.low[k] = std::max(a.low[k], b.low[k]);
      common.high[k] = std::min(a.high[k], b.high[k]);
    }
    const Vec3 centre = 0.5 * (common.low + common.high) + origin_;
    const Vec3 foot = edge.point(a_.nearest_on(edge.on_a, patch_a, a));
    return distance(centre, foot) + 0.5 * diagonal(common) <= reach;
  }

  const FaceData& a_data_;
  const FaceData& b_data_;
  const double tolerance_;
  const WorkLimit& limit_;
  const Vec3 origin_;
  const double rounding_;
  const KnownCurves balls_;
  CellsOfFace a_, b_;
  std::vector<CommonEdge> edges_;
  long pairs_ = 0;  // of the patches at hand
  Certificate certificate_;
};

}  // namespace

NeighbourProof meet_in_shared_only(const FaceData& a, const FaceData& b,
                                   const std::vector<SharedEdge>& edges, double tolerance,
                                   const WorkLimit& limit) {
  Proof proof(a, b, tolerance, limit);
  if (!proof.add_edges(edges) || !proof.holds()) return {};
  return {true, proof.certificate()};
}

}  // namespace blossom::occt
