// SPDX-License-Identifier: LGPL-2.1-or-later
// What happens along a valley: where branches and the valley itself cross the border of the cell,
// and where its gap is above, below or within the tolerance of zero.

#pragma once

#include <array>
#include <vector>

#include "core/surfaces/gap/cells/valley_shape.h"

namespace blossom {

enum class ValleyLabel { Above, Below, Contact };

/// A piece of valley [from, to] in w.
struct ValleyPiece {
  double from, to;
  ValleyLabel label;
};

/// Where something meets the cell's border.
struct BorderEvent {
  double w, z;
  int edge;      ///< 0, 1: x = -1, 1; 2, 3: y = -1, 1
  double along;  ///< on the edge
  bool upper;    ///< of a root: it lies above the valley
  double gap;    ///< of a crossing of the valley, model units
  double slope;  ///< there, along the valley
  bool contact;  ///< the valley is in contact there
};

class ValleyLabels {
 public:
  /// tolerance    model units
  /// slow_slope   a gap that changes more slowly along the valley is a contact, not a fold
  ValleyLabels(const ValleyShape& shape, double tolerance, double slow_slope);

  /// False if some sign stays undecided.
  bool read() { return find_crossings() && find_roots() && label_valley(); }

  /// Crossings of the valley, in pairs in and out; roots of the edges; pieces between each pair.
  const std::vector<BorderEvent>& crossings() const { return crossings_; }
  const std::vector<BorderEvent>& roots() const { return roots_; }
  const std::vector<std::vector<ValleyPiece>>& valleys() const { return valleys_; }

  /// True if the surfaces are in contact all along an edge and, since the gap is convex across
  /// it, nowhere else in the cell.
  bool valley_along(int edge) const;

 private:
  bool find_crossings();
  bool find_roots();
  void add_zone(std::size_t edge, double along, std::vector<double>& cuts) const;
  bool add_roots(std::size_t edge, double from, double to);
  bool label_valley();
  static bool changes_sign(const std::vector<ValleyPiece>& pieces);
  bool beyond_tolerance(const std::vector<ValleyPiece>& pieces) const;
  bool label(const ValleyStretch& stretch, const BorderEvent& in, const BorderEvent& out,
             std::vector<ValleyPiece>& pieces);
  bool label_parts(const ValleyStretch& stretch, const BorderEvent& in, const BorderEvent& out,
                   std::vector<ValleyPiece>& pieces);
  double cut_between(double from, double to) const;
  bool add_fold(double from, double to, std::vector<ValleyPiece>& pieces) const;

  const ValleyShape& shape_;
  const double tolerance_, slow_slope_;
  std::array<Polynomial, 4> edge_gap_, edge_slope_;
  std::vector<BorderEvent> crossings_, roots_;
  std::vector<std::vector<ValleyPiece>> valleys_;
  int pieces_left_ = 0;
  bool exact_ = false;  // labels by signs alone, no contact
};

}  // namespace blossom
