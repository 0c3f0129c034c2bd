// SPDX-License-Identifier: LGPL-2.1-or-later
// Places of shapes that do more than move them. For this folder and `documents` only.

#pragma once

#include <cstddef>
#include <string>

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/reading.h"

namespace blossom::occt {

/// Whether the place of a shape scales it, or is no place: Open CASCADE uses none of these.
/// throws   BadModel in words if it is
void check_place(const TopoDS_Shape& shape);

/// Whether the place of a surface or curve inside a shape is none.
///
/// whose    it is, in words
/// throws   BadModel if it is
void check_inner_place(const TopLoc_Location& place, const char* whose);

/// The table of places of a BREP text or of binary BREP, behind its count.
struct EntriesOfPlaces {
  std::size_t at = 0;
  long count = 0;
  bool binary = false;
};

/// Open CASCADE takes the nearest turn for a matrix that is none, and says nothing. Such matrices
/// get "not a number" for an entry.
void spoil_unfit_places(std::string& content, const EntriesOfPlaces& where);

/// A shape whose places only move: what they scaled or mirrored has that size and that hand itself.
/// Shapes that are shared stay shared; tolerances are scaled, too. A note says what was done. What
/// Open CASCADE cannot scale stays as it is.
TopoDS_Shape with_moving_places(const TopoDS_Shape& shape, ReadingReport& report);

}  // namespace blossom::occt
