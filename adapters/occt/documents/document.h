// SPDX-License-Identifier: LGPL-2.1-or-later
// An XDE document, its labels and where parts are used. For this folder only.

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include "adapters/occt/exchange/contents.h"

namespace blossom::occt {

/// An XDE document, closed at the end of its life.
class Document final : public DocumentInterface {
 public:
  explicit Document(const PlainParts& parts = {});
  explicit Document(const Handle(TDocStd_Document) & handle) : handle_(handle) {}
  ~Document() override;

  const Handle(TDocStd_Document) & handle() const { return handle_; }
  TDF_Label main() const { return handle_->Main(); }
  Handle(XCAFDoc_ShapeTool) shapes() const;

  TopoDS_Shape shape() const override;
  std::vector<std::string> face_names(const Faces& faces) const override;
  std::vector<std::string> part_paths(const Faces& faces) const override;
  std::vector<std::optional<FaceColour>> face_colours(const Faces& faces) const override;
  std::vector<AssemblyNode> assembly(const TopoDS_Shape& whole, const Faces& faces) const override;
  std::string part_name(const TopoDS_Face& face) const override;
  std::shared_ptr<DocumentInterface> copy() const override;
  void add(const TopoDS_Shape& shape, const std::string& name,
           const std::vector<double>& colour) override;
  void add_assembly(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts,
                    const std::string& name) override;
  void add_combined(const TopoDS_Shape& shape, const std::string& name,
                    const std::vector<FaceOrigin>& origins) override;
  void replace_faces(const Faces& faces,
                     const std::map<int, std::vector<TopoDS_Face>>& pieces) override;
  void replace_solids(Model& own, const std::vector<CombinedSolid>& solids,
                      CommonFaces common) override;
  void put_solids(const Faces& faces, const std::vector<SolidOfFaces>& solids,
                  const std::string& name) override;
  void leave_out_bad_faces(const NumberSource& source, ReadingReport& report) override;
  FileContent content(Format format, const std::string& unit) const override;

 private:
  TDF_Label add_label(const TopoDS_Shape& shape, const std::string& name) const;

  Handle(TDocStd_Document) handle_;
};

/// The document of a model, made if it has none yet.
Document& document_of(const Model& model);

/// The shape of a label as its parts say: a part, an instance or an assembly.
TopoDS_Shape assembled(const TDF_Label& label);

/// The name of a label in UTF-8; empty if it has none.
std::string name_of(const TDF_Label& label);

/// Gives a label a name in UTF-8, unless it is empty.
void set_name(const TDF_Label& label, const std::string& name);

/// Calls instances as their parts that have no name but Open CASCADE's own, "=>[0:1:1:2]" after the
/// label of the part, which other programs would show.
void name_instances(const Document& document);

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

}  // namespace blossom::occt
