// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/input.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/reading.h"
#include "adapters/occt/soundness.h"

namespace blossom::reports {
namespace {

constexpr const char* kNoName = "Open CASCADE STEP translator";  // its writer's word for no name

// Of the faces that are left: solids that lose none, with their inside, and other faces.
void select_what_is_left(Input& input) {
  TopTools_IndexedMapOfShape solids, left, bounding;
  TopExp::MapShapes(input.model.shape(), TopAbs_SOLID, solids);
  for (const int number : input.numbers) left.Add(input.model.face(number));
  input.solids.clear();
  std::vector<TopoDS_Shape> shapes;
  for (int number = 1; number <= solids.Extent(); ++number) {
    const std::vector<TopoDS_Face> faces = occt::faces_of(solids(number));
    if (!std::ranges::all_of(faces, [&](const TopoDS_Face& face) { return left.Contains(face); }))
      continue;
    input.solids.push_back(number);
    shapes.push_back(solids(number));
    for (const TopoDS_Face& face : faces) bounding.Add(face);
  }
  for (int i = 1; i <= left.Extent(); ++i)
    if (!bounding.Contains(left(i))) shapes.push_back(left(i));
  if (!input.solids.empty()) input.selected = occt::compound_of(shapes);
}

}  // namespace

void refuse_open_wires(const Input& input) {
  for (std::size_t i = 0; i < input.faces.size(); ++i)
    if (occt::has_open_wire(input.faces[i]))
      throw occt::BadModel(input.name + ": a wire of face " + std::to_string(input.numbers[i]) +
                           " is open and encloses nothing; `blossom check` lists what is wrong");
}

UnusableFaces drop_unusable_faces(Input& input) {
  if (static_cast<int>(input.numbers.size()) < input.model.face_count()) return {};
  const bool damaged = input.model.reading().grade() == occt::ReadingGrade::ShapesLost;
  UnusableFaces dropped;
  std::vector<int> kept;
  std::vector<TopoDS_Face> faces;
  for (std::size_t i = 0; i < input.faces.size(); ++i) {
    const TopoDS_Face& face = input.faces[i];
    if (damaged && (occt::has_open_wire(face) || occt::is_endless(face))) {
      dropped.open.push_back(input.numbers[i]);
    } else if (occt::has_no_width(face)) {
      dropped.lines.push_back(input.numbers[i]);
    } else {
      kept.push_back(input.numbers[i]);
      faces.push_back(face);
    }
  }
  if (kept.empty() || kept.size() == input.faces.size()) return {};
  input.numbers = std::move(kept);
  input.faces = std::move(faces);
  select_what_is_left(input);
  return dropped;
}

std::string given_name(const std::string& part) { return part.starts_with(kNoName) ? "" : part; }

std::string FaceLabels::of(int number) const {
  const std::string part = given_name(parts_.at(static_cast<std::size_t>(number) - 1));
  return "face " + std::to_string(number) + (part.empty() ? "" : " (" + part + ")");
}

std::vector<std::string> face_labels(const Input& input) {
  const FaceLabels labels(input);
  std::vector<std::string> all;
  for (const int number : input.numbers) all.push_back(labels.of(number));
  return all;
}

std::size_t selection_mark(const std::string& text) {
  const std::size_t last = text.rfind('#');
  for (std::size_t mark = last; mark != std::string::npos && mark > 0;
       mark = text.rfind('#', mark - 1))
    if (std::error_code ignored; std::filesystem::exists(text.substr(0, mark), ignored))
      return mark;
  return last;
}

std::string short_name(const std::string& input) {
  const std::size_t end = std::min(selection_mark(input), input.size());  // "/" may follow
  const std::size_t slash = input.rfind('/', end);
  return slash == std::string::npos ? input : input.substr(slash + 1);
}

}  // namespace blossom::reports
