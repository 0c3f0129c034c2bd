// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/query/query_planes.h"

#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/arguments/vectors.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/reasons.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/progress.h"
#include "plugin/drawings/section_drawing.h"
#include "plugin/pictures/results/sections.h"
#include "plugin/reports/models/edges.h"
#include "plugin/reports/queries/plane_cuts.h"

namespace blossom::cli {
namespace {

using reports::NamedPlane;
using reports::PartSection;
using reports::SectionsAnswer;
using reports::SectionsOfPlane;

constexpr long kMaxPlanes = 100'000;

std::string offset_text(double offset) { return number_text(rounded(offset)); }

// What is not proven in a plane, and why: a line for all parts of which the same is said.
std::string not_proven(const SectionsOfPlane& plane) {
  constexpr std::size_t kFew = 3;
  std::map<std::string, std::vector<std::string>> parts;
  for (const PartSection& part : plane.parts) {
    if (part.section.status == Status::Complete) continue;
    std::string why;
    for (const std::string& reason :
         reported_reasons(part.section.certificate, Contacts::NotListed))
      why += (why.empty() ? ": " : "; ") + reason;
    parts[why].push_back(part.name + " (" + to_string(stated(part.section.status)) + ")");
  }
  std::string text;
  for (auto& [why, names] : parts) {
    const std::size_t more = names.size() > kFew ? names.size() - kFew : 0;
    if (more > 0) names.resize(kFew);
    if (more > 0) names.push_back(std::to_string(more) + " more");
    text += "    in " + listed(names, "and") + why + "\n";
  }
  return text;
}

std::string plane_line(const SectionsOfPlane& plane) {
  std::size_t wires = 0, open = 0, inner = 0, points = 0;
  double length = 0;
  std::optional<double> area = 0;
  for (const PartSection& part : plane.parts) {
    const std::optional<double> own = occt::bounded_area(part.section);
    area = area && own ? std::optional(*area + *own) : std::nullopt;
    points += part.section.points.size();
    for (const occt::SectionWire& wire : part.section.wires) {
      ++wires;
      open += wire.closed || !wire.bounding ? 0 : 1;
      inner += wire.bounding ? 0 : 1;
      length += wire.length;
    }
  }
  std::string text = "  " + plane.plane.name + ": " + counted(wires, "wire");
  if (open > 0) text += " (" + std::to_string(open) + " open)";
  if (inner > 0) text += " (" + std::to_string(inner) + " inside or only touching)";
  if (points > 0) text += ", " + counted(points, "point");
  if (wires > 0) text += ", length " + number_text(rounded(length));
  if (area && *area > 0) text += ", area " + number_text(rounded(*area));
  if (plane.parts.size() > 1) text += ", " + counted(plane.parts.size(), "part");
  return text + "\n" + not_proven(plane);
}

std::string text_of(const Input& input, const SectionsAnswer& answer) {
  std::ostringstream text;
  text << input.name << ": " << to_string(stated(answer.status)) << ", "
       << counted(answer.planes.size(), "plane") << ", " << seconds_text(answer.seconds) << "\n";
  for (const SectionsOfPlane& plane : answer.planes) text << plane_line(plane);
  return text.str();
}

SectionsAnswer cut(const Input& input, const std::vector<NamedPlane>& planes,
                   const EngineOptions& engine) {
  Progress progress("cutting");
  return reports::sections_of(
      input, planes,
      {engine.tolerance, [&] { return intersection_options(engine, progress); },
       stop_if_interrupted});
}

void write_result(const Input& input, const SectionsAnswer& answer, const std::string& file) {
  if (ending_of(file) == ".json") return write_json(reports::sections_report(input, answer), file);
  if (!reports::has_shape(answer))
    return report_nothing_found(file, "no wire and no point was found");
  if (drawings::is_drawing_file(file)) return drawings::write_section_drawing(answer, file);
  write_model(reports::model_of(answer), file);
}

NamedPlane plane_in(const std::string& line, const std::string& where) {
  std::string words = line;
  for (char& c : words) c = c == ',' ? ' ' : c;
  std::istringstream text(words);
  std::string numbers, word;
  for (int i = 0; i < 6 && text >> word; ++i) numbers += (i == 0 ? "" : ",") + word;
  const bool named = text && !(text >> std::ws).eof();
  return {parse_plane(numbers, where),
          named ? line.substr(static_cast<std::size_t>(text.tellg())) : "", named};
}

}  // namespace

std::vector<NamedPlane> planes_at(const std::string& offsets, const occt::Plane& plane) {
  const std::size_t first = offsets.find(':'), second = offsets.find(':', first + 1);
  const auto number = [&](std::size_t begin, std::size_t end) {
    return finite_value(offsets.substr(begin, end - begin));
  };
  std::optional<double> from, to, count;
  if (first == std::string::npos) {
    from = to = finite_value(offsets);
    count = 1;
  } else if (second != std::string::npos) {
    from = number(0, first);
    to = number(first + 1, second);
    count = number(second + 1, std::string::npos);
  }
  if (!from || !to || !count)
    throw UsageError("--offsets: '" + offsets +
                     "' is neither one offset nor FROM:TO:NUMBER, so many planes from the first "
                     "offset to the last");
  if (*count != std::floor(*count) || *count < 1 || *count > kMaxPlanes ||
      (*count == 1 && *from != *to))
    throw UsageError("--offsets: the NUMBER of '" + offsets + "' is not a whole one from 2 to " +
                     std::to_string(kMaxPlanes));
  std::vector<NamedPlane> planes;
  const auto all = static_cast<int>(*count);
  for (int i = 0; i < all; ++i) {
    const double t = all == 1 ? 0 : static_cast<double>(i) / (all - 1);
    const double offset = i + 1 == all ? *to : *from + t * (*to - *from);
    planes.push_back({{plane.point + plane.normal * offset, plane.normal},
                      "plane " + std::to_string(i + 1) + ", offset " + offset_text(offset),
                      false,
                      offset});
  }
  return planes;
}

std::vector<NamedPlane> planes_in(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw UsageError(file + ": cannot be read");
  std::vector<NamedPlane> planes;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    while (!line.empty() && line.back() == '\r') line.pop_back();
    planes.push_back(plane_in(line, file + ", line " + std::to_string(number)));
    if (!planes.back().named) planes.back().name = "plane " + std::to_string(planes.size());
    if (static_cast<long>(planes.size()) > kMaxPlanes)
      throw UsageError(file + ": has more than " + std::to_string(kMaxPlanes) + " planes");
  }
  if (planes.empty()) throw UsageError(file + ": has no planes");
  return planes;
}

void write_parts(const Input& input, const NamedPlane& plane, const EngineOptions& engine,
                 const std::string& file) {
  write_result(input, cut(input, {plane}, engine), file);
}

Input input_to_cut(const std::string& name) {
  Input input = read_usable_input(name, Faces::Optional);
  if (input.faces.empty() && reports::edges_without_faces(input).empty())
    throw occt::BadModel(input.name + ": there is no face and no edge in it");
  return input;
}

int run_planes(const std::string& name, std::vector<NamedPlane> planes, const CommonOptions& common,
               const EngineOptions& engine) {
  const Input input = input_to_cut(name);
  stop_if_interrupted();
  const SectionsAnswer answer = cut(input, planes, engine);
  stop_if_interrupted();
  const std::vector<PictureFile> pictures =
      picture_files(common, [&] { return pictures::sections_picture(input, answer); });
  stop_if_interrupted();
  if (!common.output.empty()) write_result(input, answer, common.output);
  write_pictures(pictures);
  if (!common.json.empty()) write_json(reports::sections_report(input, answer), common.json);
  print_summary(text_of(input, answer), common.json);
  return exit_code(answer.status);
}

}  // namespace blossom::cli
