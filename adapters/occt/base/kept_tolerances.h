// SPDX-License-Identifier: LGPL-2.1-or-later
// The tolerances of faces' edges and vertices, put back after work in which they grow.

#pragma once

#include <utility>
#include <vector>

#include <BRepTools_ReShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// Edges and vertices that are not divided themselves take part in a division, and their tolerances
/// grow with what ends there. But the shapes are the caller's, and what comes of a second attempt
/// must not depend on whether there was a first one. So at its end this puts the tolerances of all
/// edges and vertices that it remembers back to what they were, unless it is told otherwise.
class KeptTolerances {
 public:
  explicit KeptTolerances(const std::vector<TopoDS_Face>& faces) { remember(faces); }
  ~KeptTolerances() { put_back(); }
  KeptTolerances(const KeptTolerances&) = delete;
  KeptTolerances& operator=(const KeptTolerances&) = delete;

  void remember(const std::vector<TopoDS_Face>& faces);

  /// The attempt came to something: tolerances stay as they are.
  void leave() { were_.clear(); }

  /// Puts the tolerances back at once. What is made of the shapes needs those that they grew to: it
  /// has to be taken through the result, which exchanges grown edges and vertices for copies.
  /// returns   null if nothing has grown
  Handle(BRepTools_ReShape) parted();

 private:
  void put_back();

  TopTools_IndexedMapOfShape known_;
  std::vector<std::pair<TopoDS_Shape, double>> were_;
};

}  // namespace blossom::occt
