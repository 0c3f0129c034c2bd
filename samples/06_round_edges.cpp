// SPDX-License-Identifier: LGPL-2.1-or-later
// Rounds the convex edges of a block, and shows what is told where an edge cannot be rounded.
//
// usage: 06_round_edges OUT.step

#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/shapes.h"

namespace {

using namespace blossom;

constexpr double kLength = 30, kWidth = 20, kHeight = 10, kRadius = 2;

// A block whose edges are rounded is a ball, swept: V = abc + 2 (ab + bc + ca) r + pi (a + b + c)
// r^2 + 4 pi r^3 / 3 for a block of a x b x c inside of it (Steiner).
double rounded_volume() {
  const double a = kLength - 2 * kRadius, b = kWidth - 2 * kRadius, c = kHeight - 2 * kRadius;
  const double r = kRadius, pi = std::numbers::pi;
  return a * b * c + 2 * (a * b + b * c + c * a) * r + pi * (a + b + c) * r * r +
         4 * pi * r * r * r / 3;
}

std::vector<int> convex_edges(const TopoDS_Shape& shape) {
  std::vector<int> numbers;
  for (const occt::EdgeFacts& edge : occt::edge_facts(shape))
    if (edge.kind == occt::EdgeKind::Convex) numbers.push_back(edge.number);
  return numbers;
}

bool round_all(const TopoDS_Shape& block, const char* file) {
  occt::FilletOptions options;
  options.radius = kRadius;
  const occt::FilletResult made = occt::fillet(block, convex_edges(block), options);
  if (made.solids.size() != 1) return false;
  const occt::FilletedSolid& solid = made.solids.front();
  std::printf("%zu edges rounded, volume %.9f, by Steiner %.9f\n", made.edges.size(), solid.volume,
              rounded_volume());
  occt::Model model;
  model.add(solid.solid, "Rounded block");
  occt::write_model(model, file);
  return std::abs(solid.volume - rounded_volume()) < 1e-6 * rounded_volume();
}

// Nothing is made, and the refusal names the edge, the cause and what would do.
bool ask_too_much(const TopoDS_Shape& block) {
  occt::FilletOptions options;
  options.radius = kWidth + 1;
  const occt::FilletResult refused = occt::fillet(block, {convex_edges(block).front()}, options);
  for (const occt::FilletRefusal& why : refused.refused) std::printf("%s\n", why.text().c_str());
  return refused.solids.empty() && !refused.refused.empty();
}

}  // namespace

int main(int count, char** words) try {
  if (count != 2) {
    std::fprintf(stderr, "usage: 06_round_edges OUT.step\n");
    return 2;
  }
  occt::quiet_messages();  // of Open CASCADE, on stdout
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(kLength, kWidth, kHeight).Shape();
  const bool right = round_all(block, words[1]) && ask_too_much(block);
  return right ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
