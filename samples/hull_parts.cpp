// SPDX-License-Identifier: LGPL-2.1-or-later
#include "samples/hull_parts.h"

#include <array>
#include <cmath>

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

namespace blossom::samples {
namespace {

struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger counts;
};

// Clamped knots 0, 1, 2, ... for so many poles.
Knots even_knots(int poles, int degree) {
  const int spans = poles - degree;
  Knots knots{{1, spans + 1}, {1, spans + 1}};
  for (int i = 0; i <= spans; ++i) {
    knots.values(i + 1) = i;
    knots.counts(i + 1) = i == 0 || i == spans ? degree + 1 : 1;
  }
  return knots;
}

Handle(Geom_BSplineSurface) bicubic(const TColgp_Array2OfPnt& poles) {
  const Knots u = even_knots(poles.ColLength(), 3), v = even_knots(poles.RowLength(), 3);
  return new Geom_BSplineSurface(poles, u.values, v.values, u.counts, v.counts, 3, 3);
}

}  // namespace

Handle(Geom_BSplineSurface) hull_skin() {
  // Stations from the transom to the stem.
  struct Station {
    double x, half_beam, keel, sheer, rake;
  };
  constexpr std::array<Station, 9> kStations = {{{0, 1480, -330, 1000, 0},
                                                 {1000, 1640, -430, 1000, 0},
                                                 {2800, 1790, -540, 1010, 0},
                                                 {4600, 1850, -600, 1040, 0},
                                                 {6400, 1820, -610, 1090, 0},
                                                 {8200, 1620, -570, 1160, 60},
                                                 {9800, 1160, -470, 1250, 260},
                                                 {11000, 500, -250, 1350, 620},
                                                 {11600, 110, 60, 1430, 900}}};
  // Around a section, from starboard sheer over the keel to port sheer: shares of the half beam
  // and of the height.
  constexpr std::array<double, 9> kAcross = {-1, -0.98, -0.86, -0.48, 0, 0.48, 0.86, 0.98, 1};
  constexpr std::array<double, 9> kUp = {1, 0.62, 0.2, 0.03, 0, 0.03, 0.2, 0.62, 1};

  TColgp_Array2OfPnt poles(1, 9, 1, 9);
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t j = 0; j < 9; ++j) {
      const Station& s = kStations[i];
      poles(int(i) + 1, int(j) + 1) = gp_Pnt(s.x + s.rake * kUp[j], s.half_beam * kAcross[j],
                                             s.keel + (s.sheer - s.keel) * kUp[j]);
    }
  return bicubic(poles);
}

Handle(Geom_BSplineSurface) deck() {
  TColgp_Array2OfPnt poles(1, 7, 1, 5);
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 5; ++j) {
      const double along = i / 6.0, across = (j - 2) / 2.0;
      const double sheer = 330 * along * along, camber = 110 * (1 - across * across);
      poles(i + 1, j + 1) = gp_Pnt(-150 + 12700 * along, 1950 * across, 660 + sheer + camber);
    }
  return bicubic(poles);
}

Handle(Geom_BSplineSurface) thruster_tunnel() {
  constexpr double kX = 9700, kZ = 60, kReach = 1350;
  constexpr std::array<double, 6> kRadius = {300, 225, 210, 210, 225, 300};
  constexpr std::array<double, 6> kAlong = {-1, -0.75, -0.3, 0.3, 0.75, 1};
  // A circle as four rational arcs of degree 2: corners of a square and the middles of its sides.
  constexpr std::array<std::array<double, 2>, 9> kCircle = {
      {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}}};

  TColgp_Array2OfPnt poles(1, 9, 1, 6);
  TColStd_Array2OfReal weights(1, 9, 1, 6);
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      poles(int(i) + 1, int(j) + 1) = gp_Pnt(kX + kRadius[j] * kCircle[i][0], kReach * kAlong[j],
                                             kZ + kRadius[j] * kCircle[i][1]);
      weights(int(i) + 1, int(j) + 1) = i % 2 == 0 ? 1 : std::sqrt(0.5);
    }
  TColStd_Array1OfReal quarters(1, 5);
  TColStd_Array1OfInteger counts(1, 5);
  for (int k = 1; k <= 5; ++k) {
    quarters(k) = k - 1;
    counts(k) = k == 1 || k == 5 ? 3 : 2;
  }
  const Knots v = even_knots(6, 3);
  return new Geom_BSplineSurface(poles, weights, quarters, v.values, counts, v.counts, 2, 3);
}

}  // namespace blossom::samples
