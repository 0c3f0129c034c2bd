// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_curves.h"

#include <algorithm>
#include <utility>

#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#ifdef BLOSSOM_WITH_CGAL
#include "adapters/cgal/mesh_intersection.h"
#include "plugin/reports/text/number_text.h"
#endif

namespace blossom::meshes {
namespace {

using reports::Json;

constexpr double kEdgeTolerance = 1e-7;  // of edges that are made, model units

// Both ends, and the points between that are not in one place with the one before: meshes that are
// about the same meet in polylines with sides of rounding, of which there is no curve.
std::vector<Vec3> apart(const std::vector<Vec3>& points) {
  std::vector<Vec3> kept{points.front()};
  for (const Vec3& p : points)
    if (distance(p, kept.back()) > kEdgeTolerance) kept.push_back(p);
  if (kept.size() > 1) kept.back() = points.back();
  return kept;
}

Handle(Geom_BSplineCurve) polygon_curve(const std::vector<Vec3>& points) {
  const auto count = static_cast<int>(points.size());
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal knots(1, count);
  TColStd_Array1OfInteger multiplicities(1, count);
  multiplicities.Init(1);
  multiplicities.SetValue(1, 2);
  multiplicities.SetValue(count, 2);
  double at = 0;
  for (int i = 1; i <= count; ++i) {
    const Vec3& p = points[static_cast<std::size_t>(i - 1)];
    if (i > 1) at += norm(p - points[static_cast<std::size_t>(i - 2)]);
    poles.SetValue(i, {p[0], p[1], p[2]});
    knots.SetValue(i, at);
  }
  return new Geom_BSplineCurve(poles, knots, multiplicities, 1);
}

#ifdef BLOSSOM_WITH_CGAL
MeshCurves told(cgal::MeshMeeting found) {
  MeshCurves made{.curves = {},
                  .points = std::move(found.points),
                  .rounding = found.rounding,
                  .touching = found.touching,
                  .in_plane = found.in_plane,
                  .flat = found.flat};
  for (cgal::MeshCurve& curve : found.curves)
    made.curves.push_back({std::move(curve.points), curve.closed, curve.length});
  return made;
}

cgal::MeshView view(const FileMesh& mesh) { return {mesh.points, mesh.triangles}; }
#endif

}  // namespace

#ifdef BLOSSOM_WITH_CGAL
std::optional<MeshCurves> curves_of_meshes(const FileMesh& a, const FileMesh& b,
                                           const std::function<void()>& stop) {
  return told(cgal::intersect_meshes(view(a), view(b), stop));
}

std::optional<MeshCurves> curves_in_plane(const FileMesh& mesh, const occt::Plane& plane,
                                          const std::function<void()>& stop) {
  return told(cgal::section_of_mesh(view(mesh), plane.point, plane.normal, stop));
}
#else
std::optional<MeshCurves> curves_of_meshes(const FileMesh&, const FileMesh&,
                                           const std::function<void()>&) {
  return {};
}

std::optional<MeshCurves> curves_in_plane(const FileMesh&, const occt::Plane&,
                                          const std::function<void()>&) {
  return {};
}
#endif

occt::PlaneSection section_of(const MeshCurves& found) {
  occt::PlaneSection section;
  section.status = found.touching ? Status::Tolerance : Status::Complete;
  const auto node = [&](const Vec3& point) {
    section.nodes.push_back({.point = point, .on = {}});
    return static_cast<int>(section.nodes.size()) - 1;
  };
  for (const MeshPolyline& polyline : found.curves) {
    const std::vector<Vec3> points = apart(polyline.points);
    if (points.size() < 2) {
      section.points.push_back(static_cast<std::size_t>(node(points.front())));
      continue;
    }
    occt::SectionCurve curve;
    curve.face = 0;
    curve.curve = polygon_curve(points);
    curve.range = {curve.curve->FirstParameter(), curve.curve->LastParameter()};
    curve.samples = points;
    curve.closed = polyline.closed;
    curve.length = polyline.length;
    curve.tolerance = kEdgeTolerance;
    if (!polyline.closed)
      curve.nodes = {node(polyline.points.front()), node(polyline.points.back())};
    section.wires.push_back({{{section.curves.size(), true}}, polyline.closed, polyline.length});
    section.curves.push_back(std::move(curve));
  }
  for (const Vec3& point : found.points)
    section.points.push_back(static_cast<std::size_t>(node(point)));
  return section;
}

Json curves_json(const MeshCurves& found) {
  Json json = {{"touching", found.touching},
               {"in_plane", found.in_plane},
               {"curves", Json::array()},
               {"points", Json::array()}};
  for (const MeshPolyline& curve : found.curves) {
    Json points = Json::array();
    for (const Vec3& p : curve.points) points.push_back(p.coordinates);
    json["curves"].push_back(
        {{"closed", curve.closed}, {"length", curve.length}, {"points", std::move(points)}});
  }
  for (const Vec3& p : found.points) json["points"].push_back(p.coordinates);
  return json;
}

Json mesh_pair_report(const MeshPair& pair) {
  Json json = {{"schema", "blossom.mesh-intersection/1"},
               {"a", pair.a},
               {"b", pair.b},
               {"status", to_string(pair.status())},
               {"within", std::max(pair.within_a, pair.within_b)},
               {"rounding", pair.found.rounding},
               {"flat", pair.found.flat},
               {"seconds", pair.seconds}};
  json.update(curves_json(pair.found));
  return json;
}

namespace {

Json area_json(const PlaneOfMesh& plane) {
  occt::PlaneSection section = section_of(plane.found);
  occt::orient_wires(section, plane.plane);
  const std::optional<double> area = occt::bounded_area(section);
  return area ? Json(*area) : Json();
}

}  // namespace

Json mesh_sections_report(const std::string& file, Status status,
                          const std::vector<PlaneOfMesh>& planes, double seconds) {
  Json json = {{"schema", "blossom.mesh-sections/1"},
               {"file", file},
               {"status", to_string(status)},
               {"rounding", planes.front().found.rounding},
               {"flat", planes.front().found.flat},
               {"seconds", seconds},
               {"planes", Json::array()}};
  for (const PlaneOfMesh& plane : planes) {
    Json of = {{"name", plane.name},
               {"point", plane.plane.point.coordinates},
               {"normal", plane.plane.normal.coordinates},
               {"offset", plane.offset ? Json(*plane.offset) : Json()},
               {"area", area_json(plane)}};
    of.update(curves_json(plane.found));
    json["planes"].push_back(std::move(of));
  }
  return json;
}

std::string counted_curves(const MeshCurves& found) {
  std::size_t closed = 0;
  double length = 0;
  for (const MeshPolyline& curve : found.curves) {
    closed += curve.closed;
    length += curve.length;
  }
  std::string text = reports::counted(found.curves.size(), "polyline");
  if (closed < found.curves.size())
    text += " (" + std::to_string(found.curves.size() - closed) + " open)";
  if (!found.curves.empty()) text += " of length " + reports::number_text(reports::rounded(length));
  if (!found.points.empty()) text += ", " + reports::counted(found.points.size(), "point");
  return text;
}

}  // namespace blossom::meshes
