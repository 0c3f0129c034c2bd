// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/page/glb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/unbounded.h"
#include "plugin/reports/text/json.h"

namespace blossom::pictures {
namespace {

using reports::Json;

constexpr double kMetres = 0.001;  // model units are millimetres
// Of the glTF specification: component types, buffer targets and primitive modes.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kVertices = 34962, kElements = 34963;
constexpr int kPoints = 0, kLines = 1, kTriangles = 4;

static_assert(std::endian::native == std::endian::little);  // as in the file

// sRGB to linear, as glTF's colours are.
double linear(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// What the file is made of: the binary chunk and what refers to it.
class Glb {
 public:
  // Points and, for triangles, normals.
  int add_vectors(const std::vector<Vec3>& vectors, double scale) {
    std::vector<float> values;
    Vec3 low = Vec3{1, 1, 1} * kInfinity, high = -low;
    for (const Vec3& v : vectors) {
      const Vec3 turned = Vec3{v[0], v[2], -v[1]} * scale;  // z upwards to y upwards
      for (int k = 0; k < 3; ++k) {
        values.push_back(static_cast<float>(turned[k]));
        low[k] = std::min(low[k], double(values.back()));
        high[k] = std::max(high[k], double(values.back()));
      }
    }
    const int accessor = add_accessor(add_view(std::as_bytes(std::span(values)), kVertices), kFloat,
                                      vectors.size(), "VEC3");
    json_["accessors"].back()["min"] = Json::array({low[0], low[1], low[2]});
    json_["accessors"].back()["max"] = Json::array({high[0], high[1], high[2]});
    return accessor;
  }

  int add_indices(const std::vector<std::uint32_t>& indices) {
    return add_accessor(add_view(std::as_bytes(std::span(indices)), kElements), kUnsignedInt,
                        indices.size(), "SCALAR");
  }

  int add_material(const Vec3& colour, double opacity) {
    Json material = {{"doubleSided", true},
                     {"pbrMetallicRoughness",
                      {{"baseColorFactor", Json::array({linear(colour[0]), linear(colour[1]),
                                                        linear(colour[2]), opacity})},
                       {"metallicFactor", 0},
                       {"roughnessFactor", 0.6}}}};
    if (opacity < kFirstOpacity) material["alphaMode"] = "BLEND";
    json_["materials"].push_back(std::move(material));
    return static_cast<int>(json_["materials"].size()) - 1;
  }

  // A node with one mesh of one primitive.
  void add_node(const std::string& name, Json primitive) {
    const std::size_t number = json_["nodes"].size();
    json_["meshes"].push_back(
        {{"name", name}, {"primitives", Json::array({std::move(primitive)})}});
    json_["nodes"].push_back({{"name", name}, {"mesh", number}});
    json_["scenes"][0]["nodes"].push_back(number);
  }

  std::string bytes() {
    if (!binary_.empty()) json_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews"})
      if (json_[list].empty()) json_.erase(list);  // the specification has no empty lists
    if (json_["scenes"][0]["nodes"].empty()) json_["scenes"][0].erase("nodes");
    std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string chunks = chunk(text, "JSON");
    if (!binary_.empty()) chunks += chunk(binary_, std::string("BIN\0", 4));
    return "glTF" + number(2) + number(12 + chunks.size()) + chunks;
  }

 private:
  static std::string number(std::size_t value) {
    std::string text;
    for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>(value >> shift & 0xFF);
    return text;
  }

  static std::string chunk(const std::string& data, const std::string& kind) {
    return number(data.size()) + kind + data;
  }

  int add_view(std::span<const std::byte> data, int target) {
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", binary_.size()},
                                    {"byteLength", data.size()},
                                    {"target", target}});
    binary_.append(reinterpret_cast<const char*>(data.data()), data.size());
    return static_cast<int>(json_["bufferViews"].size()) - 1;
  }

  int add_accessor(int view, int component, std::size_t count, const char* type) {
    json_["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(json_["accessors"].size()) - 1;
  }

  std::string binary_;
  Json json_ = {{"asset", {{"version", "2.0"}, {"generator", "blossom"}}},
                {"scene", 0},
                {"scenes", Json::array({{{"nodes", Json::array()}}})},
                {"nodes", Json::array()},
                {"meshes", Json::array()},
                {"materials", Json::array()},
                {"accessors", Json::array()},
                {"bufferViews", Json::array()}};
};

// The specification wants unit normals; where a surface has none, any will do.
Vec3 some_normal(const Vec3& normal) { return max_norm(normal) > 0 ? normal : Vec3{0, 0, 1}; }

void add_group(Glb& glb, const PictureFaces& group, std::size_t number,
               const std::vector<SceneMesh>& meshes) {
  std::vector<Vec3> points, normals;
  std::vector<std::uint32_t> corners;
  for (const SceneMesh& item : meshes) {
    if (item.group != number) continue;
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), item.mesh().points.begin(), item.mesh().points.end());
    for (const Vec3& normal : item.mesh().normals) normals.push_back(some_normal(normal));
    for (const auto& triangle : item.mesh().triangles)
      for (const int i : triangle) corners.push_back(first + static_cast<std::uint32_t>(i));
  }
  if (corners.empty()) return;
  Json attributes = {{"POSITION", glb.add_vectors(points, kMetres)},
                     {"NORMAL", glb.add_vectors(normals, 1)}};
  glb.add_node(group.name, {{"attributes", std::move(attributes)},
                            {"indices", glb.add_indices(corners)},
                            {"material", glb.add_material(group.colour, group.opacity)},
                            {"mode", kTriangles}});
}

void add_layer(Glb& glb, const PictureLayer& layer) {
  const bool marks = layer.style > LayerStyle::Hatch;
  std::vector<Vec3> points;
  for (const PictureItem& item : layer.items) {
    if (marks) points.push_back(item.points.front());
    for (std::size_t i = 1; i < item.points.size() && !marks; ++i)
      points.insert(points.end(), {item.points[i - 1], item.points[i]});
  }
  if (points.empty()) return;
  glb.add_node(layer.name, {{"attributes", {{"POSITION", glb.add_vectors(points, kMetres)}}},
                            {"material", glb.add_material(layer.colour, 1)},
                            {"mode", marks ? kPoints : kLines}});
}

}  // namespace

std::string glb_bytes(const Picture& picture, const std::vector<SceneMesh>& meshes) {
  Glb glb;
  for (std::size_t i = 0; i < picture.groups.size(); ++i)
    add_group(glb, picture.groups[i], i, meshes);
  for (const PictureLayer& layer : all_layers(picture)) add_layer(glb, layer);
  return glb.bytes();
}

}  // namespace blossom::pictures
