// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with faces, as Open CASCADE's BRepCheck and the conversion of their surfaces see
// it.
#include <algorithm>
#include <cstddef>
#include <exception>

#include <oneapi/tbb/parallel_for.h>
#include <BRepCheck_Analyzer.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/check_words.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/solids/faces_to_check.h"
#include "adapters/occt/solids/polygon_faces.h"
#include "adapters/occt/soundness.h"

namespace blossom::occt {
namespace {

// So few are checked before threads would have begun.
constexpr std::size_t kFewFaces = 16;

std::vector<std::string> found_by_check(const TopoDS_Face& given) {
  if (is_sound_polygon(given)) return {};
  const TopoDS_Face face = FacesToCheck().add(given);
  const BRepCheck_Analyzer analyzer(face);
  if (analyzer.IsValid()) return {};
  std::vector<std::string> problems;
  for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_WIRE, TopAbs_EDGE, TopAbs_VERTEX}) {
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(face, kind, shapes);
    for (int i = 1; i <= shapes.Extent(); ++i)
      add_words_of(analyzer.Result(shapes(i)), kind, problems);
  }
  if (problems.empty()) problems.emplace_back("an edge does not fit the face");
  return problems;
}

}  // namespace

std::vector<std::string> face_problems(const TopoDS_Face& face) {
  try {
    // Open CASCADE's checker does not look for numbers that are none, and can loop on them.
    guarded("converting the face", [&] { bezier_surface(face); });
    return guarded("checking the face", [&] { return found_by_check(face); });
  } catch (const std::runtime_error& error) {
    return {error.what()};
  }
}

std::string face_fault(const TopoDS_Face& face) {
  std::string text;
  for (const std::string& problem : face_problems(face))
    text += (text.empty() ? "" : "; ") + problem;
  return text;
}

std::vector<std::vector<std::string>> face_problems(const std::vector<TopoDS_Face>& faces,
                                                    const std::vector<int>& numbers,
                                                    const CheckRunner& run) {
  std::vector<std::vector<std::string>> found(faces.size());
  const bool done = faces.size() > kFewFaces && run("checking faces", [&] {
                      tbb::parallel_for(std::size_t{0}, faces.size(),
                                        [&](std::size_t i) { found[i] = face_problems(faces[i]); });
                    });
  if (done) return found;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (!run("checking face " + std::to_string(numbers[i]),
             [&] { found[i] = face_problems(faces[i]); }))
      found[i] = {kUnchecked};
  return found;
}

}  // namespace blossom::occt
