// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/input.h"

#include <cstddef>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/reading.h"
#include "adapters/occt/soundness.h"

namespace blossom::reports {
namespace {

constexpr const char* kNoName = "Open CASCADE STEP translator";  // its writer's word for no name

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
  if (kept.empty()) return {};
  input.numbers = std::move(kept);
  input.faces = std::move(faces);
  return dropped;
}

std::string given_name(const std::string& part) { return part.starts_with(kNoName) ? "" : part; }

}  // namespace blossom::reports
