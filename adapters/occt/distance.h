// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances of whole shapes: faces within their trims, edges and vertices.

#pragma once

#include <memory>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "core/base/tolerances.h"
#include "core/distance.h"
#include "core/foot_points.h"

namespace blossom::occt {

class KeptForms;

/// Where a distance is taken.
struct ShapePoint {
  TopoDS_Shape on;  ///< a face, edge or vertex; null of a point that belongs to no shape
  Vec2 uv;          ///< a face's own parameters; (t, 0) of an edge
  Vec3 point;       ///< model units
};

struct ShapeDistance {
  double lower = 0;  ///< proven
  double upper = 0;  ///< taken at `a` and `b`
  ShapePoint a, b;

  /// As in the core. Tolerance: surfaces or curves were approximated; the bounds allow for that.
  Status status = Status::Complete;
  long pairs = 0;
};

/// A shape made ready for many questions, by any number of threads: its faces, all edges with the
/// curves they have in space, all vertices. Solids are their boundaries. At first only boxes are
/// made; faces and edges are converted when a question comes near them.
class MeasuredShape {
 public:
  /// throws   BadModel if there is nothing in the shape, an edge has no curve in space, or a face
  ///          cannot be used; Failure where Open CASCADE fails at one. Those of a conversion or of
  ///          trims may come with the first question near it, and with every later one
  /// forms    taken from there where they have to be approximated
  explicit MeasuredShape(const TopoDS_Shape& shape, KeptForms* forms = nullptr);
  /// The same shape at another place, turned but not scaled: what is converted for one of the two
  /// serves both.
  /// place     a partner of the shape that this one was made from
  /// throws    InvalidInput if it is none
  MeasuredShape moved_to(const TopoDS_Shape& place) const;
  ~MeasuredShape();
  MeasuredShape(MeasuredShape&&) noexcept;
  MeasuredShape& operator=(MeasuredShape&&) noexcept;

  /// In parts: the faces, then the edges. Vertices are its points.
  const PreparedSet& set() const;
  int parts() const;
  std::vector<TopoDS_Face> faces() const;
  /// The face, edge or vertex with the parameters of its own.
  ShapePoint named(const DistanceEnd& end) const;
  /// Largest distance of an approximated form to what it stands for, model units.
  double error() const;

 private:
  struct Impl;
  explicit MeasuredShape(std::shared_ptr<Impl> impl);
  std::shared_ptr<Impl> impl_;
};

/// The least distance of two shapes, between proven bounds.
ShapeDistance least_distance(const MeasuredShape& a, const MeasuredShape& b,
                             const DistanceOptions& options = {});

/// The nearest point of a shape; `a` is the given point.
ShapeDistance nearest_point(const MeasuredShape& shape, const Vec3& point,
                            const DistanceOptions& options = {});

/// A foot point with the face or edge that it is on.
struct ShapeFoot {
  ShapePoint at;
  FootPoint foot;
};

/// All feet of a point on the faces, within their trims, and on the edges of a shape, by increasing
/// distance. Approximated forms make them Status::Tolerance. When the limit is reached each face
/// that was not searched, or not all of it, has one that is Status::Stopped.
std::vector<ShapeFoot> foot_points(const MeasuredShape& shape, const Vec3& point,
                                   double tolerance = Tolerances{}.point,
                                   const WorkLimit* limit = nullptr);

enum class Meeting {
  No,       ///< proven: they have no point in common
  Yes,      ///< proven: two faces cross
  Within,   ///< within tolerance of each other; whether they meet is not known
  Unknown,  ///< the budget was spent before it was known
};

struct ShapeMeeting {
  Meeting answer = Meeting::Unknown;
  /// Of a Yes: both faces go on by more than the tolerance round the place where they cross.
  bool through = false;
  ShapePoint a, b;   ///< the nearest points found; where they meet unless the answer is No
  double lower = 0;  ///< the distance is at least this: above 0 if the answer is No
  double upper = 0;  ///< that of `a` and `b`
  long pairs = 0;
};

/// Whether two shapes have a point in common, as early as that is known.
///
/// tolerance  distance that counts as meeting where nothing is proven, model units
ShapeMeeting meeting(const MeasuredShape& a, const MeasuredShape& b,
                     double tolerance = Tolerances{}.point, const DistanceOptions& options = {});

/// Which crossings are looked for, of faces that are within tolerance of each other in a point.
enum class Crossings {
  All,
  ThroughBoth,  ///< those of which `ShapeMeeting::through` tells: near the point, in no time
};

/// The same where the distance is known already.
ShapeMeeting meeting_at(const ShapeDistance& found, const MeasuredShape& a, const MeasuredShape& b,
                        double tolerance = Tolerances{}.point, const DistanceOptions& options = {},
                        Crossings crossings = Crossings::All);

}  // namespace blossom::occt
