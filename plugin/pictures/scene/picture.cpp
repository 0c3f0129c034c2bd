// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/scene/picture.h"

#include <array>
#include <utility>

namespace blossom::pictures {
namespace {

PictureLayer plain_layer(LayerStyle style) { return {{}, kCurveColour, style}; }

}  // namespace

const Vec3& palette(std::size_t index) {
  static constexpr std::array<Vec3, 8> kColours = {kFirstColour,           kSecondColour,
                                                   Vec3{0.47, 0.72, 0.45}, Vec3{0.85, 0.52, 0.55},
                                                   Vec3{0.63, 0.54, 0.79}, Vec3{0.45, 0.75, 0.77},
                                                   Vec3{0.78, 0.76, 0.42}, Vec3{0.68, 0.58, 0.50}};
  return kColours[index % kColours.size()];
}

std::vector<PictureLayer> all_layers(const Picture& picture) {
  PictureLayer curves = plain_layer(LayerStyle::Curve), dots = plain_layer(LayerStyle::Dot);
  for (const std::vector<Vec3>& curve : picture.curves) curves.items.push_back({curve});
  for (const Vec3& point : picture.points) dots.items.push_back({{point}});
  std::vector<PictureLayer> layers = {std::move(curves)};
  layers.insert(layers.end(), picture.layers.begin(), picture.layers.end());
  layers.push_back(std::move(dots));
  for (PictureLayer& layer : layers)
    std::erase_if(layer.items, [](const PictureItem& item) { return item.points.empty(); });
  std::erase_if(layers, [](const PictureLayer& layer) { return layer.items.empty(); });
  return layers;
}

}  // namespace blossom::pictures
