// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes as bytes that give the same shape again, to the last bit.
//
// Open CASCADE's binary form has all numbers as they are, but what is read as a direction is made
// a unit vector once more, which changes its last bit now and then, likewise the places of
// instances (exact_places.h), and one of the flags of shapes is lost. So these flags, and the
// placements of lines, conics, elementary and swept surfaces, stand behind it as they are in
// memory, in the order in which a walk over the shape meets them.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// Nothing if the bytes would not give the shape again.
std::optional<std::string> exact_bytes(const TopoDS_Shape& shape);

/// throws   Standard_Failure or std::ios_base::failure if it is not what `exact_bytes` made
TopoDS_Shape shape_of_exact_bytes(const std::string& bytes);

/// Several shapes, none of them null, which share afterwards what they share now.
std::optional<std::string> exact_bytes(const std::vector<TopoDS_Shape>& shapes);

/// Their shapes in the same order; throws as `shape_of_exact_bytes`.
std::vector<TopoDS_Shape> shapes_of_exact_bytes(const std::string& bytes);

}  // namespace blossom::occt
