// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/fuzz/support/forms.h"

#include <utility>

namespace blossom::fuzz {
namespace {

constexpr int kMaxDrawnSpans = 3, kMaxDrawnDegree = 5;

/// How coordinates and weights are made.
struct Scale {
  int kind = 0;
  double size = 1;
  Vec3 origin{};
  bool rational = false;
};

Scale scale_of(Choices& choices) {
  Scale scale;
  scale.kind = choices.within(0, 5);
  scale.rational = choices.is_so();
  if (choices.within(0, 3) == 3) scale.size = choices.magnitude(-12, 12);
  if (choices.within(0, 7) == 7) scale.origin[0] = choices.magnitude(0, 12);
  return scale;
}

double height(const Scale& scale, Choices& choices) {
  switch (scale.kind) {
    case 0: return 0.5 * choices.within(-2, 2);
    case 1: return choices.within(0, 7) == 7 ? choices.any() : choices.within(-1, 1);
    case 2: return choices.within(-1, 1) * choices.magnitude(-16, 0);
    default: return choices.between(-1, 1);
  }
}

// Near the place of a regular net, or anywhere.
Vec4 point_of(const Scale& scale, double x, double y, Choices& choices) {
  Vec3 p{x, y, height(scale, choices)};
  if (scale.kind == 4) p += Vec3{choices.between(-0.5, 0.5), choices.between(-0.5, 0.5), 0};
  if (scale.kind == 5) p[0] = height(scale, choices), p[1] = height(scale, choices);
  if (scale.kind == 1 && choices.within(0, 3) == 3) p[0] = 0;
  p = scale.origin + p * scale.size;
  double w = 1;
  if (scale.rational)
    w = choices.within(0, 7) == 7 ? choices.magnitude(-9, 9) : choices.between(0.25, 4);
  return {w * p[0], w * p[1], w * p[2], w};
}

std::vector<double> knots_of(int spans, Choices& choices) {
  std::vector<double> knots{0};
  for (int i = 0; i < spans; ++i)
    knots.push_back(knots.back() + (choices.within(0, 7) == 7 ? choices.magnitude(-12, 6) : 1));
  return knots;
}

// Neighbours have their common border from the one that comes first.
void join_borders(Grid<RationalBezierPatch>& patches) {
  for (int i = 0; i < patches.rows(); ++i)
    for (int j = 0; j < patches.columns(); ++j) {
      Grid<Vec4>& points = patches(i, j).points;
      for (int l = 0; i > 0 && l < points.columns(); ++l) {
        const Grid<Vec4>& before = patches(i - 1, j).points;
        points(0, l) = before(before.rows() - 1, l);
      }
      for (int k = 0; j > 0 && k < points.rows(); ++k) {
        const Grid<Vec4>& before = patches(i, j - 1).points;
        points(k, 0) = before(k, before.columns() - 1);
      }
    }
}

template <class Use>
void each_point(BezierSurface& surface, const Use& use) {
  for (RationalBezierPatch& patch : surface.patches.values())
    for (Vec4& point : patch.points.values()) use(point);
}

template <class Use>
void each_point(CurveSpans& curve, const Use& use) {
  for (CurveSpan& span : curve.spans)
    for (Vec4& point : span.curve.points) use(point);
}

void swap_axes(Vec4& p, int turn) {
  if (turn == 1) std::swap(p[1], p[2]);
  if (turn == 2) std::swap(p[0], p[2]);
  if (turn == 3) p[2] = -p[2];
}

// A copy that is moved, turned or changed a little; the small steps are those of tolerances.
template <class Form>
Form beside(Form form, Choices& choices) {
  const int turn = choices.within(0, 3);
  const int change = choices.within(0, 3);
  const double step = choices.magnitude(-15, 0);
  const Vec3 way{0.5 * choices.within(-2, 2), 0.5 * choices.within(-2, 2),
                 0.5 * choices.within(-2, 2)};
  each_point(form, [&](Vec4& p) {
    swap_axes(p, turn);
    if (change == 1) p = p + Vec4{p[3] * way[0], p[3] * way[1], p[3] * way[2], 0};
    if (change == 2) p[2] += p[3] * step;
    if (change == 3) p[2] += p[3] * step * choices.within(-1, 1);
  });
  return form;
}

}  // namespace

BezierSurface surface_of(Choices& choices) {
  const Scale scale = scale_of(choices);
  const int rows = choices.within(1, kMaxDrawnSpans), columns = choices.within(1, kMaxDrawnSpans);
  const int n = choices.within(1, kMaxDrawnDegree), m = choices.within(1, kMaxDrawnDegree);
  BezierSurface surface;
  surface.u_knots = knots_of(rows, choices);
  surface.v_knots = knots_of(columns, choices);
  surface.patches = Grid<RationalBezierPatch>(rows, columns);
  surface.rational = scale.rational;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      Grid<Vec4>& points = surface.patches(i, j).points;
      points = Grid<Vec4>(n + 1, m + 1);
      for (int k = 0; k <= n; ++k)
        for (int l = 0; l <= m; ++l)
          points(k, l) = point_of(scale, i + double(k) / n, j + double(l) / m, choices);
    }
  if (choices.within(0, 7) != 7) join_borders(surface.patches);
  return surface;
}

CurveSpans curve_of(Choices& choices) {
  const Scale scale = scale_of(choices);
  const int spans = choices.within(1, kMaxDrawnSpans), n = choices.within(1, kMaxDrawnDegree);
  const std::vector<double> knots = knots_of(spans, choices);
  CurveSpans curve;
  curve.rational = scale.rational;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    CurveSpan span;
    span.place = {knots[i], knots[i + 1]};
    for (int k = 0; k <= n; ++k)
      span.curve.points.push_back(
          point_of(scale, static_cast<double>(i) + double(k) / n, 0, choices));
    if (i > 0) span.curve.points.front() = curve.spans.back().curve.points.back();
    curve.spans.push_back(std::move(span));
  }
  return curve;
}

BezierSurface surface_beside(const BezierSurface& first, Choices& choices) {
  return choices.is_so() ? beside(first, choices) : surface_of(choices);
}

CurveSpans curve_beside(const CurveSpans& first, Choices& choices) {
  return choices.is_so() ? beside(first, choices) : curve_of(choices);
}

CurveSpans curve_near(const BezierSurface& surface, Choices& choices) {
  if (choices.is_so()) return curve_of(choices);
  const Grid<Vec4>& points = surface.patches(0, 0).points;
  const int row = choices.within(0, points.rows() - 1);
  RationalBezierCurve curve;
  for (int l = 0; l < points.columns(); ++l) curve.points.push_back(points(row, l));
  CurveSpans spans = curve_spans(std::move(curve));
  spans.rational = surface.rational;
  return beside(std::move(spans), choices);
}

IntersectionOptions options_of(Choices& choices) {
  IntersectionOptions options;
  options.budget = 4000;
  options.time_limit = 0.5;  // seconds
  options.threads = 1;
  if (choices.within(0, 7) == 7) options.tolerances.point = choices.magnitude(-12, 0);
  const int form = choices.within(0, 2);
  options.form = form == 1 ? CellForm::Monomial : form == 2 ? CellForm::Bezier : CellForm::Auto;
  return options;
}

}  // namespace blossom::fuzz
