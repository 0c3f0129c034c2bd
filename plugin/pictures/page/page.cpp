// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/page/page.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "core/base/unbounded.h"
#include "plugin/pictures/page/base64.h"
#include "plugin/pictures/page/viewer_files.h"
#include "plugin/reports/text/json.h"

namespace blossom::pictures {
namespace {

using reports::Json;

constexpr double kCoarser = 1.6;  // from one try to the next, see page_html
constexpr int kTries = 8;
constexpr double kMinExtent = 1e-9;  // keeps the scale of a scene without extent finite

template <typename T>
std::string packed(const std::vector<T>& values) {
  return base64(std::as_bytes(std::span(values)));
}

// What a scene fills.
struct SceneBox {
  Vec3 low = Vec3{1, 1, 1} * kInfinity;
  Vec3 high = Vec3{1, 1, 1} * -kInfinity;

  void add(const Vec3& p) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  Vec3 centre() const { return 0.5 * (low + high); }
  Vec3 extent() const {
    Vec3 size = high - low;
    for (int k = 0; k < 3; ++k) size[k] = std::max(size[k], kMinExtent);
    return size;
  }
};

SceneBox box_of(const std::vector<SceneMesh>& meshes, const std::vector<PictureLayer>& layers) {
  SceneBox box;
  for (const SceneMesh& item : meshes)
    for (const Vec3& p : item.mesh().points) box.add(p);
  for (const PictureLayer& layer : layers)
    for (const PictureItem& item : layer.items)
      for (const Vec3& p : item.points) box.add(p);
  if (box.low[0] > box.high[0]) box.low = box.high = {0, 0, 0};
  return box;
}

Json json_of(const Vec3& v) { return Json::array({v[0], v[1], v[2]}); }

// Numbers below 65536 take two bytes.
std::string packed_indices(const std::vector<std::uint32_t>& indices, bool wide) {
  if (wide) return packed(indices);
  return packed(std::vector<std::uint16_t>(indices.begin(), indices.end()));
}

// Of all triangles or lines, one after the other.
template <std::size_t Ends>
std::vector<std::uint32_t> indices_of(const std::vector<std::array<int, Ends>>& parts) {
  std::vector<std::uint32_t> indices;
  for (const std::array<int, Ends>& part : parts)
    for (const int i : part) indices.push_back(static_cast<std::uint32_t>(i));
  return indices;
}

Json face_json(const PictureMesh& mesh, const SceneBox& box) {
  const bool wide = mesh.points.size() > std::numeric_limits<std::uint16_t>::max();
  const Vec3 extent = box.extent();
  std::vector<std::uint16_t> points;
  std::vector<std::int8_t> normals;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double share = (mesh.points[i][k] - box.low[k]) / extent[k];
      points.push_back(
          static_cast<std::uint16_t>(std::lround(65535 * std::clamp(share, 0.0, 1.0))));
      normals.push_back(static_cast<std::int8_t>(std::lround(127 * mesh.normals[i][k])));
    }
  return {{"wide", wide},
          {"points", packed(points)},
          {"normals", packed(normals)},
          {"triangles", packed_indices(indices_of(mesh.triangles), wide)},
          {"border", packed_indices(indices_of(mesh.border), wide)}};
}

Json groups_json(const Picture& picture, const std::vector<SceneMesh>& meshes,
                 const SceneBox& box) {
  Json groups = Json::array();
  for (const PictureFaces& group : picture.groups)
    groups.push_back({{"name", group.name},
                      {"colour", json_of(group.colour)},
                      {"opacity", group.opacity},
                      {"faces", Json::array()}});
  for (const SceneMesh& item : meshes) {
    Json face = face_json(item.mesh(), box);
    const std::vector<std::string>& labels = picture.groups[item.group].labels;
    face["label"] = item.face < labels.size() ? labels[item.face] : "";
    groups[item.group]["faces"].push_back(std::move(face));
  }
  return groups;
}

const char* word_of(LayerStyle style) {
  switch (style) {
    case LayerStyle::Curve: return "curve";
    case LayerStyle::Net: return "net";
    case LayerStyle::Hatch: return "hatch";
    case LayerStyle::Dot: return "dot";
    case LayerStyle::Ring: return "ring";
    case LayerStyle::Square: break;
  }
  return "square";
}

// Points are lengths from the middle of the scene: single precision keeps their details.
Json layers_json(const std::vector<PictureLayer>& layers, const Vec3& centre) {
  Json all = Json::array();
  for (const PictureLayer& layer : layers) {
    Json items = Json::array();
    for (const PictureItem& item : layer.items) {
      std::vector<float> points;
      for (const Vec3& p : item.points)
        for (int k = 0; k < 3; ++k) points.push_back(static_cast<float>(p[k] - centre[k]));
      items.push_back({{"points", packed(points)}, {"label", item.label}});
    }
    all.push_back({{"name", layer.name},
                   {"colour", json_of(layer.colour)},
                   {"style", word_of(layer.style)},
                   {"items", std::move(items)}});
  }
  return all;
}

Json scene_json(const Picture& picture, const std::vector<SceneMesh>& meshes) {
  const std::vector<PictureLayer> layers = all_layers(picture);
  const SceneBox box = box_of(meshes, layers);
  return {{"title", picture.title},
          {"subtitle", picture.subtitle},
          {"facts", picture.facts},
          {"low", json_of(box.low - box.centre())},
          {"extent", json_of(box.extent())},
          {"size", norm(box.extent())},
          {"eye", json_of(scene_direction(picture, scene_corners(meshes)))},
          {"groups", groups_json(picture, meshes, box)},
          {"layers", layers_json(layers, box.centre())}};
}

// 'sha256-...' of a policy, from hexadecimal digits.
std::string policy_hash(std::string_view digits) {
  std::vector<std::uint8_t> bytes(digits.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    std::from_chars(digits.data() + 2 * i, digits.data() + 2 * i + 2, bytes[i], 16);
  return "'sha256-" + packed(bytes) + "'";
}

// JSON that no HTML ends: "<" is only in strings, where it may be written otherwise.
std::string embedded(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

std::string html_of(const Json& scene) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  html += "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src " +
          policy_hash(three_script().sha256) + " " + policy_hash(viewer_script().sha256) +
          "; style-src " + policy_hash(viewer_style().sha256) +
          "; base-uri 'none'; form-action 'none'\">\n";
  html +=
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Blossom</title>\n<style>";
  html += viewer_style().text;
  html += R"(</style>
</head>
<body>
<div id="stage"><canvas id="view"></canvas><div id="views"></div></div>
<div id="panel">
<h1 id="title"></h1>
<p id="subtitle"></p>
<h2>Shown</h2>
<div id="switches"></div>
<label><input type="checkbox" id="outlines" checked>edges of faces</label>
<h2>Clicked</h2>
<div id="picked">Click a face, a curve or a mark.</div>
<p class="hint" id="behind"></p>
<div id="certificate"><h2>Certificate</h2><ul id="facts"></ul></div>
<h2>Mouse</h2>
<p class="hint">Drag turns, the wheel zooms, Shift or the right button slides, a double click shows all.</p>
</div>
<script type="application/json" id="data">)";
  html += embedded(scene);
  html += "</script>\n<script>";
  html += three_script().text;
  html += "</script>\n<script>";
  html += viewer_script().text;
  html += "</script>\n</body>\n</html>\n";
  return html;
}

}  // namespace

std::string page_html(const Picture& picture, const std::vector<SceneMesh>& meshes) {
  std::string html = html_of(scene_json(picture, meshes));
  double coarseness = 1;
  const bool has_faces = std::ranges::any_of(
      picture.groups, [](const PictureFaces& group) { return !group.faces.empty(); });
  for (int i = 1; has_faces && i < kTries && html.size() >= kPageLimit; ++i) {
    coarseness *= kCoarser;
    html = html_of(scene_json(picture, scene_meshes(picture, coarseness)));
  }
  if (html.size() < kPageLimit) return html;
  throw occt::Failure("the page would have " + std::to_string(html.size() / 1'000'000) +
                      " MB, more than " + std::to_string(kPageLimit / 1'000'000) +
                      "; name the faces to show, as in FILE#1-500, or write a --picture or --glb");
}

}  // namespace blossom::pictures
