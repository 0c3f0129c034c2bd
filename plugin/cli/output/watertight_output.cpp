// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/output/watertight_output.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "core/base/work_limit.h"
#include "plugin/cli/process/interruption.h"

namespace blossom::cli {
namespace {

Vec4 homogeneous(const Vec3& p) { return {p[0], p[1], p[2], 1}; }

nets::NetValue value_of(const WatertightPiece& piece) {
  if (const auto* triangle = std::get_if<BezierTriangle>(&piece.form)) {
    RationalBezierTriangle made{triangle->degree, {}};
    for (const Vec3& p : triangle->points) made.points.push_back(homogeneous(p));
    return made;
  }
  const Grid<Vec3>& net = std::get<BezierPatch>(piece.form).points;
  RationalBezierPatch made{Grid<Vec4>(net.rows(), net.columns())};
  std::ranges::transform(net.values(), made.points.values().begin(), homogeneous);
  return made;
}

}  // namespace

occt::WatertightShape watertight_of(const TopoDS_Shape& shape, const EngineOptions& engine,
                                    double seconds) {
  IntersectionOptions left;
  left.time_limit = seconds;
  const WorkLimit limit(left);
  WatertightOptions options;
  options.tolerance = occt::kWatertightFactor * engine.tolerance;
  options.ask = [&limit] {
    stop_if_interrupted();
    return limit.reached() == nullptr;
  };
  occt::WatertightShape made = occt::watertight(shape, options);
  if (!made.pieces.obstacle.empty() && made.pieces.open.empty())
    throw occt::BadModel("the faces cannot be made watertight: " + made.pieces.obstacle);
  return made;
}

std::string reason_of(const WatertightPieces& pieces) {
  if (pieces.open.empty()) return {};
  return "the time limit was reached while the faces were made watertight; " +
         counted(pieces.open.size(), "face") + " not done";
}

Status status_with(Status status, const WatertightPieces& pieces) {
  if (!pieces.open.empty()) return Status::Stopped;
  return pieces.turned.empty() ? status : weaker(status, Status::Tolerance);
}

std::string summary_of(const WatertightPieces& pieces) {
  const std::size_t triangles = reports::triangle_count(pieces);
  std::ostringstream text;
  if (!pieces.open.empty()) {
    text << "  watertight: stopped; faces that are not done:";
    for (const int face : pieces.open) text << ' ' << face + 1;
    text << '\n';
    return text.str();
  }
  text << "  watertight: " << counted(triangles, "triangle") << ", "
       << counted(pieces.pieces.size() - triangles, "rectangle") << ", "
       << counted(reports::common_count(pieces), "common side") << ", within " << pieces.deviation
       << " of the faces\n";
  if (pieces.turned.empty()) return text.str();
  text << "  not proven to fold over nowhere: " << counted(pieces.turned.size(), "piece")
       << " narrower than the edges beside are moved, of face";
  for (const int face : reports::folded_faces(pieces)) text << ' ' << face;
  text << '\n';
  return text.str();
}

std::vector<nets::Net> nets_of(const WatertightPieces& pieces, const std::string& file) {
  std::vector<nets::Net> nets;
  for (const WatertightPiece& piece : pieces.pieces) {
    nets::Net net;
    net.value = value_of(piece);
    net.u = net.v = {0, 1};
    net.source.file = file;
    net.source.face = piece.face + 1;
    net.source.error = pieces.deviation;
    nets.push_back(std::move(net));
  }
  return nets;
}

}  // namespace blossom::cli
