// SPDX-License-Identifier: LGPL-2.1-or-later
// The faces of a shape, converted where a question comes near them, and pairs of them.

#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/face_data.h"
#include "core/distance.h"

namespace blossom::occt {

class FaceList {
 public:
  /// Faces without a hull of control points are converted at once.
  ///
  /// faces    are not copied
  /// name     of the list in messages, "the first shape"; may be empty
  /// throws   BadModel if a face has no surface or, being converted, cannot be used; the message
  ///          has the face's place in the list
  FaceList(const std::vector<TopoDS_Face>& faces, std::string name, double tolerance, Extent extent,
           ArcCuts cuts = ArcCuts::Even);
  /// Gives the converted faces' memory back by all threads.
  ~FaceList();
  FaceList(const FaceList&) = delete;
  FaceList& operator=(const FaceList&) = delete;

  std::size_t size() const { return faces_.size(); }
  const TopoDS_Face& face(std::size_t i) const { return faces_[i]; }

  /// Holds what the trims leave of a face, its tolerance included.
  const HullBound& hull(std::size_t i) const { return hulls_[i]; }
  /// Of the hulls.
  const std::vector<Box>& boxes() const { return boxes_; }

  /// Converts what is marked and not converted yet, by all threads.
  /// wanted   one mark for each face
  /// throws   BadModel likewise
  void convert(const std::vector<char>& wanted);
  /// The surface of a converted face, its arcs cut as by ArcCuts::Shifted.
  BezierSurface with_shifted_arcs(std::size_t i) const;
  /// Empty of a face that is not converted.
  const FaceData& data(std::size_t i) const { return data_[i]; }

 private:
  const std::vector<TopoDS_Face>& faces_;
  std::string name_;
  double tolerance_;
  Extent extent_;
  ArcCuts cuts_;
  std::vector<HullBound> hulls_;
  std::vector<Box> boxes_;
  std::vector<FaceData> data_;
  std::vector<char> converted_;
};

/// Indices into two lists, which may be one.
using FacePairs = std::vector<std::pair<int, int>>;

/// Pairs of faces whose hulls have boxes that meet, in increasing order.
FacePairs meeting_pairs(const FaceList& a, const FaceList& b);

/// Converts the faces of the pairs, and leaves the pairs whose surfaces have boxes that meet.
/// throws   BadModel as FaceList::convert does
void convert_meeting(FaceList& a, FaceList& b, FacePairs& pairs);

}  // namespace blossom::occt
