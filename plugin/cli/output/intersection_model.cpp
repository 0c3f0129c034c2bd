// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/output/intersection_model.h"

#include <algorithm>
#include <vector>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves.h"

namespace blossom::cli {
namespace {

const std::vector<double> kEdgeColour = {0.78, 0.08, 0.16};

Handle(Geom_Surface) copied_surface(const TopoDS_Face& face) {
  return Handle(Geom_Surface)::DownCast(BRep_Tool::Surface(face)->Copy());
}

// The edges of one pair of faces.
class PairBuilder {
 public:
  PairBuilder(const TopoDS_Face& a, const TopoDS_Face& b)
      : surface_a_(copied_surface(a)), surface_b_(copied_surface(b)) {
    builder_.MakeCompound(whole_);
  }

  void add(const occt::EdgeCurves& curves) {
    const double first = curves.curve->FirstParameter(), last = curves.curve->LastParameter();
    TopoDS_Edge edge;
    builder_.MakeEdge(edge, occt::basis_of(curves.curve), curves.tolerance);
    builder_.UpdateEdge(edge, curves.pcurve_a, surface_a_, TopLoc_Location(), curves.tolerance);
    builder_.UpdateEdge(edge, curves.pcurve_b, surface_b_, TopLoc_Location(), curves.tolerance);
    builder_.Range(edge, first, last);
    builder_.Add(edge,
                 vertex(curves.curve->Value(first), curves.tolerance).Oriented(TopAbs_FORWARD));
    builder_.Add(edge,
                 vertex(curves.curve->Value(last), curves.tolerance).Oriented(TopAbs_REVERSED));
    builder_.SameRange(edge, Standard_True);
    builder_.SameParameter(edge, Standard_True);
    builder_.Add(whole_, edge);
  }

  void add(const SurfacePoint& contact) {
    const Vec3& p = contact.point;
    builder_.Add(whole_, vertex(gp_Pnt(p[0], p[1], p[2]), Precision::Confusion()));
  }

  const TopoDS_Compound& whole() const { return whole_; }

 private:
  // The vertex at a point, made anew unless one of the pair's lies there.
  TopoDS_Shape vertex(const gp_Pnt& point, double tolerance) {
    for (TopoDS_Vertex& known : vertices_) {
      const double reach = std::max(tolerance, BRep_Tool::Tolerance(known));
      if (BRep_Tool::Pnt(known).Distance(point) > 2 * reach) continue;
      builder_.UpdateVertex(known, 2 * reach);
      return known;
    }
    TopoDS_Vertex made;
    builder_.MakeVertex(made, point, tolerance);
    vertices_.push_back(made);
    return made;
  }

  BRep_Builder builder_;
  TopoDS_Compound whole_;
  std::vector<TopoDS_Vertex> vertices_;
  Handle(Geom_Surface) surface_a_;
  Handle(Geom_Surface) surface_b_;
};

std::string face_name(const Input& input, int index) {
  const std::string file = input.model.file().filename().string();
  return file + "#" + std::to_string(input.numbers[static_cast<std::size_t>(index)]);
}

std::string file_names(const Input& a, const Input& b) {
  return a.model.file().filename().string() + " x " + b.model.file().filename().string();
}

}  // namespace

occt::Model joined_model(const Input& a, const Input& b, const occt::JoinedIntersection& joined) {
  occt::Model model;
  model.add(joined.wires, file_names(a, b), kEdgeColour);
  return model;
}

occt::Model paired_model(const Input& a, const Input& b, const occt::ShapeIntersection& found,
                         const reports::EdgeFindings& edges) {
  return occt::guarded("building edges", [&] {
    occt::Model model;
    for (const occt::FaceIntersection& pair : found.pairs) {
      if (pair.edges.empty() && pair.found.points.empty()) continue;
      PairBuilder builder(a.faces[static_cast<std::size_t>(pair.face_a)],
                          b.faces[static_cast<std::size_t>(pair.face_b)]);
      for (const occt::EdgeCurves& edge : pair.edges) builder.add(edge);
      for (const SurfacePoint& contact : pair.found.points) builder.add(contact);
      model.add(builder.whole(), face_name(a, pair.face_a) + " x " + face_name(b, pair.face_b),
                kEdgeColour);
    }
    if (edges.points() + edges.stretches() == 0) return model;
    occt::JoinedIntersection joined;
    reports::add_edges(edges, joined);
    model.add(joined.wires, file_names(a, b), kEdgeColour);
    return model;
  });
}

}  // namespace blossom::cli
