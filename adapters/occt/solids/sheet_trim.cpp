// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/sheets.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/faces/face_data.h"
#include "adapters/occt/faces/face_groups.h"
#include "adapters/occt/solids/combined_pair.h"

namespace blossom::occt {
namespace {

double area_of(const std::vector<TopoDS_Face>& faces) {
  double sum = 0;
  for (const TopoDS_Face& face : faces) sum += area(face);
  return sum;
}

// What divides the sheet, and its place among the tools; -1 of the part.
struct Divider {
  TrimTool tool;
  int place = -1;
};

// Solids that touch would have faces in one place, so each is taken by itself.
std::vector<Divider> one_by_one(const TrimTool& input, int place) {
  if (input.solids.size() < 2) return {{input, place}};
  std::vector<Divider> all;
  for (const TopoDS_Solid& solid : input.solids) all.push_back({solid_tool({solid}), place});
  return all;
}

// The sheet so far, and where its faces come from.
struct SheetWork {
  const SharedLimit& limit;
  SolidOperation operation;
  double stated;
  ConeVolumes cones;
  TopTools_MapOfShape valid;     // faces that need not be checked
  std::vector<SolidFace> faces;  // of the sheet so far
  SolidTrimResult told;          // no faces

  SheetWork(const SharedLimit& of, SolidOperation what, double at, const TrimTool& sheet, int place)
      : limit(of), operation(what), stated(at), cones(cone_apex(sheet)) {
    for (std::size_t i = 0; i < sheet.faces.size(); ++i) {
      faces.push_back({sheet.faces[i], place, static_cast<int>(i)});
      valid.Add(sheet.faces[i]);
    }
  }

  bool is_done() const { return faces.empty() || !told.obstacles.empty(); }
  std::vector<SolidFace> divided(const Divider& by, SolidOperation how);
  void take(const std::vector<Divider>& all);
};

// What one tool leaves of the sheet so far.
std::vector<SolidFace> SheetWork::divided(const Divider& by, SolidOperation how) {
  TrimTool sheet;
  for (const SolidFace& of : faces) sheet.faces.push_back(of.face);
  SolidTrimResult made =
      combined_pair(sheet, by.tool, how, limit.remaining(), stated, cones, valid);
  for (SolidFace& of : made.faces) {
    if (of.tool < 0) {
      const SolidFace& origin = faces[static_cast<std::size_t>(of.from)];
      of = {of.face, origin.tool, origin.from, std::max(origin.side, of.side)};
    } else {
      of.tool = by.place;
    }
    valid.Add(of.face);
  }
  told.status = weaker(told.status, made.status);
  add(told.certificate, made.certificate);
  told.obstacles.insert(told.obstacles.end(), made.obstacles.begin(), made.obstacles.end());
  told.merged.insert(told.merged.end(), made.merged.begin(), made.merged.end());
  return std::move(made.faces);
}

// What is in any of the solids of one tool is in common with it. What one of them has taken is no
// part of the sheet for the next, which may share a face with it.
void SheetWork::take(const std::vector<Divider>& all) {
  std::vector<SolidFace> common;
  for (const Divider& by : all) {
    if (is_done()) return;
    if (operation != SolidOperation::Common) {
      faces = divided(by, operation);
      continue;
    }
    const std::vector<SolidFace> taken = divided(by, SolidOperation::Common);
    common.insert(common.end(), taken.begin(), taken.end());
    if (&by != &all.back() && !taken.empty() && told.obstacles.empty())
      faces = divided(by, SolidOperation::Cut);
  }
  if (operation == SolidOperation::Common) faces = std::move(common);
}

// Edges over which two faces go on, turned alike.
TopTools_MapOfShape inner_edges(const std::vector<TopoDS_Shape>& faces) {
  TopTools_IndexedMapOfShape edges;
  struct Uses {
    int forward = 0, reversed = 0;
  };
  std::vector<Uses> uses;
  for (const TopoDS_Shape& face : faces)
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const auto number = static_cast<std::size_t>(edges.Add(it.Current())) - 1;
      uses.resize(std::max(uses.size(), number + 1));
      uses[number].forward += it.Current().Orientation() == TopAbs_FORWARD;
      uses[number].reversed += it.Current().Orientation() == TopAbs_REVERSED;
    }
  TopTools_MapOfShape inner;
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (uses[i].forward == 1 && uses[i].reversed == 1) inner.Add(edges(static_cast<int>(i) + 1));
  return inner;
}

std::vector<TopoDS_Shell> shells_over_edges(const std::vector<SolidFace>& of) {
  std::vector<TopoDS_Shape> faces;
  for (const SolidFace& one : of) faces.push_back(one.face);
  const TopTools_MapOfShape inner = inner_edges(faces);
  const BRep_Builder builder;
  std::vector<TopoDS_Shell> sheets;
  for (const FaceGroup& group :
       groups_over_edges(faces, [&](const TopoDS_Shape& edge) { return !inner.Contains(edge); })) {
    builder.MakeShell(sheets.emplace_back());
    for (const std::size_t i : group) builder.Add(sheets.back(), faces[i]);
    sheets.back().Closed(BRep_Tool::IsClosed(sheets.back()));
  }
  return sheets;
}

TotalAreas areas_of(const TrimTool& part, const std::vector<TrimTool>& tools,
                    const std::vector<SolidFace>& result) {
  TotalAreas areas;
  if (!part.is_solid()) areas.part = area_of(part.faces);
  for (const TrimTool& tool : tools)
    if (!tool.is_solid()) areas.tools += area_of(tool.faces);
  for (const SolidFace& of : result) areas.result += area(of.face);
  return areas;
}

// The part, or the first sheet among the tools where the part is a solid.
SheetWork work_on(const TrimTool& part, const std::vector<TrimTool>& tools, std::size_t sheet,
                  SolidOperation operation, double stated, const SharedLimit& limit) {
  SheetWork work(limit, operation, stated, sheet < tools.size() ? tools[sheet] : part,
                 sheet < tools.size() ? static_cast<int>(sheet) : -1);
  for (const TopoDS_Face& face : part.faces) work.valid.Add(face);
  for (const TrimTool& tool : tools)
    for (const TopoDS_Face& face : tool.faces) work.valid.Add(face);
  return work;
}

}  // namespace

std::size_t first_sheet(const std::vector<TrimTool>& tools) {
  return static_cast<std::size_t>(std::ranges::find_if_not(tools, &TrimTool::is_solid) -
                                  tools.begin());
}

bool takes_sheets(const TrimTool& part, const std::vector<TrimTool>& tools,
                  SolidOperation operation) {
  return !part.is_solid() ||
         (operation != SolidOperation::Split && first_sheet(tools) < tools.size());
}

SolidTrimResult trim_sheets(const TrimTool& part, const std::vector<TrimTool>& tools,
                            SolidOperation operation, double stated,
                            const IntersectionOptions& options) {
  const SharedLimit limit(options);
  const WorkLimit own_limit(options);
  SolidTrimResult result;
  result.of_sheets = true;
  try {
    const std::size_t sheet = part.is_solid() ? first_sheet(tools) : tools.size();
    SheetWork work = work_on(part, tools, sheet, operation, stated, limit);
    if (part.is_solid()) work.take(one_by_one(part, -1));
    for (std::size_t i = 0; i < tools.size(); ++i)
      if (i != sheet) work.take(one_by_one(tools[i], static_cast<int>(i)));
    result = std::move(work.told);
    result.of_sheets = true;
    if (!result.obstacles.empty()) return result;
    result.areas = areas_of(part, tools, work.faces);
    result.sheets = shells_over_edges(work.faces);
    result.faces = std::move(work.faces);
  } catch (const Failure& error) {
    result.obstacles.emplace_back(error.what());
    if (own_limit.reached_after_search() != nullptr) result.status = Status::Stopped;
  }
  return result;
}

}  // namespace blossom::occt
