// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/intersection_parts.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>
#include <vector>

#include "adapters/occt/faces/area.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/intersection_model.h"
#include "plugin/cli/output.h"
#include "plugin/cli/picture/picture.h"
#include "plugin/cli/progress.h"
#include "plugin/cli/reading.h"
#include "plugin/cli/stages.h"
#include "plugin/cli/values.h"
#include "plugin/cli/verbosity.h"

namespace blossom::cli {
namespace {

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

struct Counts {
  std::size_t curves = 0;
  std::size_t closed = 0;
  std::size_t points = 0;
  std::size_t nodes = 0;
  std::size_t overlaps = 0;
  double overlap_area = 0;
  std::size_t contacts = 0;
  std::size_t unresolved = 0;

  bool any() const { return curves + points + overlaps + contacts > 0; }
};

double area_of(const Input& a, const occt::FaceIntersection& pair, const Overlap& overlap) {
  const TopoDS_Face& face = a.faces[static_cast<std::size_t>(pair.face_a)];
  if (!pair.equal_edges.empty() || overlap.boundary.empty()) return occt::area(face);
  std::vector<Vec2> polygon;
  for (const SurfacePoint& point : overlap.boundary) polygon.push_back(point.uv_a);
  return occt::polygon_area(face, polygon);
}

Counts counts_of(const Input& a, const occt::ShapeIntersection& found) {
  Counts counts;
  for (const occt::FaceIntersection& pair : found.pairs) {
    counts.curves += pair.chains.size();
    counts.closed +=
        static_cast<std::size_t>(std::ranges::count_if(pair.chains, &CurveChain::closed));
    counts.points += pair.found.points.size();
    counts.nodes += pair.found.nodes.size();
    counts.overlaps += pair.found.overlaps.size();
    for (const Overlap& overlap : pair.found.overlaps)
      counts.overlap_area += area_of(a, pair, overlap);
    for (const Place& place : pair.found.places) {
      if (reports::is_contact(place) ||
          (place.kind == PlaceKind::Overlap && pair.found.overlaps.empty()))
        ++counts.contacts;
      if (place.kind == PlaceKind::Open) ++counts.unresolved;
    }
  }
  return counts;
}

const char* words_of(PlaceKind kind) {
  switch (kind) {
    case PlaceKind::Touch: return "touching in a point";
    case PlaceKind::Node: return "branches crossing";
    case PlaceKind::Cusp: return "a curve turning back";
    case PlaceKind::Pole: return "contact at a pole";
    case PlaceKind::Tangential: return "touching along a curve";
    case PlaceKind::Overlap: return "coinciding over an area";
    case PlaceKind::Open: break;
  }
  return "unresolved";
}

// "3 curves (1 closed), 1 overlap of about 20.5 mm²"; what there is none of is left out.
std::string counts_text(const Counts& counts) {
  std::ostringstream text;
  const auto item = [&text](std::size_t count, const char* noun) -> std::ostream& {
    return text << (text.tellp() > 0 ? ", " : "") << counted(count, noun);
  };
  if (counts.curves > 0) item(counts.curves, "curve") << " (" << counts.closed << " closed)";
  if (counts.points > 0) item(counts.points, "point");
  if (counts.nodes > 0) item(counts.nodes, "branching point");
  if (counts.overlaps > 0)
    item(counts.overlaps, "overlap")
        << " of about " << number_text(rounded(counts.overlap_area)) << " mm²";
  if (counts.contacts > 0) item(counts.contacts, "contact") << " within tolerance";
  if (counts.unresolved > 0) item(counts.unresolved, "unresolved region");
  return text.tellp() > 0 ? text.str() : "no curve and no point";
}

class Names {
 public:
  Names(const Input& a, const Input& b) : a_(a), b_(b), labels_a_(a), labels_b_(b) {}

  // "face 12 (Bolt) x face 3 (Plate)"; one face for one with itself.
  std::string of(const occt::FaceIntersection& pair) const {
    const int face_a = a_.numbers[static_cast<std::size_t>(pair.face_a)];
    const int face_b = b_.numbers[static_cast<std::size_t>(pair.face_b)];
    const bool itself = &a_ == &b_ && face_a == face_b;
    return labels_a_.of(face_a) + (itself ? "" : " x " + labels_b_.of(face_b));
  }

 private:
  const Input& a_;
  const Input& b_;
  FaceLabels labels_a_, labels_b_;
};

std::string curve_line(const occt::FaceIntersection& pair, const CurveChain& chain) {
  const reports::ChainFacts facts = reports::facts_of(pair.found.curves, chain);
  const Deviation& d = facts.deviation;
  std::ostringstream text;
  text << (chain.closed ? "closed" : "open") << (facts.tangential ? ", tangential" : "")
       << ", length " << number_text(rounded(facts.length)) << ", degree " << facts.degree << ", "
       << counted(facts.poles, "pole") << ", deviation "
       << number_text(rounded(std::max({d.a, d.b, d.between})));
  return text.str();
}

std::string place_line(const Place& place) {
  const Vec3 centre = (place.box_low + place.box_high) * 0.5;
  std::string at;
  for (int k = 0; k < 3; ++k) at += (k > 0 ? ", " : "") + number_text(rounded(centre[k]));
  return std::string(words_of(place.kind)) + " near (" + at + "), " +
         number_text(rounded(distance(place.box_low, place.box_high))) + " across, gap " +
         number_text(rounded(place.gap_low)) + " to " + number_text(rounded(place.gap_high));
}

// Places can be very many.
void list_places(const Names& names, const occt::ShapeIntersection& found, std::ostream& text) {
  constexpr std::size_t kFew = 20;
  std::vector<std::string> lines;
  for (const occt::FaceIntersection& pair : found.pairs)
    for (const Place& place : pair.found.places)
      lines.push_back("  " + names.of(pair) + ": " + place_line(place) + "\n");
  const bool all = verbosity() == Verbosity::Verbose || lines.size() <= kFew;
  for (std::size_t i = 0; i < (all ? lines.size() : kFew); ++i) text << lines[i];
  if (!all) text << "  and " << lines.size() - kFew << " more such places, which -v lists\n";
}

std::string summary(const Input& a, const Input& b, const std::string& title, const Counts& counts,
                    const TimedIntersection& result) {
  std::ostringstream text;
  text << title << ": ";
  if (&a == &b) text << reports::verdict_of(result.found) << ", ";
  text << to_string(stated(result.found.status)) << ", " << counts_text(counts) << ", "
       << number_text(rounded(result.times.seconds)) << " s\n";
  const Names names(a, b);
  for (const occt::FaceIntersection& pair : result.found.pairs)
    for (const CurveChain& chain : pair.chains)
      text << "  " << names.of(pair) << ": " << curve_line(pair, chain) << "\n";
  list_places(names, result.found, text);
  for (const std::string& reason : result.found.certificate.reasons) text << "  " << reason << "\n";
  return text.str();
}

Picture picture_of(const Input& a, const Input& b, const occt::ShapeIntersection& found) {
  Picture picture;
  picture.groups = {{a.faces, kFirstColour, &a == &b ? kSecondOpacity : kFirstOpacity}};
  if (&a != &b) picture.groups.push_back({b.faces, kSecondColour, kSecondOpacity});
  for (const occt::FaceIntersection& pair : found.pairs) {
    for (const IntersectionCurve& curve : pair.found.curves) {
      picture.curves.emplace_back();
      for (const SurfacePoint& sample : curve.samples)
        picture.curves.back().push_back(sample.point);
    }
    for (const auto* points : {&pair.found.points, &pair.found.nodes})
      for (const SurfacePoint& point : *points) picture.points.push_back(point.point);
  }
  return picture;
}

}  // namespace

void add_intersect_options(CLI::App& command, IntersectOptions& options) {
  add_common_options(command, options.common, "write the edges (.step, .brep, .iges)");
  add_fail_on(command, options.common);
  add_engine_options(command, options.engine);
  command.add_option("--repeat", options.repeat, "do it N times and report the median time")
      ->check(whole_number(1, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
}

namespace {

// What each pair of faces cost that has something to tell, and all of them together.
void log_pairs(const occt::ShapeIntersection& found) {
  const auto cells = [](const Certificate& certificate) {
    return certificate.cells_bezier + certificate.cells_monomial;
  };
  for (const occt::FaceIntersection& pair : found.pairs)
    log_line({{"pair", {pair.face_a + 1, pair.face_b + 1}},
              {"status", to_string(pair.found.status)},
              {"cells", cells(pair.found.certificate)},
              {"curves", pair.found.curves.size()}});
  log_line({{"pairs", found.face_pairs},
            {"status", to_string(found.status)},
            {"cells", cells(found.certificate)}});
}

}  // namespace

TimedIntersection timed_intersection(
    const IntersectOptions& options,
    const std::function<occt::ShapeIntersection(const IntersectionOptions&)>& intersect) {
  Progress progress("intersecting");
  const IntersectionOptions engine = intersection_options(options.engine, progress);
  TimedIntersection result;
  std::vector<double> seconds;
  for (int i = 0; i < options.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    result.found = intersect(engine);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    stop_if_interrupted();
    seconds.push_back(took.count());
  }
  log_pairs(result.found);
  result.times = {median(seconds), seconds.front()};
  return result;
}

int write_outputs(const Input& a, const Input& b, const std::string& title,
                  const TimedIntersection& result, const CommonOptions& options) {
  // All that may fail or be interrupted comes before the first file is written.
  const Counts counts = counts_of(a, result.found);
  std::optional<occt::Model> model;
  const bool unwritten = !options.output.empty() && counts.curves + counts.points == 0;
  if (!options.output.empty() && !unwritten) model = intersection_model(a, b, result.found);
  std::string png;
  if (!options.picture.empty()) png = picture_png(picture_of(a, b, result.found));
  stop_if_interrupted();

  if (model) write_model(*model, options.output);
  if (unwritten) tell_unwritten(options.output, "no curve and no point was found");
  if (!options.picture.empty()) occt::write_text(png, options.picture);
  if (!options.json.empty()) {
    write_json(&a == &b ? reports::self_intersection_report(a, result.found, result.times)
                        : reports::intersection_report(a, b, result.found, result.times),
               options.json);
  }
  print_summary(summary(a, b, title, counts, result), options.json);
  return exit_code(exit_code(result.found.status), findings_of(counts.any()), options);
}

}  // namespace blossom::cli
