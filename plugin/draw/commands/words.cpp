// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/draw/commands/words.h"

#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <iostream>
#include <stdexcept>

#include <DBRep.hxx>
#include <Draw.hxx>
#include <Draw_Drawable3D.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/shapes.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::draw {

int answered(Draw_Interpretor& interpreter, int count, const char** words, const std::string& usage,
             const std::function<std::string(const Words&)>& work) {
  const std::string name = words[0];
  try {
    interpreter << work(Words(words + 1, words + count)).c_str();
    return 0;
  } catch (const WrongWords&) {
    interpreter << ("usage: " + name + " " + usage).c_str();
  } catch (const std::exception& error) {
    interpreter << (name + ": " + error.what()).c_str();
  } catch (...) {  // Open CASCADE's exceptions are no std::exception
    const bool lacks_memory = occt::is_lack_of_memory();
    const std::string text = lacks_memory ? "there is not enough memory"
                                          : "internal error: " + occt::current_failure_text();
    interpreter << (name + ": " + text).c_str();
  }
  return 1;
}

void require(bool right_number) {
  if (!right_number) throw WrongWords();
}

TopoDS_Shape shape_named(const std::string& name) {
  Standard_CString text = name.c_str();
  const TopoDS_Shape shape = DBRep::Get(text);
  if (!shape.IsNull()) return shape;
  if (!Draw::Get(text).IsNull())
    throw occt::BadModel(name +
                         " is no shape; mkface makes one of a surface, mkedge one of a curve");
  throw occt::BadModel(name + ": there is no such shape");
}

SewnShape sew(const std::string& name, const std::optional<double>& within, occt::Sewable which) {
  SewnShape sewn{shape_named(name), {}};
  if (occt::faces_of(sewn.shape).empty()) return sewn;
  occt::Model model;
  model.add(sewn.shape, name);
  sewn.sewing = model.sew(within, {}, which);
  if (!sewn.sewing.solids.empty()) sewn.shape = model.shape();
  for (const std::string& line : reports::words_of(sewn.sewing, "blsew RESULT " + name))
    std::cerr << name << ": " << line << '\n';
  return sewn;
}

TopoDS_Shape sewn_shape(const std::string& name) { return sew(name, std::nullopt).shape; }

std::vector<TopoDS_Face> faces_in(const TopoDS_Shape& shape, const std::string& name) {
  std::vector<TopoDS_Face> faces = occt::faces_of(shape);
  if (faces.empty()) throw occt::BadModel(name + ": there is no face in it");
  return faces;
}

std::vector<TopoDS_Edge> loose_edges_in(const TopoDS_Shape& shape, const std::string& name) {
  std::vector<TopoDS_Edge> edges = occt::loose_edges_of(shape);
  if (edges.empty() && occt::faces_of(shape).empty())
    throw occt::BadModel(name + ": there is no face and no edge in it");
  return edges;
}

occt::TrimTool tool_named(const std::string& name, occt::Sewable which) {
  const TopoDS_Shape shape = sew(name, std::nullopt, which).shape;
  faces_in(shape, name);
  occt::TrimTool tool = occt::trim_tool(shape);
  tool.name = name;
  return tool;
}

double number_from(const std::string& word) {
  try {
    std::size_t used = 0;
    const double value = std::stod(word, &used);
    if (used == word.size() && std::isfinite(value)) return value;
  } catch (const std::logic_error&) {  // no number: answered below
  }
  throw occt::BadModel("'" + word + "' is no number");
}

double positive_from(const std::string& word) {
  try {
    if (const double value = number_from(word); value > 0) return value;
  } catch (const occt::BadModel&) {  // answered below
  }
  throw occt::BadModel("'" + word + "' is no positive number");
}

int count_from(const std::string& word) {
  int value = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
  if (read.ec == std::errc{} && read.ptr == word.data() + word.size() && value > 0) return value;
  throw occt::BadModel("'" + word + "' is no number of a face or an edge");
}

Vec3 vector_from(const Words& words, std::size_t first) {
  return {number_from(words.at(first)), number_from(words.at(first + 1)),
          number_from(words.at(first + 2))};
}

std::string tcl_number(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string tcl_list(const Vec3& v) {
  return "{" + tcl_number(v[0]) + " " + tcl_number(v[1]) + " " + tcl_number(v[2]) + "}";
}

std::string tcl_word(const std::string& text) {
  std::string word = "{";
  for (const char c : text) word += c == '{' || c == '}' || c == '\\' ? ' ' : c;
  return word + "}";
}

}  // namespace blossom::draw
