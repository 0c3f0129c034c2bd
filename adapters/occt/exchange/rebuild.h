// SPDX-License-Identifier: LGPL-2.1-or-later
// A shape with some of its faces replaced by pieces. For this folder only.

#pragma once

#include <vector>

#include <NCollection_DataMap.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/exchange/contents.h"

namespace blossom::occt {

/// A face to be replaced, as it lies in the shape, and what comes in its place: faces, or a solid.
/// The pieces' orientations stand beside the face's own.
struct Replacement {
  TopoDS_Face face;
  std::vector<TopoDS_Shape> pieces;
};

/// The replacements of loose faces by the solids that they have become.
/// faces   of the shape, by the numbers that the solids name
std::vector<Replacement> replacements_of(const TopTools_IndexedMapOfShape& faces,
                                         const std::vector<SolidOfFaces>& solids);

/// Builds shapes anew where they hold replaced faces and keeps everything else as it is.
///
///   shell      of its faces and their pieces; several shells, in a compound, when it falls apart,
///              and solids beside it
///   solid      stays a solid as long as its shells stay one and stay closed, else its shells
///   compound   of its parts; faces directly in it become their pieces
///   empty      shells, solids and compounds are left out
class Rebuild {
 public:
  explicit Rebuild(const std::vector<Replacement>& replacements);

  /// The new shape; null when nothing is left. Unchanged shapes come back as they are.
  TopoDS_Shape operator()(const TopoDS_Shape& shape);

  /// The pieces for a face, or nothing if it stays.
  const Replacement* find(const TopoDS_Shape& face) const;

 private:
  std::vector<TopoDS_Shape> rebuilt_parts(const TopoDS_Shape& shape);
  TopoDS_Shape rebuilt(const TopoDS_Shape& shape);
  std::vector<TopoDS_Shape> pieces_of(const TopoDS_Shape& face) const;
  bool is_touched(const TopoDS_Shape& shape) const;

  NCollection_DataMap<TopoDS_Shape, Replacement, TopTools_ShapeMapHasher> replacements_;
  NCollection_DataMap<TopoDS_Shape, TopoDS_Shape, TopTools_ShapeMapHasher> done_;
};

}  // namespace blossom::occt
