// SPDX-License-Identifier: LGPL-2.1-or-later
// Files for tests of reading and writing: a folder of its own, an assembly, a file's story.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blossom::testing {

/// A new folder that is removed with all it holds.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  /// Names of all that is there, hidden files too, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

std::string content(const std::filesystem::path& file);
void write_content(const std::filesystem::path& file, const std::string& text);

/// An assembly "Machine" of a blue plate "Base plate" in the layer "plates" with a red face
/// "TopFace" and a green face "SideFace", and two instances "pin:1", "pin:2" of a yellow "Pin" with
/// the faces "Left" and "Right", which is violet. All parts are boxes: faces 1 to 6 are the
/// plate's, 7 to 12 and 13 to 18 the pins'.
/// unit    as `write.step.unit` takes it
void write_machine(const std::filesystem::path& file, const std::string& unit = "MM");

/// Two assemblies "Left" and "Right" of one instance each, without a name, of a red "Block".
void write_roots(const std::filesystem::path& file);

/// A box "Gauge" with the dimension 40 +0.1 -0.2 between its faces "Left" and "Right".
void write_gauge(const std::filesystem::path& file);

/// Two instances "pair:1", "pair:2" of an assembly of two instances "box:1", "box:2" of a "Box",
/// whose face 1 is called "Fläche". Faces 1 to 6 are box:1 in pair:1, 7 to 12 box:2, and so on.
void write_pairs(const std::filesystem::path& file);

/// An assembly "Works" of the instances "machine:1", "machine:2" of an assembly "Machine", and of
/// "bolt:9" of a "Bolt". The machine has a "plate:1" of a blue "Plate" in the layer "plates", whose
/// face "Top" is red and in the layer "tops", and "bolt:1", "bolt:2" of the yellow "Bolt" in the
/// layer "bolts", with a face "Head"; "bolt:2" is blue, and "bolt:1" violet, but only in
/// "machine:2", which is turned by a right angle. All parts are boxes with six faces each, in this
/// order: machine:1 plate:1, bolt:1, bolt:2, machine:2 likewise, bolt:9.
void write_works(const std::filesystem::path& file, const std::string& unit = "MM");

/// What a STEP file holds, a line for each label: names, colours, layers, sizes, validity;
/// and its dimensions.
std::string story(const std::filesystem::path& file);

}  // namespace blossom::testing
