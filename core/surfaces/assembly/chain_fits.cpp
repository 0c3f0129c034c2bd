// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/assembly/chain_fits.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "core/base/parallel.h"
#include "core/surfaces/branches/spurious_branches.h"
#include "core/tracing/fit.h"
#include "core/tracing/trace.h"

namespace blossom {
namespace {

constexpr double kPoint = 1e-12;         // of the size: so long is what stays in a cone's apex
constexpr double kAtCorner = 1e-9;       // of the range of a surface's parameters
constexpr std::size_t kFitsAtOnce = 32;  // chains, until it is asked whether to go on

// Surfaces that are so little apart in a node meet in it: at the smallest angles that curves are
// fitted for, 1e-3 radians, this is 0.1 tolerances beside them.
constexpr double kRounding = 1e-4;

// A curve that leaves the surfaces by so many tolerances and so much of their size is none.
constexpr double kWorst = 100;
constexpr double kWorstOfSize = 1e-4;

// True if some arc of the chain is marked so.
bool any_arc(const PairSearchResult& found, const Chain& chain, bool CellArc::*mark) {
  return std::ranges::any_of(chain.links, [&](const ChainLink& link) {
    return found.arcs[static_cast<std::size_t>(link.arc)].arc.*mark;
  });
}

bool is_corner(const BezierSurface& surface, const Vec2& uv) {
  const auto ends = [](const std::vector<double>& knots, double parameter) {
    const double to_end = std::min(parameter - knots.front(), knots.back() - parameter) /
                          (knots.back() - knots.front());
    return to_end <= kAtCorner;
  };
  return ends(surface.u_knots, uv[0]) && ends(surface.v_knots, uv[1]);
}

// Whether a chain leads from corner to corner of a surface. It runs along the border then, however
// short that is, while one that only touches the border stays within tolerance of it for a while.
bool covers_border(const FitContext& context, const ChainTracer& tracer) {
  const TracePoint from = tracer.at(0, true), to = tracer.at(tracer.stations().back(), false);
  return (is_corner(context.a, from.a) && is_corner(context.a, to.a)) ||
         (is_corner(context.b, from.b) && is_corner(context.b, to.b));
}

std::optional<IntersectionCurve> fitted_chain(const FitContext& context, const Chain& chain) {
  const double tolerance = context.tolerance;
  const ChainTracer tracer(context.found, context.cells_a, context.cells_b, context.origin, chain,
                           kRounding * tolerance);
  const double length = tracer.stations().back();
  const bool is_short = length <= kShortestBranch * tolerance;
  const bool is_point = length <= kPoint * context.size;
  if (is_short && (belongs_to_contact(chain) || chain.closed || is_point)) return {};
  if (any_arc(context.found, chain, &CellArc::runs_along_border) &&
      length <= context.contact_length && !covers_border(context, tracer))
    return {};
  const bool tangential = any_arc(context.found, chain, &CellArc::tangential);
  IntersectionCurve curve =
      fitted(tracer, context.a, context.b,
             {.tolerance = tolerance,
              .gap = tangential ? context.gap : 0,
              .size = context.size,
              .most = std::max(kWorst * tolerance, kWorstOfSize * context.size),
              .work = &context.limit});
  curve.tangential = tangential;
  if (tangential || any_arc(context.found, chain, &CellArc::straight)) curve.least_angle = 0;
  return curve;
}

}  // namespace

bool belongs_to_contact(const Chain& chain) {
  return !chain.closed && std::ranges::any_of(chain.ends, [](const ChainEnd& end) {
    return end.contact >= 0 || end.cluster >= 0;
  });
}

ChainFits fitted_chains(const FitContext& context, const std::vector<Chain>& chains) {
  IntersectionCurve untraced;
  untraced.length = std::numeric_limits<double>::quiet_NaN();
  ChainFits fits;
  fits.curves.assign(chains.size(), untraced);
  for (std::size_t first = 0; first < chains.size(); first += kFitsAtOnce) {
    fits.stopped = context.limit.reached_after_search();
    if (fits.stopped != nullptr) break;
    parallel_for(std::min(kFitsAtOnce, chains.size() - first), 1, [&](std::size_t i) {
      fits.curves[first + i] = fitted_chain(context, chains[first + i]);
    });
  }
  return fits;
}

}  // namespace blossom
