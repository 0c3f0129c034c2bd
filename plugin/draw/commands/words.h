// SPDX-License-Identifier: LGPL-2.1-or-later
// What commands have in common: their words, and their answers as Tcl lists.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Draw_Interpretor.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/sewing.h"
#include "adapters/occt/trim_tool.h"
#include "core/math/vec.h"

namespace blossom::draw {

/// The words after a command's name.
using Words = std::vector<std::string>;

/// Whether there are too few words or too many: then the usage is the error.
class WrongWords {};

/// Runs a command: its answer is the Tcl result.
/// usage    the words as the help has them, for errors
/// work     throws WrongWords, or says by another exception why there is no answer
/// returns  0, or 1 for a Tcl error whose text is the message
int answered(Draw_Interpretor& interpreter, int count, const char** words, const std::string& usage,
             const std::function<std::string(const Words&)>& work);

/// throws   WrongWords
void require(bool right_number);

/// throws   BadModel if there is no shape of that name
TopoDS_Shape shape_named(const std::string& name);

/// The shape of that name with its loose faces sewn to the solids that they close, as `occt::Model`
/// sews them. What became of them is told on stderr, beside the answer.
/// throws   likewise
TopoDS_Shape sewn_shape(const std::string& name);

/// What sewing a shape of that name makes of it.
struct SewnShape {
  TopoDS_Shape shape;
  occt::Sewing sewing;
};
/// within   the widest gap that is one; without it as the borders allow
/// throws   likewise
SewnShape sew(const std::string& name, const std::optional<double>& within,
              occt::Sewable which = occt::Sewable::All);

/// throws   likewise, or if there is no face in it
std::vector<TopoDS_Face> faces_in(const TopoDS_Shape& shape, const std::string& name);

/// The edges in it beside its faces.
/// throws   likewise, or if there is neither a face nor an edge in it
std::vector<TopoDS_Edge> loose_edges_in(const TopoDS_Shape& shape, const std::string& name);

/// All of it, sewn, as a tool that is called by its name in messages.
/// throws   BadModel likewise, or as trim_tool
occt::TrimTool tool_named(const std::string& name, occt::Sewable which = occt::Sewable::All);

/// throws   BadModel if the word is no finite number, or not positive, or no number of a thing
double number_from(const std::string& word);
double positive_from(const std::string& word);
int count_from(const std::string& word);

/// Three words from a place on.
Vec3 vector_from(const Words& words, std::size_t first);

/// "0.25": as many digits as it takes to read the same number back.
std::string tcl_number(double value);
/// "{1 2 3}".
std::string tcl_list(const Vec3& vector);
/// A text as one element of a list.
std::string tcl_word(const std::string& text);

}  // namespace blossom::draw
