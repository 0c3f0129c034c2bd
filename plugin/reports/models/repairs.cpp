// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/repairs.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <sstream>

#include "core/base/tolerances.h"

namespace blossom::reports {
namespace {

constexpr std::size_t kListed = 10;

// Two figures tell how much.
std::string length_text(double length) {
  std::ostringstream text;
  text << std::setprecision(2) << length;
  return text.str();
}

// "(1.2, -3, 0)", to six digits.
std::string corner_of(const Vec3& place) {
  std::ostringstream text;
  text << "(" << place[0] << ", " << place[1] << ", " << place[2] << ")";
  return text.str();
}

std::size_t added_count(const occt::Repairs& repairs) {
  return static_cast<std::size_t>(
      std::ranges::count_if(repairs.missing, &occt::Repairs::MissingCurve::added));
}

// "title: first, second, and 3 more", to a list of lines; nothing if there are none.
template <class Members, class Words>
void add_line(const std::string& title, const Members& members, const Words& words_of,
              std::vector<std::string>& lines) {
  if (members.empty()) return;
  std::string line = title;
  for (std::size_t i = 0; i < std::min(members.size(), kListed); ++i)
    line += (i == 0 ? ": " : ", ") + words_of(members[i]);
  if (members.size() > kListed)
    line += ", and " + std::to_string(members.size() - kListed) + " more";
  lines.push_back(std::move(line));
}

std::string place_of(int face, int edge) {
  return "edge " + std::to_string(edge) + " on face " + std::to_string(face);
}

}  // namespace

std::string summary_of(const occt::Repairs& repairs) {
  std::vector<std::string> parts;
  if (const std::size_t remade = repairs.remade.size(); remade > 0)
    parts.push_back(counted(remade, "parameter curve") + " recomputed (up to " +
                    length_text(repairs.largest_gap()) + " mm)");
  if (const std::size_t raised = repairs.edges.size() + repairs.vertices.size(); raised > 0) {
    const std::string noun = raised == 1 ? " tolerance" : " tolerances";
    parts.push_back(std::to_string(raised) + noun + " raised (up to " +
                    length_text(repairs.largest_tolerance()) + " mm)");
  }
  const std::size_t added = added_count(repairs), missing = repairs.missing.size() - added;
  if (added > 0) parts.push_back(counted(added, "missing parameter curve") + " made");
  if (missing > 0)
    parts.push_back(counted(missing, "missing parameter curve") + " could not be made");
  if (!repairs.failed.empty())
    parts.push_back(counted(repairs.failed.size(), "face") + " used without repairs, which fail");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::vector<std::string> details_of(const occt::Repairs& repairs) {
  std::vector<std::string> lines;
  const auto raised = [](const occt::Repairs::RaisedTolerance& each) {
    return std::to_string(each.number) + " (" + length_text(each.tolerance) + ")";
  };
  add_line(
      "parameter curves recomputed", repairs.remade,
      [](const occt::Repairs::RemadeCurve& each) {
        return place_of(each.face, each.edge) + " (" + length_text(each.gap) + ")";
      },
      lines);
  add_line("tolerances raised of edges", repairs.edges, raised, lines);
  add_line("tolerances raised of vertices", repairs.vertices, raised, lines);
  add_line(
      "parameter curves missing", repairs.missing,
      [](const occt::Repairs::MissingCurve& each) {
        return place_of(each.face, each.edge) + (each.added ? "" : " (not made)");
      },
      lines);
  add_line(
      "repairs fail of faces", repairs.failed, [](int face) { return std::to_string(face); },
      lines);
  return lines;
}

std::vector<std::string> words_of(const occt::Sewing& sewing, const std::string& way) {
  std::vector<std::string> lines;
  const auto number = [](int count) { return static_cast<std::size_t>(count); };
  if (!sewing.solids.empty()) {
    const bool apart = sewing.gap > Tolerances{}.point;
    lines.push_back(counted(number(sewing.sewn()), "loose face") + " sewn into " +
                    counted(sewing.solids.size(), "solid") +
                    (apart ? ", gaps up to " + length_text(sewing.gap) : ", without gaps"));
    if (sewing.renumbered)
      lines.back() += "; those of several solids took turns and have new numbers";
  }
  if (!sewing.failed.empty())
    lines.push_back(std::string(sewing.solids.empty() ? "its" : "the other") +
                    " loose faces stay loose: " + sewing.failed);
  if (sewing.open_edges > 0) {
    const std::size_t left = number(sewing.loose - sewing.sewn());
    lines.push_back(counted(left, "loose face") + (left == 1 ? " closes" : " close") +
                    " no solid: " + counted(number(sewing.open_edges), "edge") +
                    " open, the first at " + corner_of(sewing.open_at) + "; " + way +
                    " T joins across gaps up to T");
  }
  return lines;
}

Json repairs_json(const Input& input) {
  const occt::Repairs& repairs = input.repairs;
  const std::size_t added = added_count(repairs);
  return {
      {"input", input.name},
      {"curves_recomputed",
       {{"count", repairs.remade.size()}, {"largest_gap", repairs.largest_gap()}}},
      {"tolerances_raised",
       {{"edges", repairs.edges.size()},
        {"vertices", repairs.vertices.size()},
        {"largest", repairs.largest_tolerance()}}},
      {"curves_added", added},
      {"curves_missing", repairs.missing.size() - added},
      {"faces_not_repaired", repairs.failed},
      {"sewn",
       {{"loose_faces", input.sewing.loose},
        {"faces", input.sewing.sewn()},
        {"solids", input.sewing.solids.size()},
        {"largest_gap", input.sewing.gap},
        {"within", input.sewing.within},
        {"open_edges", input.sewing.open_edges},
        {"open_at", input.sewing.open_edges > 0 ? Json(input.sewing.open_at.coordinates) : Json()},
        {"failed", input.sewing.failed.empty() ? Json() : Json(input.sewing.failed)}}}};
}

}  // namespace blossom::reports
