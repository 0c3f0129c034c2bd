// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/subdivisions.h"

#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <TopoDS.hxx>

#include "plugin/nets/net_shapes.h"
#include "plugin/pictures/scene/mesh.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::pictures {
namespace {

using nets::Net;
using reports::counted;
using reports::short_name;

// Where the pieces of each face begin.
class Grids {
 public:
  explicit Grids(const std::vector<Net>& pieces) {
    for (const Net& piece : pieces) {
      auto& [u, v] = starts_[piece.source.face];
      u.insert(piece.u.from);
      v.insert(piece.v.from);
    }
  }

  // 0 or 1, as on a chessboard.
  std::size_t field(const Net& piece) const {
    const auto& [u, v] = starts_.at(piece.source.face);
    const auto row = std::distance(u.begin(), u.find(piece.u.from));
    const auto column = std::distance(v.begin(), v.find(piece.v.from));
    return static_cast<std::size_t>((row + column) % 2);
  }

 private:
  std::map<int, std::pair<std::set<double>, std::set<double>>> starts_;
};

}  // namespace

Picture subdivision_picture(const std::string& name, const std::vector<Net>& made, std::size_t nets,
                            const std::function<void()>& stop) {
  constexpr std::size_t kFew = 64;
  const Grids grids(made);
  Picture picture;
  picture.title = "pieces of " + short_name(name);
  picture.subtitle = counted(made.size(), "piece") + " of " + counted(nets, "net");
  picture.groups = {{{}, kFirstColour}, {{}, kSecondColour}};
  PictureLayer control{"control net", kNetColour, LayerStyle::Net}, curves{"curve", kCurveColour};
  for (std::size_t i = 0; i < made.size(); ++i) {
    stop();
    const std::size_t field = is_triangle(made[i]) ? i % 2 : grids.field(made[i]);
    if (!is_curve(made[i]))
      picture.groups[field].faces.push_back(TopoDS::Face(nets::net_shape(made[i])));
    if (made.size() > kFew && !is_curve(made[i])) continue;
    PictureLayer& layer = is_curve(made[i]) ? curves : control;
    for (auto& line : nets::net_lines(made[i]))
      layer.items.push_back({std::move(line), "piece " + std::to_string(i + 1)});
  }
  picture.layers = {std::move(control), std::move(curves)};
  return picture;
}

Picture whole_picture(const std::string& name, const std::vector<nets::WholePart>& parts) {
  Picture picture;
  picture.title = "B-splines of " + short_name(name);
  picture.groups = {{{}, kFirstColour}};
  PictureLayer curves{"curve", kCurveColour};
  PictureFaces& surfaces = picture.groups.front();
  for (const nets::WholePart& part : parts)
    if (part.source.face > 0) {
      surfaces.faces.push_back(TopoDS::Face(part.shape));
      surfaces.labels.push_back(nets::name_of(part.source));
    } else if (auto points = edge_points(TopoDS::Edge(part.shape)); !points.empty()) {
      curves.items.push_back({std::move(points), nets::name_of(part.source)});
    }
  picture.layers = {std::move(curves)};
  return picture;
}

}  // namespace blossom::pictures
