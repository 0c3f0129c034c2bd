// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/meshes_judged.h"

#include <sys/resource.h>

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/cgal/gpl/mesh_check.h"
#include "core/math/index.h"
#include "tests/bench/apart.h"

namespace blossom::bench {
namespace {

constexpr double kMemoryLimit = 600;  // seconds

std::vector<std::vector<bool>> faces_of_solids(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<std::vector<bool>> groups;
  std::vector<bool> rest(index(faces.Extent()), true);
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    std::vector<bool>& group = groups.emplace_back(rest.size(), false);
    for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next()) {
      const auto k = index(faces.FindIndex(face.Current()) - 1);
      group[k] = true;
      rest[k] = false;
    }
  }
  groups.push_back(rest);
  return groups;
}

double megabytes() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024;
}

}  // namespace

MeshVerdict judged_mesh(const TopoDS_Shape& shape, const FacetMesh& mesh) {
  MeshVerdict verdict;
  for (const std::vector<bool>& group : faces_of_solids(shape)) {
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (group[index(mesh.face[t])]) triangles.push_back(mesh.triangles[t]);
    if (triangles.empty()) continue;
    const cgal::MeshCheck check = cgal::check_mesh(mesh.points, triangles);
    verdict.closed = verdict.closed && check.closed;
    verdict.manifold = verdict.manifold && check.manifold;
    verdict.crossings += check.self_intersections;
  }
  return verdict;
}

double peak_megabytes(const std::function<void()>& work) {
  double most = 0;
  const std::function<double()> measured = [&] {
    const double before = megabytes();
    work();
    return megabytes() - before;
  };
  return apart(kMemoryLimit, most, measured) == Ending::Done ? most : 0;
}

}  // namespace blossom::bench
