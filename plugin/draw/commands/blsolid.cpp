// SPDX-License-Identifier: LGPL-2.1-or-later
// blsolid result cut|common|fuse|split part tool [tool ...]

#include <string>
#include <vector>

#include <BRep_Builder.hxx>
#include <DBRep.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/solid_trim.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"
#include "plugin/reports/cuts/solids.h"

namespace blossom::draw {
namespace {

occt::SolidOperation operation_of(const std::string& word) {
  if (const auto operation = reports::solid_operation(word)) return *operation;
  throw occt::BadModel("'" + word + "' is none of cut, common, fuse and split");
}

// One without faces is taken for its edges and vertices.
occt::TrimTool input_named(const std::string& name) {
  const TopoDS_Shape shape = shape_named(name);
  if (!occt::faces_of(shape).empty()) return tool_named(name, occt::Sewable::Open);
  occt::TrimTool input = occt::trim_tool(shape);
  input.name = name;
  return input;
}

std::string answer_to_blsolid(const Words& words) {
  require(words.size() >= 4);
  const occt::SolidOperation operation = operation_of(words[1]);
  const occt::TrimTool part = input_named(words[2]);
  std::vector<occt::TrimTool> tools;
  for (std::size_t i = 3; i < words.size(); ++i) tools.push_back(input_named(words[i]));
  if (const std::string cause = occt::misplaced_sheet(part, tools, operation); !cause.empty())
    throw occt::BadModel(cause);

  const occt::SolidTrimResult made = occt::trim_solids(part, tools, operation);

  if (!made.obstacles.empty()) throw occt::Failure(reports::causes(made).front());
  if (made.of_wires) {
    DBRep::Set(words[0].c_str(), made.wires);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(made.wires, TopAbs_EDGE, edges);
    int shapes = edges.Extent();
    for (TopExp_Explorer it(made.wires, TopAbs_VERTEX, TopAbs_EDGE); it.More(); it.Next()) ++shapes;
    return std::to_string(shapes) + " " + to_string(made.status) + " " +
           tcl_number(made.lengths.result);
  }
  DBRep::Set(words[0].c_str(),
             made.of_sheets ? occt::compound_of(made.sheets) : occt::compound_of(made.solids));
  return std::to_string(made.of_sheets ? made.sheets.size() : made.solids.size()) + " " +
         to_string(made.status) + " " +
         tcl_number(made.of_sheets ? made.areas.result : made.total.result);
}

}  // namespace

const Command kBlsolid{
    "blsolid", "result cut|common|fuse|split part tool [tool ...]",
    "\n\t\t: closed solids, sheets of faces, or wires, combined. The answer is the number of "
    "solids,"
    "\n\t\t: sheets, or edges and vertices off them, complete or tolerance, and their volume, area "
    "or length.",
    answer_to_blsolid};

}  // namespace blossom::draw
