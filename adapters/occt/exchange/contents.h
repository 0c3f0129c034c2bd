// SPDX-License-Identifier: LGPL-2.1-or-later
// What a model holds: plain parts, or a document as soon as more is to be kept. For this folder and
// `documents` only.

#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/exchange/plain_parts.h"
#include "adapters/occt/face_colours.h"
#include "adapters/occt/shapes.h"

namespace blossom::occt {

/// Glb is written only: of the triangles that lie on faces.
enum class Format { Step, Iges, Brep, Glb };

/// By the ending, in any case.
/// throws   BadModel if the ending is not known
Format format_of(const std::filesystem::path& file);

class NumberSource;  // see numbers.h

/// How many things there are beside shapes, by their kind in words: "annotation", "layer".
using BesideShapes = std::map<std::string, int>;

/// What a file is to hold.
struct FileContent {
  std::string bytes;
  BesideShapes beside = {};  ///< what of that is in it
};

/// A solid that loose faces have become.
struct SolidOfFaces {
  TopoDS_Solid solid;
  std::map<int, TopoDS_Face> faces;  ///< by the number that it had, each face as it is in the solid
};

/// An XDE document: parts and assemblies with names, colours, layers and dimensions. What is behind
/// it takes long to load, see modules.h; face numbers are those of the model.
class DocumentInterface {
 public:
  DocumentInterface() = default;
  virtual ~DocumentInterface() = default;
  DocumentInterface(const DocumentInterface&) = delete;
  DocumentInterface& operator=(const DocumentInterface&) = delete;

  using Faces = TopTools_IndexedMapOfShape;

  /// All parts at their places; null if there are none.
  virtual TopoDS_Shape shape() const = 0;

  // As the functions of Model are, and face_colours.
  virtual std::vector<std::string> face_names(const Faces& faces) const = 0;
  virtual std::vector<std::string> part_paths(const Faces& faces) const = 0;
  virtual std::vector<std::optional<FaceColour>> face_colours(const Faces& faces) const = 0;
  virtual std::vector<AssemblyNode> assembly(const TopoDS_Shape& whole,
                                             const Faces& faces) const = 0;
  virtual std::string part_name(const TopoDS_Face& face) const = 0;
  virtual std::shared_ptr<DocumentInterface> copy() const = 0;
  virtual void add(const TopoDS_Shape& shape, const std::string& name,
                   const std::vector<double>& colour) = 0;
  virtual void add_assembly(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts,
                            const std::string& name) = 0;
  virtual void add_combined(const TopoDS_Shape& shape, const std::string& name,
                            const std::vector<FaceOrigin>& origins) = 0;
  virtual void replace_faces(const Faces& faces,
                             const std::map<int, std::vector<TopoDS_Face>>& pieces) = 0;
  virtual void replace_solids(Model& own, const std::vector<CombinedSolid>& solids,
                              CommonFaces common) = 0;

  /// Puts solids in the place of loose faces of which they are made; see Model::sew.
  virtual void put_solids(const Faces& faces, const std::vector<SolidOfFaces>& solids,
                          const std::string& name) = 0;

  /// See numbers.h.
  virtual void leave_out_bad_faces(const NumberSource& source, ReadingReport& report) = 0;

  /// What a file of the format holds; BREP has no documents.
  /// unit     in the words of `write.step.unit`
  /// throws   Failure
  virtual FileContent content(Format format, const std::string& unit) const = 0;
};

/// What a model holds.
struct Contents {
  PlainParts parts;                             ///< while there is no document
  std::shared_ptr<DocumentInterface> document;  ///< null as long as the parts are enough
  std::string unit = "MM";                      ///< of the file, in the words of `write.step.unit`
  BesideShapes beside;                          ///< in the file, where the document came from one
  TopoDS_Shape shape;                           ///< of all parts
  TopTools_IndexedMapOfShape faces;             ///< of the shape

  /// Takes shape and face numbers from the parts or the document.
  void refresh();
};

/// Of a model, which may be made a document even if it is const.
Contents& contents_of(const Model& model);

/// The document, made of the parts if there is none yet.
/// throws   Failure if what documents need is not installed
DocumentInterface& document_of(Contents& contents);

}  // namespace blossom::occt
