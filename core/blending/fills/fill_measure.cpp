// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fills/fill_measure.h"

#include <algorithm>
#include <cmath>

namespace blossom {
namespace {

using Patches = std::vector<RationalBezierPatch>;

/// Places on a half of a side, or on an inner edge. Ends are not among them: there the common point
/// belongs to several edges.
constexpr int kPlaces = 19;
double place_at(int k) { return (k + 0.5) / kPlaces; }

/// The second fundamental form in the directions x, y of the tangent plane with normal n.
struct SecondForm {
  double xx, xy, yy;
};

SecondForm second_form(const PatchJet& jet, const Vec3& n, const Vec3& x, const Vec3& y) {
  // A tangent vector is its part of S_u and S_v by the dual vectors.
  const Vec3 normal = cross(jet.u, jet.v);
  const Vec3 dual_u = cross(jet.v, normal) * (1 / dot(normal, normal));
  const Vec3 dual_v = cross(normal, jet.u) * (1 / dot(normal, normal));
  const double l = dot(jet.uu, n), m = dot(jet.uv, n), k = dot(jet.vv, n);
  const auto form = [&](const Vec3& p, const Vec3& q) {
    const double pu = dot(p, dual_u), pv = dot(p, dual_v);
    const double qu = dot(q, dual_u), qv = dot(q, dual_v);
    return l * pu * qu + m * (pu * qv + pv * qu) + k * pv * qv;
  };
  return {form(x, x), form(x, y), form(y, y)};
}

double largest(const SecondForm& form) {
  return std::max({std::abs(form.xx), std::abs(form.xy), std::abs(form.yy)});
}

void add(FillContact& contact, double& curvature, const MeetingOfJets& at) {
  contact.gap = std::max(contact.gap, at.gap);
  contact.normal_angle = std::max(contact.normal_angle, at.normal_angle);
  contact.curvature_difference = std::max(contact.curvature_difference, at.curvature_difference);
  curvature = std::max(curvature, at.curvature);
}

/// Parameters of a place on an edge of a patch, seen from inside with the edge along it.
Vec2 on_edge(int edge, double t) {
  switch (edge) {
    case 0: return {t, 0};
    case 1: return {1, t};
    case 2: return {1 - t, 1};
    default: return {0, 1 - t};
  }
}

PatchJet jet_on(const Patches& patches, const PolygonLayout& layout, int sector,
                const QuadEdge& edge, double t) {
  const auto quads = static_cast<int>(layout.quads.size());
  const int turned = (sector + edge.sector + layout.sides) % layout.sides;
  const Vec2 uv = on_edge(edge.edge, t);
  return jet_at(patches[static_cast<std::size_t>(turned * quads + edge.quad)], uv[0], uv[1], 2);
}

/// The neighbour as a patch that has its value and derivatives at t = 0:
///   P_0 = C, P_1 = C + C_t / 2, P_2 = C + C_t + C_tt / 2.
RationalBezierPatch neighbour(const FillSide& side) {
  const std::size_t size = std::max({side.edge.size(), side.across.size(), side.bend.size()});
  const int degree = static_cast<int>(size) - 1;
  const Row edge = raised(side.edge, degree), across = raised(side.across, degree);
  const Row bend = side.bend.empty() ? Row(size) : raised(side.bend, degree);
  RationalBezierPatch patch{Grid<Vec4>(degree + 1, 3)};
  for (int i = 0; i <= degree; ++i) {
    const auto k = static_cast<std::size_t>(i);
    patch.points(i, 0) = edge[k];
    patch.points(i, 1) = edge[k] + 0.5 * across[k];
    patch.points(i, 2) = edge[k] + across[k] + 0.5 * bend[k];
  }
  return patch;
}

void measure_side(FillFigures& figures, const Patches& patches, const FillSide& side,
                  const PolygonLayout& layout, int k) {
  FillContact& contact = figures.sides[static_cast<std::size_t>(k)];
  const bool alone = side.across.empty();
  const RationalBezierPatch patch = alone ? RationalBezierPatch{} : neighbour(side);
  for (int half = 0; half < 2; ++half)
    for (int i = 0; i < kPlaces; ++i) {
      const double t = place_at(i);
      const PatchJet inside =
          jet_on(patches, layout, k, layout.borders[static_cast<std::size_t>(half)], t);
      const double s = 0.5 * (half + t);
      if (alone) {
        contact.gap = std::max(
            contact.gap, distance(jet_at(RationalBezierCurve{side.edge}, s).point, inside.point));
        continue;
      }
      // C_t leads away from the hole, so the normals are opposite: turned by exchanging u and v.
      const PatchJet jet = jet_at(patch, s, 0, 2);
      const PatchJet outside{jet.point, jet.v, jet.u, jet.vv, jet.uv, jet.uu};
      add(contact, figures.largest_curvature, meeting_of(inside, outside, !side.bend.empty()));
    }
}

}  // namespace

MeetingOfJets meeting_of(const PatchJet& a, const PatchJet& b, bool second) {
  MeetingOfJets result;
  const Vec3 na = unit(cross(a.u, a.v)), nb = unit(cross(b.u, b.v));
  result.gap = distance(a.point, b.point);
  result.normal_angle = std::atan2(norm(cross(na, nb)), dot(na, nb));
  if (!second) return result;
  const Vec3 x = unit(a.u), y = cross(na, x);
  const SecondForm form_a = second_form(a, na, x, y), form_b = second_form(b, nb, x, y);
  result.curvature = std::max(largest(form_a), largest(form_b));
  result.curvature_difference =
      largest({form_a.xx - form_b.xx, form_a.xy - form_b.xy, form_a.yy - form_b.yy});
  return result;
}

FillFigures fill_figures(const Patches& patches, const std::vector<FillSide>& sides,
                         const PolygonLayout& layout) {
  FillFigures figures;
  figures.sides.assign(sides.size(), {});
  for (int k = 0; k < layout.sides; ++k) {
    measure_side(figures, patches, sides[static_cast<std::size_t>(k)], layout, k);
    for (const SharedQuadEdge& edge : layout.shared)
      for (int i = 0; i < kPlaces; ++i) {
        const double t = place_at(i);
        const PatchJet a = jet_on(patches, layout, k, edge.a, t);
        const PatchJet b = jet_on(patches, layout, k, edge.b, 1 - t);
        add(figures.inside, figures.largest_curvature, meeting_of(a, b, true));
      }
  }
  return figures;
}

}  // namespace blossom
