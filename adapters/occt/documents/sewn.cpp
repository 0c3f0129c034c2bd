// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids in the place of the loose faces that close them, with the labels of an XDE document
// following.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <TDF_LabelSequence.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/documents/parts.h"

namespace blossom::occt {
namespace {

/// One solid on its way into the document.
class SolidPlacing {
 public:
  SolidPlacing(const Document& document, const SolidOfFaces& solid)
      : document_(document), shapes_(document.shapes()), solid_(solid) {}

  /// The part in which the first face lies has the solid; the others bring what their faces look
  /// like, and lose them.
  /// returns   the parts of which nothing is left
  std::vector<TDF_Label> place(const std::vector<PartCut>& cuts, const std::string& name) {
    std::vector<TDF_Label> emptied;
    for (const PartCut& cut : cuts) {
      const TDF_Label part = own_part(shapes_, cut.usage);
      const bool first = target_.IsNull();
      if (first) {
        target_ = part;
        back_ = cut.usage.location.Inverted();
      }
      if (!replace(part, cut)) emptied.push_back(part);
    }
    if (cuts.size() > 1 || name_of(target_).empty()) set_name(target_, name);
    return emptied;
  }

 private:
  using Looks = std::pair<TDF_Label, int>;  // what has them, and the number of the face

  TopoDS_Face now(int number) const { return TopoDS::Face(solid_.faces.at(number).Moved(back_)); }

  /// What looks like a face: its label, or the part that is the face.
  std::vector<Looks> looks_of(const TDF_Label& part, const PartCut& cut) const {
    std::vector<TDF_Label> labels{part};
    TDF_LabelSequence subs;
    XCAFDoc_ShapeTool::GetSubShapes(part, subs);
    labels.insert(labels.end(), subs.begin(), subs.end());
    std::vector<Looks> found;
    for (const TDF_Label& label : labels)
      for (std::size_t i = 0; i < cut.numbers.size(); ++i)
        if (cut.replacements[i].face.IsSame(XCAFDoc_ShapeTool::GetShape(label)))
          found.emplace_back(label, cut.numbers[i]);
    return found;
  }

  /// The label of a face of the solid; labels of the part that has it stay.
  void label(const Looks& looks, const TDF_Label& part) {
    const auto& [from, number] = looks;
    if (from != part && part == target_) return set_shape(from, now(number));
    const TDF_Label label = shapes_->AddSubShape(target_, now(number));
    if (!label.IsNull()) copy_looks(from, label);
    if (from == part) forget_colours(part);
  }

  /// The part was one face, and its colour is not that of the solid.
  void forget_colours(const TDF_Label& part) const {
    const auto colours = XCAFDoc_DocumentTool::ColorTool(document_.main());
    for (const XCAFDoc_ColorType type : kColourTypes) colours->UnSetColor(part, type);
  }

  bool replace(const TDF_Label& part, const PartCut& cut) {
    const std::vector<Looks> looks = looks_of(part, cut);
    std::vector<std::pair<TDF_Label, TopoDS_Shape>> olds;
    TDF_LabelSequence subs;
    XCAFDoc_ShapeTool::GetSubShapes(part, subs);
    for (const TDF_Label& sub : subs) olds.emplace_back(sub, XCAFDoc_ShapeTool::GetShape(sub));
    Rebuild rebuild(cut.replacements);
    const TopoDS_Shape whole = rebuild(XCAFDoc_ShapeTool::GetShape(part));
    if (!whole.IsNull()) shapes_->SetShape(part, whole);
    forget_properties(part);
    for (const Looks& face : looks) label(face, part);
    TopTools_IndexedMapOfShape remaining;
    if (!whole.IsNull()) TopExp::MapShapes(whole, remaining);
    for (const auto& [sub, shape] : olds) follow(sub, shape, rebuild, remaining);
    return !whole.IsNull();
  }

  /// A label that is no replaced face's stands for what is left of its shape.
  static void follow(const TDF_Label& label, const TopoDS_Shape& old, Rebuild& rebuild,
                     const TopTools_IndexedMapOfShape& remaining) {
    if (rebuild.find(old) != nullptr) return;
    const TopoDS_Shape left = rebuild(old);
    if (left.IsNull() || !remaining.Contains(left)) return label.ForgetAllAttributes();
    if (left.IsSame(old)) return;
    forget_properties(label);
    set_shape(label, left);
  }

  const Document& document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  const SolidOfFaces& solid_;
  TDF_Label target_;
  TopLoc_Location back_;
};

}  // namespace

void Document::put_solids(const Faces& faces, const std::vector<SolidOfFaces>& solids,
                          const std::string& name) {
  for (const SolidOfFaces& solid : solids) {
    std::map<int, std::vector<TopoDS_Shape>> pieces;
    for (const auto& [number, face] : solid.faces) pieces[number];
    pieces.begin()->second.push_back(solid.solid);
    for (const TDF_Label& part :
         SolidPlacing(*this, solid).place(cuts_of(*this, faces, pieces), name))
      remove_part(shapes(), part);
  }
  forget_assembly_properties(shapes());
  shapes()->UpdateAssemblies();
}

}  // namespace blossom::occt
