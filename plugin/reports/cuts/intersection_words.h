// SPDX-License-Identifier: LGPL-2.1-or-later
// What an intersection is in words: for summaries, and for pages that show it.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "adapters/occt/intersection.h"
#include "plugin/reports/cuts/intersection.h"
#include "plugin/reports/models/input.h"

namespace blossom::reports {

struct IntersectionCounts {
  std::size_t curves = 0;
  std::size_t closed = 0;
  std::size_t points = 0;
  std::size_t nodes = 0;
  std::size_t overlaps = 0;
  double overlap_area = 0;  ///< about, square model units
  std::size_t contacts = 0;
  std::size_t unresolved = 0;
  std::size_t stretches = 0;    ///< of edges
  double stretches_length = 0;  ///< model units

  bool any() const { return curves + points + overlaps + contacts + stretches > 0; }
  bool has_shape() const {
    return curves + points + stretches > 0;
  }  ///< that a file of pairs can hold
};
IntersectionCounts counts_of(const Input& a, const occt::ShapeIntersection& found,
                             const EdgeFindings& edges);

/// "3 curves (1 closed), 1 overlap of about 20.5 mm²"; what there is none of is left out.
std::string counts_text(const IntersectionCounts& counts);

/// Pairs of faces as results name them; a and b are one object for an input with itself.
class PairNames {
 public:
  PairNames(const Input& a, const Input& b);

  /// "Shaft x Bearing, face 12 x face 3"; one face for one with itself.
  std::string of(const occt::FaceIntersection& pair) const;

 private:
  const Input& a_;
  const Input& b_;
  std::vector<std::string> parts_a_, parts_b_;  // by face number - 1
};

/// "closed, length 3.5, within 1e-9": the last is the largest deviation of the curve from its
/// faces. detail   degree and poles, too
std::string curve_text(const occt::FaceIntersection& pair, const CurveChain& chain, bool detail);

/// "touching in a point near (1, 2, 3), 1e-6 across, gap 0 to 1e-9".
/// points   known ones: a contact is near that which it holds, else near its middle
std::string place_text(const Place& place, const std::vector<Vec3>& points = {});

/// About the area of an overlap of a pair, square model units.
double overlap_area(const Input& a, const occt::FaceIntersection& pair, const Overlap& overlap);

/// "(1, 2, 3)", of six digits.
std::string shown_point(const Vec3& point);

/// "gap 0 to 1e-9".
std::string gap_text(const Place& place);

/// Whether a point is in a place's box.
bool is_in(const Place& place, const Vec3& point);

}  // namespace blossom::reports
