// SPDX-License-Identifier: LGPL-2.1-or-later
// Nets to JSON.

#include "plugin/nets/net_json.h"

namespace blossom::nets {
namespace {

// Three coordinates of a polynomial form, four of a rational one.
Json point_json(const Vec4& p, bool rational) {
  Json json = Json::array({p[0], p[1], p[2]});
  if (rational) json.push_back(p[3]);
  return json;
}

Json row_json(std::span<const Vec4> row, bool rational) {
  Json json = Json::array();
  for (const Vec4& p : row) json.push_back(point_json(p, rational));
  return json;
}

Json grid_json(const Grid<Vec4>& grid, bool rational) {
  Json json = Json::array();
  const auto columns = static_cast<std::size_t>(grid.columns());
  for (int i = 0; i < grid.rows(); ++i)
    json.push_back(
        row_json(grid.values().subspan(static_cast<std::size_t>(i) * columns, columns), rational));
  return json;
}

Json pair(const Interval& interval) { return Json::array({interval.from, interval.to}); }

Json pair(const QParameters& q) { return Json::array({q.q1, q.q2}); }

Json head(const char* kind, const char* form, const Json& degree, bool rational) {
  return {{"kind", kind}, {"form", form}, {"degree", degree}, {"rational", rational}};
}

// The members of a net without those of its source.
struct Writer {
  const Net& net;

  Json curve(const char* form, int degree) const {
    Json json = head("curve", form, degree, net.rational);
    json["interval"] = pair(net.u);
    return json;
  }

  Json patch(const char* form, int n, int m) const {
    Json json = head("patch", form, {n, m}, net.rational);
    json["u"] = pair(net.u);
    json["v"] = pair(net.v);
    const bool angle_u = net.u_law == ParameterLaw::Angle,
               angle_v = net.v_law == ParameterLaw::Angle;
    if (angle_u || angle_v) json["angle"] = {angle_u, angle_v};
    return json;
  }

  Json operator()(const RationalBezierCurve& value) const {
    Json json = curve("bezier", value.degree());
    json["points"] = row_json(value.points, net.rational);
    return json;
  }
  Json operator()(const RationalMonomialCurve& value) const {
    Json json = curve("monomial", value.degree());
    json["centre"] = value.centre;
    json["scale"] = value.scale;
    json["points"] = row_json(value.coefficients, net.rational);
    return json;
  }
  Json operator()(const QCurve& value) const {
    Json json = curve("q-bezier", value.degree());
    json["q"] = pair(value.q);
    json["points"] = row_json(value.points, net.rational);
    return json;
  }
  Json operator()(const RationalBezierPatch& value) const {
    Json json = patch("bezier", value.degree_u(), value.degree_v());
    json["points"] = grid_json(value.points, net.rational);
    return json;
  }
  Json operator()(const RationalMonomialPatch& value) const {
    Json json = patch("monomial", value.degree_u(), value.degree_v());
    json["centre"] = {value.centre_u, value.centre_v};
    json["scale"] = {value.scale_u, value.scale_v};
    json["points"] = grid_json(value.coefficients, net.rational);
    return json;
  }
  Json operator()(const QPatch& value) const {
    Json json = patch("q-bezier", value.degree_u(), value.degree_v());
    json["q"] = pair(value.q);
    json["r"] = pair(value.r);
    json["points"] = grid_json(value.points, net.rational);
    return json;
  }
  Json operator()(const RationalBezierTriangle& value) const {
    Json json = head("triangle", "bezier", value.degree, net.rational);
    for (const Vec2& corner : net.corners)
      json["corners"].push_back(Json::array({corner[0], corner[1]}));
    Json rows = Json::array();
    for (int nu = 0; nu <= value.degree; ++nu) {
      Json row = Json::array();
      for (int mu = 0; mu <= value.degree - nu; ++mu)
        row.push_back(point_json(value(nu, mu), net.rational));
      rows.push_back(std::move(row));
    }
    json["points"] = std::move(rows);
    return json;
  }
};

}  // namespace

Json to_json(const Net& net) {
  Json json = std::visit(Writer{net}, net.value);
  const NetSource& source = net.source;
  if (source.face > 0) json["face"] = source.face;
  if (source.edge > 0) json["edge"] = source.edge;
  if (source.net > 0) json["net"] = source.net;
  if (!source.name.empty()) json["name"] = source.name;
  if (source.error > 0) json["error"] = source.error;
  if (net.border_error > 0) json["border_error"] = net.border_error;
  return json;
}

Json nets_json(std::span<const Net> nets) {
  Json json = {{"schema", "blossom.net/1"}, {"nets", Json::array()}};
  for (const Net& net : nets) json["nets"].push_back(to_json(net));
  return json;
}

}  // namespace blossom::nets
