// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces in the place of faces, with the labels of an XDE document following.

#include <string>
#include <utility>
#include <vector>

#include <TDF_LabelSequence.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/documents/parts.h"
#include "adapters/occt/exchange/rebuild.h"

namespace blossom::occt {
namespace {

/// A sub-shape label and what it stood for.
struct OldLabel {
  TDF_Label label;
  TopoDS_Shape shape;
};

/// The first piece takes over the face's label, the others get one of their own.
void label_pieces(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part,
                  const TDF_Label& label, const std::vector<TopoDS_Shape>& pieces) {
  const std::string name = name_of(label);
  set_shape(label, pieces.front());
  if (pieces.size() == 1) return;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const TDF_Label piece = i == 0 ? label : shapes->AddSubShape(part, pieces[i]);
    if (piece.IsNull()) continue;
    if (i > 0) copy_looks(label, piece);
    set_name(piece, numbered_name(name, static_cast<int>(i) + 1));
  }
}

}  // namespace

std::vector<PartCut> cuts_of(const Document& document, const TopTools_IndexedMapOfShape& faces,
                             const std::map<int, std::vector<TopoDS_Shape>>& pieces) {
  std::vector<PartCut> cuts;
  std::map<int, bool> placed;
  for (const Usage& usage : all_usages(document)) {
    const TopoDS_Shape part = XCAFDoc_ShapeTool::GetShape(usage.part);
    TopTools_IndexedMapOfShape here;
    TopExp::MapShapes(part.Moved(usage.location), TopAbs_FACE, here);
    const TopLoc_Location back = usage.location.Inverted();
    PartCut cut{usage, {}, {}};
    for (const auto& [number, news] : pieces) {
      if (placed[number] || !here.Contains(faces(number))) continue;
      placed[number] = true;
      Replacement replacement{TopoDS::Face(faces(number).Moved(back)), {}};
      for (const TopoDS_Shape& piece : news) replacement.pieces.push_back(moved_faces(piece, back));
      cut.numbers.push_back(number);
      cut.replacements.push_back(std::move(replacement));
    }
    if (!cut.replacements.empty()) cuts.push_back(std::move(cut));
  }
  return cuts;
}

bool replace_in_part(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part,
                     const std::vector<Replacement>& replacements) {
  std::vector<OldLabel> olds;
  TDF_LabelSequence subs;
  XCAFDoc_ShapeTool::GetSubShapes(part, subs);
  for (const TDF_Label& sub : subs) olds.push_back({sub, XCAFDoc_ShapeTool::GetShape(sub)});
  Rebuild rebuild(replacements);
  const TopoDS_Shape whole = rebuild(XCAFDoc_ShapeTool::GetShape(part));
  if (whole.IsNull()) return false;
  shapes->SetShape(part, whole);
  forget_properties(part);
  TopTools_IndexedMapOfShape remaining;
  TopExp::MapShapes(whole, remaining);
  for (const OldLabel& old : olds) {
    const Replacement* replacement = rebuild.find(old.shape);
    if (replacement != nullptr && !replacement->pieces.empty()) {
      forget_properties(old.label);
      label_pieces(shapes, part, old.label, replacement->pieces);
      continue;
    }
    const TopoDS_Shape now = replacement == nullptr ? rebuild(old.shape) : TopoDS_Shape();
    if (now.IsNull() || !remaining.Contains(now)) {
      old.label.ForgetAllAttributes();
    } else if (!now.IsSame(old.shape)) {
      forget_properties(old.label);
      set_shape(old.label, now);
    }
  }
  return true;
}

void Document::replace_faces(const Faces& faces,
                             const std::map<int, std::vector<TopoDS_Face>>& pieces) {
  std::map<int, std::vector<TopoDS_Shape>> shapes_of;
  for (const auto& [number, news] : pieces) shapes_of[number] = {news.begin(), news.end()};
  std::vector<TDF_Label> emptied;
  for (const PartCut& cut : cuts_of(*this, faces, shapes_of)) {
    const TDF_Label part = own_part(shapes(), cut.usage);
    if (!replace_in_part(shapes(), part, cut.replacements))
      emptied.push_back(part);
    else if (part != cut.usage.part)
      unshare(shapes(), part);
  }
  for (const TDF_Label& part : emptied) remove_part(shapes(), part);
  forget_assembly_properties(shapes());
  shapes()->UpdateAssemblies();
}

}  // namespace blossom::occt
