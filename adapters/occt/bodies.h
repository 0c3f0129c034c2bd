// SPDX-License-Identifier: LGPL-2.1-or-later
// Models as bodies: closed solids with what is inside of them, everything else as surfaces; and how
// two models, or a point, lie to them.

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/distance.h"
#include "adapters/occt/intersection.h"
#include "core/base/tolerances.h"

namespace blossom::occt {

struct Body {
  TopoDS_Shape shape;  ///< a closed solid, or all that belongs to none
  /// Of the solid, 1-based in the order of TopExp::MapShapes; 0 of what belongs to no closed solid:
  /// it is taken as a surface, which has no inside.
  int solid = 0;
  int faces = 0;

  bool is_solid() const { return solid > 0; }
};

/// The closed solids of a shape in their order, then what belongs to none, if there is anything.
std::vector<Body> bodies_of(const TopoDS_Shape& shape);

/// A shape taken apart, made ready for questions of one thread.
class Bodies {
 public:
  /// throws   as MeasuredShape
  explicit Bodies(const TopoDS_Shape& shape);
  /// boundary   of the same shape, made ready already
  Bodies(const TopoDS_Shape& shape, MeasuredShape boundary);
  ~Bodies();
  Bodies(Bodies&&) noexcept;
  Bodies& operator=(Bodies&&) noexcept;

  /// The solids in their order, then the surface if there is one.
  const std::vector<Body>& all() const;
  /// All faces, edges and vertices.
  const MeasuredShape& boundary() const;

 private:
  friend class BodyRelations;
  friend class BodyPlaces;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// How two bodies lie to each other.
enum class Relation {
  Unknown,
  Disjoint,
  Touching,  ///< boundaries within tolerance, and no inside in common
  Crossing,  ///< they have points in common, and none holds the other
  AInsideB,
  BInsideA,
  Equal,
};

/// "unknown", "disjoint", "touching", "crossing", "a inside b", "b inside a", "equal".
const char* to_string(Relation relation);

/// Whether the relation says that there are common points, and not only within tolerance.
bool has_common_points(Relation relation);

/// Faces of two bodies, and what they have in common.
struct FacesMet {
  std::vector<TopoDS_Face> a, b;
  ShapeIntersection found;
};

struct BodyPair {
  std::size_t a = 0, b = 0;  ///< places among the bodies
  Relation relation = Relation::Unknown;
  /// Complete: proven. Tolerance: right if what is within tolerance is one. Stopped: a limit was
  /// reached before it was known.
  Status status = Status::Complete;
  /// Where solids in contact were split to tell: what their faces have in common, at the tolerance
  /// asked for.
  std::shared_ptr<const FacesMet> faces{};
};

struct ModelRelation {
  /// Of the models as wholes: one is inside of the other if each of its bodies is inside of one of
  /// the other's, they are equal if both are, and crossing if some bodies have common points.
  Relation relation = Relation::Unknown;
  Status status = Status::Complete;  ///< the weakest of all pairs
  std::vector<BodyPair> pairs;       ///< all that are not disjoint
};

/// How two models lie to each other, by pairs of their bodies.
///
/// Bodies whose boundaries are apart are told by one point of each piece of boundary: rays from it
/// leave the other solid as often as they have to from inside. Cavities are outside. Where
/// boundaries are within tolerance, points of all faces tell first, and else the pieces into which
/// `solid_pieces` splits both solids, or `trim` a surface.
///
/// boundaries   what is known of those of the models as wholes
/// tolerance    distance that counts as meeting where nothing is proven, model units
ModelRelation relation_of(Bodies& a, Bodies& b, const ShapeMeeting& boundaries,
                          double tolerance = Tolerances{}.point,
                          const DistanceOptions& options = {});

enum class PointPlace { Unknown, Outside, Inside, OnBoundary };

/// "unknown", "outside", "inside", "on the boundary".
const char* to_string(PointPlace place);

/// Where a point lies to each body that is a solid, in their order.
///
/// nearest     what is known of its distance from the boundary
/// tolerance   how near to the boundary is on it, model units
std::vector<PointPlace> places_of(Bodies& bodies, const Vec3& point, const ShapeDistance& nearest,
                                  double tolerance = Tolerances{}.point,
                                  const DistanceOptions& options = {});

}  // namespace blossom::occt
