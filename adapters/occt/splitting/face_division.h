// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces on their way from intersection curves to pieces: what trims and solids do alike.
//
// All faces of a model go through each step before one of them goes through the next:
//
//   add_cut     for each intersection curve that lies in the face
//   begin       where cuts cross the wires of the face
//   settle      loose ends, and crossings of cuts; after it solids exchange the stops of cuts
//   finish      the pieces
//
// On which side of a tool the pieces lie is told by trim_sides.h.

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/intersection.h"
#include "adapters/occt/splitting/face_splitter.h"
#include "adapters/occt/splitting/trim_sides.h"

namespace blossom::occt {

/// What the divisions of all faces of a job have in common; all kept by reference.
struct DivisionJob {
  EdgeSplits& splits;
  double tolerance = 0;              ///< points closer than this are one; model units
  const WorkLimit* limit = nullptr;  ///< asked between searches for crossings; null: none
};

class FaceDivision {
 public:
  explicit FaceDivision(const TopoDS_Face& face) : face_(face) {}

  const TopoDS_Face& face() const { return face_; }
  const std::vector<FaceCut>& cuts() const { return cuts_; }
  const std::vector<CutSource>& sources() const { return sources_; }  ///< one for each cut

  /// Before `begin`.
  void add_cut(FaceCut cut, CutSource source);

  /// Makes the splitter, of a face that has none yet: of one with cuts before all `settle`, of
  /// others when something comes to lie in them.
  /// throws   BadModel as `face_trims`; Failure when the limit is reached, `settle` too
  void begin(const DivisionJob& job);
  void settle();

  /// Null for a face that nothing divides.
  FaceSplitter* splitter() const { return splitter_.get(); }

  /// Splits the face; one without cuts only if one of its edges is split.
  void finish(const DivisionJob& job, OpenCuts open = OpenCuts::LeaveOut);

  /// The face as its only piece, whatever was to divide it.
  void leave_whole();

  /// After `finish` or `leave_whole`.
  const FaceSplit& split() const { return split_; }

 private:
  TopoDS_Face face_;
  std::vector<FaceCut> cuts_;
  std::vector<CutSource> sources_;
  std::unique_ptr<FaceSplitter> splitter_;
  FaceSplit split_;
};

/// The cut of the first face of a pair along one of the pair's curves, and of the second one.
FaceCut cut_of_a(const FaceIntersection& pair, std::size_t curve);
FaceCut cut_of_b(const FaceIntersection& pair, std::size_t curve);

/// Whether one of the pair's curves is in one point: as a whole in a place that is listed as a
/// point of contact, as round a pole that the other surface touches. It divides nothing.
bool is_one_place(const FaceIntersection& pair, std::size_t curve);

}  // namespace blossom::occt
