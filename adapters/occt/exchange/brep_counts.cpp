// SPDX-License-Identifier: LGPL-2.1-or-later
// Counts of BREP files that cannot be. What Open CASCADE cannot make of an entry it takes for none,
// and goes on behind what it has read of it; so does this.

#include <array>
#include <cstddef>
#include <string>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/brep_words.h"

namespace blossom::occt {
namespace {

class Counts {
 public:
  Counts(std::string_view content, std::size_t at, bool binary)
      : words_(content, at, binary),
        binary_(binary),
        has_normals_(content.substr(0, at).find(binary ? "Topology V4" : "Topology V3") !=
                     std::string_view::npos) {}

  void check();

 private:
  void check_size(int count) const;
  bool entry();
  void place();
  void curve(std::size_t dimension);
  void spline_curve(std::size_t dimension);
  void bezier_curve(std::size_t dimension);
  void surface();
  void bezier_surface();
  void spline_surface();
  void polygon();
  void polygon_on_triangles();
  void triangles();

  /// A count, if so many things of so many numbers each can follow.
  std::size_t fit(long count, std::size_t numbers_of_each, std::size_t room,
                  const std::string& what, const std::string& stated = {}) const;
  void skip_grid(long rows, long columns, bool weights);
  void skip_poles(long count, bool weights, std::size_t dimension);
  std::size_t knots(long count) const { return fit(count, 1, words_.room_for_reals(), "knots"); }
  void skip_knots(std::size_t count);

  BrepWords words_;
  const bool binary_;
  const bool has_normals_;
  std::string_view table_;
  int entry_ = 0;
};

void Counts::check() {
  while (!words_.ended()) {
    table_ = words_.word();
    const int count = words_.count();
    check_size(count);
    for (entry_ = 1; entry_ <= count && !words_.ended(); ++entry_)
      if (!entry()) return;
  }
}

/// Of a text the lines tell more, and its shapes may be cut off.
void Counts::check_size(int count) const {
  if (binary_ && !words_.ended() &&
      (count < 0 || static_cast<std::size_t>(count) > words_.room_for_kinds()))
    throw BadModel("is damaged: it cannot have as many entries as its table '" +
                   std::string(table_) + "' says");
}

/// Whether it is of a table with counts.
bool Counts::entry() {
  if (table_ == "Locations")
    place();
  else if (table_ == "Curve2ds")
    curve(2);
  else if (table_ == "Curves")
    curve(3);
  else if (table_ == "Surfaces")
    surface();
  else if (table_ == "Polygon3D")
    polygon();
  else if (table_ == "PolygonOnTriangulations")
    polygon_on_triangles();
  else if (table_ == "Triangulations")
    triangles();
  else
    return false;
  return true;
}

std::size_t Counts::fit(long count, std::size_t numbers_of_each, std::size_t room,
                        const std::string& what, const std::string& stated) const {
  if (count >= 0 && static_cast<std::size_t>(count) <= room / numbers_of_each)
    return static_cast<std::size_t>(count);
  throw BadModel("is damaged: entry " + std::to_string(entry_) + " of its table '" +
                 std::string(table_) + "' cannot have the " +
                 (stated.empty() ? std::to_string(count) : stated) + " " + what + " that it says");
}

void Counts::place() {
  constexpr int kMatrix = 1;  // 2 is a product of powers of others: pairs up to a 0
  if (words_.kind() == kMatrix) return words_.skip_reals(12);
  while (!words_.ended() && words_.integer() != 0) words_.skip_integers(1);
}

void Counts::skip_poles(long count, bool weights, std::size_t dimension) {
  const std::size_t each = dimension + (weights ? 1 : 0);
  words_.skip_reals(each * fit(count, each, words_.room_for_reals(), "control points"));
}

void Counts::skip_grid(long rows, long columns, bool weights) {
  const std::string stated = std::to_string(rows) + " x " + std::to_string(columns);
  const std::size_t each = weights ? 4 : 3, room = words_.room_for_reals();
  for (const long count : {rows, columns, rows * columns})
    fit(count, each, room, "control points", stated);
  words_.skip_reals(each * static_cast<std::size_t>(rows * columns));
}

void Counts::skip_knots(std::size_t count) {
  for (std::size_t i = 0; i < count && !words_.ended(); ++i) {
    words_.skip_reals(1);
    words_.skip_integers(1);
  }
}

void Counts::bezier_curve(std::size_t dimension) {
  const bool rational = words_.flag();
  skip_poles(words_.degree() + 1L, rational, dimension);
}

void Counts::spline_curve(std::size_t dimension) {
  const bool rational = words_.flag();
  words_.flag();  // periodic
  words_.degree();
  const int poles = words_.integer();
  const std::size_t knots = this->knots(words_.integer());
  skip_poles(poles, rational, dimension);
  skip_knots(knots);
}

void Counts::curve(std::size_t dimension) {
  // Line, circle, ellipse, parabola and hyperbola.
  constexpr std::array<std::size_t, 6> kPlanar = {0, 4, 7, 8, 7, 8},
                                       kSpatial = {0, 6, 13, 14, 13, 14};
  constexpr int kBezier = 6, kSpline = 7, kTrimmed = 8, kOffset = 9;
  const std::array<std::size_t, 6>& plain = dimension == 2 ? kPlanar : kSpatial;
  while (!words_.ended()) {
    const int kind = words_.kind();
    if (kind == kBezier) return bezier_curve(dimension);
    if (kind == kSpline) return spline_curve(dimension);
    if (kind > 0 && kind < kBezier) words_.skip_reals(plain[static_cast<std::size_t>(kind)]);
    if (kind != kTrimmed && kind != kOffset) return;
    if (kind == kTrimmed) words_.skip_reals(2);
    if (kind == kOffset) words_.skip_reals(dimension == 2 ? 1 : 4);
    // The curve that is trimmed or offset follows.
  }
}

void Counts::bezier_surface() {
  const bool rational_u = words_.flag(), rational_v = words_.flag();
  const long rows = words_.degree() + 1L, columns = words_.degree() + 1L;
  skip_grid(rows, columns, rational_u || rational_v);
}

void Counts::spline_surface() {
  const bool rational_u = words_.flag(), rational_v = words_.flag();
  words_.flag();  // periodic along u, and along v
  words_.flag();
  words_.degree();
  words_.degree();
  const int rows = words_.integer(), columns = words_.integer();
  const int knots_u = words_.integer(), knots_v = words_.integer();
  const std::size_t knots = this->knots(knots_u) + this->knots(knots_v);
  skip_grid(rows, columns, rational_u || rational_v);
  skip_knots(knots);
}

void Counts::surface() {
  // Plane, cylinder, cone, sphere, torus; extrusion, revolution, trimmed and offset before what
  // they are of.
  constexpr std::array<std::size_t, 12> kNumbers = {0, 12, 13, 14, 13, 14, 3, 6, 0, 0, 4, 1};
  constexpr int kExtrusion = 6, kRevolution = 7, kBezier = 8, kSpline = 9, kTrimmed = 10,
                kOffset = 11;
  while (!words_.ended()) {
    const int kind = words_.kind();
    if (kind == kBezier) return bezier_surface();
    if (kind == kSpline) return spline_surface();
    if (kind > 0 && kind <= kOffset) words_.skip_reals(kNumbers[static_cast<std::size_t>(kind)]);
    if (kind == kExtrusion || kind == kRevolution) return curve(3);
    if (kind != kTrimmed && kind != kOffset) return;
  }
}

void Counts::polygon() {
  const int count = words_.integer();
  const bool parameters = words_.flag();
  words_.skip_reals(1);  // the deflection
  const std::size_t each = parameters ? 4 : 3;
  words_.skip_reals(each * fit(count, each, words_.room_for_reals(), "nodes"));
}

void Counts::polygon_on_triangles() {
  const std::size_t count = fit(words_.integer(), 1, words_.room_for_integers(), "nodes");
  words_.skip_integers(count);
  words_.skip_text_word();  // "p"
  words_.skip_reals(1);
  if (words_.flag()) words_.skip_reals(count);
}

void Counts::triangles() {
  const int nodes = words_.integer(), triangles = words_.integer();
  const bool parameters = words_.flag(), normals = has_normals_ && words_.flag();
  words_.skip_reals(1);  // the deflection
  const std::size_t each = parameters ? 5 : 3;
  const std::size_t corners = fit(nodes, each, words_.room_for_reals(), "nodes");
  fit(triangles, 3, words_.room_for_integers(), "triangles");
  words_.skip_reals(each * corners);
  words_.skip_integers(3 * static_cast<std::size_t>(triangles));
  if (normals) words_.skip_singles(3 * corners);
}

}  // namespace

void check_counts(std::string_view content, bool binary) {
  constexpr std::string_view kFirst = "\nLocations ";
  if (const std::size_t at = content.find(kFirst); at != std::string_view::npos)
    Counts(content, at + 1, binary).check();
}

}  // namespace blossom::occt
