// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/nets/net_input.h"

#include <algorithm>
#include <map>

#include <TopoDS_Face.hxx>

#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/nets/net_json.h"
#include "plugin/nets/net_models.h"

namespace blossom::cli {
namespace {

std::vector<Net> chosen(std::vector<Net> nets, const InputName& name) {
  if (!name.words.empty())
    throw UsageError(name.file.string() + ": nets have numbers, there is no '" +
                     name.words.front() + "' in it");
  if (name.faces.empty()) return nets;
  const int count = static_cast<int>(nets.size());
  for (const auto& [first, last] : name.faces)
    if (last > count)
      throw occt::BadModel(name.file.string() + ": there is no net " +
                           std::to_string(std::max(first, count + 1)) + " in it, it has " +
                           counted(nets.size(), "net"));
  std::erase_if(nets, [&](const Net& net) {
    return std::ranges::none_of(name.faces, [&](const auto& range) {
      return range.first <= net.source.net && net.source.net <= range.second;
    });
  });
  return nets;
}

}  // namespace

NetInput read_net_input(const std::string& text, Take take) {
  const InputName name = parse_input(text);
  NetInput input{text, {}, {}};
  if (nets::is_net_file(name.file)) {
    input.nets = chosen(nets::read_nets(name.file), name);
    return input;
  }
  const bool edges = take == Take::Edges;
  const auto read = edges ? read_input : read_usable_input;
  input.model.emplace(read(text, edges ? Faces::Optional : Faces::Required,
                           reports::Repairing::Used, reports::LooseFaces::Kept));
  input.nets = edges ? nets::nets_of_edges(*input.model, name.is_whole(), stop_if_interrupted)
                     : nets::nets_of_faces(*input.model, stop_if_interrupted);
  return input;
}

void write_nets(NetInput& input, std::span<const Net> nets, const std::string& file) {
  if (nets::is_net_file(file)) return write_plain_json(nets::nets_json(nets), file);
  const bool of_faces = input.model && !nets.empty() && nets.front().source.face > 0;
  if (!of_faces) return write_model(nets::model_of_nets(nets), file);
  stop_if_interrupted();
  nets::put_nets(input.model->model, nets);
  write_model(input.model->model, file);
}

void drop_other_faces(Input& input) {
  std::map<int, std::vector<TopoDS_Face>> others;
  for (int number = 1; number <= input.model.face_count(); ++number) others[number];
  for (const int number : input.numbers) others.erase(number);
  if (!others.empty()) input.model.replace_faces(others);
}

}  // namespace blossom::cli
