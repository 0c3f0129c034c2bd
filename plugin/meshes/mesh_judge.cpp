// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_judge.h"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>

#ifdef BLOSSOM_WITH_CGAL
#include "adapters/cgal/mesh_judge.h"
#endif
#include "plugin/meshes/mesh_info.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::meshes {
namespace {

constexpr std::size_t kNamedPairs = 10;  // in summaries
}  // namespace

#ifdef BLOSSOM_WITH_CGAL
std::optional<JudgedMesh> judged_mesh(const FileMesh& mesh, const std::function<void()>& stop,
                                      const std::function<void(int, int)>& crossing) {
  cgal::MeshVerdict found = cgal::judge_mesh(mesh.points, mesh.triangles, stop, crossing);
  return JudgedMesh{static_cast<MeshFacts&&>(found), found.degenerate, found.crossings,
                    found.repeated, std::move(found.crossing_pairs)};
}
#else
std::optional<JudgedMesh> judged_mesh(const FileMesh&, const std::function<void()>&,
                                      const std::function<void(int, int)>&) {
  return {};
}
#endif

reports::Json mesh_check_report(const std::string& file, const FileMesh& mesh,
                                const JudgedMesh& found) {
  return {{"schema", "blossom.mesh-check/1"},
          {"file", file},
          {"verdict", found.sound() ? "sound" : "not sound"},
          {"points", mesh.points.size()},
          {"triangles", mesh.triangles.size()},
          {"parts", found.parts},
          {"closed", found.closed()},
          {"open_sides", found.open_sides},
          {"non_manifold_sides", found.crowded_sides},
          {"turned_sides", found.turned_sides},
          {"degenerate", found.degenerate},
          {"crossings", found.crossings},
          {"repeated", found.repeated},
          {"crossing_triangles", found.crossing_pairs},
          {"area", found.area},
          {"volume", found.closed() ? reports::Json(found.volume) : reports::Json(nullptr)},
          {"notes", mesh.notes}};
}

std::string notes_text(const FileMesh& mesh) {
  std::string text;
  for (const std::string& note : mesh.notes) text += "  " + note + "\n";
  return text;
}

std::string mesh_check_text(const std::string& file, const FileMesh& mesh,
                            const JudgedMesh& found) {
  using reports::counted;
  std::ostringstream text;
  text << file << ": " << (found.sound() ? "sound" : "not sound") << ", "
       << counted(mesh.triangles.size(), "triangle") << ", " << counted(mesh.points.size(), "point")
       << ", " << counted(found.parts, "part") << "\n  " << enclosed_text(found) << "\n";
  const auto line = [&](std::size_t count, const char* noun, const char* what) {
    if (count > 0) text << "  " << counted(count, noun) << " " << what << "\n";
  };
  line(found.open_sides, "side", "of one triangle, or an odd number: the mesh is open");
  line(found.crowded_sides, "side", "of more than two triangles");
  line(found.turned_sides, "side", "whose triangles are turned against each other");
  line(found.degenerate, "triangle", "of no area");
  const std::string repeated =
      found.repeated > 0 ? ", " + std::to_string(found.repeated) + " with the same corners" : "";
  line(found.crossings, "pair", ("of triangles that cross" + repeated).c_str());
  for (std::size_t k = 0; k < found.crossing_pairs.size() && k < kNamedPairs; ++k)
    text << "    triangles " << found.crossing_pairs[k][0] + 1 << " and "
         << found.crossing_pairs[k][1] + 1 << "\n";
  if (found.crossings > kNamedPairs)
    text << "    and " << found.crossings - kNamedPairs << " more\n";
  if (found.closed() && found.volume < 0) text << "  it is turned inside out\n";
  return text.str() + loose_text(mesh, found) + notes_text(mesh);
}

}  // namespace blossom::meshes
