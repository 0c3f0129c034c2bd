// SPDX-License-Identifier: LGPL-2.1-or-later
// Stretches of the borders of one surface, and of its patches, that lie on another one.

#pragma once

#include <optional>
#include <vector>

#include "core/base/work_limit.h"
#include "core/bounds/box_tree.h"
#include "core/cells/surface_cells.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// The lower or upper border of a row of patches. Inside a surface two of them share each knot
/// line.
struct BorderLine {
  int across = 0;      ///< the parameter held: 0 is u, 1 is v
  int span = 0;        ///< in that parameter
  bool upper = false;  ///< at the end of the span

  friend bool operator==(const BorderLine&, const BorderLine&) = default;
};

/// All such borders of a surface.
std::vector<BorderLine> border_lines(const BezierSurface& surface);

/// The span beyond a border; nothing where the surface ends.
std::optional<int> span_beyond(const BezierSurface& surface, const BorderLine& line);

/// The closest point of the other surface.
struct Foot {
  int patch = 0;
  Vec2 x;          ///< local parameters in [0, 1]
  Vec2 raw;        ///< likewise, before they were clamped to the surface
  double gap = 0;  ///< distance, model units
};

/// A point of a border with its foot.
struct BorderProbe {
  double along = 0;  ///< span plus local parameter, along the border
  int patch = 0;
  Vec2 x;  ///< local parameters
  Foot foot;
};

/// A stretch of a border within tolerance of the other surface; at least 2 points.
struct BorderOverlap {
  BorderLine line;
  std::vector<BorderProbe> points;  ///< by `along`, dense: chords are within 1e-4 of the size
};

/// A place on one surface's border where a stretch of the other surface's border ends.
struct BorderJunction {
  BorderLine line;
  double along = 0;
};

/// Which stretches count.
enum class StretchKind {
  Any,
  Interior,  ///< only those in the interior of patches of the other surface
};

/// Follows the borders of `own` over `other`.
class BorderFollower {
 public:
  /// others       by patch of `own`: the patches of `other` that it may lie on
  /// tolerance    largest distance of a stretch, model units
  /// limit        once it is reached no point lies on the other surface any more
  BorderFollower(SurfaceCells& own, SurfaceCells& other, std::vector<std::vector<int>> others,
                 double tolerance, double size, PolledLimit& limit);

  /// All stretches of a border. They are sought from points a fraction of a span apart, so shorter
  /// ones may be missed unless `junctions` names their ends.
  std::vector<BorderOverlap> stretches(const BorderLine& line, StretchKind kind,
                                       const std::vector<double>& junctions);

  /// Where the ends of a stretch lie on borders of the other surface.
  std::vector<BorderJunction> junctions(const BorderOverlap& stretch) const;

  /// The stretch cut at the places given by `along`.
  std::vector<BorderOverlap> cut(const BorderOverlap& stretch, const std::vector<double>& places);

  /// True if the surfaces also coincide beside the stretch, in its row of patches, but not beyond
  /// its border.
  bool bounds_coincidence(const BorderOverlap& stretch);

  /// The stretch by a few points of which neighbours lie in the same pair of patches or are one
  /// point in two pairs.
  std::vector<BorderProbe> links(const BorderOverlap& stretch);

  Vec3 point(const BorderProbe& probe);

 private:
  struct Start {
    int patch;
    Vec2 x;
    Vec3 point;
  };

  int spans(const BorderLine& line) const;
  bool coincide_inside(const BorderOverlap& stretch);
  bool coincides_off(const BorderLine& line, double along, bool beyond);
  bool leaves(const Foot& foot) const;
  bool is_crease(const BorderLine& line, int span);
  BorderProbe placed(const BorderLine& line, double along, int span) const;
  BorderProbe placed(const BorderLine& line, double along) const;
  bool probe(BorderProbe& at, const Foot* near);
  bool follow(BorderProbe& at, Foot near);
  bool search(BorderProbe& at);
  const std::vector<Start>& starts(int patch);
  bool move_on(Foot& foot) const;
  std::vector<BorderLine> borders_at(const Foot& foot, double width) const;
  bool lies_on(const BorderProbe& at, bool found, StretchKind kind) const;
  BorderProbe end_between(const BorderLine& line, BorderProbe in, double out, StretchKind kind);
  bool snap(const BorderLine& line, BorderProbe& end, double inwards, const BorderLine& border);
  void refine(BorderOverlap& stretch);
  std::vector<BorderProbe> patch_change(const BorderLine& line, BorderProbe from,
                                        const BorderProbe& to);

  SurfaceCells& own_;
  SurfaceCells& other_;
  std::vector<std::vector<int>> others_;
  std::vector<std::vector<Start>> starts_;  // by patch of other
  double tolerance_;
  double size_;
  Box near_other_;  // what is within tolerance of `other`, relative to the origin
  PolledLimit& limit_;
};

}  // namespace blossom
