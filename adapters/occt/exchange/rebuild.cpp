// SPDX-License-Identifier: LGPL-2.1-or-later
// Shells, solids and compounds around replaced faces.

#include "adapters/occt/exchange/rebuild.h"

#include <cstddef>
#include <utility>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_CompSolid.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/faces/face_groups.h"

namespace blossom::occt {
namespace {

/// Nothing, the only one, or a compound; compounds among the parts are opened.
TopoDS_Shape joined(const std::vector<TopoDS_Shape>& parts) {
  std::vector<TopoDS_Shape> all;
  for (const TopoDS_Shape& part : parts) {
    if (part.IsNull()) continue;
    if (part.ShapeType() != TopAbs_COMPOUND) {
      all.push_back(part);
      continue;
    }
    for (TopoDS_Iterator inner(part); inner.More(); inner.Next()) all.push_back(inner.Value());
  }
  if (all.empty()) return {};
  return all.size() == 1 ? all.front() : compound_of(all);
}

/// The solids among the parts, and a shell for every connected group of faces, in the order of
/// their first faces.
TopoDS_Shape shells_of(const std::vector<TopoDS_Shape>& parts) {
  const BRep_Builder builder;
  std::vector<TopoDS_Shape> shells, faces;
  for (const TopoDS_Shape& part : parts)
    (part.ShapeType() == TopAbs_FACE ? faces : shells).push_back(part);
  for (const FaceGroup& group :
       groups_over_edges(faces, [](const TopoDS_Shape&) { return false; })) {
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (const std::size_t i : group) builder.Add(shell, faces[i]);
    shell.Closed(BRep_Tool::IsClosed(shell));
    shells.push_back(shell);
  }
  return joined(shells);
}

bool stays_shell(const TopoDS_Shape& before, const TopoDS_Shape& after) {
  if (after.IsNull() || after.ShapeType() != TopAbs_SHELL) return false;
  return BRep_Tool::IsClosed(after) || !BRep_Tool::IsClosed(before);
}

template <class Whole>
TopoDS_Shape filled(Whole whole, const std::vector<TopoDS_Shape>& parts) {
  for (const TopoDS_Shape& part : parts) BRep_Builder().Add(whole, part);
  return whole;
}

}  // namespace

std::vector<Replacement> replacements_of(const TopTools_IndexedMapOfShape& faces,
                                         const std::vector<SolidOfFaces>& solids) {
  std::vector<Replacement> replacements;
  for (const SolidOfFaces& solid : solids)
    for (const auto& [number, face] : solid.faces) {
      const bool first = number == solid.faces.begin()->first;
      Replacement& of = replacements.emplace_back(TopoDS::Face(faces(number)));
      if (first) of.pieces.push_back(solid.solid);
    }
  return replacements;
}

Rebuild::Rebuild(const std::vector<Replacement>& replacements) {
  for (const Replacement& replacement : replacements)
    replacements_.Bind(replacement.face, replacement);
}

const Replacement* Rebuild::find(const TopoDS_Shape& face) const {
  return replacements_.Seek(face);
}

std::vector<TopoDS_Shape> Rebuild::pieces_of(const TopoDS_Shape& face) const {
  const Replacement* replacement = find(face);
  if (replacement == nullptr) return {face};
  // A face between two solids is met in both orientations, its pieces are given for one.
  const bool same = face.Orientation() == replacement->face.Orientation();
  std::vector<TopoDS_Shape> pieces;
  for (const TopoDS_Shape& piece : replacement->pieces)
    pieces.push_back(same ? piece : piece.Reversed());
  return pieces;
}

bool Rebuild::is_touched(const TopoDS_Shape& shape) const {
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    if (replacements_.IsBound(face.Current())) return true;
  return false;
}

TopoDS_Shape Rebuild::operator()(const TopoDS_Shape& shape) {
  if (!is_touched(shape)) return shape;
  // Each shape is built once, forward, and turned as it is met.
  if (!done_.IsBound(shape)) done_.Bind(shape, rebuilt(shape.Oriented(TopAbs_FORWARD)));
  const TopoDS_Shape& result = done_.Find(shape);
  const bool reversed = shape.Orientation() == TopAbs_REVERSED;
  return reversed && !result.IsNull() ? result.Reversed() : result;
}

std::vector<TopoDS_Shape> Rebuild::rebuilt_parts(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> parts;
  for (TopoDS_Iterator part(shape); part.More(); part.Next()) {
    if (part.Value().ShapeType() == TopAbs_FACE) {
      for (const TopoDS_Shape& piece : pieces_of(part.Value())) parts.push_back(piece);
    } else if (const TopoDS_Shape now = (*this)(part.Value()); !now.IsNull()) {
      parts.push_back(now);
    }
  }
  return parts;
}

TopoDS_Shape Rebuild::rebuilt(const TopoDS_Shape& shape) {
  if (shape.ShapeType() == TopAbs_FACE) {
    const std::vector<TopoDS_Shape> pieces = pieces_of(shape);
    return pieces.size() == 1 ? pieces.front() : shells_of(pieces);
  }
  const std::vector<TopoDS_Shape> parts = rebuilt_parts(shape);
  if (parts.empty()) return {};
  if (shape.ShapeType() == TopAbs_SHELL) return shells_of(parts);
  if (shape.ShapeType() == TopAbs_COMPOUND) return compound_of(parts);
  bool whole = true;
  for (TopoDS_Iterator part(shape); part.More(); part.Next()) {
    const TopoDS_Shape now = (*this)(part.Value());
    if (part.Value().ShapeType() == TopAbs_SHELL) whole = whole && stays_shell(part.Value(), now);
    if (part.Value().ShapeType() == TopAbs_SOLID)
      whole = whole && !now.IsNull() && now.ShapeType() == TopAbs_SOLID;
  }
  if (!whole) return joined(parts);
  const BRep_Builder builder;
  if (shape.ShapeType() == TopAbs_COMPSOLID) {
    TopoDS_CompSolid solids;
    builder.MakeCompSolid(solids);
    return filled(solids, parts);
  }
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  return filled(solid, parts);
}

}  // namespace blossom::occt
