// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_distance.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/tessellation.h"
#include "core/bounds/box_tree.h"
#include "core/meshes/mesh_distance.h"

namespace blossom::meshes {
namespace {

// Of the size of both: how near a mesh is to its model at first, and by how much it gets nearer
// until the bounds are as near as a part of the distance. No nearer than they ask for where the
// distance is known from below.
constexpr double kFirstDeviation = 1e-3;
constexpr double kFiner = 0.2;
constexpr double kGoodPart = 0.1;
constexpr double kNearPart =
    0.4;  // of what bounds may differ by, beside what the search leaves open
constexpr int kRounds = 4;
constexpr double kSearchPart = 0.2;  // of the deviation: what the search of meshes leaves open
// Of the distance that is asked about: with models so near to their meshes a part that is as near
// as half of it is told at once.
constexpr double kAskedPart = 0.2;
constexpr double kAnyDeviation = 1e6;  // model units: triangles for the size alone

// Both sets may be off their meshes by what these are off.
FarthestOfMesh farthest(const MeshSource& from, const MeshSource& to, double accuracy,
                        std::optional<double> within, const std::function<bool()>& ask) {
  const double off = from.distance() + to.distance();
  WantedBounds wanted{.accuracy = accuracy};
  if (within) {
    // Where meshes are too far from what they stand for to tell that it is, they may tell that not.
    wanted.enough = off < *within ? *within - off : *within + off;
    wanted.too_far = *within + off;
  }
  const FarthestPoint found = farthest_point(from.mesh().points, from.mesh().triangles,
                                             to.mesh().points, to.mesh().triangles, wanted, ask);
  return {std::max(0.0, found.lower - off), found.upper + off, found.point};
}

reports::Json json_of(const FarthestOfMesh& way) {
  return {{"lower", way.lower}, {"upper", way.upper}, {"at", way.point.coordinates}};
}

}  // namespace

MeshSource::MeshSource(std::string name, FileMesh mesh)
    : name_(std::move(name)), mesh_(std::move(mesh)) {}

MeshSource::MeshSource(std::string name, const TopoDS_Shape& shape, std::vector<int> numbers)
    : name_(std::move(name)), shape_(shape), numbers_(std::move(numbers)) {
  mesh_model(kAnyDeviation, FacetOptions{}.angle, {});
}

double MeshSource::size() const {
  Box box;
  for (const Vec3& p : mesh_.points) box = joined(box, {p, p});
  return diagonal(box);
}

bool MeshSource::refine(double deviation, const std::function<bool()>& ask) {
  return !shape_ || mesh_model(deviation, 0, ask);
}

bool MeshSource::mesh_model(double deviation, double angle, const std::function<bool()>& ask) {
  FacetOptions options;
  options.deviation = deviation;
  options.angle = angle;
  const occt::ShapeTessellation made = occt::tessellation(*shape_, options, ask);
  if (made.facets.stopped) return false;
  for (std::size_t f = 0; f < made.facets.faces.size(); ++f)
    if (!made.facets.faces[f].obstacle.empty())
      throw occt::BadModel(name_ + ": face " + std::to_string(numbers_[f]) +
                           " cannot be meshed: " + made.facets.faces[f].obstacle);
  mesh_ = {made.facets.points, occt::triangles_of(made)};
  distance_ = made.facets.distance;
  return true;
}

double MeshDistance::lower() const { return std::max(a_to_b.lower, b_to_a.lower); }
double MeshDistance::upper() const { return std::max(a_to_b.upper, b_to_a.upper); }

std::optional<bool> MeshDistance::is_within() const {
  if (within && upper() <= *within) return true;
  if (within && lower() > *within) return false;
  return {};
}

MeshDistance distance_of(MeshSource& a, MeshSource& b, double tolerance,
                         const std::function<bool()>& ask, std::optional<double> within) {
  const auto start = std::chrono::steady_clock::now();
  MeshDistance found;
  found.a = a.name();
  found.b = b.name();
  found.within = within;
  double deviation = kFirstDeviation * std::max(a.size(), b.size());
  for (int round = 0; round < kRounds; ++round) {
    if (!a.refine(deviation, ask) || !b.refine(deviation, ask)) break;
    const double accuracy = std::max(tolerance, kSearchPart * deviation);
    const FarthestOfMesh forth = farthest(a, b, accuracy, within, ask),
                         back = farthest(b, a, accuracy, within, ask);
    if (round > 0 && !ask()) break;
    found.a_to_b = forth;
    found.b_to_a = back;
    const double apart = found.upper() - found.lower();
    if (within ? found.is_within().has_value()
               : apart <= std::max(tolerance, kGoodPart * found.upper()))
      break;
    if (!a.is_model() && !b.is_model() && accuracy <= tolerance) break;
    deviation =
        round == 0 && within && *within > 0
            ? std::min(kFiner * deviation, kAskedPart * *within)
            : std::max(kFiner * deviation, within ? 0 : kNearPart * kGoodPart * found.lower());
  }
  if (within && !found.is_within()) found.status = Status::Tolerance;
  if (!ask()) found.status = Status::Stopped;
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return found;
}

reports::Json mesh_distance_report(const MeshDistance& found) {
  const std::optional<bool> is_within = found.is_within();
  return {{"within", found.within ? reports::Json(*found.within) : reports::Json(nullptr)},
          {"is_within", is_within ? reports::Json(*is_within) : reports::Json(nullptr)},
          {"schema", "blossom.mesh-distance/1"},
          {"a", found.a},
          {"b", found.b},
          {"status", to_string(found.status)},
          {"lower", found.lower()},
          {"upper", found.upper()},
          {"a_to_b", json_of(found.a_to_b)},
          {"b_to_a", json_of(found.b_to_a)},
          {"seconds", found.seconds}};
}

}  // namespace blossom::meshes
