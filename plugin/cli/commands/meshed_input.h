// SPDX-License-Identifier: LGPL-2.1-or-later
// Inputs as triangles: files of them, and models.

#pragma once

#include <functional>
#include <memory>
#include <string>

#include "plugin/cli/inputs.h"
#include "plugin/meshes/mesh_files.h"

namespace blossom::cli {

/// Whether an input, as the user wrote it, is a file of triangles.
bool is_mesh_input(const std::string& input);

/// An input as triangles, and how far these may be from it.
class MeshedInput {
 public:
  /// A model has few triangles at first, for its size alone.
  explicit MeshedInput(const std::string& name);

  const std::string& name() const { return name_; }
  const meshes::FileMesh& mesh() const { return mesh_; }
  double distance() const { return distance_; }  ///< proven, both ways; 0 of a file of triangles
  bool is_model() const { return model_ != nullptr; }
  double size() const;  ///< the diagonal of its box

  /// Triangles of a model within a deviation. False if it was told to end.
  /// throws   occt::BadModel, with the face, if one cannot be meshed
  bool refine(double deviation, const std::function<bool()>& ask);

 private:
  bool mesh_model(double deviation, double angle, const std::function<bool()>& ask);

  std::string name_;
  meshes::FileMesh mesh_;
  std::unique_ptr<Input> model_;
  double distance_ = 0;
};

}  // namespace blossom::cli
