// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs solvers over a folder of certified cases and writes their answers for its scorer.

#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>

namespace blossom::bench {

using Point = std::array<double, 3>;

struct SampledCurve {
  bool closed = false;
  bool tangential = false;
  std::vector<Point> points;  ///< model units; a closed curve repeats its first point
};

struct Answer {
  std::vector<SampledCurve> curves;
  std::vector<Point> points;
  std::vector<std::vector<Point>> overlaps;  ///< the border of each
  std::string status = "ok";
  std::string claim;
};

struct Pair {
  TopoDS_Face a, b;
  double size = 0;       ///< diagonal of the larger surface's box, model units
  double tolerance = 0;  ///< model units
};

/// One program or setting under test. `prepare` turns faces into the solver's own input and is not
/// timed, `solve` is timed, `answer` samples what the last solve() found.
struct Solver {
  std::string name;
  std::function<void(const Pair&)> prepare;
  std::function<void()> solve;
  std::function<Answer()> answer;
};

/// Arguments: CASES_FOLDER OUT_FOLDER [--limit SECONDS] [--only PREFIX]. Every solver meets every
/// case in a process of its own, one after the other, so that all see the same machine. Writes
/// OUT_FOLDER/<solver>.jsonl; `seconds` is the median of five calls, or of as many as take
/// 30 ms together (of one above 0.2 s), `seconds_first` the first call's.
/// returns   the exit code of the program
int run_cases(int argc, char** argv, const std::vector<Solver>& solvers);

}  // namespace blossom::bench
