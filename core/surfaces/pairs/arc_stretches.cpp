// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/arc_stretches.h"

#include <numeric>

namespace blossom {
namespace {

constexpr double kGetsOn = 0.97;  // part of a stretch's width that narrowing it leaves at most

}  // namespace

const ArcStretch& ArcStretches::stretch(std::size_t number) {
  auto& made = made_[number];
  if (made) return *made;
  ArcStretch next;
  if (number > 1) {
    next = stretch(number / 2);
    if (!next.empty) {
      const auto along = static_cast<std::size_t>(along_);
      next.part.radius[along] *= 0.5;
      next.part.middle[along] += (number % 2 == 0 ? -1 : 1) * next.part.radius[along];
    }
  }
  narrow_stretch(next);
  made = next;
  return *made;
}

bool ArcStretches::narrow_again(std::size_t number) {
  ArcStretch& s = *made_[number];
  const auto width = [&] {
    return std::accumulate(s.part.radius.begin(), s.part.radius.end(), 0.0);
  };
  const double before = width();
  narrow_stretch(s);
  return s.empty || width() < kGetsOn * before;
}

void ArcStretches::narrow_stretch(ArcStretch& s) const {
  if (s.empty) return;
  const PairJet jet = model_.jet(s.part.middle);
  const JacobianBounds means = model_.mean_jacobian(jet, s.part);
  if (const Minor minor = means.minor(along_); minor.regular)
    s.empty = !narrow(s.part, minor, along_, means.column(along_), jet.place,
                      {jet.gap, model_.rounding()});
  if (!s.empty) s.bounds = model_.jacobian(jet, s.part);
}

}  // namespace blossom
