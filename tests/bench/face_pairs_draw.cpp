// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/face_pairs_draw.h"

#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/intersection_edges.h"
#include "tests/support/random.h"

namespace blossom::bench {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr int kTries = 400;  // of a pair whose boxes meet

struct Copy {
  const char* kind;
  double turn;  // radians
  double move;  // part of the model's size
};
constexpr Copy kCopies[] = {
    {"c1", 23 * kDegree, 0.06}, {"c2", 2 * kDegree, 0.004}, {"c3", 0.05 * kDegree, 0.0001}};

Bnd_Box box_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box;
}

bool is_free_form(const TopoDS_Face& face) {
  const GeomAbs_SurfaceType type = BRepAdaptor_Surface(face, false).GetType();
  return type == GeomAbs_BSplineSurface || type == GeomAbs_BezierSurface;
}

gp_Dir direction(testing::Random& random) {
  while (true) {
    const gp_XYZ x(testing::uniform(random, -1, 1), testing::uniform(random, -1, 1),
                   testing::uniform(random, -1, 1));
    if (x.Modulus() > 0.1 && x.Modulus() < 1) return gp_Dir(x);
  }
}

void add_neighbours(const TopoDS_Shape& model, testing::Random& random, int most,
                    std::vector<FacePair>& pairs) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edges;
  TopExp::MapShapesAndAncestors(model, TopAbs_EDGE, TopAbs_FACE, faces_of_edges);
  std::vector<FacePair> all;
  for (int i = 1; i <= faces_of_edges.Extent(); ++i) {
    const TopTools_ListOfShape& faces = faces_of_edges(i);
    if (faces.Extent() != 2) continue;
    const TopoDS_Face a = TopoDS::Face(faces.First()), b = TopoDS::Face(faces.Last());
    if (!a.IsSame(b) && is_free_form(a) && is_free_form(b)) all.push_back({"nb", a, b});
  }
  for (int i = 0; i < most && !all.empty(); ++i) {
    const int k = testing::pick(random, 0, static_cast<int>(all.size()) - 1);
    pairs.push_back(all[static_cast<std::size_t>(k)]);
    all.erase(all.begin() + k);
  }
}

}  // namespace

std::vector<FacePair> draw_pairs(const TopoDS_Shape& model, std::uint64_t seed, int most) {
  testing::Random random(seed);
  std::vector<FacePair> pairs;
  add_neighbours(model, random, most, pairs);
  std::vector<TopoDS_Face> faces;
  for (const TopoDS_Face& face : occt::faces_of(model))
    if (is_free_form(face)) faces.push_back(face);
  if (faces.empty()) return pairs;
  const Bnd_Box box = box_of(model);
  const gp_Pnt middle(0.5 * (box.CornerMin().XYZ() + box.CornerMax().XYZ()));
  const double size = std::sqrt(box.SquareExtent());
  const int last = static_cast<int>(faces.size()) - 1;
  for (const Copy& copy : kCopies) {
    std::set<std::pair<int, int>> drawn;
    for (int tries = 0; tries < kTries && static_cast<int>(drawn.size()) < most; ++tries) {
      gp_Trsf turn, move;
      turn.SetRotation(gp_Ax1(middle, direction(random)), copy.turn);
      move.SetTranslation(gp_Vec(direction(random)) * (copy.move * size));
      const int i = testing::pick(random, 0, last);
      // Every third pair is a face and its own copy.
      const int j = tries % 3 == 0 ? i : testing::pick(random, 0, last);
      const TopoDS_Face a = faces[static_cast<std::size_t>(i)];
      const TopoDS_Face b =
          TopoDS::Face(faces[static_cast<std::size_t>(j)].Moved(TopLoc_Location(move * turn)));
      if (drawn.count({i, j}) > 0 || box_of(a).IsOut(box_of(b))) continue;
      drawn.insert({i, j});
      pairs.push_back({copy.kind, a, b});
    }
  }
  return pairs;
}

void keep(const std::string& folder, const std::string& name, const FacePair& faces,
          std::size_t number) {
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, faces.a);
  builder.Add(both, faces.b);
  const std::string file =
      folder + "/" + name + "_" + faces.kind + "_" + std::to_string(number) + ".brep";
  if (!::BRepTools::Write(both, file.c_str()))
    std::fprintf(stderr, "%s cannot be written\n", file.c_str());
}

}  // namespace blossom::bench
