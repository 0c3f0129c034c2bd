// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/border_gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <BndLib_Add3dCurve.hxx>
#include <Bnd_Box.hxx>
#include <Extrema_ExtPC.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "core/base/disjoint_sets.h"
#include "core/base/unbounded.h"
#include "core/bounds/box_tree.h"

namespace blossom::occt {
namespace {

constexpr double kWidest = 0.01;  // of the shortest border
// Places along a border's parameter range. At its ends the next edges of its own face are near.
// Approximated curves swing about each other some times in each of their spans.
constexpr int kInner = 15;
constexpr double kFirst = 0.1, kLast = 0.9;
constexpr std::array kEnds = {0., 1.};

/// A border with its curve.
struct LooseCurve {
  std::size_t face = 0;
  std::unique_ptr<BRepAdaptor_Curve> curve;
  std::unique_ptr<Extrema_ExtPC> feet;
  double length = 0;
  double tolerance = 0;
  Box box;  // with the tolerance

  double first() const { return curve->FirstParameter(); }
  double last() const { return curve->LastParameter(); }
  gp_Pnt at(double share) const { return curve->Value(first() + share * (last() - first())); }

  double distance(const gp_Pnt& point) const {
    double least = std::min(point.Distance(at(0)), point.Distance(at(1)));
    feet->Perform(point);
    for (int i = 1; feet->IsDone() && i <= feet->NbExt(); ++i)
      least = std::min(least, std::sqrt(feet->SquareDistance(i)));
    return least;
  }
};

LooseCurve curve_of(const TopoDS_Edge& edge, const TopoDS_Face& face, std::size_t number) {
  LooseCurve border;
  border.face = number;
  const bool in_space = BRep_Tool::IsGeometric(edge) && [&] {
    double first = 0, last = 0;
    return !BRep_Tool::Curve(edge, first, last).IsNull();
  }();
  border.curve = in_space ? std::make_unique<BRepAdaptor_Curve>(edge)
                          : std::make_unique<BRepAdaptor_Curve>(edge, face);
  border.length = curve_length(*border.curve, {border.first(), border.last()});
  border.tolerance = BRep_Tool::Tolerance(edge);
  border.feet = std::make_unique<Extrema_ExtPC>();
  border.feet->Initialize(*border.curve, border.first(), border.last());
  Bnd_Box box;
  BndLib_Add3dCurve::Add(*border.curve, 0, box);
  border.box = widened({vec(box.CornerMin()), vec(box.CornerMax())}, border.tolerance);
  return border;
}

/// The edges that are used once, with their faces' places. Faces that share others are joined.
std::vector<std::pair<TopoDS_Edge, std::size_t>> edges_used_once(
    const std::vector<TopoDS_Face>& faces, DisjointSets& bodies) {
  TopTools_IndexedMapOfShape edges;
  std::vector<std::size_t> uses, users;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (TopExp_Explorer it(faces[i].Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
      const TopAbs_Orientation turned = it.Current().Orientation();
      if (turned != TopAbs_FORWARD && turned != TopAbs_REVERSED) continue;
      if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) continue;
      const auto number = static_cast<std::size_t>(edges.Add(it.Current())) - 1;
      uses.resize(std::max(uses.size(), number + 1));
      users.resize(uses.size());
      if (uses[number]++ > 0) bodies.join(i, users[number]);
      users[number] = i;
    }
  std::vector<std::pair<TopoDS_Edge, std::size_t>> found;
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (uses[i] == 1) found.emplace_back(TopoDS::Edge(edges(static_cast<int>(i) + 1)), users[i]);
  return found;
}

double bound_of(const std::vector<LooseCurve>& curves) {
  double shortest = kInfinity;
  for (const LooseCurve& curve : curves)
    if (curve.length > 2 * curve.tolerance) shortest = std::min(shortest, curve.length);
  return std::isinf(shortest) ? 0 : kWidest * shortest;
}

class Measuring {
 public:
  Measuring(const std::vector<LooseCurve>& curves, std::optional<double> within)
      : curves_(curves),
        tree_(boxes_of(curves)),
        within_(within.value_or(bound_of(curves))),
        by_tolerances_(!within) {}

  /// bodies   the face on the other side is joined with the border's own
  std::optional<double> gap_of(std::size_t border, DisjointSets& bodies) const {
    const LooseCurve& own = curves_[border];
    double widest = 0;
    for (int i = 0; i < kInner; ++i) {
      const double share = kFirst + (kLast - kFirst) * i / (kInner - 1);
      const std::vector<Near> near =
          all_near(own, share, [&](std::size_t other) { return other != border; });
      if (near.empty()) return std::nullopt;
      widest = std::max(widest, near.front().gap);
      bodies.join(own.face, other_side(own, near));
    }
    // A border that ends where another one goes on is near to it there, too.
    for (const double share : kEnds) {
      const std::vector<Near> near =
          all_near(own, share, [&](std::size_t other) { return curves_[other].face != own.face; });
      if (!near.empty()) widest = std::max(widest, near.front().gap);
    }
    return widest;
  }

 private:
  struct Near {
    double gap = 0;
    std::size_t border = 0;
  };

  static std::vector<Box> boxes_of(const std::vector<LooseCurve>& curves) {
    std::vector<Box> boxes;
    for (const LooseCurve& curve : curves) boxes.push_back(curve.box);
    return boxes;
  }

  /// Borders within the bound, the nearest first.
  template <class Taken>
  std::vector<Near> all_near(const LooseCurve& own, double share, const Taken& taken) const {
    std::vector<Near> near;
    const gp_Pnt point = own.at(share);
    const double reach = std::max(within_, by_tolerances_ ? own.tolerance : 0);
    tree_.for_each_near(vec(point), reach * reach, [&](int item) {
      const auto other = static_cast<std::size_t>(item);
      if (taken(other))
        if (const double gap = curves_[other].distance(point); gap <= bound(own, curves_[other]))
          near.push_back({gap, other});
      return reach * reach;
    });
    std::ranges::sort(near, {}, &Near::gap);
    return near;
  }

  double bound(const LooseCurve& a, const LooseCurve& b) const {
    return std::max(within_, by_tolerances_ ? a.tolerance + b.tolerance : 0);
  }

  /// Where bodies touch, several borders are as near as the nearest one. Files have the faces of a
  /// body one after the other: of all in order, the first two belong together, and so on.
  std::size_t other_side(const LooseCurve& own, const std::vector<Near>& near) const {
    const double bound = joined_within(near.front().gap);
    std::vector<std::size_t> faces{own.face};
    for (const Near& each : near)
      if (each.gap <= bound) faces.push_back(curves_[each.border].face);
    std::ranges::sort(faces);
    const std::size_t place =
        static_cast<std::size_t>(std::ranges::find(faces, own.face) - faces.begin()) ^ 1;
    return place < faces.size() ? faces[place] : curves_[near.front().border].face;
  }

  const std::vector<LooseCurve>& curves_;
  BoxTree tree_;
  double within_;
  bool by_tolerances_;
};

std::vector<LooseBody> bodies_of(DisjointSets& bodies, const std::vector<LooseCurve>& curves,
                                 const std::vector<LooseBorder>& borders) {
  std::map<std::size_t, LooseBody> found;
  for (std::size_t i = 0; i < bodies.size(); ++i) found[bodies.find(i)].faces.push_back(i);
  for (std::size_t i = 0; i < borders.size(); ++i) {
    double& widest = found[bodies.find(curves[i].face)].widest;
    widest = std::max(widest, borders[i].gap.value_or(0));
  }
  std::vector<LooseBody> all;
  for (auto& [known_by, body] : found) all.push_back(std::move(body));
  return all;
}

}  // namespace

double joined_within(double gap) { return 2 * gap + Precision::Confusion(); }

std::size_t BorderGaps::open() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(borders, [](const LooseBorder& border) { return !border.gap; }));
}

BorderGaps border_gaps(const std::vector<TopoDS_Face>& faces, std::optional<double> within,
                       const std::function<void()>& stop) {
  BorderGaps found;
  DisjointSets bodies(faces.size());
  std::vector<LooseCurve> curves;
  for (const auto& [edge, face] : edges_used_once(faces, bodies)) {
    if (stop) stop();
    curves.push_back(curve_of(edge, faces[face], face));
    found.borders.push_back({edge, vec(curves.back().at(0.5)), std::nullopt});
  }
  const Measuring measuring(curves, within);
  for (std::size_t i = 0; i < found.borders.size(); ++i) {
    if (stop) stop();
    found.borders[i].gap = measuring.gap_of(i, bodies);
  }
  found.bodies = bodies_of(bodies, curves, found.borders);
  return found;
}

}  // namespace blossom::occt
