// SPDX-License-Identifier: LGPL-2.1-or-later
// What reading, writing and changing models share. For this folder only.

#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_Reader.hxx>

#include "adapters/occt/repair/repair.h"
#include "adapters/occt/shapes.h"

namespace blossom::occt {

/// Glb is written only: of the triangles that lie on faces.
enum class Format { Step, Iges, Brep, Glb };

/// By the ending, in any case.
/// throws   BadModel if the ending is not known
Format format_of(const std::filesystem::path& file);

/// Reading, writing and documents share tables of Open CASCADE that are not thread-safe.
std::recursive_mutex& exchange_lock();

/// An XDE document, closed at the end of its life.
class Document {
 public:
  Document();
  ~Document();
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const Handle(TDocStd_Document) & handle() const { return handle_; }
  TDF_Label main() const { return handle_->Main(); }
  Handle(XCAFDoc_ShapeTool) shapes() const;

  /// Becomes empty.
  void renew();

  /// The length unit of the file, in the words of `write.step.unit`: "MM", "INCH", ...
  std::string unit = "MM";

 private:
  Handle(TDocStd_Document) handle_;
};

/// The shape of a label as its parts say: a part, an instance or an assembly.
TopoDS_Shape assembled(const TDF_Label& label);

/// The name of a label in UTF-8; empty if it has none.
std::string name_of(const TDF_Label& label);

/// Gives a label a name in UTF-8, unless it is empty.
void set_name(const TDF_Label& label, const std::string& name);

/// Where a part is used: from a root, the number of the component in every assembly on the way.
/// Numbers, because components get new labels when an assembly is copied.
struct Usage {
  TDF_Label root;
  std::vector<int> components;
  TDF_Label part;
  TopLoc_Location location;
  std::vector<TDF_Label> instances;  ///< on the way from the root to the part
  std::string
      path;  ///< names of instances from the outside in, "machine:2/bolt:1"; empty of a root
};

/// All uses of all parts.
std::vector<Usage> all_usages(const Document& document);

/// The path of a usage, or the name of a part that is in no assembly.
std::string part_path(const Usage& usage);

/// Adds every instance of a part to another document as a part of its own at its place, named by
/// its path (beginning with the root's name if there are several), with the looks that it has
/// there: for files without assemblies.
void add_instances(const Document& from, const Document& to);

struct Model::Impl {
  Document document;
  std::filesystem::path file;
  ReadingReport reading;
  TopoDS_Shape shape;
  TopTools_IndexedMapOfShape faces;
  StatedTolerances stated = StatedTolerances::Kept;
  std::unique_ptr<Repairer> repairer;  ///< of `shape`; null until something is to be repaired

  /// Takes shape and face numbers from the document.
  void refresh();

  /// Made when it is first asked for.
  Repairer& repairs();
};

/// A file on its way into a document.
struct Reading {
  Document& document;
  const std::filesystem::path& file;
  const ReadOptions& options;
  ReadingReport& report;
  std::string text = {};  ///< of the file, unpacked
  std::string step = {};  ///< what is being done

  /// Says what is done next.
  void begin(const char* doing);

  /// Puts the shapes that `reader` has transferred into the document: by `transfer`, with names and
  /// colours, or without them if they are not wanted or fail, which is then reported.
  void with_names(const XSControl_Reader& reader, const std::function<bool()>& transfer);
};

/// Refuses a file of which nothing is left, for the first loss of shape or else for `cause`.
/// throws   BadModel
[[noreturn]] void refuse(const std::string& cause, const ReadingReport& report);

/// A length unit's name in a file, "millimetre" or "INCH", in the words of `write.step.unit`.
std::string unit_named(std::string name);

/// Line ends of old Macintoshes, which have no line feeds, become line feeds.
void mend_line_ends(std::string& text);

/// They list what is lost, and leave out what must not be made.
/// throws   BadModel with the cause, without the file's name
void read_step(Reading& reading);
void read_iges(Reading& reading);
void read_brep(Reading& reading);

/// A shape from BREP text or binary BREP. What is cut off or cannot be read is listed; null if
/// nothing is left.
TopoDS_Shape brep_shape(const std::string& bytes, ReadingReport& report);

/// Why the first surface is refused that Open CASCADE cannot read from a BREP text; nothing if it
/// reads them all.
std::string why_without_surface(const std::string& text);

/// Whether a BREP text has curves whose numbers Open CASCADE refuses; edges have none instead.
bool loses_curves(const std::string& text);

/// Takes faces out of the document that have no surface, or whose surface, curves or points have
/// numbers that are none, and lists them. Curves that a BREP text has and Open CASCADE does not
/// read count among these.
void leave_out_bad_faces(const Document& document, Format format, const std::string& text,
                         ReadingReport& report);

}  // namespace blossom::occt
