// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/kept_facts.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>

#include "adapters/occt/exchange/rebuild.h"
#include "adapters/occt/exchange/value_bytes.h"

namespace blossom::occt {
template <class Way>
void each_member(Way& way, AssemblyNode& node) {
  way(node.name), way(node.product), way(node.path);
  way(node.solids), way(node.faces), way(node.parts);
}

template <class Way>
void each_member(Way& way, KeptFacts& facts) {
  way(facts.unit), way(facts.raised), each_member(way, facts.reading);
  way(facts.names), way(facts.paths), way(facts.parts), way(facts.assembly);
}

namespace {

[[noreturn]] void refuse_change() {
  throw std::logic_error("a model of the folder of models is to be changed or written");
}

class KeptDocument : public DocumentInterface {
 public:
  KeptDocument(const TopoDS_Shape& shape, KeptFacts facts)
      : shape_(shape), facts_(std::move(facts)) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
  }

  TopoDS_Shape shape() const override { return shape_; }
  std::vector<std::string> face_names(const Faces&) const override { return facts_.names; }
  std::vector<std::string> part_paths(const Faces&) const override { return facts_.paths; }
  /// Models that are read with their looks are not kept.
  std::vector<std::optional<FaceColour>> face_colours(const Faces& faces) const override {
    return std::vector<std::optional<FaceColour>>(static_cast<std::size_t>(faces.Extent()));
  }
  std::vector<AssemblyNode> assembly(const TopoDS_Shape&, const Faces&) const override {
    return facts_.assembly;
  }
  std::string part_name(const TopoDS_Face& face) const override {
    const int number = faces_.FindIndex(face);
    return number == 0 ? "" : facts_.parts.at(static_cast<std::size_t>(number) - 1);
  }

  std::shared_ptr<DocumentInterface> copy() const override { refuse_change(); }
  void add(const TopoDS_Shape&, const std::string&, const std::vector<double>&) override {
    refuse_change();
  }
  void add_assembly(const std::vector<std::pair<std::string, TopoDS_Shape>>&,
                    const std::string&) override {
    refuse_change();
  }
  void add_combined(const TopoDS_Shape&, const std::string&,
                    const std::vector<FaceOrigin>&) override {
    refuse_change();
  }
  void replace_faces(const Faces&, const std::map<int, std::vector<TopoDS_Face>>&) override {
    refuse_change();
  }
  void replace_solids(Model&, const std::vector<CombinedSolid>&, CommonFaces) override {
    refuse_change();
  }
  void put_solids(const Faces&, const std::vector<SolidOfFaces>& solids,
                  const std::string&) override;
  void leave_out_bad_faces(const NumberSource&, ReadingReport&) override { refuse_change(); }
  FileContent content(Format, const std::string&) const override { refuse_change(); }

 private:
  void join_parts(const SolidOfFaces& solid, const std::string& name);

  TopoDS_Shape shape_;
  KeptFacts facts_;
  Faces faces_;
};

void renumber(AssemblyNode& node, const std::vector<int>& now, const NumberedShapes& all) {
  for (AssemblyNode& part : node.parts) renumber(part, now, all);
  std::set<int> faces;
  for (const int face : node.faces) faces.insert(now[static_cast<std::size_t>(face) - 1]);
  node.faces.assign(faces.begin(), faces.end());
  node.solids.clear();
  for (int i = 1; i <= all.solids.Extent() && !faces.empty(); ++i)
    if (const TopExp_Explorer first(all.solids(i), TopAbs_FACE); first.More())
      if (faces.contains(all.faces.FindIndex(first.Current()))) node.solids.push_back(i);
}

/// The first part with a face of a solid gets all of its faces.
/// returns   whether other parts had some
bool gather(std::vector<AssemblyNode>& nodes, const SolidOfFaces& solid, AssemblyNode*& first) {
  bool several = false;
  for (AssemblyNode& node : nodes) {
    several = gather(node.parts, solid, first) || several;
    if (!node.parts.empty()) continue;
    const auto in_solid = [&](int face) { return solid.faces.contains(face); };
    if (std::ranges::none_of(node.faces, in_solid)) continue;
    if (first == nullptr) {
      first = &node;
      continue;
    }
    std::erase_if(node.faces, in_solid);
    several = true;
  }
  return several;
}

void drop_empty(std::vector<AssemblyNode>& nodes) {
  for (AssemblyNode& node : nodes) drop_empty(node.parts);
  std::erase_if(nodes, [](const AssemblyNode& node) {
    return node.faces.empty() && node.solids.empty() && node.parts.empty();
  });
}

void reorder(std::vector<std::string>& words, const std::vector<int>& now) {
  std::vector<std::string> ordered(words.size());
  for (std::size_t i = 0; i < now.size(); ++i)
    ordered[static_cast<std::size_t>(now[i]) - 1] = std::move(words[i]);
  words = std::move(ordered);
}

// As Document::put_solids does: what several parts have become together is called anew.
void KeptDocument::join_parts(const SolidOfFaces& solid, const std::string& name) {
  AssemblyNode* part = nullptr;
  if (!gather(facts_.assembly, solid, part)) return;
  part->product = name;
  const bool is_root =
      std::ranges::any_of(facts_.assembly, [&](const AssemblyNode& node) { return &node == part; });
  if (is_root) part->name = part->path = name;
  std::set<int> faces(part->faces.begin(), part->faces.end());
  for (const auto& [number, face] : solid.faces) {
    faces.insert(number);
    facts_.paths[static_cast<std::size_t>(number) - 1] = part->path;
    facts_.parts[static_cast<std::size_t>(number) - 1] = name;
  }
  part->faces.assign(faces.begin(), faces.end());
  drop_empty(facts_.assembly);
}

// What was said of faces by their numbers follows them.
void KeptDocument::put_solids(const Faces&, const std::vector<SolidOfFaces>& solids,
                              const std::string& name) {
  for (const SolidOfFaces& solid : solids) join_parts(solid, name);
  const Faces before = faces_;
  const std::vector<Replacement> replacements = replacements_of(before, solids);
  shape_ = Rebuild(replacements)(shape_);
  faces_.Clear();
  TopExp::MapShapes(shape_, TopAbs_FACE, faces_);
  std::vector<int> now;
  for (int i = 1; i <= before.Extent(); ++i) now.push_back(faces_.FindIndex(before(i)));
  for (const SolidOfFaces& solid : solids)
    for (const auto& [number, face] : solid.faces)
      now[static_cast<std::size_t>(number) - 1] = faces_.FindIndex(face);
  for (auto* words : {&facts_.names, &facts_.paths, &facts_.parts}) reorder(*words, now);
  const NumberedShapes all(shape_, faces_);
  for (AssemblyNode& node : facts_.assembly) renumber(node, now, all);
}

}  // namespace

std::string bytes_of(const KeptFacts& facts) { return value_bytes(facts); }

KeptFacts facts_of(const std::string& bytes) { return value_of<KeptFacts>(bytes); }

std::shared_ptr<DocumentInterface> kept_document(const TopoDS_Shape& shape, KeptFacts facts) {
  return std::make_shared<KeptDocument>(shape, std::move(facts));
}

}  // namespace blossom::occt
