// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/tessellation/shape_reader.h"

#include <utility>

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/base/step_failure.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/faces/untrimmed.h"
#include "adapters/occt/tessellation/elementary_charts.h"
#include "core/base/parallel.h"
#include "core/math/index.h"

namespace blossom::occt {
namespace {

constexpr std::size_t kEdgeGrain = 8;

class ShapeReader {
 public:
  ShapeReader(const TopoDS_Shape& shape, double fine) : fine_(fine) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_EDGE, read_.edges);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
  }

  ReadShape read() {
    for (int k = 1; k <= vertices_.Extent(); ++k)
      read_.model.vertices.push_back(vec(BRep_Tool::Pnt(TopoDS::Vertex(vertices_(k)))));
    read_.model.edges.resize(index(read_.edges.Extent()));
    edge_faults_.resize(read_.model.edges.size());
    // What goes wrong with one face is no matter of the others.
    constexpr const char* kReading = "reading it";
    parallel_for(read_.model.edges.size(), kEdgeGrain, [this](std::size_t k) {
      edge_faults_[k] = failure_of(kReading, [&] { read_edge(k); });
    });
    read_.model.faces.resize(index(faces_.Extent()));
    read_.refusals.resize(read_.model.faces.size());
    parallel_for(read_.model.faces.size(), 1, [this](std::size_t f) {
      read_.refusals[f] = failure_of(kReading, [&] { read_face(f); });
    });
    return std::move(read_);
  }

 private:
  void read_edge(std::size_t k) {
    const TopoDS_Edge edge =
        TopoDS::Edge(read_.edges(static_cast<int>(k) + 1).Oriented(TopAbs_FORWARD));
    ModelEdge& made = read_.model.edges[k];
    made.from = vertices_.FindIndex(TopExp::FirstVertex(edge)) - 1;
    made.to = vertices_.FindIndex(TopExp::LastVertex(edge)) - 1;
    made.is_point = BRep_Tool::Degenerated(edge);
    if (made.from < 0 || made.to < 0) {
      made.from = made.to = 0;
      throw BadModel("an edge has no vertex at an end");
    }
    if (made.is_point) return;
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) {
      made.is_point = true;
      throw BadModel("an edge has no curve in space");
    }
    made.curve = bezier_spans(curve, {first, last}, fine_);
  }

  void read_face(std::size_t f) {
    const TopoDS_Face face = TopoDS::Face(faces_(static_cast<int>(f) + 1));
    ModelFace made;
    const FaceTrims trims = face_trims(face);
    const TrimShapes shapes = trim_shapes(face);
    if (const auto chart = elementary_chart(BRep_Tool::Surface(face)))
      made.surface = *chart;
    else
      made.surface = bezier_surface(face, fine_);
    made.chart = trimmed_chart(trims);
    for (const auto& loop : trims.loops)
      for (const Coedge& coedge : loop) {
        made.edges.push_back(read_.edges.FindIndex(shapes.edge(coedge)) - 1);
        const std::string& fault = edge_faults_[index(made.edges.back())];
        if (!fault.empty()) throw BadModel(fault);
      }
    read_.model.faces[f] = std::move(made);
  }

  double fine_;
  TopTools_IndexedMapOfShape faces_, vertices_;
  ReadShape read_;
  std::vector<std::string> edge_faults_;
};

}  // namespace

ReadShape read_shape(const TopoDS_Shape& shape, double fine) {
  return ShapeReader(shape, fine).read();
}

}  // namespace blossom::occt
