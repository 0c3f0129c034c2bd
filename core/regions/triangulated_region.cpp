// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/triangulated_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "core/base/errors.h"
#include "core/blossom/triangle_composition.h"
#include "core/math/index.h"
#include "core/plane/loops.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/subdivision/triangle_subdivision.h"

namespace blossom {
namespace {

constexpr int kTouchHalvings = 5;  // of an arc, to see which cells it meets
// Of areas in grid coordinates: the quadrature along rational arcs.
constexpr double kAreaError = 1e-8;
constexpr double kBesideCell = 1.0 / 16;  // of a cell: no trim is nearer to one that stays whole
constexpr int kFewSpans = 3;  // up to here spans are cut into cells, or none would lie inside

int cells_for(const BezierSurface& surface, int wanted) {
  if (wanted > 0) return wanted;
  const int spans = std::max(surface.patches.rows(), surface.patches.columns());
  return spans == 1 ? 4 : spans <= kFewSpans ? 2 : 1;
}

void check(const BezierSurface& surface, const TrimmedChart& chart, const RegionOptions& options) {
  validate(surface, "trimmed region");
  const int count = static_cast<int>(chart.corners.size());
  for (const RegionBorder& border : chart.borders) {
    if (border.curve.spans.empty()) throw InvalidInput("trimmed region: a border has no curve");
    if (std::min(border.from, border.to) < 0 || std::max(border.from, border.to) >= count)
      throw InvalidInput("trimmed region: a border ends at no corner");
  }
  if (!(options.tolerance > 0) || options.cells < 0 || (options.cells & (options.cells - 1)) != 0)
    throw InvalidInput("trimmed region: the tolerance must be positive, cells a power of two");
}

class Builder {
 public:
  Builder(const BezierSurface& surface, const TrimmedChart& chart, const RegionOptions& options,
          TriangleLowering& lowering)
      : surface_(surface),
        options_(options),
        cells_(cells_for(surface, options.cells)),
        borders_(surface, chart, options, cells_),
        lowering_(lowering),
        arcs_in_(surface.patches.rows(), surface.patches.columns()),
        sides_in_(surface.patches.rows(), surface.patches.columns()) {
    result_.stops.resize(chart.borders.size());
    for (const RegionArc& arc : borders_.arcs()) add_curve(arc);
  }

  TriangulatedRegion built() {
    for (std::size_t i = 0; i < borders_.arcs().size(); ++i) {
      const RegionArc& arc = borders_.arcs()[i];
      arcs_in_(arc.patch_u, arc.patch_v).push_back(static_cast<int>(i));
    }
    for (const int direction : {0, 1}) add_line_sides(direction);
    add_whole_cells();
    for (int i = 0; i < surface_.patches.rows() && result_.obstacle.empty(); ++i)
      for (int j = 0; j < surface_.patches.columns() && result_.obstacle.empty(); ++j)
        add_triangles(i, j);
    finish();
    return std::move(result_);
  }

 private:
  // ---- which points lie inside

  struct PlacedCurve {
    PlanarPath path;  // grid coordinates
    PlanarBox box;
  };

  void add_curve(const RegionArc& arc) {
    PlanarBezier curve = arc.curve;
    for (Vec3& p : curve.points)
      p += p[2] * Vec3{static_cast<double>(arc.patch_u), static_cast<double>(arc.patch_v), 0};
    const PlanarBox box = box_of(curve.points);
    curves_.push_back({{std::move(curve)}, box});
  }

  bool is_inside(const Vec2& point) const {
    int winding = 0;
    for (const PlacedCurve& curve : curves_)
      if (curve.box.low[1] <= point[1] && point[1] <= curve.box.high[1] &&
          point[0] <= curve.box.high[0])
        winding += ray_crossings(curve.path, point);
    return winding > 0;
  }

  // ---- sides along the lines between patches

  // Stretches of a line that borders take, by their other coordinate.
  std::vector<Interval> taken(int direction, double line) const {
    std::vector<Interval> result;
    for (const RegionArc& arc : borders_.arcs()) {
      const Vec2& from = borders_.vertices()[index(arc.from)];
      const Vec2& to = borders_.vertices()[index(arc.to)];
      if (arc.across != direction || from[direction] != line) continue;
      const int along = 1 - direction;
      result.push_back({std::min(from[along], to[along]), std::max(from[along], to[along])});
    }
    return result;
  }

  std::set<double> stops_on(int direction, double line) const {
    std::set<double> stops;
    const int along = 1 - direction;
    const int spans = along == 0 ? surface_.patches.rows() : surface_.patches.columns();
    for (int k = 0; k <= spans * cells_; ++k) stops.insert(static_cast<double>(k) / cells_);
    for (const Vec2& vertex : borders_.vertices())
      if (vertex[direction] == line) stops.insert(vertex[along]);
    return stops;
  }

  void add_line_sides(int direction) {
    const int along = 1 - direction;
    const int lines = direction == 0 ? surface_.patches.rows() : surface_.patches.columns();
    for (int line = 1; line < lines; ++line) {
      const std::vector<Interval> borders = taken(direction, line);
      const std::set<double> stops = stops_on(direction, line);
      for (auto low = stops.begin(), high = std::next(low); high != stops.end(); ++low, ++high) {
        const double middle = 0.5 * (*low + *high);
        const bool is_border = std::ranges::any_of(
            borders, [&](const Interval& b) { return b.from <= middle && middle <= b.to; });
        Vec2 at;
        at[direction] = line;
        at[along] = middle;
        if (is_border || !is_inside(at)) continue;
        add_side(direction, line, {*low, *high});
      }
    }
  }

  // One side for both patches, each of which has the region on its left.
  void add_side(int direction, int line, const Interval& place) {
    const int along = 1 - direction;
    Vec2 from, to;
    from[direction] = to[direction] = line;
    from[along] = place.from;
    to[along] = place.to;
    const BorderSide up{borders_.vertex_at(from), borders_.vertex_at(to)};
    const BorderSide down{up.to, up.from};
    // Trims may reach a little beyond the outermost patches.
    const int spans = along == 0 ? surface_.patches.rows() : surface_.patches.columns();
    const int span =
        std::clamp(static_cast<int>(std::floor(0.5 * (place.from + place.to))), 0, spans - 1);
    if (direction == 0) {  // going up, patch line - 1 is on the left
      sides_in_(line - 1, span).push_back(up);
      sides_in_(line, span).push_back(down);
    } else {
      sides_in_(span, line).push_back(up);
      sides_in_(span, line - 1).push_back(down);
    }
  }

  // ---- whole cells

  Grid<char> touched_cells() const {
    Grid<char> touched(surface_.patches.rows() * cells_, surface_.patches.columns() * cells_, 0);
    for (std::size_t i = 0; i < curves_.size(); ++i)
      if (!is_side_of_cell(borders_.arcs()[i]))
        touch(touched, curves_[i].path.front(), kTouchHalvings);
    return touched;
  }

  // Marks all cells, borders included, that the boxes of the curve's pieces meet or pass so near
  // that triangles between them and the curve would be slivers.
  void touch(Grid<char>& touched, const PlanarBezier& curve, int halvings) const {
    const PlanarBox box = box_of(curve.points);
    std::array<int, 2> first, last;
    for (int k = 0; k < 2; ++k) {
      const int count = k == 0 ? touched.rows() : touched.columns();
      const double low = box.low[k] * cells_ - kBesideCell,
                   high = box.high[k] * cells_ + kBesideCell;
      first[index(k)] = std::max(static_cast<int>(std::ceil(low)) - 1, 0);
      last[index(k)] = std::min(static_cast<int>(std::floor(high)), count - 1);
    }
    if (halvings > 0 && (first[0] < last[0] || first[1] < last[1])) {
      touch(touched, bezier_piece(curve, {0, 0.5}), halvings - 1);
      touch(touched, bezier_piece(curve, {0.5, 1}), halvings - 1);
      return;
    }
    for (int a = first[0]; a <= last[0]; ++a)
      for (int b = first[1]; b <= last[1]; ++b) touched(a, b) = 1;
  }

  // Whether an arc is exactly one side of a cell.
  bool is_side_of_cell(const RegionArc& arc) const {
    if (arc.across < 0 || !borders_.takes_cells(arc.border)) return false;
    const Vec2& from = borders_.vertices()[index(arc.from)];
    const Vec2& to = borders_.vertices()[index(arc.to)];
    for (int k = 0; k < 2; ++k)
      if (from[k] * cells_ != std::floor(from[k] * cells_)) return false;
    return std::abs(norm(to - from) * cells_ - 1) < 0.5 && arc.curve.degree() == 1;
  }

  void add_whole_cells() {
    const Grid<char> touched = touched_cells();
    const double size = 1.0 / cells_;
    for (int a = 0; a < touched.rows(); ++a)
      for (int b = 0; b < touched.columns(); ++b)
        if (!touched(a, b) && is_inside({(a + 0.5) * size, (b + 0.5) * size})) add_cell(a, b);
  }

  void add_cell(int a, int b) {
    const double size = 1.0 / cells_;
    RegionPiece piece{a / cells_, b / cells_, {}, true, 0};
    const Interval u{(a % cells_) * size, (a % cells_ + 1) * size};
    const Interval v{(b % cells_) * size, (b % cells_ + 1) * size};
    RegionCell cell{u, v, {}};
    const Vec2 low{a * size, b * size}, high{(a + 1) * size, (b + 1) * size};
    cell.vertices = {borders_.vertex_at(low), borders_.vertex_at({high[0], low[1]}),
                     borders_.vertex_at(high), borders_.vertex_at({low[0], high[1]})};
    for (std::size_t k = 0; k < 4; ++k)
      sides_in_(piece.patch_u, piece.patch_v)
          .push_back({cell.vertices[(k + 1) % 4], cell.vertices[k]});
    piece.shape = cell;
    result_.pieces.push_back(std::move(piece));
  }

  // ---- triangles

  // What the whole cells of a patch leave: sides that two of them share go, and so do arcs that
  // are sides of cells.
  void add_triangles(int i, int j) {
    std::map<std::pair<int, int>, int> count;
    for (const BorderSide& side : sides_in_(i, j)) ++count[{side.from, side.to}];
    std::vector<int>& arcs = arcs_in_(i, j);
    std::erase_if(arcs, [&](int number) {
      const RegionArc& arc = borders_.arcs()[index(number)];
      const auto back = count.find({arc.to, arc.from});
      if (!is_side_of_cell(arc) || back == count.end() || back->second == 0) return false;
      --back->second;
      arc_of_cell_[{arc.from, arc.to}] = number;
      return true;
    });
    std::vector<BorderSide> sides;
    for (const auto& [ends, number] : count) {
      const auto back = count.find({ends.second, ends.first});
      const int left = number - (back == count.end() ? 0 : back->second);
      for (int k = 0; k < left; ++k) sides.push_back({ends.first, ends.second});
    }
    CurvedTriangles made = curved_triangles(borders_, arcs, sides, i, j, lowering_);
    result_.obstacle = made.obstacle;
    for (CurvedTriangle& triangle : made.triangles)
      result_.pieces.push_back({i, j, std::move(triangle), true, 0});
  }

  // What the pieces cover against what the arcs enclose, in grid coordinates.
  bool adds_up() const {
    double enclosed = 0, covered = 0;
    for (const RegionArc& arc : borders_.arcs()) {
      const Vec2 corner{static_cast<double>(arc.patch_u), static_cast<double>(arc.patch_v)};
      enclosed += area_along({arc.curve}, -corner);
    }
    for (const RegionPiece& piece : result_.pieces) {
      if (const auto* cell = std::get_if<RegionCell>(&piece.shape)) {
        covered += length(cell->u) * length(cell->v);
        continue;
      }
      const BezierTriangle& map = std::get<CurvedTriangle>(piece.shape).map;
      covered += area_along({side_of(map, 0, 1), side_of(map, 1, 2), side_of(map, 2, 0)},
                            projected(map(0, 0)));
    }
    return std::abs(enclosed - covered) <= kAreaError * (1 + enclosed);
  }

  void finish() {
    if (result_.obstacle.empty() && !adds_up()) result_.obstacle = "its borders enclose no region";
    if (!result_.obstacle.empty()) result_.pieces.clear();
    result_.arcs = borders_.arcs();
    result_.vertices = borders_.vertices();
    result_.beyond_lines = borders_.beyond_lines();
    for (const RegionArc& arc : result_.arcs)
      result_.stops[index(arc.border)].insert(result_.stops[index(arc.border)].end(),
                                              {arc.place.from, arc.place.to});
    for (std::vector<double>& stops : result_.stops) {
      std::ranges::sort(stops);
      stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    }
    for (RegionPiece& piece : result_.pieces) add_errors(piece);
  }

  void add_errors(RegionPiece& piece) const {
    const auto add = [&](int number) {
      if (number < 0) return;
      const RegionArc& arc = result_.arcs[index(number)];
      piece.exact = piece.exact && arc.exact;
      piece.error = std::max(piece.error, arc.error);
    };
    if (const auto* triangle = std::get_if<CurvedTriangle>(&piece.shape)) {
      for (const int number : triangle->arcs) add(number);
      if (!triangle->lowered) return;
      piece.off_surface = triangle->lowered->error;
      piece.exact = false;
      piece.error += piece.off_surface;
      return;
    }
    const auto& vertices = std::get<RegionCell>(piece.shape).vertices;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto arc = arc_of_cell_.find({vertices[k], vertices[(k + 1) % 4]});
      if (arc != arc_of_cell_.end()) add(arc->second);
    }
  }

  const BezierSurface& surface_;
  RegionOptions options_;
  int cells_;
  BorderArcs borders_;
  TriangleLowering& lowering_;
  std::vector<PlacedCurve> curves_;  // of the first arcs, before any is halved
  Grid<std::vector<int>> arcs_in_;
  Grid<std::vector<BorderSide>> sides_in_;
  std::map<std::pair<int, int>, int> arc_of_cell_;  // arcs that are sides of cells, by their ends
  TriangulatedRegion result_;
};

bool is_polynomial(const BezierTriangle& map) {
  return std::ranges::all_of(map.points, [](const Vec3& p) { return p[2] == 1; });
}

}  // namespace

TriangulatedRegion triangulated_region(const BezierSurface& surface, const TrimmedChart& chart,
                                       const RegionOptions& options) {
  TriangleLowering lowering;
  return triangulated_region(surface, chart, options, lowering);
}

TriangulatedRegion triangulated_region(const BezierSurface& surface, const TrimmedChart& chart,
                                       const RegionOptions& options, TriangleLowering& lowering) {
  check(surface, chart, options);
  return Builder(surface, chart, options, lowering).built();
}

RegionForm bezier_form(const BezierSurface& surface, const RegionPiece& piece) {
  const RationalBezierPatch& patch = surface.patches(piece.patch_u, piece.patch_v);
  if (const auto* cell = std::get_if<RegionCell>(&piece.shape)) {
    RationalBezierPatch made = sub_patch(patch, cell->u, cell->v);
    for (Vec4& p : made.points.values())
      if (!surface.rational) p[3] = 1;
    return made;
  }
  const auto& [vertices, arcs, map, lowered] = std::get<CurvedTriangle>(piece.shape);
  RationalBezierTriangle made;
  if (lowered) return lowered->form;
  if (map.degree == 1) {
    const auto corner = [](const Vec3& p) { return Vec2{p[0], p[1]}; };
    made = sub_triangle(patch, {corner(map(1, 0)), corner(map(0, 1)), corner(map(0, 0))});
  } else {
    made = composition(patch, map);
  }
  for (Vec4& p : made.points)
    if (!surface.rational && is_polynomial(map)) p[3] = 1;
  return made;
}

}  // namespace blossom
