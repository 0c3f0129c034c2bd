// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/watertight_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopLoc_Location.hxx>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/blossom/triangle_conversion.h"
#include "core/forms/algebra/conversion.h"
#include "core/math/index.h"

namespace blossom::occt {
namespace {

// The triangle with its corners renamed: `first` becomes a, the next one b.
BezierTriangle turned(const BezierTriangle& triangle, std::size_t first) {
  BezierTriangle result = triangle;
  for (int nu = 0; nu <= triangle.degree; ++nu)
    for (int mu = 0; nu + mu <= triangle.degree; ++mu) {
      std::array<int, 3> count{};
      count[first] = nu;
      count[(first + 1) % 3] = mu;
      count[(first + 2) % 3] = triangle.degree - nu - mu;
      result(nu, mu) = triangle(count[0], count[1]);
    }
  return result;
}

// Bound on the distance of its half patch.
double half_error(const BezierTriangle& triangle) {
  double largest = 0;  // coordinate
  for (const Vec3& p : triangle.points) largest = std::max(largest, max_norm(p));
  return std::sqrt(3.0) * half_patch_error(triangle.degree) * largest;
}

}  // namespace

PieceFaces::PieceFaces(const WatertightPieces& pieces) : pieces_(pieces) {
  for (const Vec3& p : pieces.vertices) {
    TopoDS_Vertex vertex;
    builder_.MakeVertex(vertex, gp_Pnt(p[0], p[1], p[2]), kTolerance);
    vertices_.push_back(vertex);
  }
  for (const WatertightSide& side : pieces.sides) edges_.push_back(edge_on(side));
}

TopoDS_Face PieceFaces::face_of(const WatertightPiece& piece) {
  const auto* triangle = std::get_if<BezierTriangle>(&piece.form);
  if (!triangle) {
    begin(std::get<BezierPatch>(piece.form));
    for (std::size_t k = 0; k < 4; ++k) add_side(piece, k, k);
    return finished();
  }
  if (const auto plane = plane_of(pieces_, piece, kInPlane, kNarrow))
    return flat_face(piece, *plane);
  if (const auto diagonal = diagonal_of(piece, *triangle))
    return half_face(piece, *triangle, *diagonal);
  return collapsed_face(piece, *triangle);
}

// Meshers put nodes inside of patches even if these are flat; inside of planes they have no reason.
TopoDS_Face PieceFaces::flat_face(const WatertightPiece& piece, const PiecePlane& plane) {
  flattened_ = std::max(flattened_, plane.error);
  const Vec3 normal = cross(plane.x, plane.y);
  const auto direction = [](const Vec3& v) { return gp_Dir(v[0], v[1], v[2]); };
  const gp_Pnt origin(plane.origin[0], plane.origin[1], plane.origin[2]);
  builder_.MakeFace(face_, new Geom_Plane(gp_Ax3(origin, direction(normal), direction(plane.x))),
                    kTolerance);
  builder_.MakeWire(wire_);
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Vec2> points;
    for (const Vec3& p : side_of_piece(piece, k).curve.points) points.push_back(plane.at(p));
    if (!points.empty()) add_curved(piece, k, points);
  }
  return finished();
}

// No side is collapsed: beside the tip of such patches meshers make facets that lie over each
// other.
TopoDS_Face PieceFaces::half_face(const WatertightPiece& piece, const BezierTriangle& triangle,
                                  std::size_t diagonal) {
  flattened_ = std::max(flattened_, half_error(triangle));
  begin(half_patch(turned(triangle, diagonal)));
  add_side(piece, (diagonal + 2) % 3, 0);  // c to a along v = 0
  std::vector<Vec2> ends{{1, 0}, {0, 1}};
  if (!piece.along[diagonal]) std::ranges::reverse(ends);
  add_curved(piece, diagonal, ends);
  add_side(piece, (diagonal + 1) % 3, 3);
  return finished();
}

TopoDS_Face PieceFaces::collapsed_face(const WatertightPiece& piece,
                                       const BezierTriangle& triangle) {
  const std::size_t a = first_corner(piece);
  begin(collapsed_patch(turned(triangle, a)));
  add_side(piece, (a + 2) % 3, 0);  // c to a along v = 0
  add_side(piece, a, 1);
  add_side(piece, (a + 1) % 3, 2);
  add_point(piece.vertices[(a + 2) % 3], 3);
  return finished();
}

const WatertightSide& PieceFaces::side_of_piece(const WatertightPiece& piece, std::size_t k) const {
  return pieces_.sides[index(piece.sides[k])];
}

bool PieceFaces::has_point(const WatertightPiece& piece) const {
  return std::ranges::any_of(piece.sides,
                             [&](int k) { return pieces_.sides[index(k)].curve.points.empty(); });
}

double PieceFaces::length_of(const WatertightPiece& piece, std::size_t k) const {
  const BezierCurve& curve = side_of_piece(piece, k).curve;
  return curve.points.empty() ? 0 : distance(curve.points.front(), curve.points.back());
}

// Meshers put nodes inside of slender collapsed patches, too, which lie off the chords of both long
// sides by more than these are apart. An edge may be the diagonal there, if only rounding parts it
// from the patch.
std::optional<std::size_t> PieceFaces::diagonal_of(const WatertightPiece& piece,
                                                   const BezierTriangle& triangle) const {
  if (has_point(piece) || height_of(triangle) >= kSlender) return longest_inner_side(piece);
  const std::size_t shortest = shortest_side(piece);
  const bool only_rounding = half_error(triangle) <= kInPlane;
  if (length_of(piece, shortest) == 0 ||
      (side_of_piece(piece, shortest).edge >= 0 && !only_rounding))
    return std::nullopt;
  return shortest;
}

std::size_t PieceFaces::shortest_side(const WatertightPiece& piece) const {
  std::size_t shortest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (length_of(piece, k) < length_of(piece, shortest)) shortest = k;
  return shortest;
}

// None if all are on edges, whose points are to be those of the surface, too.
std::optional<std::size_t> PieceFaces::longest_inner_side(const WatertightPiece& piece) const {
  std::optional<std::size_t> longest;
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double size = length_of(piece, k);
    if (side_of_piece(piece, k).edge >= 0 || size <= most) continue;
    most = size;
    longest = k;
  }
  return longest;
}

// Of a collapsed patch the side from a to b stays whole. It is one that is a point, since collapsed
// sides beside each other do not survive a STEP file; or else one on an edge.
std::size_t PieceFaces::first_corner(const WatertightPiece& piece) const {
  std::size_t best = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const WatertightSide& side = side_of_piece(piece, k);
    if (side.curve.points.empty()) return k;
    if (side.edge >= 0) best = k;
  }
  return best;
}

TopoDS_Edge PieceFaces::edge_on(const WatertightSide& side) const {
  TopoDS_Edge edge;
  if (side.curve.points.empty()) return edge;
  RationalBezierCurve curve;
  for (const Vec3& p : side.curve.points) curve.points.push_back({p[0], p[1], p[2], 1});
  builder_.MakeEdge(edge, to_occt(curve), kTolerance);
  add_ends(edge, side.from, side.to);
  return edge;
}

void PieceFaces::add_ends(TopoDS_Edge& edge, int from, int to) const {
  builder_.Add(edge, vertices_[index(from)].Oriented(TopAbs_FORWARD));
  builder_.Add(edge, vertices_[index(to)].Oriented(TopAbs_REVERSED));
  builder_.Range(edge, 0, 1);
}

void PieceFaces::begin(const BezierPatch& patch) {
  surface_ = to_occt(homogeneous(patch));
  builder_.MakeFace(face_, surface_, kTolerance);
  builder_.MakeWire(wire_);
}

// Border k of the unit square, counter-clockwise from v = 0.
void PieceFaces::add_side(const WatertightPiece& piece, std::size_t side, std::size_t border) {
  TopoDS_Edge& edge = edges_[index(piece.sides[side])];
  if (edge.IsNull()) return add_point(piece.vertices[side], border);
  add_pcurve(edge, border, piece.along[side]);
  builder_.Add(wire_, edge.Oriented(piece.along[side] ? TopAbs_FORWARD : TopAbs_REVERSED));
}

// A side with a Bezier curve in the face's parameters, which runs as the side's own curve does.
void PieceFaces::add_curved(const WatertightPiece& piece, std::size_t side,
                            const std::vector<Vec2>& points) {
  TColgp_Array1OfPnt2d poles(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    poles(static_cast<int>(i) + 1) = {points[i][0], points[i][1]};
  TopoDS_Edge& edge = edges_[index(piece.sides[side])];
  builder_.UpdateEdge(edge, new Geom2d_BezierCurve(poles), face_, kTolerance);
  builder_.Add(wire_, edge.Oriented(piece.along[side] ? TopAbs_FORWARD : TopAbs_REVERSED));
}

void PieceFaces::add_point(int vertex, std::size_t border) {
  TopoDS_Edge edge;
  builder_.MakeEdge(edge);
  builder_.Degenerated(edge, Standard_True);
  builder_.UpdateEdge(edge, kTolerance);
  add_pcurve(edge, border, true);
  add_ends(edge, vertex, vertex);
  builder_.Add(wire_, edge);
}

void PieceFaces::add_pcurve(TopoDS_Edge& edge, std::size_t border, bool along) const {
  static const gp_Pnt2d corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const gp_Pnt2d& from = corners[along ? border : (border + 1) % 4];
  const gp_Pnt2d& to = corners[along ? (border + 1) % 4 : border];
  const Handle(Geom2d_Line) line = new Geom2d_Line(from, gp_Dir2d(gp_Vec2d(from, to)));
  builder_.UpdateEdge(edge, line, surface_, TopLoc_Location(), kTolerance);
  builder_.Range(edge, surface_, TopLoc_Location(), 0, 1);
}

TopoDS_Face PieceFaces::finished() {
  wire_.Closed(Standard_True);
  builder_.Add(face_, wire_);
  return face_;
}

}  // namespace blossom::occt
