// SPDX-License-Identifier: LGPL-2.1-or-later
// What inputs name of a model: parts, solids, faces and edges.

#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "adapters/occt/shapes.h"
#include "plugin/reports/models/input.h"

namespace blossom::reports {

/// Numbers are 1-based in the order of TopExp::MapShapes.
struct Selection {
  std::set<int> faces;   ///< those of parts and solids among them
  std::set<int> solids;  ///< as wholes
  std::set<int> edges;
};

/// What words mean in a model:
///
///   Shaft, machine:1/Shaft   a part: its own name, that of an instance, or the way to it, as a
///                            whole, with the name of the whole model before it or not, or from
///                            some instance on; all that are called so
///   Shaft/Face3, /Edge3, /Solid3   the third one of each such part
///   part:12                  a part with a name that is a number
///   face:3, solid:2, edge:12       by the numbers of `info`
///   TopFace                  a face with a name of its own, if there is no such part
///   Face3, Edge12, Solid2    the same as face:3, edge:12, solid:2, if nothing is called so
///
/// throws   occt::BadModel, with the nearest names, if there is none; InvalidInput if a number is
///          none
Selection selection_of(const occt::Model& model, const std::vector<std::string>& words);

/// Gives an input what is named beside the numbers that it has.
void choose(const Selection& selection, Input& input);

/// Whether all that an input means is solids, or all of a model.
bool is_of_solids(const Input& input);

/// What of its model an input gives to operations on solids: the solids that it names alone, its
/// faces alone as a sheet (all faces of a solid: as that), or its edges alone; nothing where it is
/// the whole model.
/// throws   occt::BadModel if it names edges beside faces
std::optional<occt::Model> alone_for_solids(const Input& input);

/// A model of what an input names, with its names, looks and place in assemblies.
occt::Model alone(const Input& input);

/// The words of a list between commas; what the model calls by a name with commas, such as
/// "Gear, big" or "Gear, big/Face3", is one word.
std::vector<std::string> words_in(const occt::Model& model, const std::string& list);

}  // namespace blossom::reports
