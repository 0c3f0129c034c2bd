// SPDX-License-Identifier: LGPL-2.1-or-later
// How entities are written in a STEP text, where the standard leaves or writers take liberties that
// Open CASCADE does not understand. For this folder only.

#pragma once

#include <string>
#include <string_view>

namespace blossom::occt {

/// Whether keywords of entities have small letters: "#1=Point(...)", "#1=(named_unit(*)...)".
bool has_small_keywords(std::string_view text);

/// Sorts the parts of complex entities, "(LENGTH_UNIT()NAMED_UNIT(*)...)", by their names, as ISO
/// 10303-21 has them: Open CASCADE finds no value in others, the factor of an inch, say. The text
/// keeps its length.
void sort_complex_entities(std::string& text);

/// Writes entities that others have in a scope, "#1=&SCOPE #2=A(); ENDSCOPE B();", before these:
/// Open CASCADE crashes on scopes, which only the first edition of ISO 10303-21 has. What a scope
/// exports is dropped.
void open_scopes(std::string& text);

/// Puts "$" into empty lists of entities on which Open CASCADE crashes, tried with 7.6.3:
/// directions, knots, weights, loops, curves on surfaces, tolerances. Then it says that something
/// is missing.
void fill_empty_lists(std::string& text);

/// Puts "$" in the place of the edges of oriented edges that are of themselves, or of each other in
/// a circle: Open CASCADE goes round in it until its stack ends. The text keeps its length.
void open_edge_circles(std::string& text);

}  // namespace blossom::occt
