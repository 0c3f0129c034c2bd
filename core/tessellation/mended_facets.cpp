// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/mended_facets.h"

#include <set>
#include <utility>

#include "core/math/index.h"

namespace blossom {
namespace {

// Chords that are half as long are a quarter as far from their arcs.
constexpr double kFiner = 0.25;
constexpr int kFinerRounds = 3;

using Faults = std::map<int, std::size_t>;

// Which faces are to be finer, by what finer facets have done to their faults.
class FinerFaces {
 public:
  FinerFaces(ShapeModel& model, Faults faults) : model_(model), faults_(std::move(faults)) {
    for (const auto& [face, count] : faults_) refine(face);
  }

  // After facets were made: whether other ones are to be tried. Once more after the last round, for
  // faces that are as coarse as before.
  bool take(const Faults& found) {
    if (++round_ > kFinerRounds) return false;
    bool changed = false;
    for (const auto& [face, count] : found) {
      if (given_up_.contains(face)) continue;
      changed = true;
      const auto before = faults_.find(face);
      const bool is_less = before == faults_.end() || count < before->second;
      if (is_less && round_ < kFinerRounds)
        refine(face);
      else
        give_up(face);
    }
    faults_ = found;
    return changed;
  }

  std::vector<int> numbers() const {
    std::vector<int> finer;
    for (std::size_t f = 0; f < model_.faces.size(); ++f)
      if (model_.faces[f].part < 1) finer.push_back(static_cast<int>(f));
    return finer;
  }

 private:
  void refine(int face) { model_.faces[index(face)].part *= kFiner; }

  void give_up(int face) {
    model_.faces[index(face)].part = 1;
    given_up_.insert(face);
  }

  ShapeModel& model_;
  Faults faults_;
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
  FinerFaces faces(model, *found);
  for (int looked = 1; !faces.numbers().empty(); ++looked) {
    MendedFacets made{shape_facets(model, options, ask), faces.numbers(), looked};
    if (made.facets.stopped) return first;
    const std::optional<Faults> left = faults(made.facets);
    if (!left) return first;
    if (faces.take(*left)) continue;
    if (left->size() < found->size()) return made;
    return first;
  }
  return first;
}

}  // namespace blossom
