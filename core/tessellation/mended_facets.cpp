// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/mended_facets.h"

#include <algorithm>
#include <set>

#include "core/math/index.h"

namespace blossom {
namespace {

// Chords that are half as long are a quarter as far from their arcs.
constexpr double kFiner = 0.25;
constexpr int kFinerRounds = 3;
// Facets that may be expected then: so many times as many, or, if that is more, what takes a tenth
// of a second.
constexpr std::size_t kTimes = 4;
constexpr std::size_t kFewFacets = 50'000;

using Faults = std::map<int, std::size_t>;

std::size_t facet_count(const ShapeFacets& facets) {
  std::size_t count = 0;
  for (const MeshedFace& face : facets.faces) count += face.triangles.size();
  return count;
}

// Which faces are to be finer, by what finer facets have done to their faults.
class FinerFaces {
 public:
  FinerFaces(ShapeModel& model, const ShapeFacets& first, const Faults& faults)
      : model_(model), most_(std::max(kFewFacets, kTimes * facet_count(first))), faults_(faults) {
    for (const auto& [face, count] : faults) open_.insert(face);
    refine(first);
  }

  // After facets were made: whether other ones are to be tried. Once more after the last round, for
  // faces that are as coarse as before.
  bool take(const Faults& found, const ShapeFacets& facets) {
    if (++round_ > kFinerRounds) return false;
    open_.clear();
    bool changed = false;
    for (const auto& [face, count] : found) {
      if (given_up_.contains(face)) continue;
      changed = true;
      const auto before = faults_.find(face);
      const bool is_less = before == faults_.end() || count < before->second;
      if (is_less && round_ < kFinerRounds)
        open_.insert(face);
      else
        give_up(face);
    }
    faults_ = found;
    refine(facets);
    return changed;
  }

  std::vector<int> numbers() const {
    std::vector<int> finer;
    for (std::size_t f = 0; f < model_.faces.size(); ++f)
      if (model_.faces[f].part < 1) finer.push_back(static_cast<int>(f));
    return finer;
  }

 private:
  // Facets of half the sides are four times as many.
  void refine(const ShapeFacets& facets) {
    std::size_t expected = facet_count(facets);
    for (const int face : open_) expected += 3 * facets.faces[index(face)].triangles.size();
    for (const int face : open_) {
      if (expected > most_)
        give_up(face);
      else
        model_.faces[index(face)].part *= kFiner;
    }
  }

  void give_up(int face) {
    model_.faces[index(face)].part = 1;
    given_up_.insert(face);
  }

  ShapeModel& model_;
  std::size_t most_ = 0;  // facets
  Faults faults_;
  std::set<int> open_;  // faces that are to become finer
  std::set<int> given_up_;
  int round_ = 0;
};

}  // namespace

MendedFacets mended_facets(ShapeModel model, const FacetOptions& options, const FacetFaults& faults,
                           const std::function<bool()>& ask) {
  MendedFacets first{shape_facets(model, options, ask), {}, -1};
  if (!faults || first.facets.stopped) return first;
  const std::optional<Faults> found = faults(first.facets);
  if (!found) return first;
  first.looked = 0;
  if (found->empty()) return first;
  FinerFaces faces(model, first.facets, *found);
  for (int looked = 1; !faces.numbers().empty(); ++looked) {
    MendedFacets made{shape_facets(model, options, ask), faces.numbers(), looked};
    if (made.facets.stopped) return first;
    const std::optional<Faults> left = faults(made.facets);
    if (!left) return first;
    if (faces.take(*left, made.facets)) continue;
    if (left->size() < found->size()) return made;
    return first;
  }
  return first;
}

}  // namespace blossom
