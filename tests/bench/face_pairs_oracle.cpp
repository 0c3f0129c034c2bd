// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/face_pairs_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Bnd_Box.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

namespace blossom::bench {
namespace {

constexpr int kGrid = 64;
constexpr int kNewtonSteps = 12;
constexpr double kBulge = 0.3;    // of a cell's diagonal, that its surface may leave its corners
constexpr double kInside = 1e-4;  // of the parameters' ranges: strictly inside
constexpr double kClose = 1e-9;   // of the size: a common point
constexpr double kThin = 2e-3;    // of the size: points nearer to each other are one

struct Grid {
  explicit Grid(const TopoDS_Face& f) : face(f), surface(f, false), classifier(f, 1e-9) {
    BRepTools::UVBounds(f, low[0], high[0], low[1], high[1]);
    for (int i = 0; i <= kGrid; ++i)
      for (int j = 0; j <= kGrid; ++j)
        points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
            surface.Value(parameter(0, i), parameter(1, j));
  }

  double parameter(int k, double i) const {
    const auto d = static_cast<std::size_t>(k);
    return low[d] + (high[d] - low[d]) * i / kGrid;
  }

  Bnd_Box box(int i0, int i1, int j0, int j1) const {
    Bnd_Box box;
    for (int i = i0; i <= i1; ++i)
      for (int j = j0; j <= j1; ++j)
        box.Add(points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    const double cell = std::sqrt(box.SquareExtent()) / std::max(1, std::max(i1 - i0, j1 - j0));
    box.Enlarge(kBulge * cell);
    return box;
  }

  bool holds(double u, double v) const {
    const std::array x{u, v};
    for (std::size_t k = 0; k < 2; ++k) {
      const double margin = kInside * (high[k] - low[k]);
      if (!(x[k] > low[k] + margin && x[k] < high[k] - margin)) return false;
    }
    return classifier.Perform(gp_Pnt2d(u, v)) == TopAbs_IN;
  }

  TopoDS_Face face;
  BRepAdaptor_Surface surface;
  mutable BRepTopAdaptor_FClass2d classifier;
  std::array<double, 2> low{}, high{};
  std::array<std::array<gp_Pnt, kGrid + 1>, kGrid + 1> points;
};

// Steps of least length to S_a = S_b.
std::optional<OraclePoint> refined(const Grid& a, const Grid& b, std::array<double, 4> x,
                                   double size) {
  for (int step = 0; step < kNewtonSteps; ++step) {
    gp_Pnt p, q;
    gp_Vec au, av, bu, bv;
    a.surface.D1(x[0], x[1], p, au, av);
    b.surface.D1(x[2], x[3], q, bu, bv);
    const gp_Vec gap(p, q);
    if (gap.Magnitude() <= kClose * size) {
      if (!a.holds(x[0], x[1]) || !b.holds(x[2], x[3])) return std::nullopt;
      const gp_Vec na = au.Crossed(av), nb = bu.Crossed(bv);
      const double product = na.Magnitude() * nb.Magnitude();
      return OraclePoint{p, product > 0 ? na.Crossed(nb).Magnitude() / product : 0};
    }
    // In parameters scaled by the ranges: J J^T y = gap, step J^T y.
    const std::array columns{au * (a.high[0] - a.low[0]), av * (a.high[1] - a.low[1]),
                             bu * (b.low[0] - b.high[0]), bv * (b.low[1] - b.high[1])};
    std::array<std::array<double, 4>, 3> m{};
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c)
        for (const gp_Vec& column : columns)
          m[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] +=
              column.Coord(r + 1) * column.Coord(c + 1);
      m[static_cast<std::size_t>(r)][3] = gap.Coord(r + 1);
    }
    const auto det = [&](std::size_t c0, std::size_t c1, std::size_t c2) {
      return m[0][c0] * (m[1][c1] * m[2][c2] - m[1][c2] * m[2][c1]) -
             m[0][c1] * (m[1][c0] * m[2][c2] - m[1][c2] * m[2][c0]) +
             m[0][c2] * (m[1][c0] * m[2][c1] - m[1][c1] * m[2][c0]);
    };
    const double whole = det(0, 1, 2);
    if (whole == 0) return std::nullopt;
    const gp_Vec y(det(3, 1, 2) / whole, det(0, 3, 2) / whole, det(0, 1, 3) / whole);
    const std::array ranges{a.high[0] - a.low[0], a.high[1] - a.low[1], b.high[0] - b.low[0],
                            b.high[1] - b.low[1]};
    for (std::size_t k = 0; k < 4; ++k) x[k] += columns[k].Dot(y) * ranges[k];
    for (std::size_t k = 0; k < 4; ++k) {
      const Grid& grid = k < 2 ? a : b;
      const double slack = 0.1 * ranges[k];
      if (!(x[k] >= grid.low[k % 2] - slack && x[k] <= grid.high[k % 2] + slack))
        return std::nullopt;
      x[k] = std::clamp(x[k], grid.low[k % 2], grid.high[k % 2]);
    }
  }
  return std::nullopt;
}

struct Part {
  int i0 = 0, i1 = kGrid, j0 = 0, j1 = kGrid;
  bool single() const { return i1 - i0 == 1 && j1 - j0 == 1; }
  std::array<Part, 2> halves() const {
    Part low = *this, high = *this;
    if (i1 - i0 >= j1 - j0)
      low.i1 = high.i0 = (i0 + i1) / 2;
    else
      low.j1 = high.j0 = (j0 + j1) / 2;
    return {low, high};
  }
};

class Pairing {
 public:
  Pairing(const Grid& a, const Grid& b, double size) : a_(a), b_(b), size_(size) {}

  void pair(const Part& p, const Part& q) {
    if (a_.box(p.i0, p.i1, p.j0, p.j1).IsOut(b_.box(q.i0, q.i1, q.j0, q.j1))) return;
    if (p.single() && q.single()) return add(p, q);
    const bool halve_a =
        !p.single() && (q.single() || p.i1 - p.i0 + p.j1 - p.j0 >= q.i1 - q.i0 + q.j1 - q.j0);
    for (const Part& half : (halve_a ? p : q).halves()) halve_a ? pair(half, q) : pair(p, half);
  }

  std::vector<OraclePoint> points;

 private:
  void add(const Part& p, const Part& q) {
    const auto found = refined(a_, b_,
                               {a_.parameter(0, p.i0 + 0.5), a_.parameter(1, p.j0 + 0.5),
                                b_.parameter(0, q.i0 + 0.5), b_.parameter(1, q.j0 + 0.5)},
                               size_);
    if (!found) return;
    for (const OraclePoint& known : points)
      if (known.point.Distance(found->point) < kThin * size_) return;
    points.push_back(*found);
  }

  const Grid& a_;
  const Grid& b_;
  const double size_;
};

}  // namespace

std::vector<OraclePoint> common_points(const TopoDS_Face& a, const TopoDS_Face& b, double size) {
  const Grid grid_a(a), grid_b(b);
  Pairing pairing(grid_a, grid_b, size);
  pairing.pair({}, {});
  return pairing.points;
}

double size_of(const TopoDS_Face& face) {
  const Grid grid(face);
  Bnd_Box box;
  for (const auto& row : grid.points)
    for (const gp_Pnt& p : row) box.Add(p);
  return std::sqrt(box.SquareExtent());
}

}  // namespace blossom::bench
