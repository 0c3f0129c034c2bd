// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solid_layers.h"

#include <algorithm>
#include <cstddef>
#include <memory>

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>

#include "adapters/occt/distance.h"
#include "adapters/occt/errors.h"

namespace blossom::occt {
namespace {

// Cells' pairs that a question may cost: two solids in contact are not told apart by more.
constexpr long kBudget = 20'000;

// A solid with what is asked about it.
class Neighbour {
 public:
  explicit Neighbour(const TopoDS_Solid& solid)
      : solid_(solid), own_(BRep_Tool::MaxTolerance(solid, TopAbs_EDGE)) {
    BRepBndLib::Add(solid, box_, Standard_False);  // with the tolerances
  }

  bool is_apart_from(Neighbour& other, double tolerance) {
    Bnd_Box around = box_;
    around.Enlarge(tolerance);
    if (around.IsOut(other.box_)) return true;
    const double reach = tolerance + own_ + other.own_;
    return least_distance(measured(), other.measured(), {kBudget, reach}).lower > reach;
  }

 private:
  const MeasuredShape& measured() {
    if (!measured_) measured_ = std::make_unique<MeasuredShape>(solid_);
    return *measured_;
  }

  TopoDS_Solid solid_;
  double own_;
  Bnd_Box box_;
  std::unique_ptr<MeasuredShape> measured_;
};

// What cannot be measured is not shown to be apart.
bool are_apart(Neighbour& a, Neighbour& b, double tolerance) try {
  return a.is_apart_from(b, tolerance);
} catch (const Failure&) {
  return false;
} catch (const BadModel&) {
  return false;
}

}  // namespace

std::vector<std::vector<std::size_t>> solid_layers(const std::vector<TopoDS_Solid>& solids,
                                                   double tolerance, const SharedLimit& limit) {
  std::vector<Neighbour> neighbours;
  for (const TopoDS_Solid& solid : solids) neighbours.emplace_back(solid);
  std::vector<std::vector<std::size_t>> layers;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const auto fits = [&](const std::vector<std::size_t>& layer) {
      return std::ranges::all_of(layer, [&](std::size_t k) {
        return !limit.is_reached() && are_apart(neighbours[i], neighbours[k], tolerance);
      });
    };
    const auto free = std::ranges::find_if(layers, fits);
    if (free == layers.end())
      layers.push_back({i});
    else
      free->push_back(i);
  }
  return layers;
}

}  // namespace blossom::occt
