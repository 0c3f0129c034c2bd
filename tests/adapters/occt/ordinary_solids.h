// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids as people model them: of ordinary features with random sizes.

#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

namespace blossom::occt::testing {

inline constexpr int kOrdinaryFamilies = 12;

struct OrdinarySolid {
  std::string what;    ///< its features
  TopoDS_Shape shape;  ///< null where Open CASCADE could not make it
};

/// The solid of a seed: its family is `seed` modulo the number of families, its sizes are random.
OrdinarySolid ordinary_solid(int seed);

}  // namespace blossom::occt::testing
