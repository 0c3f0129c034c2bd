// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/models.h"

#include <string>
#include <utility>
#include <vector>

#include "plugin/pictures/scene/mesh.h"
#include "plugin/reports/models/soundness.h"

namespace blossom::pictures {
namespace {

using reports::FaceLabels;
using reports::Input;
using reports::short_name;

constexpr Vec3 kOpenEdge = {0.93, 0.50, 0.05};
constexpr Vec3 kCrowdedEdge = {0.42, 0.13, 0.62};

struct Layers {
  PictureLayer open{"open edge", kOpenEdge};
  PictureLayer crowded{"non-manifold edge", kCrowdedEdge};
  PictureLayer faulty{"edge with a problem", kCurveColour};
  PictureLayer places{"where a problem is", kCurveColour, LayerStyle::Ring};
};

std::string text_of(const std::vector<occt::Problem>& problems) {
  std::string text;
  for (const occt::Problem& problem : problems) text += "\n" + problem.text();
  return text;
}

void add_places(const std::string& name, const std::vector<occt::Problem>& problems,
                Layers& layers) {
  for (const occt::Problem& problem : problems)
    if (problem.place)
      layers.places.items.push_back({{*problem.place}, name + "\n" + problem.text()});
}

void add_edge(const occt::EdgeSoundness& edge, Layers& layers) {
  const std::string name = "edge " + std::to_string(edge.number);
  add_places(name, edge.problems, layers);
  PictureLayer* layer = nullptr;
  if (!edge.problems.empty())
    layer = &layers.faulty;
  else if (edge.crowded)
    layer = &layers.crowded;
  else if (edge.free)
    layer = &layers.open;
  if (layer == nullptr) return;
  std::string label = name + (edge.free ? ", open" : edge.crowded ? ", non-manifold" : "");
  layer->items.push_back({edge_points(edge.edge), label + text_of(edge.problems)});
}

}  // namespace

Picture model_picture(const Input& input, const reports::ModelFacts& facts) {
  Picture picture;
  picture.title = short_name(input.name);
  picture.subtitle = facts.valid ? "valid" : "not valid";
  PictureFaces good{{}, kFirstColour, kFirstOpacity, "faces"};
  PictureFaces bad{{}, kFaultyColour, kFirstOpacity, "faces that are not valid"};
  const FaceLabels labels(input);
  for (std::size_t i = 0; i < facts.faces.size(); ++i) {
    const reports::FaceFacts& face = facts.faces[i];
    std::string label = labels.of(face.number) + "\n" + face.surface;
    if (const std::string of = reports::measures_text(face.measures); !of.empty())
      label += ", " + of;
    for (const std::string& problem : face.problems) label += "\n" + problem;
    PictureFaces& group = face.problems.empty() ? good : bad;
    group.faces.push_back(input.faces[i]);
    group.labels.push_back(std::move(label));
  }
  picture.groups = {std::move(good), std::move(bad)};
  return picture;
}

Picture soundness_picture(const Input& input, const occt::Soundness& found) {
  Picture picture;
  picture.title = short_name(input.name);
  const std::size_t problems = reports::problem_count(found);
  picture.subtitle = std::string(reports::verdict_of(found)) +
                     (problems == 0 ? "" : ": " + reports::counted(problems, "problem"));
  PictureFaces good{{}, kFirstColour, kFirstOpacity, "faces"};
  PictureFaces bad{{}, kFaultyColour, kFirstOpacity, "faces with problems"};
  const FaceLabels labels(input);
  Layers layers;
  for (const occt::FaceSoundness& face : found.faces) {
    const std::string name = labels.of(face.number);
    PictureFaces& group = face.problems.empty() ? good : bad;
    group.faces.push_back(input.model.face(face.number));
    group.labels.push_back(name + text_of(face.problems));
    add_places(name, face.problems, layers);
  }
  for (const occt::EdgeSoundness& edge : found.edges) add_edge(edge, layers);
  picture.groups = {std::move(good), std::move(bad)};
  picture.layers = {layers.open, layers.crowded, layers.faulty, layers.places};
  picture.facts = found.problems;
  return picture;
}

}  // namespace blossom::pictures
