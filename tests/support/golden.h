// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads the exact reference data below tests/data: fractions "p/q", points [x, y, z].

#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/exact.h"

namespace blossom::testing {

using Json = nlohmann::json;
using ExactPoint = Vec<Rational, 3>;

inline Json read_golden(const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(BLOSSOM_TEST_FILES) / name;
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("no test data: " + file.string());
  return Json::parse(stream);
}

inline Rational number(const Json& fraction) { return Rational(fraction.get<std::string>()); }

inline ExactPoint point(const Json& values) {
  return {number(values.at(0)), number(values.at(1)), number(values.at(2))};
}

inline std::vector<ExactPoint> points(const Json& list) {
  std::vector<ExactPoint> result;
  for (const Json& values : list) result.push_back(point(values));
  return result;
}

inline Grid<ExactPoint> net(const Json& rows) {
  Grid<ExactPoint> result(static_cast<int>(rows.size()), static_cast<int>(rows.at(0).size()));
  for (int i = 0; i < result.rows(); ++i)
    for (int j = 0; j < result.columns(); ++j)
      result(i, j) = point(rows.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j)));
  return result;
}

inline std::vector<Rational> numbers(const Json& list) {
  std::vector<Rational> result;
  for (const Json& value : list) result.push_back(number(value));
  return result;
}

inline Vec<Rational, 2> parameters(const Json& pair) {
  return {number(pair.at(0)), number(pair.at(1))};
}

inline std::array<Vec<Rational, 2>, 3> corners(const Json& triangle) {
  return {parameters(triangle.at("a")), parameters(triangle.at("b")), parameters(triangle.at("c"))};
}

inline double rounded(const Rational& value) { return value.convert_to<double>(); }

template <int Dim>
std::vector<Vec<double, Dim>> rounded(const std::vector<Vec<Rational, Dim>>& points) {
  std::vector<Vec<double, Dim>> result;
  for (const auto& exact_point : points) result.push_back(rounded(exact_point));
  return result;
}

template <int Dim>
Grid<Vec<double, Dim>> rounded(const Grid<Vec<Rational, Dim>>& net) {
  Grid<Vec<double, Dim>> result(net.rows(), net.columns());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) result(i, j) = rounded(net(i, j));
  return result;
}

inline std::vector<double> rounded(const std::vector<Rational>& values) {
  std::vector<double> result;
  for (const Rational& value : values) result.push_back(rounded(value));
  return result;
}

template <std::size_t Count>
std::array<Vec2, Count> rounded(const std::array<Vec<Rational, 2>, Count>& points) {
  std::array<Vec2, Count> result;
  for (std::size_t k = 0; k < Count; ++k) result[k] = rounded(points[k]);
  return result;
}

}  // namespace blossom::testing
