// SPDX-License-Identifier: LGPL-2.1-or-later
// How far meshes and models are from each other at worst, both ways, between bounds.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "core/base/status.h"
#include "plugin/meshes/mesh_files.h"
#include "plugin/reports/text/json.h"

namespace blossom::meshes {

/// Triangles, and how far these may be from what they stand for.
class MeshSource {
 public:
  MeshSource(std::string name, FileMesh mesh);
  /// A model, of few triangles at first, for its size alone.
  /// numbers   of the shape's faces, for messages
  /// throws    occt::BadModel as refine
  MeshSource(std::string name, const TopoDS_Shape& shape, std::vector<int> numbers);

  const std::string& name() const { return name_; }
  const FileMesh& mesh() const { return mesh_; }
  double distance() const { return distance_; }  ///< proven, both ways; 0 of a mesh
  bool is_model() const { return shape_.has_value(); }
  double size() const;  ///< the diagonal of its box

  /// Triangles of a model within a deviation. False if it was told to end.
  /// throws   occt::BadModel, with the face, if one cannot be meshed
  bool refine(double deviation, const std::function<bool()>& ask);

 private:
  bool mesh_model(double deviation, double angle, const std::function<bool()>& ask);

  std::string name_;
  FileMesh mesh_;
  std::optional<TopoDS_Shape> shape_;
  std::vector<int> numbers_;
  double distance_ = 0;
};

struct FarthestOfMesh {
  double lower = 0, upper = 0;
  Vec3 point;
};

struct MeshDistance {
  std::string a, b;
  FarthestOfMesh a_to_b, b_to_a;
  Status status = Status::Complete;
  double seconds = 0;

  std::optional<double> within;  ///< what was asked about, model units

  /// Whether they are within it; none if the bounds leave it open, or nothing was asked.
  std::optional<bool> is_within() const;

  double lower() const;
  double upper() const;
};

/// The largest distance of points of one from the other, both ways: the two-sided Hausdorff
/// distance. Models become finer until the bounds are as near as a tenth of the distance.
///
/// tolerance   the bounds are to be this near, or the upper one below it; model units
/// ask         whether to go on; the bounds hold if it ends, and the status is Stopped
/// within      if given: no more is done than tells whether they are; the status is Tolerance where
///             this stays open
MeshDistance distance_of(MeshSource& a, MeshSource& b, double tolerance,
                         const std::function<bool()>& ask, std::optional<double> within = {});

/// Schema blossom.mesh-distance/1.
reports::Json mesh_distance_report(const MeshDistance& found);

}  // namespace blossom::meshes
