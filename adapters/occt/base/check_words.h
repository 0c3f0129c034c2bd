// SPDX-License-Identifier: LGPL-2.1-or-later
// What Open CASCADE's BRepCheck finds, in words.

#pragma once

#include <string>
#include <vector>

#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <BRepCheck_Status.hxx>
#include <TopAbs_ShapeEnum.hxx>

namespace blossom::occt {

/// What is said of a shape that has the status: "is not closed", "has no curve in space". Empty for
/// BRepCheck_NoError.
std::string words_of(BRepCheck_Status status);

/// The same of one of the shapes in a face, which it names: "a wire is not closed". Of the face
/// itself as above.
std::string words_of(BRepCheck_Status status, TopAbs_ShapeEnum kind);

/// Whether all of the statuses are BRepCheck_NoError.
bool finds_nothing(const BRepCheck_ListOfStatus& statuses);

/// Adds what was found of one shape, alone and in those that it is part of; nothing twice.
void add_words_of(const Handle(BRepCheck_Result) & result, TopAbs_ShapeEnum kind,
                  std::vector<std::string>& problems);

}  // namespace blossom::occt
