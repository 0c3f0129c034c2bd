// SPDX-License-Identifier: LGPL-2.1-or-later
// Combined solids in the place of those that they come from, with the labels of an XDE document
// following.

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <BRep_Builder.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/documents/parts.h"

namespace blossom::occt {
namespace {

using Solids = std::vector<const CombinedSolid*>;

/// The solids that come from one use of a part.
struct PartSolids {
  Usage usage;
  std::set<int> numbers;  ///< of the model's faces that lie there
  Solids solids;
};

/// All uses of parts, each with the solids whose first face of the model lies there; and the
/// solids that have no face of the model.
std::pair<std::vector<PartSolids>, Solids> by_parts(const Document& document,
                                                    const TopTools_IndexedMapOfShape& faces,
                                                    const std::vector<CombinedSolid>& solids,
                                                    const Model& model) {
  std::vector<PartSolids> parts;
  std::vector<std::size_t> part_of(static_cast<std::size_t>(faces.Extent()) + 1);
  std::set<int> placed;
  for (const Usage& usage : all_usages(document)) {
    PartSolids part{usage, {}, {}};
    TopExp_Explorer it(XCAFDoc_ShapeTool::GetShape(usage.part).Moved(usage.location), TopAbs_FACE);
    for (; it.More(); it.Next())
      if (const int number = faces.FindIndex(it.Current()); placed.insert(number).second) {
        part.numbers.insert(number);
        part_of[static_cast<std::size_t>(number)] = parts.size();
      }
    parts.push_back(std::move(part));
  }
  Solids others;
  for (const CombinedSolid& solid : solids) {
    const auto own = std::find_if(solid.faces.begin(), solid.faces.end(),
                                  [&](const FaceOrigin& face) { return face.model == &model; });
    if (own == solid.faces.end())
      others.push_back(&solid);
    else
      parts[part_of[static_cast<std::size_t>(own->number)]].solids.push_back(&solid);
  }
  return {std::move(parts), std::move(others)};
}

/// Loose edges and vertices of a part stay when its solids change.
void add_loose(const TopoDS_Shape& from, TopoDS_Compound& to) {
  const BRep_Builder builder;
  for (TopExp_Explorer edge(from, TopAbs_EDGE, TopAbs_FACE); edge.More(); edge.Next())
    builder.Add(to, edge.Current());
  for (TopExp_Explorer vertex(from, TopAbs_VERTEX, TopAbs_EDGE); vertex.More(); vertex.Next())
    builder.Add(to, vertex.Current());
}

bool has_loose(const TopoDS_Shape& shape) {
  return TopExp_Explorer(shape, TopAbs_EDGE, TopAbs_FACE).More() ||
         TopExp_Explorer(shape, TopAbs_VERTEX, TopAbs_EDGE).More();
}

/// Solids moved to where the part stands, in a compound unless there is one alone.
TopoDS_Shape shape_of(const Solids& solids, const TopLoc_Location& back, const TopoDS_Shape& old) {
  if (solids.size() == 1 && !has_loose(old)) return moved_faces(solids.front()->solid, back);
  TopoDS_Compound whole;
  const BRep_Builder builder;
  builder.MakeCompound(whole);
  for (const CombinedSolid* solid : solids) builder.Add(whole, moved_faces(solid->solid, back));
  add_loose(old, whole);
  return whole;
}

/// What all parts need of the model and the document.
struct Context {
  const Document& document;
  const Model& model;
  const TopTools_IndexedMapOfShape& faces;
  LooksOfModels& looks;

  Handle(XCAFDoc_ShapeTool) shapes() const { return document.shapes(); }
};

/// Gives a part other solids; its labels follow.
class Filling {
 public:
  Filling(const Context& context, const PartSolids& part, const TDF_Label& label)
      : context_(context),
        part_(part),
        label_(label),
        back_(part.usage.location.Inverted()),
        shapes_(context.shapes()) {}

  void fill(const Solids& solids) {
    std::vector<std::pair<TDF_Label, TopoDS_Shape>> olds;
    TDF_LabelSequence subs;
    XCAFDoc_ShapeTool::GetSubShapes(label_, subs);
    for (const TDF_Label& sub : subs) olds.emplace_back(sub, XCAFDoc_ShapeTool::GetShape(sub));
    whole_ = shape_of(solids, back_, XCAFDoc_ShapeTool::GetShape(label_));
    shapes_->SetShape(label_, whole_);
    forget_properties(label_);
    std::vector<FaceOrigin> strangers;
    for (const CombinedSolid* solid : solids)
      for (const FaceOrigin& origin : solid->faces) {
        const TopoDS_Face face = TopoDS::Face(origin.face.Moved(back_));
        const bool own = origin.model == &context_.model && part_.numbers.contains(origin.number);
        if (own)
          add_piece(face, origin.number);
        else
          strangers.push_back({face, origin.model, origin.number});
      }
    for (const auto& [sub, shape] : olds) relabel(sub, shape);
    for (const FaceOrigin& face : strangers) label_stranger(face);
  }

 private:
  void add_piece(const TopoDS_Face& face, int number) {
    pieces_[number].push_back(face);
    numbers_.Bind(face, number);
  }

  int number_of(const TopoDS_Shape& old_face) const {
    return context_.faces.FindIndex(old_face.Moved(part_.usage.location));
  }

  /// What has become of a face, shell or solid; other shapes are there as they were or not at all.
  std::vector<TopoDS_Shape> now_of(const TopoDS_Shape& old) const {
    if (old.ShapeType() == TopAbs_FACE) {
      const auto found = pieces_.find(number_of(old));
      return found == pieces_.end() ? std::vector<TopoDS_Shape>() : found->second;
    }
    std::set<int> own;
    for (TopExp_Explorer it(old, TopAbs_FACE); it.More(); it.Next())
      own.insert(number_of(it.Current()));
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(whole_, old.ShapeType(), all);
    std::vector<TopoDS_Shape> found;
    for (int i = 1; i <= all.Extent(); ++i) {
      const TopoDS_Shape& candidate = all(i);
      bool descends = own.empty() && candidate.IsSame(old);
      for (TopExp_Explorer it(candidate, TopAbs_FACE); it.More() && !descends; it.Next())
        if (const int* number = numbers_.Seek(it.Current())) descends = own.contains(*number);
      if (descends) found.push_back(candidate);
    }
    return found;
  }

  /// The first piece takes over the label, the others get one of their own.
  void relabel(const TDF_Label& label, const TopoDS_Shape& old) {
    const std::vector<TopoDS_Shape> pieces = now_of(old);
    if (pieces.empty()) return label.ForgetAllAttributes();
    const std::string name = name_of(label);
    if (pieces.size() > 1 || !pieces.front().IsSame(old)) forget_properties(label);
    set_shape(label, pieces.front());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const TDF_Label piece = i == 0 ? label : shapes_->AddSubShape(label_, pieces[i]);
      if (piece.IsNull()) continue;
      if (i > 0) copy_looks(label, piece);
      if (old.ShapeType() == TopAbs_FACE)  // numbered through all parts
        set_name(piece, context_.looks.names().next({{}, &context_.model, number_of(old)}, name));
      else if (pieces.size() > 1)
        set_name(piece, numbered_name(name, static_cast<int>(i) + 1));
    }
  }

  /// A face that comes from elsewhere brings its looks.
  void label_stranger(const FaceOrigin& face) {
    const Looks& looks = context_.looks(face);
    if (!looks.any()) return;
    const TDF_Label label = shapes_->AddSubShape(label_, face.face);
    if (label.IsNull()) return;
    set_name(label, context_.looks.names().next(face, looks.name));
    paint(context_.document, label, looks);
  }

  const Context& context_;
  const PartSolids& part_;
  TDF_Label label_;
  TopLoc_Location back_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  TopoDS_Shape whole_;
  std::map<int, std::vector<TopoDS_Shape>> pieces_;  // by the number of the face they are of
  NCollection_DataMap<TopoDS_Shape, int, TopTools_ShapeMapHasher> numbers_;
};

/// The same part once more, at the same place.
TDF_Label twin_of(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part) {
  const TDF_Label twin = copy_of(shapes, part);
  TDF_LabelSequence users;
  XCAFDoc_ShapeTool::GetUsers(part, users);
  for (const TDF_Label& user : users) {
    const TopLoc_Location place(XCAFDoc_ShapeTool::GetLocation(user).Transformation());
    const TDF_Label beside = shapes->AddComponent(user.Father(), twin, place);
    copy_looks(user, beside);
    styles_of_twin(shapes, user, beside);
  }
  return twin;
}

void number_names(const TDF_Label& part, int number) {
  set_name(part, numbered_name(name_of(part), number));
  TDF_LabelSequence users;
  XCAFDoc_ShapeTool::GetUsers(part, users);
  for (const TDF_Label& user : users) set_name(user, numbered_name(name_of(user), number));
}

/// A part that was one solid and falls apart becomes several, one beside the other. Returns all.
std::vector<TDF_Label> place(const Context& context, const PartSolids& part,
                             const TDF_Label& label) {
  if (name_of(label).empty()) set_name(label, context.model.file().stem().string());
  std::vector<TDF_Label> labels{label};
  const bool one = XCAFDoc_ShapeTool::GetShape(label).ShapeType() == TopAbs_SOLID;
  if (!one || part.solids.size() == 1) {
    Filling(context, part, label).fill(part.solids);
    return labels;
  }
  while (labels.size() < part.solids.size()) labels.push_back(twin_of(context.shapes(), label));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    number_names(labels[i], static_cast<int>(i) + 1);
    Filling(context, part, labels[i]).fill({part.solids[i]});
  }
  return labels;
}

/// Whether a part comes out as it was.
bool is_same(const Context& context, const PartSolids& part) {
  std::size_t count = 0;
  for (const CombinedSolid* solid : part.solids)
    for (const FaceOrigin& face : solid->faces) {
      if (face.model != &context.model || !context.faces(face.number).IsSame(face.face))
        return false;
      ++count;
    }
  return count == part.numbers.size();
}

/// Each solid that is made of other models alone becomes a part, named as the one there.
void add_others(Model& model, const Solids& others) {
  std::map<std::string, int> count, numbered;
  const auto name = [](const CombinedSolid& solid) {
    return solid.faces.front().model->part_name(solid.faces.front().number);
  };
  for (const CombinedSolid* solid : others) ++count[name(*solid)];
  for (const CombinedSolid* solid : others) {
    const std::string own = name(*solid);
    const int number = ++numbered[own];
    model.add_combined(solid->solid, count[own] > 1 ? numbered_name(own, number) : own,
                       solid->faces);
  }
}

}  // namespace

void Document::replace_solids(Model& own, const std::vector<CombinedSolid>& solids,
                              CommonFaces common) {
  LooksOfModels looks;
  for (const CombinedSolid& solid : solids) looks.add(solid.faces);
  const Faces& faces = contents_of(own).faces;
  const auto [parts, others] = by_parts(*this, faces, solids, own);
  const Context context{*this, own, faces, looks};
  std::vector<TDF_Label> emptied;
  for (const PartSolids& part : parts) {
    if (is_same(context, part)) continue;
    const TDF_Label label = own_part(shapes(), part.usage);
    if (part.solids.empty()) {
      emptied.push_back(label);
      continue;
    }
    const std::vector<TDF_Label> filled = place(context, part, label);
    if (common == CommonFaces::Keep) continue;
    const bool copied = label != part.usage.part;
    for (std::size_t i = copied ? 0 : 1; i < filled.size(); ++i) unshare(shapes(), filled[i]);
  }
  for (const TDF_Label& label : emptied) remove_part(shapes(), label);
  forget_assembly_properties(shapes());
  shapes()->UpdateAssemblies();
  add_others(own, others);
}

}  // namespace blossom::occt
