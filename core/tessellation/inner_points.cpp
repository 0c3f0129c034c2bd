// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/inner_points.h"

#include <algorithm>
#include <cmath>

#include "core/math/index.h"
#include "core/math/spans.h"

namespace blossom {
namespace {

constexpr int kMaxRows = 20000;
constexpr int kMaxSparse = 10;  // level of rows

int cell_of(const std::vector<double>& ends, double at) {
  return static_cast<int>(span_of(ends, at));
}

// A function that is constant in each cell, integrated from the low end of a range.
class Spread {
 public:
  // value   of a cell, by its number
  Spread(const std::vector<double>& ends, double low, double high, const auto& value) {
    at_.push_back(low);
    sum_.push_back(0);
    for (int k = cell_of(ends, low); k + 1 < static_cast<int>(ends.size()); ++k) {
      const bool last = ends[index(k + 1)] >= high || k + 2 == static_cast<int>(ends.size());
      const double end = last ? high : ends[index(k + 1)];
      if (end > at_.back()) {
        sum_.push_back(sum_.back() + value(k) * (end - at_.back()));
        at_.push_back(end);
      }
      if (last) break;
    }
  }

  double all() const { return sum_.back(); }

  // The place with that share of the integral.
  double place(double share) const {
    const double wanted = share * all();
    const auto above = std::upper_bound(sum_.begin() + 1, sum_.end() - 1, wanted);
    const auto k = static_cast<std::size_t>(above - sum_.begin());
    const double step = sum_[k] - sum_[k - 1];
    const double part = step > 0 ? (wanted - sum_[k - 1]) / step : 0;
    return at_[k - 1] + std::clamp(part, 0.0, 1.0) * (at_[k] - at_[k - 1]);
  }

 private:
  std::vector<double> at_, sum_;
};

// Rows of constant q along p, where (p, q) is (u, v) or, turned, (v, u).
struct Rows {
  const FacetDensity& density;
  bool turned;
  Vec2 low, high;

  const std::vector<double>& p_ends() const { return turned ? density.v_ends : density.u_ends; }
  const std::vector<double>& q_ends() const { return turned ? density.u_ends : density.v_ends; }
  double along_p(int i, int j) const {
    return turned ? density.facets(j, i)[1] : density.facets(i, j)[0];
  }
  double along_q(int i, int j) const {
    return turned ? density.facets(j, i)[0] : density.facets(i, j)[1];
  }
  double low_of(int k) const { return low[turned ? 1 - k : k]; }
  double high_of(int k) const { return high[turned ? 1 - k : k]; }

  double most_in(int j) const {
    double most = 0;
    for (int i = 0; i + 1 < static_cast<int>(p_ends().size()); ++i)
      most = std::max(most, along_q(i, j));
    return most;
  }

  Spread across() const {
    return Spread(q_ends(), low_of(1), high_of(1), [this](int j) { return most_in(j); });
  }

  Spread along(int j) const {
    return Spread(p_ends(), low_of(0), high_of(0), [&](int i) { return along_p(i, j); });
  }

  // Of 2^level rows one is enough at p, in a cell of q where rows are as dense as `most` wants.
  int level(double p, int j, double most) const {
    const double here = along_q(cell_of(p_ends(), p), j);
    int level = 0;
    while (level < kMaxSparse && here * (2 << level) <= most) ++level;
    return level;
  }

  // How many, about; they are nearer than the sides of equilateral triangles are long.
  int count(const Spread& spread) const {
    return static_cast<int>(
        std::ceil(std::min<double>(kMaxRows, spread.all() * 2 / std::sqrt(3.0))));
  }
};

double points_of(const Rows& rows) {
  const Spread across = rows.across();
  const int count = rows.count(across);
  double points = 0;
  for (int k = 1; k < count; ++k)
    points +=
        rows.along(cell_of(rows.q_ends(), across.place(static_cast<double>(k) / count))).all();
  return points;
}

}  // namespace

Vec2 facets_at(const FacetDensity& density, const Vec2& uv) {
  return density.facets(cell_of(density.u_ends, uv[0]), cell_of(density.v_ends, uv[1]));
}

std::vector<Vec2> points_in_rows(const FacetDensity& density, const Vec2& low, const Vec2& high) {
  Rows rows{density, false, low, high};
  const Rows turned{density, true, low, high};
  const bool turn = points_of(turned) < points_of(rows);
  rows.turned = turn;
  const Spread across = rows.across();
  const int count = rows.count(across);
  std::vector<Vec2> points;
  for (int k = 1; k < count; ++k) {
    const double q = across.place(static_cast<double>(k) / count);
    const int cell = cell_of(rows.q_ends(), q);
    const double most = rows.most_in(cell);
    const Spread along = rows.along(cell);
    const int parts = static_cast<int>(std::ceil(along.all()));
    for (int i = 0; i < parts; ++i) {
      const int step = k % 2 == 1 ? i : parts - 1 - i;
      const int level = rows.level(along.place((step + 0.25) / parts), cell, most);
      if (k % (1 << level) != 0) continue;
      const bool shifted = (k >> level) % 2 == 1;
      if (!shifted && step == 0) continue;
      const double p = along.place((step + (shifted ? 0.5 : 0.0)) / parts);
      points.push_back(turn ? Vec2{q, p} : Vec2{p, q});
    }
  }
  return points;
}

}  // namespace blossom
