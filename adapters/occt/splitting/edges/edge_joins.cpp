// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edges/edge_joins.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/edge_charts.h"
#include "core/bounds/box_tree.h"

namespace blossom::occt {
namespace {

constexpr int kSamples = 16;              // intervals of a relation
constexpr int kRelationSteps = 12;        // from a sample's neighbourhood to rounding
constexpr double kMinLength = 50;         // of edges that are joined, in ways they may be apart
constexpr double kSameParameter = 1e-14;  // relative to the range: the steps have settled

/// The other parameter of a pair, by a line between the samples beside it. `known`: which one is
/// given. `falling`: it falls from sample to sample.
double between(const std::vector<Vec2>& samples, int known, double value, bool falling) {
  std::size_t k = 1;
  while (k + 1 < samples.size() &&
         (falling ? value < samples[k][known] : value > samples[k][known]))
    ++k;
  const Vec2 low = samples[k - 1], high = samples[k];
  const int wanted = 1 - known;
  const double run = high[known] - low[known];
  return run == 0 ? low[wanted]
                  : low[wanted] + (value - low[known]) / run * (high[wanted] - low[wanted]);
}

/// Newton's method within a domain; miss(x, rate) is what is left at x, and how it changes there.
template <class Miss>
double settled(double x, const Interval& domain, const Miss& miss) {
  for (int step = 0; step < kRelationSteps; ++step) {
    double rate = 0;
    const double left = miss(x, rate);
    if (rate == 0) break;
    const double next = std::clamp(x + left / rate, domain.from, domain.to);
    const double moved = std::abs(next - x);
    x = next;
    if (moved <= kSameParameter * length(domain)) break;
  }
  return x;
}

struct FreeEdge {
  TopoDS_Edge edge;
  BorderImage image;
  Vec3 from, to;
  double uncertain = 0;    // what its vertices and itself claim
  double length = 0;       // of a polygon through some points
  bool backwards = false;  // as the face, turned as it is, has it
};

bool runs_backwards(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().IsSame(edge)) return it.Current().Orientation() == TopAbs_REVERSED;
  return false;
}

FreeEdge free_edge(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  FreeEdge made{edge, BorderImage(edge, face), {}, {}};
  const Interval domain = made.image.domain();
  made.from = made.image.at(domain.from);
  made.to = made.image.at(domain.to);
  made.uncertain =
      std::max({BRep_Tool::Tolerance(edge), BRep_Tool::Tolerance(TopExp::FirstVertex(edge)),
                BRep_Tool::Tolerance(TopExp::LastVertex(edge))});
  Vec3 last = made.from;
  for (int k = 1; k <= kSamples; ++k) {
    const Vec3 next = made.image.at(at(domain, static_cast<double>(k) / kSamples));
    made.length += distance(last, next);
    last = next;
  }
  made.backwards = runs_backwards(edge, face);
  return made;
}

// How a candidate fits: which way round, and how far apart.
struct Fit {
  std::size_t other = 0;
  bool reversed = false;
  double apart = 0;
};

std::optional<Fit> fit_of(const FreeEdge& a, const FreeEdge& b, std::size_t other,
                          double tolerance) {
  const double reach = std::min(std::max({tolerance, a.uncertain, b.uncertain}),
                                std::min(a.length, b.length) / kMinLength);
  std::optional<Fit> best;
  for (const bool reversed : {false, true}) {
    if ((a.backwards == b.backwards) != reversed) continue;
    const double ends = std::max(distance(a.from, reversed ? b.to : b.from),
                                 distance(a.to, reversed ? b.from : b.to));
    if (ends > reach) continue;
    const double apart = std::max(ends, BorderRelation(a.image, b.image, reversed).apart());
    if (apart <= reach && (!best || apart < best->apart)) best = Fit{other, reversed, apart};
  }
  return best;
}

// The nearest partner of each edge, among those whose ends may be as near as they have to be.
std::vector<std::optional<Fit>> best_fits(const std::vector<FreeEdge>& edges, double tolerance) {
  std::vector<std::optional<Fit>> best(edges.size());
  const auto take = [&](std::size_t i, const Fit& fit) {
    if (!best[i] || fit.apart < best[i]->apart) best[i] = fit;
  };
  std::vector<Box> boxes;
  for (const FreeEdge& edge : edges)
    boxes.push_back(widened(joined({edge.from, edge.from}, {edge.to, edge.to}),
                            std::max(tolerance, edge.uncertain)));
  const BoxTree tree(boxes);
  tree.for_each_meeting(tree, [&](int first, int second) {
    const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
    if (i >= j) return;
    const auto fit = fit_of(edges[i], edges[j], j, tolerance);
    if (!fit) return;
    take(i, *fit);
    take(j, {i, fit->reversed, fit->apart});
  });
  return best;
}

}  // namespace

BorderImage::BorderImage(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  const Handle(Geom2d_Curve) chart = chart_curve_of(edge, face, domain_);
  if (chart.IsNull()) throw BadModel("an edge has no curve in the chart of its face");
  curve_ = new Adaptor3d_CurveOnSurface(new Geom2dAdaptor_Curve(chart, domain_.from, domain_.to),
                                        new GeomAdaptor_Surface(BRep_Tool::Surface(face)));
}

Vec3 BorderImage::at(double parameter) const { return vec(curve_->Value(parameter)); }

void BorderImage::jet_at(double parameter, Vec3& point, Vec3& first) const {
  gp_Pnt p;
  gp_Vec d;
  curve_->D1(parameter, p, d);
  point = vec(p);
  first = vec(d);
}

BorderRelation::BorderRelation(BorderImage first, BorderImage second, bool reversed)
    : first_(std::move(first)), second_(std::move(second)), reversed_(reversed) {
  sample();
}

// Each sample begins where the last one ended, moved on by what is left of both.
void BorderRelation::sample() {
  const Interval s = first_.domain(), t = second_.domain();
  const double start = reversed_ ? t.to : t.from, end = reversed_ ? t.from : t.to;
  pairs_ = {{s.from, start}, {s.to, end}};
  std::vector<Vec2> made{pairs_.front()};
  for (int k = 1; k < kSamples; ++k) {
    const double here = blossom::at(s, static_cast<double>(k) / kSamples);
    const Vec2 last = made.back();
    pairs_ = {last, {s.to, end}};
    made.push_back({here, second_at(here)});
  }
  made.push_back({s.to, end});
  pairs_ = std::move(made);
}

double BorderRelation::apart() const {
  double most = 0;
  for (std::size_t k = 1; k < pairs_.size(); ++k) {
    const double s = 0.5 * (pairs_[k - 1][0] + pairs_[k][0]);
    most = std::max({most, distance(first_.at(pairs_[k][0]), second_.at(pairs_[k][1])),
                     distance(first_.at(s), second_.at(second_at(s)))});
  }
  return most;
}

double BorderRelation::first_at(double second) const {
  if (second == pairs_.front()[1]) return pairs_.front()[0];
  if (second == pairs_.back()[1]) return pairs_.back()[0];
  const Vec3 point = second_.at(second);
  return settled(between(pairs_, 1, second, reversed_), first_.domain(),
                 [&](double s, double& rate) {
                   Vec3 here, along;
                   first_.jet_at(s, here, along);
                   rate = dot(along, along);
                   return dot(point - here, along);
                 });
}

double BorderRelation::second_at(double first) const {
  if (first == pairs_.front()[0]) return pairs_.front()[1];
  if (first == pairs_.back()[0]) return pairs_.back()[1];
  Vec3 point, along;
  first_.jet_at(first, point, along);
  return settled(between(pairs_, 0, first, false), second_.domain(), [&](double t, double& rate) {
    Vec3 here, slope;
    second_.jet_at(t, here, slope);
    rate = dot(slope, along);
    return dot(point - here, along);
  });
}

double apart(const BorderImage& a, const BorderImage& b) {
  double most = 0;
  for (int k = 0; k <= 2 * kSamples; ++k) {
    const double t = at(a.domain(), 0.5 * k / kSamples);
    most = std::max(most, distance(a.at(t), b.at(t)));
  }
  return most;
}

std::vector<EdgeJoin> edge_joins(const TopTools_IndexedDataMapOfShapeListOfShape& faces,
                                 double tolerance) {
  std::vector<FreeEdge> edges;
  for (int k = 1; k <= faces.Extent(); ++k) {
    const TopoDS_Edge edge = TopoDS::Edge(faces.FindKey(k).Oriented(TopAbs_FORWARD));
    if (faces(k).Extent() != 1 || BRep_Tool::Degenerated(edge)) continue;
    edges.push_back(free_edge(edge, TopoDS::Face(faces(k).First())));
  }
  const std::vector<std::optional<Fit>> best = best_fits(edges, tolerance);
  std::vector<EdgeJoin> joins;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!best[i] || best[i]->other < i) continue;
    const std::size_t j = best[i]->other;
    if (!best[j] || best[j]->other != i) continue;
    joins.push_back({edges[i].edge, edges[j].edge, best[i]->reversed,
                     BorderRelation(edges[i].image, edges[j].image, best[i]->reversed)});
  }
  return joins;
}

}  // namespace blossom::occt
