// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/check/continuity_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

#include "plugin/cli/arguments/values.h"
#include "plugin/cli/arguments/vectors.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/verbosity.h"

namespace blossom::cli {
namespace {

using occt::EdgeContinuity;
using occt::EdgeRole;
using reports::angle_text;
using reports::edge_line;
using reports::edge_text;
using reports::folds_back;
using reports::is_sharp;
using reports::is_smooth;
using reports::short_text;

/// Edges named one by one in a summary; more are counted, and all of them in the report.
constexpr std::size_t kNamed = 12;

std::string place_text(const EdgeContinuity& edge, const LargestFound& found) {
  const Vec3& p = found.point;
  return edge_text(edge) + " at " + vector_text({rounded(p[0]), rounded(p[1]), rounded(p[2])});
}

/// How much is known: the bound, or how many places were looked at.
std::string certainty_text(const EdgeContinuity& edge, double ContinuityBounds::*member) {
  if (edge.bounds && std::isfinite((*edge.bounds).*member))
    return "at most " + short_text((*edge.bounds).*member);
  return "found at " + std::to_string(edge.found->samples) + " samples and their largest refined";
}

/// A figure of edges and the edge that has most of it, or least.
struct Extreme {
  const EdgeContinuity* edge = nullptr;
  double value = 0;
};

template <class Take, class Value>
Extreme largest_of(const ContinuityReport& report, const Take& take, const Value& value) {
  Extreme most;
  for (const EdgeContinuity& edge : report.edges)
    if (take(edge) && (most.edge == nullptr || value(edge) > most.value))
      most = {&edge, value(edge)};
  return most;
}

void add_gap(const ContinuityReport& report, std::ostringstream& text) {
  const Extreme gap = largest_of(
      report, [](const EdgeContinuity& e) { return e.found.has_value(); },
      [](const EdgeContinuity& e) { return e.found->gap.value; });
  if (gap.edge == nullptr) return;
  text << "  largest gap " << short_text(gap.value) << " mm ("
       << certainty_text(*gap.edge, &ContinuityBounds::gap)
       << "): " << place_text(*gap.edge, gap.edge->found->gap) << "\n";
}

void add_angles(const ContinuityReport& report, std::ostringstream& text) {
  const auto angle = [](const EdgeContinuity& e) { return e.found->angle.value; };
  if (const Extreme most = largest_of(report, is_smooth, angle); most.edge != nullptr)
    text << "  largest angle of G1 and G2 edges " << angle_text(most.value) << " ("
         << certainty_text(*most.edge, &ContinuityBounds::angle)
         << "): " << place_text(*most.edge, most.edge->found->angle) << "\n";
  const Extreme least =
      largest_of(report, is_sharp, [&](const EdgeContinuity& e) { return -angle(e); });
  if (least.edge == nullptr) return;
  const Extreme most = largest_of(report, is_sharp, angle);
  text << "  sharp edges turn by " << angle_text(-least.value);
  if (most.edge == least.edge) {
    text << ": " << place_text(*least.edge, least.edge->found->angle) << "\n";
    return;
  }
  text << " at least: " << place_text(*least.edge, least.edge->found->angle) << "\n    and by "
       << angle_text(most.value) << " at most: " << place_text(*most.edge, most.edge->found->angle)
       << "\n";
}

std::string numbers_text(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), kNamed); ++i)
    text += " " + std::to_string(numbers[i]);
  return text + (numbers.size() > kNamed ? " ... (--json lists all)" : "");
}

void add_folds(const ContinuityReport& report, std::ostringstream& text) {
  std::vector<int> numbers;
  for (const EdgeContinuity& edge : report.edges)
    if (folds_back(edge)) numbers.push_back(edge.number);
  if (!numbers.empty())
    text << "  " << counted(numbers.size(), "edge")
         << " where a face folds back on the other or is turned over:" << numbers_text(numbers)
         << "\n";
}

void add_curvatures(const ContinuityReport& report, std::ostringstream& text) {
  const auto value = [](const EdgeContinuity& e) { return e.found->curvature.value; };
  for (const Smoothness of : {Smoothness::G1, Smoothness::G2}) {
    const Extreme most = largest_of(
        report, [&](const EdgeContinuity& e) { return e.found && e.smoothness == of; }, value);
    if (most.edge == nullptr) continue;
    text << "  largest difference of curvature of " << to_string(of) << " edges "
         << short_text(100 * most.value) << " % (" << short_text(most.edge->found->difference.value)
         << " / mm; " << certainty_text(*most.edge, &ContinuityBounds::curvature)
         << "): " << place_text(*most.edge, most.edge->found->curvature) << "\n";
  }
}

/// "3 open edges, 1 non-manifold edge"; empty if there are none.
std::string others_text(const ContinuityReport& report) {
  std::string text;
  for (const EdgeRole kind :
       {EdgeRole::Open, EdgeRole::NonManifold, EdgeRole::Degenerate, EdgeRole::Inner})
    if (const std::size_t count = report.count(kind); count > 0)
      text += (text.empty() ? "" : ", ") + counted(count, std::string(to_string(kind)) + " edge");
  return text;
}

void add_exceptions(const ContinuityReport& report, std::ostringstream& text) {
  if (const std::string others = others_text(report); !others.empty())
    text << "  not compared: " << others << "\n";
  const auto unmeasured = report.unmeasured();
  for (std::size_t i = 0; i < std::min(unmeasured.size(), kNamed); ++i)
    text << "  " << edge_text(*unmeasured[i]) << " cannot be measured: " << unmeasured[i]->problem
         << "\n";
  if (unmeasured.size() > kNamed)
    text << "  and " << counted(unmeasured.size() - kNamed, "edge") << " more; --json lists all\n";
  const std::vector<int> failing = report.failing();
  const std::string& require = report.require;
  if (!require.empty() && failing.empty())
    text << "  no edge is less than " << require << "\n";
  else if (!failing.empty())
    text << "  less than " << (require.empty() ? "G0" : require) << ": "
         << counted(failing.size(), "edge") << "," << numbers_text(failing) << "\n";
}

std::string head_text(const std::string& name, const ContinuityReport& report) {
  const std::size_t all = report.count(EdgeRole::Shared) + report.count(EdgeRole::Seam);
  std::ostringstream text;
  text << name << ": " << counted(all, "edge") << " between faces";
  if (const std::size_t seams = report.count(EdgeRole::Seam); seams > 0)
    text << " (" << counted(seams, "seam") << " among them)";
  const char* separator = ": ";
  const auto add = [&](std::size_t count, const std::string& what) {
    if (count == 0) return;
    text << separator << count << " " << what;
    separator = ", ";
  };
  add(report.count("apart"), "apart");
  add(report.count("G0"), "sharp (G0)");
  add(report.count("G1"), "G1");
  add(report.count("G2"), "G2");
  add(report.unmeasured().size(), "not measured");
  text << "\n";
  if (all == 0) {
    text << "  no two faces share an edge: there is nothing to compare\n";
    return text.str();
  }
  const ContinuityTolerances& within = report.tolerances;
  text << "  within gap " << short_text(within.gap) << " mm, angle " << angle_text(within.angle)
       << ", curvature " << short_text(100 * within.curvature) << " %; proven for "
       << report.proven() << " of " << all << "\n";
  return text.str();
}

}  // namespace

std::string continuity_text(const std::string& name, const ContinuityReport& report,
                            bool has_picture) {
  std::ostringstream text;
  text << head_text(name, report);
  add_gap(report, text);
  add_angles(report, text);
  add_folds(report, text);
  add_curvatures(report, text);
  add_exceptions(report, text);
  if (has_picture)
    text << "  colours: sharp black, G1 orange, G2 green, apart purple, not compared red\n";
  if (report.table || verbosity() == Verbosity::Verbose)
    for (const EdgeContinuity& edge : report.edges) text << "  " << edge_line(edge) << "\n";
  return text.str();
}

}  // namespace blossom::cli
