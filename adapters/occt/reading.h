// SPDX-License-Identifier: LGPL-2.1-or-later
// What reading a model lost: a damaged file gives what is whole in it, and says what is not there.

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace blossom::occt {

/// How much of a file has become a model.
enum class ReadingGrade {
  Whole,
  AttributesLost,  ///< names, colours, dimensions, presentation: no shape is touched
  ShapesLost,      ///< faces, edges or parts are missing, or are not as the file has them
};

/// "whole", "attributes lost" or "shapes lost": the words of JSON reports.
const char* to_string(ReadingGrade grade);

/// Things of one kind that are lost for one cause.
struct Loss {
  std::string what;   ///< the kind in words, "face" or "SEAM_CURVE"
  std::string cause;  ///< in words
  bool of_shape = false;
  int count = 1;
  std::vector<std::string> which = {};       ///< the first few, as "#12" or "face 3"
  std::vector<std::string> belongs_to = {};  ///< faces and products that have them, the first few

  /// "2 faces (#12, #15 of product 'Bolt'): the cause".
  std::string text() const;
};

/// All losses of a reading.
struct ReadingReport {
  std::vector<Loss> losses;
  std::vector<std::string> notes = {};  ///< what was made otherwise than the file has it, in words

  ReadingGrade grade() const;

  /// Adds to the loss of the same kind and cause, or as a new one.
  void add(const Loss& loss);

  /// One line: how much was lost, of shape first, and the first cause; empty if all is there.
  std::string summary() const;
};

/// How the step begins in which Open CASCADE reads what is no shape; see ReadOptions.
inline constexpr const char* kReadingNames = "reading names and colours";

/// Likewise of the step in which Open CASCADE makes faces of damaged entities.
inline constexpr const char* kMakingDamaged = "making faces of damaged entities";

/// How to read, and who wants to know how far it is.
struct ReadOptions {
  /// Without them, a file whose names, colours or dimensions cannot be read gives its shapes. The
  /// assembly goes with them.
  bool names = true;

  /// Without them, colours, layers, dimensions and what else STEP has beside shapes and names may
  /// be left out: who only looks at shapes and their names has the answer sooner.
  bool looks = true;

  /// Faces of damaged entities in STEP files, without a curve for an edge, say, are made of what is
  /// left of them, as far as Open CASCADE can, and listed as losses of shape. It crashes on some of
  /// these, or never comes back: for programs that outlive it. Without, they are left out.
  bool damaged = false;

  /// Told each step before it begins: "transferring the shapes of part.step". What it throws ends
  /// the reading.
  std::function<void(const char* step)> step = {};

  /// Of a file that another one names for its parts: it is left out, as reading it is known to end
  /// programs.
  bool left_out = false;

  /// How to read such a file, which is asked before each; as the one that names it without this.
  std::function<ReadOptions(const std::filesystem::path& file)> other = {};
};

/// Processor seconds that Open CASCADE may take to read a file, or to check a face of it. The
/// slowest sound files that we know take 7e-6 s a byte, most a tenth of that; packed files are up
/// to ten times as long as they seem.
double reading_allowance(const std::filesystem::path& file);

/// The same for so many bytes that are not packed.
double reading_allowance(double bytes);

}  // namespace blossom::occt
