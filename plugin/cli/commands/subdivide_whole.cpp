// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/subdivide_whole.h"

#include <sstream>
#include <utility>

#include <TopoDS.hxx>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/nets/net_json.h"
#include "plugin/nets/whole_parts.h"
#include "plugin/pictures/results/subdivisions.h"

namespace blossom::cli {
namespace {

using nets::WholePart;

void write_parts(const Input& input, const std::vector<WholePart>& parts, const std::string& file) {
  if (parts.front().source.face == 0) return write_model(nets::model_of_whole_edges(parts), file);
  nets::put_whole_faces(input.model, parts);
  write_model(input.model, file);
}

std::string summary_of_whole(const std::string& name, const std::vector<WholePart>& parts,
                             double seconds) {
  std::ostringstream text;
  text << name << ": " << parts.size() << " B-spline "
       << (parts.front().source.face > 0 ? "surface" : "curve") << (parts.size() == 1 ? "" : "s")
       << ", " << seconds_text(seconds) << "\n";
  return text.str();
}

nets::WholeCut cut_of(const WholeQuestion& question) {
  nets::WholeCut cut;
  if (const auto& i = question.interval; !i.empty()) cut.interval = Interval{i[0], i[1]};
  if (const auto& r = question.rectangle; !r.empty())
    cut.rectangle = {Interval{r[0], r[1]}, Interval{r[2], r[3]}};
  cut.all_edges = parse_input(question.input).is_whole();
  cut.stop = stop_if_interrupted;
  return cut;
}

}  // namespace

int run_whole(const WholeQuestion& question) {
  check_files(question.common, {question.input});
  if (nets::is_net_file(parse_input(question.input).file))
    throw UsageError(question.input + ": --whole takes models; nets are one piece already");
  const bool edges = !question.interval.empty();
  const Input input = read_input(question.input, edges ? Faces::Optional : Faces::Required,
                                 reports::Repairing::Used, reports::LooseFaces::Kept);
  const Stopwatch watch;
  const nets::WholeCut cut = cut_of(question);
  const std::vector<WholePart> parts = nets::whole_parts(input, cut);
  const double seconds = watch.seconds();
  const Json report = nets::whole_report(input, cut, parts, seconds);
  const std::vector<PictureFile> pictures = picture_files(
      question.common, [&] { return pictures::whole_picture(question.input, parts); });
  stop_if_interrupted();
  if (!question.common.output.empty()) write_parts(input, parts, question.common.output);
  write_pictures(pictures);
  if (!question.common.json.empty()) write_json(report, question.common.json);
  print_summary(summary_of_whole(question.input, parts, seconds), question.common.json);
  return kExitComplete;
}

}  // namespace blossom::cli
