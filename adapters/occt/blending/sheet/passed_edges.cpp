// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges that are too tight for the ball, between two with strips: as if they had no length, their
// vertices are one corner. The strips beside them end where their contacts cross on the one side,
// and where those come to the rounding that is passed on the other, along lines in their own
// parameters, and a fill closes what is left.
//
// Its borders are those of the part of a sphere where ball and rounding are of one radius, and near
// the mitre of the strips as the rounding gets smaller.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/faces/surface_projector.h"

namespace blossom::occt {
namespace {

constexpr int kSideSamples = 5;  // in each direction of a patch

}  // namespace

// All edges round a vertex; in the place of one that is passed, those that are round its other
// vertex. Edges that lead back to where they come from make no corner.
BlendSheet::Ring BlendSheet::ring_at(const DirectedEdge& half, std::vector<int>& passed) const {
  Ring merged;
  for (const VertexSector& each : body_.round(half)) {
    if (each.half == half || passed_.count(each.half.edge) == 0) {
      merged.push_back(each);
      continue;
    }
    if (std::ranges::find(passed, each.half.edge) != passed.end())
      refuse(each.half, FilletFault::Corner,
             "the edges that are passed there form a ring: they cannot become one corner");
    passed.push_back(each.half.edge);
    const Ring behind = ring_at({each.half.edge, !each.half.at_start}, passed);
    merged.insert(merged.end(), behind.begin() + 1, behind.end());
  }
  return merged;
}

// Where a strip ends beside an edge that is passed, on one of its sides. Where the strip behind has
// its contact on the same face, and both do not cross, in its section through the vertex.
void BlendSheet::end_beside_passed(const Ring& ring, std::size_t sector, bool on_left,
                                   std::map<std::size_t, double>& cuts) {
  const std::size_t count = ring.size();
  const std::size_t next = (sector + (on_left ? 1 : count - 1)) % count;
  const DirectedEdge half = ring[sector].half, beside = ring[next].half;
  const PlacedStrip& of = strip_of(half);
  const std::size_t side = on_left ? left_side(half) : right_side(half);
  StripEnd& end = end_of(half);
  end.t[side] = end_t(half);
  if (is_filleted(beside.edge)) {
    if (const auto met = stop_beside(ring, sector, on_left)) end.t[side] = *met;
  } else {
    const EdgeUseInFace& use =
        on_left ? arriving(ring, sector)
                : body_.uses(ring[next].face)[static_cast<std::size_t>(ring[next].use)];
    const auto meeting = meeting_with(body_, of.strip, side, use, end_t(half));
    if (!meeting) refuse_miss(half, side, use, beside);
    end.t[side] = meeting->t;
    end.vertices[side] =
        cut_edge(beside, meeting->edge_parameter, body_.face(of.strip.contacts[side].face));
    if (!cuts.emplace(next, meeting->edge_parameter).second)
      refuse(half, FilletFault::Corner,
             "its strip and that beside it come to edge " + std::to_string(beside.edge) +
                 " from both sides");
  }
  if ((is_low_end(half) ? 1 : -1) * (of.inside - end.t[side]) <= 0)
    refuse(half, FilletFault::EdgeConsumed,
           "what is beside its strip meets it beyond its middle: " + too_large());
  if (is_filleted(beside.edge))
    end.vertices[side] = new_vertex(vec(of.strip.contacts[side].curve->Value(end.t[side])));
}

// A ball that is too large for an edge lies between those beside it already, so that the contacts
// there cross on one side; where they do not, strips would lie beyond each other.
void BlendSheet::end_at_passed(const Ring& ring) {
  const std::size_t count = ring.size();
  std::map<std::size_t, double> cuts;  // by sector
  for (std::size_t i = 0; i < count; ++i)
    if (is_filleted(ring[i].half.edge))
      for (const bool on_left : {true, false}) end_beside_passed(ring, i, on_left, cuts);
  const DirectedEdge first = ring.front().half;
  bool crosses = false;
  std::vector<SetbackSide> sides;
  for (std::size_t i = 0; i < count; ++i) {
    const DirectedEdge half = ring[i].half, next = ring[(i + 1) % count].half;
    const bool has_strip = is_filleted(half.edge), has_next = is_filleted(next.edge);
    if (!has_strip && cuts.count(i) == 0)
      refuse(first, FilletFault::Corner,
             "edge " + std::to_string(half.edge) +
                 " is in its corner between others: how strips "
                 "meet there cannot be built yet");
    if (has_strip) sides.push_back(slanted_side(half));
    if (has_strip != has_next) continue;  // the contact ends in the other edge
    const TopoDS_Vertex from = has_strip ? end_of(half).vertices[left_side(half)]
                                         : cut_edge(half, cuts.at(i), body_.face(ring[i].face));
    const bool is_crossing = has_strip && from.IsSame(end_of(next).vertices[right_side(next)]);
    crosses = crosses || is_crossing;
    if (is_crossing) continue;
    sides.push_back(path_side(ring, i, cuts));
    sides.back().from = from;
  }
  if (!crosses)
    refuse(first, FilletFault::Corner,
           "the strips beside it lie beyond each other: " + too_large());
  const std::size_t first_patch = patches_.size();
  fill_corner(ring, sides);
  if (!keeps_side(ring, first_patch))
    refuse(first, FilletFault::Corner,
           "what would fill its corner goes beyond the faces beside it: " + too_large());
}

// Whether what fills a corner of strips of one kind keeps to their side of the faces round it:
// takes material away at convex edges, and adds it at concave ones.
bool BlendSheet::keeps_side(const Ring& ring, std::size_t first_patch) const {
  const double sign = strip_of(ring.front().half).strip.concave ? -1 : 1;
  for (const VertexSector& sector : ring) {
    const TopoDS_Face& face = body_.face(sector.face);
    const SurfaceProjector on(face, Precision::Confusion());
    const double outwards = face.Orientation() == TopAbs_REVERSED ? -sign : sign;
    const auto is_beyond = [&](const Vec3& point) {
      return outwards * on.height(point) > kSamePlace * tolerance_ &&
             lies_inside(body_, sector.face, on.foot(point, std::nullopt));
    };
    for (std::size_t i = first_patch; i < patches_.size(); ++i) {
      const Handle(Geom_Surface) surface = BRep_Tool::Surface(patches_[i].face);
      for (int k = 0; k < kSideSamples * kSideSamples; ++k) {
        const double u = (k / kSideSamples + 0.5) / kSideSamples,
                     v = (k % kSideSamples + 0.5) / kSideSamples;
        if (is_beyond(vec(surface->Value(u, v)))) return false;
      }
    }
  }
  return true;
}

void BlendSheet::pass(const Ring& ring, const std::vector<int>& passed) {
  try {
    end_at_passed(ring);
  } catch (const FilletRefused& refusal) {
    FilletRefusal why = passed_.at(passed.front());
    why.cause += ", and its corner cannot be filled: " + refusal.why().cause;
    throw FilletRefused(why);
  }
  notes_.push_back("edge " + std::to_string(passed.front()) +
                   ": its curvature leaves no room for the " + (is_chamfer_ ? "chamfer" : "ball") +
                   ": its corner is filled between the strips beside it");
}

}  // namespace blossom::occt
