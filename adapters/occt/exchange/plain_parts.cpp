// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/plain_parts.h"

#include <cstddef>

#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>

namespace blossom::occt {
namespace {

std::vector<int> numbers_in(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind,
                            const TopTools_IndexedMapOfShape& all) {
  TopTools_IndexedMapOfShape own;
  TopExp::MapShapes(shape, kind, own);
  std::vector<int> numbers;
  for (int i = 1; i <= own.Extent(); ++i)
    if (const int number = all.FindIndex(own(i)); number > 0) numbers.push_back(number);
  return numbers;
}

}  // namespace

TopoDS_Shape whole_of(const PlainParts& parts) {
  if (parts.empty()) return {};
  if (parts.size() == 1) return parts.front().shape;
  TopoDS_Compound whole;
  const BRep_Builder builder;
  builder.MakeCompound(whole);
  for (const PlainPart& part : parts)
    if (!part.shape.IsNull()) builder.Add(whole, part.shape);
  return whole;
}

void name_faces(const TopoDS_Shape& shape, const std::string& name,
                const TopTools_IndexedMapOfShape& faces, std::vector<std::string>& names) {
  if (shape.IsNull() || name.empty()) return;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (const int number = faces.FindIndex(it.Current()); number > 0)
      names[static_cast<std::size_t>(number - 1)] = name;
}

std::vector<std::string> face_names(const PlainParts& parts,
                                    const TopTools_IndexedMapOfShape& faces) {
  std::vector<std::string> names = part_paths(parts, faces);
  for (const PlainPart& part : parts)
    for (const NamedShape& named : part.named) name_faces(named.shape, named.name, faces, names);
  return names;
}

std::vector<std::string> part_paths(const PlainParts& parts,
                                    const TopTools_IndexedMapOfShape& faces) {
  std::vector<std::string> names(static_cast<std::size_t>(faces.Extent()));
  for (const PlainPart& part : parts) name_faces(part.shape, part.name, faces, names);
  return names;
}

std::vector<AssemblyNode> assembly(const PlainParts& parts, const TopoDS_Shape& whole,
                                   const TopTools_IndexedMapOfShape& faces) {
  const NumberedShapes all(whole, faces);
  std::vector<AssemblyNode> nodes;
  for (const PlainPart& part : parts) {
    AssemblyNode& node = nodes.emplace_back();
    node.name = node.product = node.path = part.name;
    all.put(part.shape, node);
  }
  return nodes;
}

std::string part_name(const PlainParts& parts, const TopoDS_Face& face) {
  for (const PlainPart& part : parts) {
    TopTools_IndexedMapOfShape own;
    if (!part.shape.IsNull()) TopExp::MapShapes(part.shape, TopAbs_FACE, own);
    if (own.Contains(face)) return part.name;
  }
  return {};
}

NumberedShapes::NumberedShapes(const TopoDS_Shape& whole,
                               const TopTools_IndexedMapOfShape& all_faces)
    : faces(all_faces) {
  if (!whole.IsNull()) TopExp::MapShapes(whole, TopAbs_SOLID, solids);
}

void NumberedShapes::put(const TopoDS_Shape& shape, AssemblyNode& node) const {
  if (shape.IsNull()) return;
  node.solids = numbers_in(shape, TopAbs_SOLID, solids);
  node.faces = numbers_in(shape, TopAbs_FACE, faces);
}

}  // namespace blossom::occt
