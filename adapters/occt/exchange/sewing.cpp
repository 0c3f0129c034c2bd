// SPDX-License-Identifier: LGPL-2.1-or-later
// The loose faces of a model, sewn part by part.

#include <algorithm>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/rebuild.h"
#include "adapters/occt/repair/sewn_faces.h"
#include "adapters/occt/trim_tool.h"

namespace blossom::occt {
namespace {

/// Numbers of the faces that bound no closed solid.
std::set<int> loose_faces(const Contents& contents) {
  TopTools_MapOfShape bounding;
  for (TopExp_Explorer solid(contents.shape, TopAbs_SOLID); solid.More(); solid.Next())
    if (is_closed_solid(solid.Current()))
      for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next())
        bounding.Add(face.Current());
  std::set<int> loose;
  for (int number = 1; number <= contents.faces.Extent(); ++number)
    if (!bounding.Contains(contents.faces(number))) loose.insert(number);
  return loose;
}

/// Numbers of the faces of shells that are closed, and of faces that close alone, outside of
/// solids.
std::set<int> closed_sheets(const Contents& contents) {
  std::set<int> sheets;
  const auto add = [&](const TopoDS_Shape& sheet) {
    if (!is_closed_solid(sheet)) return;
    for (TopExp_Explorer face(sheet, TopAbs_FACE); face.More(); face.Next())
      sheets.insert(contents.faces.FindIndex(face.Current()));
  };
  for (TopExp_Explorer it(contents.shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
    add(it.Current());
  for (TopExp_Explorer it(contents.shape, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next())
    add(it.Current());
  return sheets;
}

/// The parts that are in no other one, by their faces.
void add_parts(const std::vector<AssemblyNode>& nodes, std::vector<std::vector<int>>& parts) {
  for (const AssemblyNode& node : nodes)
    if (node.parts.empty())
      parts.push_back(node.faces);
    else
      add_parts(node.parts, parts);
}

class SewingOfModel {
 public:
  SewingOfModel(const Contents& contents, std::optional<double> within,
                const std::function<void()>& stop, Sewable which)
      : contents_(contents), within_(within), stop_(stop), loose_(loose_faces(contents)) {
    const bool are_all_loose = static_cast<int>(loose_.size()) == contents.faces.Extent();
    if (which == Sewable::Open && are_all_loose) kept_ = closed_sheets(contents);
    for (const int number : kept_) loose_.erase(number);
    told_.loose = static_cast<int>(loose_.size());
  }

  void sew_parts(const std::vector<AssemblyNode>& nodes) {
    sew_loose(nodes);
    if (solids_.empty() || kept_.empty()) return;
    told_.loose += static_cast<int>(kept_.size());
    loose_.merge(kept_);
    sew_loose(nodes);
  }

  const std::vector<SolidOfFaces>& solids() const { return solids_; }
  const Sewing& told() const { return told_; }

 private:
  void sew_loose(const std::vector<AssemblyNode>& nodes) {
    if (loose_.empty()) return;
    std::vector<std::vector<int>> parts;
    add_parts(nodes, parts);
    for (const std::vector<int>& part : parts) {
      std::vector<int> numbers;
      for (const int number : part)
        if (loose_.contains(number)) numbers.push_back(number);
      if (numbers.empty()) continue;
      if (numbers.size() > 1 && numbers.size() < loose_.size()) sew(numbers);
    }
    if (!loose_.empty()) sew({loose_.begin(), loose_.end()});
    if (!loose_.empty()) return;
    told_.open_edges = 0;
    told_.failed.clear();
  }

  void sew(const std::vector<int>& numbers) {
    std::vector<TopoDS_Face> faces;
    for (const int number : numbers) faces.push_back(TopoDS::Face(contents_.faces(number)));
    told_.open_edges = 0;
    told_.failed.clear();
    try {
      add(sewn_faces(faces, within_, stop_), numbers);
    } catch (const Failure& failure) {
      told_.failed = failure.what();
    }
  }

  void add(const SewnFaces& made, const std::vector<int>& numbers) {
    told_.open_edges = made.open_edges;
    told_.open_at = made.open_at;
    if (made.solids.empty()) return;
    told_.gap = std::max(told_.gap, made.gap);
    told_.within = std::max(told_.within, made.within);
    for (const SewnSolid& solid : made.solids) {
      SolidOfFaces& of = solids_.emplace_back(solid.solid);
      for (const auto& [place, face] : solid.faces) {
        of.faces[numbers[place]] = face;
        loose_.erase(numbers[place]);
      }
      told_.solids.push_back(static_cast<int>(of.faces.size()));
    }
  }

  const Contents& contents_;
  const std::optional<double> within_;
  const std::function<void()>& stop_;
  std::set<int> loose_, kept_;
  std::vector<SolidOfFaces> solids_;
  Sewing told_;
};

/// Plain parts take solids as long as no name has to follow.
void put_solids(Contents& contents, const std::vector<SolidOfFaces>& solids,
                const std::string& name) {
  if (!contents.document && contents.parts.size() == 1 && contents.parts.front().named.empty()) {
    TopoDS_Shape& shape = contents.parts.front().shape;
    shape = Rebuild(replacements_of(contents.faces, solids))(shape);
  } else {
    document_of(contents).put_solids(contents.faces, solids, name);
  }
}

bool are_renumbered(const std::vector<SolidOfFaces>& solids, const Contents& contents) {
  for (const SolidOfFaces& solid : solids)
    for (const auto& [number, face] : solid.faces)
      if (contents.faces.FindIndex(face) != number) return true;
  return false;
}

}  // namespace

Sewing Model::sew(std::optional<double> within, const std::function<void()>& stop, Sewable which) {
  if (impl_->sewing && (impl_->sewn == Sewable::All || which == Sewable::Open))
    return *impl_->sewing;
  const std::lock_guard guard(exchange_lock());
  SewingOfModel sewing(*impl_, within, stop, which);
  if (!shape().IsNull()) sewing.sew_parts(assembly());
  Sewing told = sewing.told();
  if (!sewing.solids().empty()) try {
      guarded("putting solids in the place of loose faces", [&] {
        put_solids(*impl_, sewing.solids(), file().stem().string());
        impl_->refresh();
        told.renumbered = are_renumbered(sewing.solids(), *impl_);
      });
    } catch (const Failure& failure) {
      const int loose = told.loose;
      told = {};
      told.loose = loose;
      told.failed = failure.what();
    }
  impl_->sewing = told;
  impl_->sewn = which;
  return told;
}

bool Model::is_sewn() const { return impl_->sewing.has_value(); }

}  // namespace blossom::occt
