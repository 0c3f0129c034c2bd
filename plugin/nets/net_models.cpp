// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/net_models.h"

#include <iterator>
#include <map>
#include <string>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "plugin/nets/net_shapes.h"

namespace blossom::nets {
namespace {

// As messages call it: the file, or the input's name if there is none.
std::string file_of(const reports::Input& input) {
  const std::string file = input.model.file().string();
  return file.empty() ? input.name : file;
}

// The face of a net, oriented as the face that it comes from.
TopoDS_Face oriented_face(const Net& net, const occt::Model& model) {
  return TopoDS::Face(net_shape(net).Oriented(model.face(net.source.face).Orientation()));
}

}  // namespace

void append(std::vector<Net>& all, std::vector<Net> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<Net> nets_of_faces(const reports::Input& input, const Stop& stop) {
  const std::vector<std::string> names = input.model.face_names();
  std::vector<Net> nets;
  for (std::size_t i = 0; i < input.faces.size(); ++i) {
    ask(stop);
    NetSource source;
    source.file = file_of(input);
    source.face = input.numbers[i];
    source.name = names[static_cast<std::size_t>(source.face - 1)];
    append(nets, face_nets(input.faces[i], source));
  }
  return nets;
}

std::vector<Net> nets_of_edges(const reports::Input& input, bool all, const Stop& stop) {
  TopTools_IndexedMapOfShape numbered, wanted;
  TopExp::MapShapes(input.model.shape(), TopAbs_EDGE, numbered);
  for (const TopoDS_Face& face : input.faces) TopExp::MapShapes(face, TopAbs_EDGE, wanted);
  for (const int number : input.edges) wanted.Add(numbered(number));
  std::vector<Net> nets;
  for (int number = 1; number <= numbered.Extent(); ++number) {
    if (!all && !wanted.Contains(numbered(number))) continue;
    ask(stop);
    NetSource source;
    source.file = file_of(input);
    source.edge = number;
    append(nets, edge_nets(TopoDS::Edge(numbered(number)), source));
  }
  if (nets.empty()) throw occt::BadModel(file_of(input) + ": there is no edge with a curve in it");
  return nets;
}

void put_nets(occt::Model& model, std::span<const Net> nets) {
  std::map<int, std::vector<TopoDS_Face>> faces;
  for (int number = 1; number <= model.face_count(); ++number) faces[number];
  for (const Net& net : nets) faces[net.source.face].push_back(oriented_face(net, model));
  model.replace_faces(faces);
}

occt::Model model_of_nets(std::span<const Net> nets) {
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
  return model;
}

}  // namespace blossom::nets
