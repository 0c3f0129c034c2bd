// SPDX-License-Identifier: LGPL-2.1-or-later
// What reading, writing and changing models share. For this folder only.

#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <Standard_Transient.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/exchange/contents.h"
#include "adapters/occt/repair/repair.h"
#include "adapters/occt/shapes.h"

namespace blossom::occt {

/// Reading, writing and documents share tables of Open CASCADE that are not thread-safe.
std::recursive_mutex& exchange_lock();

struct Model::Impl : Contents {
  std::filesystem::path file;
  ReadingReport reading;
  StatedTolerances stated = StatedTolerances::Kept;
  std::optional<Sewing> sewing;        ///< what became of loose faces, once they were looked at
  Sewable sewn = Sewable::Open;        ///< which were
  std::unique_ptr<Repairer> repairer;  ///< of `shape`; null until something is to be repaired

  /// After a change of what it holds: takes shape and face numbers from it.
  void refresh();

  /// Made when it is first asked for.
  Repairer& repairs();
};

/// Why there are none: who reads again after a crash asks for none.
inline constexpr const char* kNamesNotRead = "reading them fails, or is not wanted";

/// What becomes of a face without a border of it that cannot be made: a hole is closed, and without
/// the outer border all of the surface is there.
inline constexpr const char* kBorderLost =
    "Open CASCADE cannot make it, and the face goes on where it should end";

/// A file beside a STEP file, which has a part of it.
struct OtherFile {
  Handle(Standard_Transient) product;  ///< in the session of the STEP file
  std::filesystem::path file;
  std::shared_ptr<Model> model = {};  ///< with a document; null if it cannot be read
};

/// A file on its way into a model.
struct Reading {
  Contents& contents;
  const std::filesystem::path& file;
  const ReadOptions& options;
  ReadingReport& report;
  std::string text = {};     ///< of the file, unpacked
  std::string step = {};     ///< what is being done
  bool asking = false;       ///< the caller is told a step: what that throws is no fault of ours
  bool names_files = false;  ///< for parts of it
  std::vector<OtherFile> others = {};  ///< that are there

  /// Says what is done next.
  void begin(const char* doing);

  /// Lists that there are shapes alone.
  void lose_names(const std::string& cause);
};

/// Refuses a file of which nothing is left, for the first loss of shape or else for `cause`.
/// throws   BadModel
[[noreturn]] void refuse(const std::string& cause, const ReadingReport& report);

/// A length unit's name in a file, "millimetre" or "INCH", in the words of `write.step.unit`.
std::string unit_named(const std::string& name);

/// Whether that is the name of a unit at all.
bool names_unit(const std::string& name);

/// Line ends of old Macintoshes, which have no line feeds, become line feeds.
void mend_line_ends(std::string& text);

/// Lists what is lost.
/// throws   BadModel with the cause, without the file's name
void read_brep(Reading& reading);

/// A shape from BREP text or binary BREP. What is cut off or cannot be read is listed; null if
/// nothing is left.
TopoDS_Shape brep_shape(const std::string& bytes, ReadingReport& report);

/// Why the first surface is refused that Open CASCADE cannot read from a BREP text; nothing if it
/// reads them all.
std::string why_without_surface(const std::string& text);

/// Whether a BREP text has curves whose numbers Open CASCADE refuses; edges have none instead.
bool loses_curves(const std::string& text);

}  // namespace blossom::occt
