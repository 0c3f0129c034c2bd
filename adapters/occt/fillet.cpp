// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/fillet.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/sheet/fillet_limit.h"
#include "adapters/occt/blending/sheet/filleting.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

void check_request(const BodyEdges& body, const std::vector<int>& edges,
                   const FilletOptions& options) {
  const auto check_length = [](double length, const char* what) {
    if (!(length > 0) || !std::isfinite(length))
      throw InvalidInput(std::string("fillet: the ") + what + " has to be positive and finite");
  };
  check_length(options.radius, "radius");
  check_length(options.last_radius.value_or(1), "last radius");
  if (options.rho && !(*options.rho > 0 && *options.rho < 1))
    throw InvalidInput("fillet: rho has to be between 0 and 1");
  if (options.chamfer) {
    check_length(options.chamfer->first, "distance");
    check_length(options.chamfer->second.value_or(1), "second distance");
    const double angle = options.chamfer->angle.value_or(1);
    if (!(angle > 0 && angle < std::numbers::pi))
      throw InvalidInput("fillet: the angle has to be between 0 and pi");
  }
  if (edges.empty()) throw InvalidInput("fillet: no edge is named");
  for (const int edge : edges)
    if (edge < 1 || edge > body.edge_count())
      throw InvalidInput("fillet: there is no edge " + std::to_string(edge) + ", only 1 to " +
                         std::to_string(body.edge_count()));
}

// The chains of the edges that can have fillets; the others are refused.
std::vector<FilletEdges> chains_of(const BodyEdges& body, const std::vector<int>& edges,
                                   std::vector<FilletRefusal>& refused) {
  std::vector<FilletEdges> chains;
  for (const int edge : edges) {
    if (std::ranges::any_of(chains, [&](const auto& chain) { return chain.count(edge) > 0; }))
      continue;
    try {
      chains.push_back(smooth_chain(body, edge));
    } catch (const FilletRefused& refusal) {
      refused.push_back(refusal.why());
    }
  }
  return chains;
}

// The parameter of the edge at fault that is nearest to the place.
void add_parameter(const BodyEdges& body, FilletRefusal& why) {
  if (why.edge < 1 || !why.point || why.parameter) return;
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(body.edge(why.edge), range.from, range.to);
  if (!curve.IsNull()) why.parameter = nearest_on(curve, range, *why.point);
}

// The largest radius of the edge at fault, where it is the radius that does not fit.
void add_limit(const BodyEdges& body, const std::vector<FilletEdges>& chains, double radius,
               FilletRefusal& why) {
  const bool of_radius = why.fault == FilletFault::NoBall || why.fault == FilletFault::Pinch ||
                         why.fault == FilletFault::LeavesFace;
  if (!of_radius || why.largest) return;
  for (const FilletEdges& chain : chains) {
    const auto edge = chain.find(why.edge);
    if (edge == chain.end()) continue;
    if (const auto limit = fillet_limit(body, edge->first, edge->second, radius)) {
      why.largest = limit->radius;
      why.cause += "; larger balls are stopped by " + limit->cause;
    }
  }
}

// What went wrong where no edge is known to be at fault.
FilletRefusal not_put_together(const std::exception& error) {
  return {FilletFault::Result,
          0,
          std::string("the strips cannot be put into the solid together: ") + error.what(),
          {},
          {},
          {}};
}

// Chains that are made together, or why they cannot be.
struct Attempt {
  std::vector<FilletedSolid> solids;
  std::vector<std::string> notes;
  std::optional<FilletRefusal> why;
};

// throws   LimitFailure
Attempt attempt(Filleting& work, const std::vector<FilletEdges>& chains) {
  FilletEdges all;
  for (const FilletEdges& chain : chains) all.insert(chain.begin(), chain.end());
  try {
    Attempt made{guarded(kFilleting, [&] { return work.made(all); }), {}, {}};
    made.notes = work.notes();
    return made;
  } catch (const FilletRefused& refusal) {
    return {{}, {}, refusal.why()};
  } catch (const LimitFailure&) {
    throw;
  } catch (const Failure& failure) {
    return {{}, {}, not_put_together(failure)};
  } catch (const BadModel& error) {
    return {{}, {}, not_put_together(error)};
  }
}

// Whether a chain has its fault alone, whatever else is rounded.
bool is_own_fault(FilletFault fault) {
  return fault == FilletFault::Edge || fault == FilletFault::NoBall ||
         fault == FilletFault::Pinch || fault == FilletFault::LeavesFace;
}

// As many chains as go together: one after the other is added to those that work, until no more
// can be. The others are refused, each with what it met there.
Attempt as_many_as_work(Filleting& work, std::vector<FilletEdges>& chains,
                        const std::function<void(const FilletRefusal&)>& refuse) {
  Attempt best;
  std::vector<FilletEdges> kept, open = std::move(chains);
  std::vector<FilletRefusal> causes;
  for (bool changed = true; changed;) {
    changed = false;
    causes.clear();
    std::vector<FilletEdges> left;
    for (FilletEdges& chain : open) {
      kept.push_back(chain);
      Attempt next = attempt(work, kept);
      changed = changed || !next.why;
      if (!next.why) {
        best = std::move(next);
        continue;
      }
      kept.pop_back();
      if (chain.count(next.why->edge) == 0) next.why->edge = chain.begin()->first;
      causes.push_back(*next.why);
      left.push_back(std::move(chain));
    }
    open = std::move(left);
  }
  chains = open;  // those at fault, while the reasons are told
  for (const FilletRefusal& why : causes) refuse(why);
  chains = std::move(kept);
  return best;
}

}  // namespace

FilletResult fillet(const TopoDS_Shape& shape, const std::vector<int>& edges,
                    const FilletOptions& options) {
  if (shape.IsNull()) throw InvalidInput("fillet: there is no shape");
  FilletResult result;
  Filleting work(shape, options);
  check_request(work.body(), edges, options);
  if (options.volumes) result.volume_before = work.volume_given();
  std::vector<FilletEdges> chains = chains_of(work.body(), edges, result.refused);
  const auto refuse = [&](const FilletRefusal& why) {
    result.refused.push_back(why);
    add_parameter(work.body(), result.refused.back());
    if (!options.chamfer && !options.last_radius && !options.rho)
      add_limit(work.body(), chains, options.radius, result.refused.back());
  };
  try {
    while (!chains.empty() && (options.partial || result.refused.empty())) {
      Attempt made = attempt(work, chains);
      if (made.why) {
        const auto at_fault = std::ranges::find_if(
            chains, [&](const auto& chain) { return chain.count(made.why->edge) > 0; });
        const bool is_own = is_own_fault(made.why->fault) && at_fault != chains.end();
        if (!options.partial || is_own) refuse(*made.why);
        if (!options.partial) return result;
        if (is_own) {
          chains.erase(at_fault);
          continue;
        }
        made = as_many_as_work(work, chains, refuse);
      }
      result.solids = std::move(made.solids);
      result.notes = std::move(made.notes);
      for (const FilletEdges& chain : chains)
        for (const auto& [edge, concave] : chain) result.edges.push_back(edge);
      std::ranges::sort(result.edges);
      return result;
    }
  } catch (const LimitFailure& reached) {
    result.refused.push_back({FilletFault::Result, 0, reached.what(), {}, {}, {}});
    result.status = Status::Stopped;
  }
  return result;
}

}  // namespace blossom::occt
