// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with faces, as Open CASCADE's BRepCheck and the conversion of their surfaces see
// it.
#include <cstddef>
#include <optional>
#include <utility>

#include <BRepCheck_Analyzer.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/check_words.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/kept_forms.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/solids/validity/faces_to_check.h"
#include "adapters/occt/solids/validity/polygon_faces.h"
#include "adapters/occt/solids/validity/sound_faces.h"
#include "adapters/occt/soundness.h"
#include "core/base/parallel.h"

namespace blossom::occt {
namespace {

// So few are checked before threads would have begun.
constexpr std::size_t kFewFaces = 16;

// Of a face of which nothing is known: the loops of polygons are in doubt already.
std::vector<std::string> found_by_check(const TopoDS_Face& face) {
  if (!is_held_polygon(face) && is_sound_face(face)) return {};
  if (has_hole_astray(face)) return {"a hole does not lie in it"};
  const BRepCheck_Analyzer analyzer(face);
  if (analyzer.IsValid()) return {};
  std::vector<std::string> problems;
  // What is wrong with the whole may come of its parts.
  for (const TopAbs_ShapeEnum kind : {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_WIRE, TopAbs_FACE}) {
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(face, kind, shapes);
    for (int i = 1; i <= shapes.Extent(); ++i)
      add_words_of(analyzer.Result(shapes(i)), kind, problems);
  }
  if (problems.empty()) problems.emplace_back("an edge does not fit the face");
  return problems;
}

// What a check finds; one that fails on a face's numbers is a problem of the face.
template <class Check>
std::vector<std::string> found_by(const Check& check) try {
  return guarded("checking the face", check);
} catch (const Failure& failure) {
  return {failure.what()};
}

// What is known of a face before Open CASCADE's checker sees it: that it cannot be converted, or
// that it is sound. The checker does not look for numbers that are none, and can loop on them.
std::optional<std::vector<std::string>> known_of(const TopoDS_Face& face, KeptForms* forms) {
  if (std::vector<std::string> problems = conversion_problems(face, forms); !problems.empty())
    return problems;
  bool sound = false;
  std::vector<std::string> problems = found_by([&] {
    sound = is_sound_polygon(face);
    return std::vector<std::string>();
  });
  if (problems.empty() && !sound) return std::nullopt;
  return problems;
}

// Checks only read what faces share; making copies writes to vertices, so one thread does it.
std::vector<std::vector<std::string>> found_in_threads(const std::vector<TopoDS_Face>& faces,
                                                       KeptForms* forms) {
  std::vector<std::optional<std::vector<std::string>>> known(faces.size());
  parallel_for(faces.size(), 1, [&](std::size_t i) { known[i] = known_of(faces[i], forms); });
  FacesToCheck copies;
  std::vector<TopoDS_Face> copy(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (known[i]) continue;
    std::vector<std::string> problems = found_by([&] {
      copy[i] = copies.add(faces[i]);
      return std::vector<std::string>();
    });
    if (!problems.empty()) known[i] = std::move(problems);
  }
  std::vector<std::vector<std::string>> found(faces.size());
  parallel_for(faces.size(), 1, [&](std::size_t i) {
    found[i] = known[i] ? *known[i] : found_by([&] { return found_by_check(copy[i]); });
  });
  return found;
}

}  // namespace

std::vector<std::string> conversion_problems(const TopoDS_Face& face, KeptForms* forms) try {
  guarded("converting the face", [&] {
    if (forms != nullptr)
      forms->make(face);
    else
      bezier_surface(face);
  });
  return {};
} catch (const std::runtime_error& error) {
  return {error.what()};
}

std::vector<std::string> face_problems(const TopoDS_Face& face, KeptForms* forms) {
  if (const auto known = known_of(face, forms)) return *known;
  return found_by([&] { return found_by_check(FacesToCheck().add(face)); });
}

std::string face_fault(const TopoDS_Face& face) {
  std::string text;
  for (const std::string& problem : face_problems(face))
    text += (text.empty() ? "" : "; ") + problem;
  return text;
}

std::vector<std::vector<std::string>> face_problems(const std::vector<TopoDS_Face>& faces,
                                                    const std::vector<int>& numbers,
                                                    const CheckRunner& run, KeptForms* forms) {
  std::vector<std::vector<std::string>> found(faces.size());
  if (faces.size() > kFewFaces &&
      run("checking faces", [&] { found = found_in_threads(faces, forms); }))
    return found;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (!run("checking face " + std::to_string(numbers[i]),
             [&] { found[i] = face_problems(faces[i], forms); }))
      found[i] = {kUnchecked};
  return found;
}

}  // namespace blossom::occt
