// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads a STEP file, cuts its faces with a plane, keeps what is above, and writes it with names and
// colours.
//
// usage: 05_trim_a_step_file IN.step OUT.step   (without IN.step: a part that is made here)

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <BRepPrimAPI_MakeCylinder.hxx>

#include "adapters/occt/half_space.h"
#include "adapters/occt/plane_section.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/trim.h"

namespace {

using namespace blossom;

void write_pin(const std::string& file) {
  occt::Model model;
  model.add(BRepPrimAPI_MakeCylinder(2, 10).Shape(), "Pin", {0.8, 0.3, 0.1});
  occt::write_model(model, file);
}

// The faces above the plane z = 4 take the place of those that were there.
occt::TrimResult trim(occt::Model& model) {
  std::vector<occt::PartFace> faces;
  for (int number = 1; number <= model.face_count(); ++number)
    faces.push_back({number, model.face(number)});
  const occt::TrimTool tool = occt::plane_tool({{0, 0, 4}, {0, 0, 1}}, model.shape(), "z = 4");

  occt::TrimOptions options;
  options.keep = occt::Keep::Above;
  occt::TrimResult made = occt::trim(faces, {tool}, options);
  model.replace_faces(made.replacements);
  return made;
}

void print(const occt::TrimResult& made) {
  std::printf("%s, %zu pieces\n", to_string(made.status), made.pieces.size());
  for (const occt::TrimPiece& piece : made.pieces)
    std::printf("  piece %d of face %d: %s, area %.9f%s\n", piece.number, piece.face,
                occt::to_string(piece.side), piece.area, piece.kept ? "" : ", left out");
}

}  // namespace

int main(int count, char** words) try {
  if (count != 2 && count != 3) {
    std::fprintf(stderr, "usage: 05_trim_a_step_file [IN.step] OUT.step\n");
    return 2;
  }
  occt::quiet_messages();  // of Open CASCADE, on stdout
  const std::string out = words[count - 1];
  if (count == 2) write_pin(out);
  occt::Model model = occt::read_model(count == 2 ? out : std::string(words[1]));
  const occt::TrimResult made = trim(model);
  print(made);
  occt::write_model(model, out);

  // What was written can be read again, with the part's name.
  const occt::Model again = occt::read_model(out);
  std::printf("%s has %d faces of %s\n", out.c_str(), again.face_count(),
              again.part_name(1).c_str());
  return made.status == Status::Complete && again.face_count() == model.face_count() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
