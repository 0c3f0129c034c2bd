// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/coincidence/chart_sheet.h"

#include <array>
#include <cmath>

#include <Geom_Surface.hxx>

namespace blossom::occt {
namespace {

constexpr double kRounding = 1e-12;  // of a parameter: so near a seam it is on it

}  // namespace

ChartSheet sheet_of(const SurfaceProjector& feet, const BezierSurface& surface) {
  ChartSheet sheet{feet,
                   {0.5 * (surface.u_knots.front() + surface.u_knots.back()),
                    0.5 * (surface.v_knots.front() + surface.v_knots.back())},
                   feet.turns(),
                   false};
  Vec2 low, high;
  feet.surface()->Bounds(low[0], high[0], low[1], high[1]);
  const std::array periodic{feet.surface()->IsUPeriodic(), feet.surface()->IsVPeriodic()};
  for (int d = 0; d < 2; ++d) {
    if (sheet.period[d] == 0 || periodic[static_cast<std::size_t>(d)]) continue;
    sheet.middle[d] = 0.5 * (low[d] + high[d]);
    sheet.leaps = true;
  }
  return sheet;
}

Vec2 in_sheet(const ChartSheet& sheet, Vec2 uv) {
  for (int d = 0; d < 2; ++d)
    if (sheet.period[d] > 0)
      uv[d] -= sheet.period[d] * std::round((uv[d] - sheet.middle[d]) / sheet.period[d]);
  return uv;
}

Vec2 on_seam(const ChartSheet& sheet, Vec2 uv) {
  for (int d = 0; d < 2; ++d)
    for (const double side : {-0.5, 0.5}) {
      const double seam = sheet.middle[d] + side * sheet.period[d];
      if (sheet.period[d] > 0 && std::abs(uv[d] - seam) <= kRounding * sheet.period[d])
        uv[d] = seam;
    }
  return uv;
}

}  // namespace blossom::occt
