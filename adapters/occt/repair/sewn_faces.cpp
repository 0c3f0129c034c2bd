// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/sewn_faces.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <string>

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Message_ProgressIndicator.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/faces/face_groups.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/queries/cone_volumes.h"
#include "adapters/occt/queries/solid_rays.h"
#include "adapters/occt/repair/border_gaps.h"
#include "adapters/occt/solids/solid_shells.h"

namespace blossom::occt {
namespace {

using Stop = std::function<void()>;

/// Asks `stop` in Open CASCADE's work, through which no exception may go.
class StopIndicator : public Message_ProgressIndicator {
 public:
  explicit StopIndicator(const Stop& stop) : stop_(stop) {}

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

  Standard_Boolean UserBreak() override {
    try {
      if (stop_ && !failure_) stop_();
    } catch (...) {
      failure_ = std::current_exception();
    }
    return failure_ != nullptr;
  }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

 private:
  const Stop& stop_;
  std::exception_ptr failure_;
};

/// Faces as they are after sewing, each turned as its shell wants it, with their places before.
struct Sewn {
  std::vector<TopoDS_Shape> faces;
  std::vector<std::size_t> places;
  std::vector<double> within;  ///< how much the borders of each were joined, model units
};

void sew(const std::vector<TopoDS_Face>& faces, const std::vector<std::size_t>& body, double within,
         const Stop& stop, Sewn& sewn) {
  BRepBuilderAPI_Sewing sewing(within);
  for (const std::size_t i : body) sewing.Add(faces[i]);
  const Handle(StopIndicator) indicator = new StopIndicator(stop);
  sewing.Perform(indicator->Start());
  indicator->rethrow();
  if (sewing.SewedShape().IsNull()) return;
  NCollection_DataMap<TopoDS_Shape, std::size_t, TopTools_ShapeMapHasher> places;
  for (const std::size_t i : body) places.Bind(sewing.Modified(faces[i]), i);
  for (TopExp_Explorer it(sewing.SewedShape(), TopAbs_FACE); it.More(); it.Next())
    if (const std::size_t* place = places.Seek(it.Current())) {
      sewn.faces.push_back(it.Current());
      sewn.places.push_back(*place);
      sewn.within.push_back(within);
    }
}

bool is_closed(const std::vector<TopoDS_Shape>& faces) {
  TopTools_IndexedMapOfShape edges;
  std::vector<int> balance;
  for (const TopoDS_Shape& face : faces)
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopAbs_Orientation turned = it.Current().Orientation();
      if (turned != TopAbs_FORWARD && turned != TopAbs_REVERSED) continue;
      if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) continue;
      const auto number = static_cast<std::size_t>(edges.Add(it.Current())) - 1;
      balance.resize(std::max(balance.size(), number + 1));
      balance[number] += turned == TopAbs_FORWARD ? 1 : -1;
    }
  return std::ranges::all_of(balance, [](int sum) { return sum == 0; });
}

/// A closed shell turned outwards.
struct ClosedShell {
  std::vector<TopoDS_Face> faces;
  double within = 0;  ///< how much borders were joined, model units
  Bnd_Box box;
};

void turn(std::vector<TopoDS_Face>& faces) {
  for (TopoDS_Face& face : faces) face.Reverse();
}

/// The shells that faces close, and that bound something.
std::vector<ClosedShell> closed_shells(const Sewn& sewn, ConeVolumes& volumes) {
  std::vector<ClosedShell> shells;
  for (const FaceGroup& group :
       groups_over_edges(sewn.faces, [](const TopoDS_Shape&) { return false; })) {
    std::vector<TopoDS_Shape> faces;
    for (const std::size_t i : group) faces.push_back(sewn.faces[i]);
    if (!is_closed(faces)) continue;
    ClosedShell shell;
    shell.within = sewn.within[group.front()];
    double volume = 0, skin = 0;
    for (const TopoDS_Shape& face : faces) {
      shell.faces.push_back(TopoDS::Face(face));
      volume += volumes.of(shell.faces.back());
      skin += std::abs(area(shell.faces.back()));
      shell.box.Add(bounds_of(face));
    }
    if (std::abs(volume) <= shell.within * skin) continue;
    if (volume < 0) turn(shell.faces);
    shells.push_back(std::move(shell));
  }
  return shells;
}

/// How many other shells a shell lies in; odd ones are voids.
int depth_of(const ClosedShell& shell, const std::vector<ClosedShell>& shells) {
  int depth = 0;
  for (const ClosedShell& other : shells) {
    const std::optional<gp_Pnt> point = point_inside(shell.faces.front());
    if (&other == &shell || !point || other.box.IsOut(*point)) continue;
    if (SolidRays(other.faces, other.within).is_inside(vec(*point)).value_or(false)) ++depth;
  }
  return depth;
}

std::vector<TopoDS_Solid> solids_from(std::vector<ClosedShell>& shells, ConeVolumes& volumes) {
  std::vector<int> depths;
  for (const ClosedShell& shell : shells) depths.push_back(depth_of(shell, shells));
  std::vector<BoundingFace> bounding;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (depths[i] % 2 == 1) turn(shells[i].faces);
    for (const TopoDS_Face& face : shells[i].faces) bounding.push_back({face, volumes.of(face)});
  }
  std::string obstacle;
  std::vector<TopoDS_Solid> solids = solids_of(bounding, obstacle);
  return obstacle.empty() ? solids : std::vector<TopoDS_Solid>();
}

/// The solid with the faces of each shell in the order in which they were given.
SewnSolid ordered(const TopoDS_Solid& solid, const Sewn& sewn) {
  NCollection_DataMap<TopoDS_Shape, std::size_t, TopTools_ShapeMapHasher> places;
  for (std::size_t i = 0; i < sewn.faces.size(); ++i) places.Bind(sewn.faces[i], sewn.places[i]);
  const BRep_Builder builder;
  SewnSolid made;
  builder.MakeSolid(made.solid);
  for (TopoDS_Iterator shell(solid); shell.More(); shell.Next()) {
    std::map<std::size_t, TopoDS_Face> faces;
    for (TopExp_Explorer it(shell.Value(), TopAbs_FACE); it.More(); it.Next())
      faces[places.Find(it.Current())] = TopoDS::Face(it.Current());
    TopoDS_Shell sorted;
    builder.MakeShell(sorted);
    for (const auto& [place, face] : faces) builder.Add(sorted, face);
    sorted.Closed(true);
    builder.Add(made.solid, sorted);
    made.faces.insert(made.faces.end(), faces.begin(), faces.end());
  }
  std::ranges::sort(made.faces, {}, &std::pair<std::size_t, TopoDS_Face>::first);
  return made;
}

}  // namespace

SewnFaces sewn_faces(const std::vector<TopoDS_Face>& faces, std::optional<double> within,
                     const Stop& stop) {
  return guarded("sewing loose faces", [&] {
    SewnFaces made;
    const BorderGaps gaps = border_gaps(faces, within, stop);
    const std::size_t open = gaps.open();
    if (!gaps.borders.empty() && open == gaps.borders.size()) return made;
    if (open > 0) {
      made.open_edges = static_cast<int>(open);
      made.open_at = std::ranges::find_if(gaps.borders, [](const LooseBorder& border) {
                       return !border.gap;
                     })->middle;
    }
    Sewn sewn;
    for (const LooseBody& body : gaps.bodies)
      sew(faces, body.faces, joined_within(body.widest), stop, sewn);
    ConeVolumes volumes(middle_of(compound_of(faces)));
    std::vector<ClosedShell> shells = closed_shells(sewn, volumes);
    for (const TopoDS_Solid& solid : solids_from(shells, volumes))
      made.solids.push_back(ordered(solid, sewn));
    for (const ClosedShell& shell : shells) made.within = std::max(made.within, shell.within);
    for (const LooseBody& body : gaps.bodies)
      if (joined_within(body.widest) <= made.within) made.gap = std::max(made.gap, body.widest);
    std::ranges::sort(made.solids, {}, [](const SewnSolid& s) { return s.faces.front().first; });
    return made;
  });
}

}  // namespace blossom::occt
