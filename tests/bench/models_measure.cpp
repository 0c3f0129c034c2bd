// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/models_measure.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

namespace blossom::bench {

Outcome measured(double limit, const std::function<Outcome()>& work) {
  Outcome outcome;
  const Ending ending = apart<Outcome>(limit, outcome, [&] {
    const double start = processor_seconds();
    Outcome found = work();
    found.seconds = processor_seconds() - start;
    return found;
  });
  if (ending == Ending::Done) return outcome;
  outcome = {};
  outcome.status = Status::Stopped;
  outcome.failed = ending == Ending::Died;
  outcome.ended = outcome.failed;
  outcome.seconds = limit;
  return outcome;
}

double length_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  double sum = 0;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    if (!BRep_Tool::Degenerated(edge)) sum += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge));
  }
  return sum;
}

}  // namespace blossom::bench
