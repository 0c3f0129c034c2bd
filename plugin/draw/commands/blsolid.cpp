// SPDX-License-Identifier: LGPL-2.1-or-later
// blsolid result cut|common|fuse|split part tool [tool ...]

#include <map>
#include <string>
#include <vector>

#include <BRep_Builder.hxx>
#include <DBRep.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/solid_trim.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"
#include "plugin/reports/cuts/solids.h"

namespace blossom::draw {
namespace {

occt::SolidOperation operation_of(const std::string& word) {
  static const std::map<std::string, occt::SolidOperation> kWords = {
      {"cut", occt::SolidOperation::Cut},
      {"common", occt::SolidOperation::Common},
      {"fuse", occt::SolidOperation::Fuse},
      {"split", occt::SolidOperation::Split}};
  const auto found = kWords.find(word);
  if (found == kWords.end())
    throw occt::BadModel("'" + word + "' is none of cut, common, fuse and split");
  return found->second;
}

std::string answer_to_blsolid(const Words& words) {
  require(words.size() >= 4);
  const occt::SolidOperation operation = operation_of(words[1]);
  const occt::TrimTool part = tool_named(words[2]);
  std::vector<occt::TrimTool> tools;
  for (std::size_t i = 3; i < words.size(); ++i) tools.push_back(tool_named(words[i]));
  if (const std::string cause = occt::misplaced_sheet(part, tools, operation); !cause.empty())
    throw occt::BadModel(cause);

  const occt::SolidTrimResult made = occt::trim_solids(part, tools, operation);

  if (!made.obstacles.empty()) throw occt::Failure(reports::causes(made).front());
  DBRep::Set(words[0].c_str(),
             made.of_sheets ? occt::compound_of(made.sheets) : occt::compound_of(made.solids));
  return std::to_string(made.of_sheets ? made.sheets.size() : made.solids.size()) + " " +
         to_string(made.status) + " " +
         tcl_number(made.of_sheets ? made.areas.result : made.total.result);
}

}  // namespace

const Command kBlsolid{
    "blsolid", "result cut|common|fuse|split part tool [tool ...]",
    "\n\t\t: closed solids, or sheets of faces, combined. The answer is the number of solids or"
    "\n\t\t: sheets, complete or tolerance, and their volume or area.",
    answer_to_blsolid};

}  // namespace blossom::draw
