// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/base/tolerances.h"

namespace blossom::occt {
namespace {

constexpr std::array kSides{SurfaceSide::UMin, SurfaceSide::UMax, SurfaceSide::VMin,
                            SurfaceSide::VMax};

/// Points of a pcurve looked at to see whether it runs along a border.
constexpr int kSamples = 9;

/// How far a pcurve may leave a border, as a part of the face's range of parameters.
constexpr double kOnBorder = 1e-6;

bool runs_along_v(SurfaceSide side) {
  return side == SurfaceSide::UMin || side == SurfaceSide::UMax;
}

double constant_of(const ParameterBox& box, SurfaceSide side) {
  switch (side) {
    case SurfaceSide::UMin: return box.u.from;
    case SurfaceSide::UMax: return box.u.to;
    case SurfaceSide::VMin: return box.v.from;
    case SurfaceSide::VMax: break;
  }
  return box.v.to;
}

/// The part of a border, as a fraction of its length, that an edge covers; 0 when it leaves it.
double covered(const TopoDS_Edge& edge, const TopoDS_Face& face, const ParameterBox& box,
               SurfaceSide side) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (pcurve.IsNull()) return 0;
  const bool along_v = runs_along_v(side);
  const Interval& along = along_v ? box.v : box.u;
  const Interval& inwards = along_v ? box.u : box.v;
  double low = 0, high = 0;
  for (int i = 0; i < kSamples; ++i) {
    const gp_Pnt2d uv = pcurve->Value(at({first, last}, i / (kSamples - 1.0)));
    const double off = (along_v ? uv.X() : uv.Y()) - constant_of(box, side);
    if (std::abs(off) > kOnBorder * length(inwards)) return 0;
    const double place = along_v ? uv.Y() : uv.X();
    low = i == 0 ? place : std::min(low, place);
    high = i == 0 ? place : std::max(high, place);
  }
  return (high - low) / length(along);
}

bool is_open(const TopoDS_Face& face, const ParameterBox& box, SurfaceSide side) {
  double sum = 0;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) continue;
    sum += covered(edge, face, box, side);
  }
  return sum > 1 - kOnBorder;
}

/// The sides that may be used: the named one, or all that are open.
std::vector<SurfaceSide> candidates(const TopoDS_Face& face,
                                    const std::optional<SurfaceSide>& named,
                                    const std::string& name) {
  const std::vector<SurfaceSide> open = open_sides(face);
  if (open.empty())
    throw BadModel("face " + name + " has no edge along a border of its parameters");
  if (!named) return open;
  if (std::find(open.begin(), open.end(), *named) != open.end()) return {*named};
  std::string known;
  for (const SurfaceSide side : open)
    known += std::string(known.empty() ? "" : ", ") + to_string(side);
  throw BadModel("face " + name + " has no edge along " + to_string(*named) + ", it has " + known);
}

std::pair<SurfaceSide, SurfaceSide> nearest_sides(const BezierSurface& a,
                                                  const std::vector<SurfaceSide>& sides_a,
                                                  const BezierSurface& b,
                                                  const std::vector<SurfaceSide>& sides_b) {
  std::pair<SurfaceSide, SurfaceSide> best{sides_a.front(), sides_b.front()};
  double least = border_distance(a, best.first, b, best.second);
  for (const SurfaceSide side_a : sides_a)
    for (const SurfaceSide side_b : sides_b) {
      const double apart = border_distance(a, side_a, b, side_b);
      if (apart < least) {
        least = apart;
        best = {side_a, side_b};
      }
    }
  return best;
}

/// Lowers multiplicities as far as the surface stays where it is within `tolerance`; every knot
/// stays, so that spans are still those of the strip.
void smooth_knots(Geom_BSplineSurface& surface, double tolerance) {
  for (int knot = surface.NbUKnots() - 1; knot > 1; --knot)
    for (int left = surface.UMultiplicity(knot) - 1; left >= 1; --left)
      if (!surface.RemoveUKnot(knot, left, tolerance)) break;
}

/// Figures of the surface that is written, not of the one before the last roundings.
void measure_again(FaceStrip& made, const BezierSurface& a, const BezierSurface& b) {
  Strip& strip = made.strip;
  const double error = strip.surface.error;
  strip.surface = bezier_surface(Handle(Geom_Surface)(made.surface), {{0, 1}, {0, 1}});
  strip.surface.error = error;
  const auto contacts =
      strip_contacts(strip.surface, a, made.side_a, b, made.side_b, strip.backward);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    strip.contacts[i].gap = contacts[i].gap;
    strip.contacts[i].normal_angle = contacts[i].normal_angle;
  }
}

TopoDS_Face face_on(const Handle(Geom_BSplineSurface) & surface) {
  BRepBuilderAPI_MakeFace maker(surface, Tolerances{}.point);
  if (!maker.IsDone()) throw Failure("the strip gives no face");
  if (!BRepCheck_Analyzer(maker.Face()).IsValid())
    throw Failure("the strip gives an invalid face: does it cross itself?");
  return maker.Face();
}

}  // namespace

std::vector<SurfaceSide> open_sides(const TopoDS_Face& face) {
  return guarded("looking at the edges of a face", [&] {
    const ParameterBox box = parameter_box(face);
    std::vector<SurfaceSide> open;
    for (const SurfaceSide side : kSides)
      if (is_open(face, box, side)) open.push_back(side);
    return open;
  });
}

FaceStrip strip_between(const TopoDS_Face& a, const TopoDS_Face& b,
                        const FaceStripOptions& options) {
  const std::vector<SurfaceSide> sides_a = candidates(a, options.side_a, "a");
  const std::vector<SurfaceSide> sides_b = candidates(b, options.side_b, "b");
  const BezierSurface surface_a = bezier_surface(a), surface_b = bezier_surface(b);
  FaceStrip result;
  std::tie(result.side_a, result.side_b) = nearest_sides(surface_a, sides_a, surface_b, sides_b);
  result.strip = strip_between(surface_a, result.side_a, surface_b, result.side_b, options.strip);
  guarded("making the strip's face", [&] {
    result.surface = to_occt(result.strip.surface);
    smooth_knots(*result.surface, strip_gap_bound(result.strip.surface));
    result.face = face_on(result.surface);
  });
  measure_again(result, surface_a, surface_b);
  return result;
}

}  // namespace blossom::occt
