// SPDX-License-Identifier: LGPL-2.1-or-later
// The enclosures of several cells as one for a facet over all of them.
//
// Along a segment the error of a chord is the integral of |S''| times at most a quarter of the
// segment's length. A strip of width w with second derivatives that are larger than elsewhere by E
// adds so much as a jump of the first derivative by w E would; its largest value over the whole
// facet would add more by the ratio of widths. Knots are bunched where a surface turns within
// little, and this is what makes such places harmless.
//
// In a strip that is narrow in u, S_u changes by w E_uu across it and back, and S_v by w E_uv; a
// segment gets 2 w E_uv from the mixed derivative. Twice w E covers both.

#pragma once

#include <algorithm>

#include "core/tessellation/charts/jet_enclosure.h"

namespace blossom {

/// Of the facet's extent L: strips that are narrower count by their width. Counted by it, a strip
/// adds at most 2 w E L / 4 for its own derivative and as much for the mixed one; counted with the
/// others, E L^2 / 8. The former is less where w is below L / 8.
inline constexpr double kNarrowStrip = 1.0 / 8;

/// By coordinate, how far one range goes beyond another.
inline Vec3 excess(const VectorRange& range, const VectorRange& of) {
  const Vec3 far = absolute(range.centre - of.centre) + range.radius - of.radius;
  return {std::max(far[0], 0.0), std::max(far[1], 0.0), std::max(far[2], 0.0)};
}

/// rows, columns       of the cells, at least one each
/// jet_of(i, j)        the enclosure of a cell
/// u_width(i), v_width(j)   how much of the facet's extent is in it
template <class JetOf, class UWidth, class VWidth>
JetEnclosure joined_jet(int rows, int columns, JetOf jet_of, UWidth u_width, VWidth v_width) {
  const auto limit = [](int count, auto width) {  // below it strips are narrow
    double sum = 0, widest = 0;
    for (int k = 0; k < count; ++k) sum += width(k), widest = std::max(widest, width(k));
    return widest >= kNarrowStrip * sum ? kNarrowStrip * sum : 0.0;
  };
  const double u_limit = limit(rows, u_width), v_limit = limit(columns, v_width);
  JetEnclosure whole = jet_of(0, 0);
  bool has_uu = false, has_uv = false, has_vv = false;
  const auto take = [](bool& has, VectorRange& all, const VectorRange& range) {
    all = has ? united(all, range) : range;
    has = true;
  };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const JetEnclosure& jet = jet_of(i, j);
      const bool wide_u = u_width(i) >= u_limit, wide_v = v_width(j) >= v_limit;
      if (wide_u) take(has_uu, whole.uu, jet.uu);
      if (wide_v) take(has_vv, whole.vv, jet.vv);
      if (wide_u && wide_v) take(has_uv, whole.uv, jet.uv);
      whole.length_u = std::max(whole.length_u, jet.length_u);
      whole.length_v = std::max(whole.length_v, jet.length_v);
      whole.jacobian = std::min(whole.jacobian, jet.jacobian);
    }
  const auto add_strip = [](double width, const Vec3& own, const Vec3& mixed, Vec3& jump,
                            Vec3& other) {
    jump += 2 * width * own;
    other += 2 * width * mixed;
  };
  const auto raise = [](Vec3& most, const Vec3& value) {
    for (int k = 0; k < 3; ++k) most[k] = std::max(most[k], value[k]);
  };
  for (int i = 0; i < rows; ++i) {
    if (u_width(i) >= u_limit) continue;
    Vec3 own, mixed;
    for (int j = 0; j < columns; ++j) {
      raise(own, excess(jet_of(i, j).uu, whole.uu));
      raise(mixed, excess(jet_of(i, j).uv, whole.uv));
    }
    add_strip(u_width(i), own, mixed, whole.jump_u, whole.jump_v);
  }
  for (int j = 0; j < columns; ++j) {
    if (v_width(j) >= v_limit) continue;
    Vec3 own, mixed;
    for (int i = 0; i < rows; ++i) {
      raise(own, excess(jet_of(i, j).vv, whole.vv));
      raise(mixed, excess(jet_of(i, j).uv, whole.uv));
    }
    add_strip(v_width(j), own, mixed, whole.jump_v, whole.jump_u);
  }
  return whole;
}

}  // namespace blossom
