// SPDX-License-Identifier: LGPL-2.1-or-later
// Which parts of an assembly, or of two, penetrate, touch or hold each other, and how far the
// others are apart.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/bodies.h"
#include "core/bounds/box_tree.h"
#include "core/results/options.h"

namespace blossom::occt {

enum class ContactKind { Point, Curve, Face };

/// "point", "curve", "face".
const char* to_string(ContactKind kind);

/// Where two bodies touch.
struct BodyContact {
  ContactKind kind = ContactKind::Point;
  TopoDS_Face face_a, face_b;
  Vec3 point;  ///< one that both have, within tolerance
  Box box;     ///< of samples of what they have in common
};

/// What two bodies have in common.
struct CommonBody {
  double volume = 0;  ///< cubic model units
  double lower = 0;   ///< bounds on the depth: the largest distance of a point of either body's
  double upper = 0;   ///< boundary within the other one from that one's boundary, model units
  Vec3 deepest;       ///< where `lower` is taken
  std::vector<TopoDS_Solid> solids{};
};

/// How two parts lie to each other.
struct Clash {
  std::size_t a = 0, b = 0;  ///< places in the list of parts
  Relation relation = Relation::Unknown;
  Status status = Status::Complete;
  double lower = 0, upper = 0;    ///< bounds on the distance of the boundaries, model units
  bool measured = true;           ///< false: only known to be more than `lower`, as the clearance
  ShapePoint near_a{}, near_b{};  ///< where `upper` is taken
  std::vector<BodyContact>
      contacts{};  ///< of parts that touch, or of a sheet that crosses; the highest kind first
  std::optional<CommonBody> common{};    ///< of solids that penetrate or hold each other
  std::vector<std::string> obstacles{};  ///< why it is missing, or the relation not known
};

struct ClashOptions {
  /// Distances up to this are measured, those of other pairs only known to be more; model units.
  /// Nothing: those of pairs whose boxes meet, and of parts that meet no other that of the nearest.
  std::optional<double> clearance{};
  IntersectionOptions engine{};
};

struct Clashes {
  /// Pairs that were looked at, by their places. The parts of all other pairs are apart, by no less
  /// than their boxes are.
  std::vector<Clash> pairs;
  std::vector<Box> boxes;  ///< of the parts, with their tolerances
};

/// Looks at all pairs of parts whose boxes come near each other.
///
/// Parts are closed solids, or faces that bound none, which have no inside. Those that are one
/// shape at several places are made ready once. One that cannot be measured leaves its pairs open,
/// with the cause among their obstacles.
///
/// first_of_b   parts from this one on are those of a second model, and pairs have one of each; 0:
///              all pairs
Clashes clashes_of(const std::vector<TopoDS_Shape>& parts, const ClashOptions& options,
                   std::size_t first_of_b = 0);

}  // namespace blossom::occt
