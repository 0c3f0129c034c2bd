// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/feet_on_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <ElSLib.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>

#include "adapters/occt/convert/curves.h"
#include "core/base/unbounded.h"
#include "core/math/binomial.h"

namespace blossom::occt {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
// A homogeneous point in the frame of the surface.
Vec4 in_frame(const gp_Ax3& frame, const Vec4& p) {
  const gp_XYZ& o = frame.Location().XYZ();
  const gp_XYZ from(p[0] - p[3] * o.X(), p[1] - p[3] * o.Y(), p[2] - p[3] * o.Z());
  return {from.Dot(frame.XDirection().XYZ()), from.Dot(frame.YDirection().XYZ()),
          from.Dot(frame.Direction().XYZ()), p[3]};
}

using Net = Grid<Vec4>;

Net in_frame(const gp_Ax3& frame, const RationalBezierPatch& patch) {
  Net net(patch.points.rows(), patch.points.columns());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) net(i, j) = in_frame(frame, patch.points(i, j));
  return net;
}

double factor(int n, int i, int j) {
  return binomial(n, i) * binomial(n, j) / binomial(2 * n, i + j);
}

// The range of the squared distance from the origin, or from the axis, by the coefficients of
//   |x|^2 = (sum of N_kl B_k^2n B_l^2m) / (sum of W_kl B_k^2n B_l^2m)
Interval squared_norms(const Net& net, int coordinates) {
  const int n = net.rows() - 1, m = net.columns() - 1;
  Grid<Vec2> sums(2 * n + 1, 2 * m + 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      for (int k = 0; k <= n; ++k)
        for (int l = 0; l <= m; ++l) {
          const Vec4 &p = net(i, j), &q = net(k, l);
          double dot = 0;
          for (int c = 0; c < coordinates; ++c) dot += p[c] * q[c];
          const double by = factor(n, i, k) * factor(m, j, l);
          sums(i + k, j + l) = sums(i + k, j + l) + Vec2{by * dot, by * p[3] * q[3]};
        }
  Interval range{kInfinity, -kInfinity};
  for (const Vec2& sum : sums.values()) {
    range.from = std::min(range.from, sum[0] / sum[1]);
    range.to = std::max(range.to, sum[0] / sum[1]);
  }
  return range;
}

// The range of a function of the control points.
template <class Value>
Interval range_of(const Net& net, Value value) {
  Interval range{kInfinity, -kInfinity};
  for (const Vec4& p : net.values()) {
    const double at = value(p);
    range.from = std::min(range.from, at);
    range.to = std::max(range.to, at);
  }
  return range;
}

// The angles about the axis; nothing unless the hull keeps clear of it.
std::optional<Interval> angles_of(const Net& net) {
  const Vec4& first = net(net.rows() / 2, net.columns() / 2);
  const double middle = std::atan2(first[1], first[0]);
  const double c = std::cos(middle), s = std::sin(middle);
  if (range_of(net, [&](const Vec4& p) { return c * p[0] + s * p[1]; }).from <= 0)
    return std::nullopt;
  const Interval turned = range_of(
      net, [&](const Vec4& p) { return std::atan2(c * p[1] - s * p[0], c * p[0] + s * p[1]); });
  return Interval{middle + turned.from, middle + turned.to};
}

}  // namespace

FeetOnFace::FeetOnFace(const TopoDS_Face& face) : trims_(face_trims(face)) {
  const BRepAdaptor_Surface surface(face, Standard_False);
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      kind_ = ElementaryKind::Plane;
      frame_ = surface.Plane().Position();
      break;
    case GeomAbs_Cylinder:
      kind_ = ElementaryKind::Cylinder;
      frame_ = surface.Cylinder().Position();
      radius_ = surface.Cylinder().Radius();
      break;
    case GeomAbs_Sphere:
      kind_ = ElementaryKind::Sphere;
      frame_ = surface.Sphere().Position();
      radius_ = surface.Sphere().Radius();
      break;
    default: break;
  }
}

std::optional<double> FeetOnFace::farthest(const RationalBezierPatch& patch, double within) const {
  if (!kind_ || std::max(patch.degree_u(), patch.degree_v()) > kMaxBinomial / 2) return {};
  const std::optional<Range> feet = feet_of(patch);
  if (!feet || !are_inside(*feet, within)) return {};
  return distance_bound(in_frame(frame_, patch)) + 2 * within;
}

// From the surface without its trims; a net in its frame.
double FeetOnFace::distance_bound(const Net& net) const {
  if (kind_ == ElementaryKind::Plane) {
    const Interval heights = range_of(net, [](const Vec4& p) { return p[2] / p[3]; });
    return std::max(std::abs(heights.from), std::abs(heights.to));
  }
  const Interval squares = squared_norms(net, kind_ == ElementaryKind::Cylinder ? 2 : 3);
  const double least = std::sqrt(std::max(0.0, squares.from)), most = std::sqrt(squares.to);
  return std::max(radius_ - least, most - radius_);
}

std::optional<double> FeetOnFace::farthest_in_plane(const TopoDS_Face& face, const FaceTrims& piece,
                                                    double within) const {
  if (kind_ != ElementaryKind::Plane && kind_ != ElementaryKind::Cylinder) return {};
  if (BRepAdaptor_Surface(face, Standard_False).GetType() != GeomAbs_Plane) return {};
  if (kind_ == ElementaryKind::Cylinder && axis_meets(face, piece)) return {};
  const TrimShapes shapes = trim_shapes(face);
  double most = 0;
  Range feet{Interval{kInfinity, -kInfinity}, Interval{kInfinity, -kInfinity}};
  for (const auto& loop : piece.loops)
    for (const Coedge& coedge : loop) {
      const CurveSpans curve = bezier_spans(shapes.edge(coedge), within);
      for (const CurveSpan& span : curve.spans) {
        Net net(static_cast<int>(span.curve.points.size()), 1);
        for (int i = 0; i < net.rows(); ++i)
          net(i, 0) = in_frame(frame_, span.curve.points[static_cast<std::size_t>(i)]);
        most = std::max(most, distance_bound(net) + curve.error + coedge.tolerance);
        for (std::size_t k = 0; k < 2; ++k) {
          const int along = kind_ == ElementaryKind::Plane ? static_cast<int>(k) : 2;
          const Interval range = range_of(net, [&](const Vec4& p) { return p[along] / p[3]; });
          feet[k] = {std::min(feet[k].from, range.from), std::max(feet[k].to, range.to)};
        }
      }
    }
  if (kind_ == ElementaryKind::Cylinder) {  // whatever the angle
    const double seam = trims_.box.low[0] / trims_.scale[0];
    feet[0] = {seam, seam + kTurn};
  }
  if (!(feet[1].from <= feet[1].to) || !are_inside(feet, within)) return {};
  return most + 2 * within;
}

// Or may meet it, where it is along the plane.
bool FeetOnFace::axis_meets(const TopoDS_Face& face, const FaceTrims& piece) const {
  constexpr double kAlong = 1e-6;  // of unit vectors
  const gp_Pln plane = BRepAdaptor_Surface(face, Standard_False).Plane();
  const gp_Dir &normal = plane.Axis().Direction(), &axis = frame_.Direction();
  const double across = normal.Dot(axis);
  if (std::abs(across) < kAlong) return true;
  const gp_Vec way(frame_.Location(), plane.Location());
  const double t = way.Dot(gp_Vec(normal)) / across;
  double u = 0, v = 0;
  ElSLib::Parameters(plane, frame_.Location().Translated(gp_Vec(axis) * t), u, v);
  return part_side(piece, {u, u}, {v, v}) != PartSide::Outside;
}

// The chart rectangle of all feet.
std::optional<FeetOnFace::Range> FeetOnFace::feet_of(const RationalBezierPatch& patch) const {
  const Net net = in_frame(frame_, patch);
  const Interval heights = range_of(net, [](const Vec4& p) { return p[2] / p[3]; });
  if (kind_ == ElementaryKind::Plane)
    return Range{range_of(net, [](const Vec4& p) { return p[0] / p[3]; }),
                 range_of(net, [](const Vec4& p) { return p[1] / p[3]; })};
  const std::optional<Interval> angles = angles_of(net);
  if (!angles) return std::nullopt;
  if (kind_ == ElementaryKind::Cylinder) return Range{*angles, heights};
  // sin(latitude) = height / |x|
  const Interval squares = squared_norms(net, 3);
  if (!(squares.from > 0)) return std::nullopt;
  const auto latitude = [&](double height, bool up) {
    const double by = (height > 0) == up ? squares.from : squares.to;
    return std::asin(std::clamp(height / std::sqrt(by), -1.0, 1.0));
  };
  return Range{*angles, Interval{latitude(heights.from, false), latitude(heights.to, true)}};
}

// Of a range that no foot is farther from than `within`: what is left of a smaller one, or where
// nothing is left, as of feet along a border, on either side of it.
bool FeetOnFace::are_inside(const Range& feet, double within) const {
  std::array<std::vector<Interval>, 2> near;
  for (std::size_t k = 0; k < 2; ++k) {
    const bool angle = kind_ == ElementaryKind::Sphere || (k == 0 && radius_ > 0);
    const double less = within / (angle ? radius_ : 1);
    const double from = feet[k].from + less, to = feet[k].to - less;
    if (from <= to)
      near[k] = {{from, to}};
    else
      for (const double at : {0.5 * (from + to), to, from}) near[k].push_back({at, at});
  }
  for (const Interval& u : near[0])
    for (const Interval& v : near[1])
      if (is_range_inside({u, v}, within)) return true;
  return false;
}

// In two where a seam goes through it.
bool FeetOnFace::is_range_inside(const Range& rest, double within) const {
  const auto inside = [&](const Interval& u) {
    return u.from >= u.to || part_side(trims_, u, rest[1]) == PartSide::Inside;
  };
  if (kind_ == ElementaryKind::Plane)
    return part_side(trims_, rest[0], rest[1]) == PartSide::Inside;
  const double seam = trims_.box.low[0] / trims_.scale[0];
  const double before = seam + kTurn * std::floor((rest[0].to - seam) / kTurn);
  if (!(before > rest[0].from)) return part_side(trims_, rest[0], rest[1]) == PartSide::Inside;
  const double less = within / radius_;
  return inside({rest[0].from, before - less}) && inside({before + less, rest[0].to});
}

}  // namespace blossom::occt
