// SPDX-License-Identifier: LGPL-2.1-or-later
// Reading nets from JSON.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>

#include "adapters/occt/base/errors.h"
#include "plugin/nets/net_json.h"
#include "plugin/reports/text/lower_case.h"
#include "plugin/reports/text/nesting.h"

namespace blossom::nets {
namespace {

using Rows = std::vector<std::vector<Vec4>>;

[[noreturn]] void refuse(const std::string& what) { throw occt::BadModel(what); }

std::string quoted(const char* name) { return "\"" + std::string(name) + "\""; }

const Json& member(const Json& net, const char* name) {
  const auto found = net.find(name);
  if (found == net.end()) refuse("there is no " + quoted(name));
  return *found;
}

std::string text(const Json& net, const char* name) {
  const Json& value = member(net, name);
  if (!value.is_string()) refuse(quoted(name) + " is no text");
  return value.get<std::string>();
}

double number(const Json& value, const std::string& what) {
  if (!value.is_number()) refuse(what + " is no number");
  const double x = value.get<double>();
  if (!std::isfinite(x)) refuse(what + " is not finite");
  return x;
}

// A list of numbers, or one number alone.
std::vector<double> numbers(const Json& net, const char* name, std::size_t count) {
  const Json& value = member(net, name);
  if (count == 1 && value.is_number()) return {number(value, quoted(name))};
  if (!value.is_array() || value.size() != count)
    refuse(quoted(name) + " is no list of " + std::to_string(count) + " numbers");
  std::vector<double> result;
  for (const Json& entry : value) result.push_back(number(entry, "a number of " + quoted(name)));
  return result;
}

Interval interval(const Json& net, const char* name) {
  if (!net.contains(name)) return {0, 1};
  const std::vector<double> ends = numbers(net, name, 2);
  if (ends[0] == ends[1]) refuse(quoted(name) + " has equal ends");
  return {ends[0], ends[1]};
}

int degree(double value, int most) {
  const bool whole = value == std::floor(value);
  if (!whole || value < 1 || value > most)
    refuse("\"degree\" is not in 1.." + std::to_string(most));
  return static_cast<int>(value);
}

// The value at (i, j) of a list of lists, or at j of a list.
class Table {
 public:
  Table(const Json& net, const char* name, const std::vector<std::size_t>& rows, bool nested)
      : value_(member(net, name)), name_(name), nested_(nested) {
    check(value_, nested ? rows.size() : rows.front(), quoted(name));
    for (std::size_t i = 0; nested && i < rows.size(); ++i) check(value_[i], rows[i], place(i));
  }
  const Json& at(std::size_t i, std::size_t j) const { return nested_ ? value_[i][j] : value_[j]; }
  std::string place(std::size_t i, std::size_t j) const {
    return nested_ ? place(i) + "[" + std::to_string(j) + "]" : place(j);
  }

 private:
  std::string place(std::size_t i) const { return name_ + "[" + std::to_string(i) + "]"; }
  static void check(const Json& list, std::size_t count, const std::string& what) {
    if (!list.is_array()) refuse(what + " is no list");
    if (list.size() != count)
      refuse(what + " has " + reports::counted(list.size(), "entry") + ", the degree wants " +
             std::to_string(count));
  }

  const Json& value_;
  std::string name_;
  bool nested_;
};

// A point of 3 or 4 coordinates; the weight of the former is `weight`.
Vec4 point(const Json& value, const std::string& place, double weight) {
  if (!value.is_array() || (value.size() != 3 && value.size() != 4))
    refuse(place + " is no list of 3 or 4 coordinates");
  Vec4 result{0, 0, 0, weight};
  for (std::size_t k = 0; k < value.size(); ++k)
    result[static_cast<int>(k)] = number(value[k], "a coordinate of " + place);
  return result;
}

// Rows of homogeneous points. Without weights, 3 coordinates are those of a polynomial form.
Rows points(const Json& net, const std::vector<std::size_t>& sizes, bool nested, bool monomial) {
  const Table table(net, "points", sizes, nested);
  std::optional<Table> weights;
  if (net.contains("weights")) {
    if (monomial) refuse("\"weights\" belong to control points; give 4 homogeneous coordinates");
    weights.emplace(net, "weights", sizes, nested);
  }
  const std::size_t width = table.at(0, 0).size();
  if (weights && width != 3) refuse("with \"weights\" points have 3 coordinates");
  Rows rows(sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i)
    for (std::size_t j = 0; j < sizes[i]; ++j) {
      Vec4 p = point(table.at(i, j), table.place(i, j), monomial && i + j > 0 ? 0 : 1);
      if (table.at(i, j).size() != width)
        refuse(table.place(i, j) + " has another number of coordinates than the first point");
      if (weights) p *= number(weights->at(i, j), weights->place(i, j));
      rows[i].push_back(p);
    }
  return rows;
}

bool is_rational(const Rows& rows, bool monomial) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j)
      if (rows[i][j][3] != (monomial && i + j > 0 ? 0 : 1)) return true;
  return false;
}

void require_positive_weights(const Rows& rows) {
  for (const auto& row : rows)
    for (const Vec4& p : row)
      if (!(p[3] > 0)) refuse("a weight is " + Json(p[3]).dump() + ", weights must be positive");
}

Grid<Vec4> grid(const Rows& rows) {
  Grid<Vec4> result(static_cast<int>(rows.size()), static_cast<int>(rows.front().size()));
  for (int i = 0; i < result.rows(); ++i)
    std::ranges::copy(rows[static_cast<std::size_t>(i)],
                      result.values().begin() + i * result.columns());
  return result;
}

QParameters q_parameters(const Json& net, const char* name) {
  const std::vector<double> q = numbers(net, name, 2);
  return {q[0], q[1]};
}

// The member "centre" or "scale" of `count` numbers, or its default.
std::vector<double> origin(const Json& net, const char* name, std::size_t count, double usual) {
  if (!net.contains(name)) return std::vector<double>(count, usual);
  std::vector<double> result = numbers(net, name, count);
  if (usual != 0 && std::ranges::find(result, 0.0) != result.end()) refuse(quoted(name) + " is 0");
  return result;
}

void read_curve(const Json& json, const std::string& form, Net& net) {
  const int n = degree(numbers(json, "degree", 1)[0], kMaxDegree);
  const bool monomial = form == "monomial";
  const Rows rows = points(json, {static_cast<std::size_t>(n) + 1}, false, monomial);
  net.rational = is_rational(rows, monomial);
  net.u = interval(json, "interval");
  if (monomial) {
    net.value = RationalMonomialCurve{rows[0], origin(json, "centre", 1, 0)[0],
                                      origin(json, "scale", 1, 1)[0]};
  } else if (form == "q-bezier") {
    net.value = QCurve{rows[0], net.u, q_parameters(json, "q")};
  } else {
    require_positive_weights(rows);
    net.value = RationalBezierCurve{rows[0]};
  }
}

void read_patch(const Json& json, const std::string& form, Net& net) {
  const std::vector<double> degrees = numbers(json, "degree", 2);
  const int n = degree(degrees[0], kMaxDegree), m = degree(degrees[1], kMaxDegree);
  const bool monomial = form == "monomial";
  const std::vector<std::size_t> sizes(static_cast<std::size_t>(n) + 1,
                                       static_cast<std::size_t>(m) + 1);
  const Rows rows = points(json, sizes, true, monomial);
  net.rational = is_rational(rows, monomial);
  net.u = interval(json, "u");
  net.v = interval(json, "v");
  if (monomial) {
    const auto centre = origin(json, "centre", 2, 0), scale = origin(json, "scale", 2, 1);
    net.value = RationalMonomialPatch{grid(rows), centre[0], centre[1], scale[0], scale[1]};
  } else if (form == "q-bezier") {
    const QParameters q = q_parameters(json, "q");
    net.value =
        QPatch{grid(rows), net.u, net.v, q, json.contains("r") ? q_parameters(json, "r") : q};
  } else {
    require_positive_weights(rows);
    net.value = RationalBezierPatch{grid(rows)};
  }
}

void read_triangle(const Json& json, const std::string& form, Net& net) {
  if (form != "bezier") refuse("a triangle has the form \"bezier\", not \"" + form + "\"");
  const int n = degree(numbers(json, "degree", 1)[0], 2 * kMaxDegree);
  std::vector<std::size_t> sizes;
  for (int nu = 0; nu <= n; ++nu) sizes.push_back(static_cast<std::size_t>(n - nu + 1));
  const Rows rows = points(json, sizes, true, false);
  require_positive_weights(rows);
  net.rational = is_rational(rows, false);
  RationalBezierTriangle triangle{n, {}};
  for (const auto& row : rows)
    triangle.points.insert(triangle.points.end(), row.begin(), row.end());
  net.value = std::move(triangle);
  if (!json.contains("corners")) return;
  const Table corners(json, "corners", {2, 2, 2}, true);
  for (std::size_t k = 0; k < 3; ++k)
    net.corners[k] = {number(corners.at(k, 0), corners.place(k, 0)),
                      number(corners.at(k, 1), corners.place(k, 1))};
}

Net read_net(const Json& json, const NetSource& source) {
  Net net;
  net.source = source;
  if (!json.is_object()) refuse("it is no object");
  if (json.contains("name")) net.source.name = text(json, "name");
  const std::string form = json.contains("form") ? text(json, "form") : "bezier";
  if (form != "bezier" && form != "monomial" && form != "q-bezier")
    refuse("\"form\" is bezier, monomial or q-bezier, not \"" + form + "\"");
  const std::string kind = text(json, "kind");
  if (kind == "curve")
    read_curve(json, form, net);
  else if (kind == "patch")
    read_patch(json, form, net);
  else if (kind == "triangle")
    read_triangle(json, form, net);
  else
    refuse("\"kind\" is curve, patch or triangle, not \"" + kind + "\"");
  return net;
}

Json parsed(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) refuse(file.string() + ": it is a folder");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(file.string() + ": there is no such file, or it cannot be read");
  const std::string all{std::istreambuf_iterator<char>(stream), {}};
  if (all.empty()) refuse(file.string() + ": the file is empty");
  if (!reports::is_nested_soundly(all))
    refuse(file.string() + ": lists in it are nested more than " +
           std::to_string(reports::kMaxNesting) + " deep");
  try {
    return Json::parse(all);
  } catch (const Json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line ..."
    const std::string what = error.what();
    refuse(file.string() + ": no JSON: " + what.substr(what.find("] ") + 2));
  }
}

}  // namespace

bool is_net_file(const std::filesystem::path& file) {
  return reports::lower_ending(file) == ".json";
}

std::vector<Net> read_nets(const std::filesystem::path& file) {
  const Json json = parsed(file);
  if (!json.is_object() || !json.contains("schema") || json["schema"] != "blossom.net/1")
    refuse(file.string() + ": its \"schema\" is not \"blossom.net/1\"");
  Json list = Json::array();
  if (json.contains("nets"))
    list = json["nets"];
  else
    list.push_back(json);
  if (!list.is_array() || list.empty()) refuse(file.string() + ": there is no net in \"nets\"");
  std::vector<Net> nets;
  for (const Json& entry : list) {
    NetSource source;
    source.file = file.string();
    source.net = static_cast<int>(nets.size()) + 1;
    nets.push_back(named(source, [&] { return read_net(entry, source); }));
  }
  return nets;
}

}  // namespace blossom::nets
