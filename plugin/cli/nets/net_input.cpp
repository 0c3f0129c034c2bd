// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/nets/net_input.h"

#include <algorithm>
#include <map>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "plugin/cli/exit_code.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/nets/net_json.h"
#include "plugin/cli/nets/net_shapes.h"

namespace blossom::cli {
namespace {

void append(std::vector<Net>& all, std::vector<Net> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

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

std::vector<Net> nets_of_faces(const Input& input) {
  const std::vector<std::string> names = input.model.face_names();
  std::vector<Net> nets;
  for (std::size_t i = 0; i < input.faces.size(); ++i) {
    stop_if_interrupted();
    NetSource source;
    source.file = input.model.file().string();
    source.face = input.numbers[i];
    source.name = names[static_cast<std::size_t>(source.face - 1)];
    append(nets, face_nets(input.faces[i], source));
  }
  return nets;
}

// Edges have the numbers of the whole model, whichever faces were chosen.
std::vector<Net> nets_of_edges(const Input& input, bool all) {
  TopTools_IndexedMapOfShape numbered, wanted;
  TopExp::MapShapes(input.model.shape(), TopAbs_EDGE, numbered);
  for (const TopoDS_Face& face : input.faces) TopExp::MapShapes(face, TopAbs_EDGE, wanted);
  for (const int number : input.edges) wanted.Add(numbered(number));
  std::vector<Net> nets;
  for (int number = 1; number <= numbered.Extent(); ++number) {
    if (!all && !wanted.Contains(numbered(number))) continue;
    stop_if_interrupted();
    NetSource source;
    source.file = input.model.file().string();
    source.edge = number;
    append(nets, edge_nets(TopoDS::Edge(numbered(number)), source));
  }
  if (nets.empty())
    throw occt::BadModel(input.model.file().string() + ": there is no edge with a curve in it");
  return nets;
}

void write_parts(std::span<const Net> nets, const std::string& file) {
  occt::Model model;
  std::map<std::string, int> counts;
  for (const Net& net : nets) ++counts[name_of(net.source)];
  std::map<std::string, int> numbers;
  for (const Net& net : nets) {
    std::string name = name_of(net.source);
    const int number = ++numbers[name];
    if (counts[name] > 1) name += "." + std::to_string(number);
    model.add(net_shape(net), name);
  }
  write_model(model, file);
}

// The face of a net, oriented as the face that it comes from.
TopoDS_Face oriented_face(const Net& net, const occt::Model& model) {
  return TopoDS::Face(net_shape(net).Oriented(model.face(net.source.face).Orientation()));
}

}  // namespace

NetInput read_net_input(const std::string& text, Take take) {
  const InputName name = parse_input(text);
  NetInput input{text, {}, {}};
  if (is_net_file(name.file)) {
    input.nets = chosen(read_nets(name.file), name);
    return input;
  }
  const bool edges = take == Take::Edges;
  input.model.emplace(read_input(text, edges ? Faces::Optional : Faces::Required));
  input.nets = edges ? nets_of_edges(*input.model, name.is_whole()) : nets_of_faces(*input.model);
  return input;
}

void write_nets(NetInput& input, std::span<const Net> nets, const std::string& file) {
  if (is_net_file(file)) return write_plain_json(nets_json(nets), file);
  const bool of_faces = input.model && !nets.empty() && nets.front().source.face > 0;
  if (!of_faces) return write_parts(nets, file);
  occt::Model& model = input.model->model;
  std::map<int, std::vector<TopoDS_Face>> faces;
  for (int number = 1; number <= model.face_count(); ++number) faces[number];
  for (const Net& net : nets) faces[net.source.face].push_back(oriented_face(net, model));
  stop_if_interrupted();
  model.replace_faces(faces);
  write_model(model, file);
}

void drop_other_faces(Input& input) {
  std::map<int, std::vector<TopoDS_Face>> others;
  for (int number = 1; number <= input.model.face_count(); ++number) others[number];
  for (const int number : input.numbers) others.erase(number);
  if (!others.empty()) input.model.replace_faces(others);
}

}  // namespace blossom::cli
