// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/continuity.h"

#include <utility>
#include <vector>

#include "plugin/pictures/scene/mesh.h"
#include "plugin/reports/blends/continuity_words.h"

namespace blossom::pictures {
namespace {

using reports::Input;
using reports::short_name;

constexpr Vec3 kApartColour = {0.85, 0.10, 0.60};
constexpr Vec3 kSharpColour = {0.10, 0.11, 0.13};
constexpr Vec3 kTangentColour = {0.90, 0.49, 0.08};
constexpr Vec3 kSmoothColour = {0.13, 0.58, 0.25};
constexpr Vec3 kOpenColour = {0.82, 0.12, 0.12};

// The layers of the picture; what is less smooth is drawn over what is smoother.
struct EdgeLayers {
  PictureLayer smooth{"G2", kSmoothColour};
  PictureLayer tangent{"G1", kTangentColour};
  PictureLayer sharp{"sharp (G0)", kSharpColour};
  PictureLayer apart{"apart", kApartColour};
  PictureLayer open{"not compared", kOpenColour};

  PictureLayer& of(const occt::EdgeContinuity& edge) {
    if (!edge.found) return open;
    switch (edge.smoothness) {
      case Smoothness::None: return apart;
      case Smoothness::G0: return sharp;
      case Smoothness::G1: return tangent;
      case Smoothness::G2: break;
    }
    return smooth;
  }
};

}  // namespace

Picture continuity_picture(const Input& input, const reports::ContinuityAnswer& answer) {
  Picture picture;
  picture.title = "continuity of " + short_name(input.name);
  picture.groups = {{input.faces, kFirstColour, kFirstOpacity, short_name(input.name),
                     reports::face_labels(input)}};
  EdgeLayers layers;
  for (const occt::EdgeContinuity& edge : answer.edges)
    if (std::vector<Vec3> points = edge_points(edge.edge); !points.empty())
      layers.of(edge).items.push_back({std::move(points), reports::edge_line(edge)});
  picture.layers = {layers.smooth, layers.tangent, layers.sharp, layers.apart, layers.open};
  return picture;
}

}  // namespace blossom::pictures
