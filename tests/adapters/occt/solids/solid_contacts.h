// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of solids that touch, with the volume that they have in common known by hand.

#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

namespace blossom::testing {

struct SolidContact {
  std::string name;
  std::function<TopoDS_Shape()> a, b;
  double common = 0;    ///< volume
  double error = 1e-9;  ///< of volumes, from images that are fitted
};

inline std::ostream& operator<<(std::ostream& out, const SolidContact& contact) {
  return out << contact.name;
}

std::vector<SolidContact> box_contacts();
std::vector<SolidContact> prism_contacts();
std::vector<SolidContact> rod_contacts();
std::vector<SolidContact> ball_contacts();
std::vector<SolidContact> wedge_contacts();
std::vector<SolidContact> cone_and_ring_contacts();
std::vector<SolidContact> hole_and_corner_contacts();
std::vector<SolidContact> spline_contacts();

/// Solids that cross each other, with edges that touch; what they have in common is left out.
std::vector<SolidContact> touching_edges();

TopoDS_Shape box(const gp_Pnt& from, const gp_Pnt& to);

/// A shape turned about an axis through the origin; angles in radians.
TopoDS_Shape turned(const TopoDS_Shape& shape, const gp_Dir& axis, double angle);

}  // namespace blossom::testing
