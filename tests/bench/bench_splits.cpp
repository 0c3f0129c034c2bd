// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of real models split by faces, beside BRepAlgoAPI_Splitter.
//
//   bench_splits [--seed N] [--pairs N] [--limit SECONDS] [--no-peer] [--keep FOLDER] FILE...
//
// Pairs are drawn as in bench_face_pairs; of a pair the first face is split by the second one. A
// file with exactly two faces is itself the pair. Prints a line a pair and a table for each kind.
//
//   invalid      a piece is not valid by BRepCheck_Analyzer
//   wrong area   the pieces' areas do not add up to that of the face within 1e-9 relative and what
//                its wire's gaps in the chart leave open
//   refused      a part of the intersection is left out, with the reason in the pair's line
//
// Both work in one thread, each in a process of its own with a limit of processor time; seconds
// are that thread's, the least of three runs where they are short: the first one also pays for the
// binding of libraries and for pages that the process does not have yet. The exit code tells
// whether a result of ours is invalid or its area wrong.
// --keep writes the pairs with anything to look at as BREP files.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/trim.h"
#include "tests/bench/apart.h"
#include "tests/bench/command_line.h"
#include "tests/bench/face_pairs_draw.h"
#include "tests/bench/face_pairs_oracle.h"
#include "tests/support/models.h"

namespace blossom::bench {
namespace {

constexpr double kAreaError = 1e-9;  // relative
constexpr int kRuns = 3;
constexpr double kShort = 0.1;  // seconds

// Of one side; plain values, so that it can be passed between processes.
struct Split {
  Ending ending = Ending::Died;
  Status status = Status::Complete;
  double seconds = 0;
  int pieces = 0;
  bool valid = true;
  double off = 0;      // of the areas' sum, relative to the area
  double allowed = 0;  // of that, for gaps of the wire
  std::array<char, 1000> refused{};

  bool wrong_area() const { return !(off <= kAreaError + allowed); }
  bool wrong() const { return ending != Ending::Done || !valid || wrong_area(); }
};

// A corner of the chart at which two coedges leave a gap may be closed in another way by a piece:
// the triangle between them is no larger than the gap and the vertex's tolerance allow.
double gap_area(const TopoDS_Face& face) {
  const FaceTrims trims = occt::face_trims(face);
  double tolerance = BRep_Tool::Tolerance(face);
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(face, TopAbs_VERTEX, vertices);
  for (int i = 1; i <= vertices.Extent(); ++i)
    tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Vertex(vertices(i))));
  return static_cast<double>(trims.corners.size()) * trims.largest_gap *
         (trims.largest_gap + tolerance);
}

void judge(const TopoDS_Face& face, const std::vector<TopoDS_Face>& pieces, Split& split) {
  split.pieces = static_cast<int>(pieces.size());
  double sum = 0;
  for (const TopoDS_Face& piece : pieces) {
    split.valid = split.valid && BRepCheck_Analyzer(piece).IsValid();
    sum += occt::area(piece);
  }
  const double whole = occt::area(face);
  split.off = std::abs(sum - whole) / whole;
  split.allowed = gap_area(face) / whole;
}

// What leaves out nothing that would divide the face or lie on it.
bool is_harmless(const std::string& note) {
  for (const char* word :
       {"runs along an edge", "lies outside of the trims", "repeats another", "is imprinted"})
    if (note.find(word) != std::string::npos) return true;
  return false;
}

Split by_blossom(const FacePair& faces, const PairSettings& settings) {
  const double size = std::min(size_of(faces.a), size_of(faces.b));
  occt::TrimOptions options;
  options.intersection.tolerances.point = std::max(1e-7, 1e-7 * size);
  options.intersection.time_limit = settings.limit;
  options.intersection.threads = 1;
  Split split;
  const double start = thread_seconds();
  const occt::TrimResult made = occt::trim({{1, faces.a}}, {{{faces.b}, {}}}, options);
  split.seconds = thread_seconds() - start;
  split.status = made.status;
  std::string refused;
  for (const std::string& note : made.notes)
    if (!is_harmless(note)) refused += (refused.empty() ? "" : "; ") + note;
  refused.copy(split.refused.data(), split.refused.size() - 1);
  std::vector<TopoDS_Face> pieces;
  for (const occt::TrimPiece& piece : made.pieces) pieces.push_back(piece.shape);
  judge(faces.a, pieces, split);
  return split;
}

Split by_occt(const FacePair& faces) {
  Split split;
  TopTools_ListOfShape parts, tools;
  parts.Append(faces.a);
  tools.Append(faces.b);
  const double start = thread_seconds();
  BRepAlgoAPI_Splitter splitter;
  splitter.SetArguments(parts);
  splitter.SetTools(tools);
  splitter.SetRunParallel(false);
  splitter.Build();
  split.seconds = thread_seconds() - start;
  TopTools_IndexedMapOfShape pieces;
  TopExp::MapShapes(splitter.Shape(), TopAbs_FACE, pieces);
  std::vector<TopoDS_Face> faces_made;
  for (int i = 1; i <= pieces.Extent(); ++i) faces_made.push_back(TopoDS::Face(pieces(i)));
  judge(faces.a, faces_made, split);
  split.valid = split.valid && BRepCheck_Analyzer(splitter.Shape()).IsValid();
  return split;
}

Split quickest(const std::function<Split()>& work) {
  Split split = work();
  for (int i = 1; i < kRuns && split.seconds < kShort; ++i)
    split.seconds = std::min(split.seconds, work().seconds);
  return split;
}

// Integration of what either side made costs time as well.
Split measured(const PairSettings& settings, const std::function<Split()>& work) {
  Split split;
  const Ending ending = apart<Split>(3 * settings.limit, split, [&] { return quickest(work); });
  if (ending != Ending::Done) split = {};
  split.ending = ending != Ending::Done           ? ending
                 : split.seconds > settings.limit ? Ending::OutOfTime
                                                  : Ending::Done;
  return split;
}

struct Both {
  Split ours, theirs;
};

// One row of the table.
struct Summary {
  int jobs = 0, divided = 0, untouched = 0, invalid = 0, wrong_area = 0, refused = 0, stopped = 0;
  int out_of_time = 0, died = 0, other_count = 0;
  int their_divided = 0, their_invalid = 0, their_wrong_area = 0, their_out_of_time = 0;
  std::vector<double> seconds, their_seconds;

  void add(const Both& both) {
    const auto& [ours, theirs] = both;
    const bool done = ours.ending == Ending::Done, peer_done = theirs.ending == Ending::Done;
    ++jobs;
    divided += done && ours.pieces > 1;
    untouched += done && ours.pieces == 1 && ours.refused[0] == 0;
    invalid += done && !ours.valid;
    wrong_area += done && ours.wrong_area();
    refused += done && ours.refused[0] != 0;
    stopped += done && ours.status == Status::Stopped;
    out_of_time += ours.ending == Ending::OutOfTime;
    died += ours.ending == Ending::Died;
    other_count += done && peer_done && ours.pieces != theirs.pieces;
    their_divided += peer_done && theirs.pieces > 1;
    their_invalid += peer_done && !theirs.valid;
    their_wrong_area += peer_done && theirs.wrong_area();
    their_out_of_time += !peer_done;
    if (done) seconds.push_back(ours.seconds);
    if (peer_done) their_seconds.push_back(theirs.seconds);
  }
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string words(const Split& split) {
  if (split.ending == Ending::OutOfTime) return "OUT OF TIME";
  if (split.ending == Ending::Died) return "DIED";
  char text[100];
  std::snprintf(text, sizeof text, "%2d pieces off %.1e (gaps %.0e) %8.4f s", split.pieces,
                split.off, split.allowed, split.seconds);
  return std::string(text) + (split.valid ? "" : " INVALID") +
         (split.wrong_area() ? " WRONG AREA" : "") +
         (split.status == Status::Stopped ? " STOPPED" : "");
}

void print(const std::string& name, const FacePair& faces, std::size_t number, const Both& both,
           bool peer) {
  std::printf("%-18s %s %2zu  %s", name.c_str(), faces.kind.c_str(), number,
              words(both.ours).c_str());
  if (peer) std::printf("  Splitter: %s", words(both.theirs).c_str());
  if (both.ours.refused[0] != 0) std::printf("  REFUSED: %s", both.ours.refused.data());
  std::printf("\n");
  std::fflush(stdout);
}

std::vector<FacePair> pairs_of(const std::string& file, const PairSettings& settings) {
  const occt::Model model = testing::repaired_model(file);
  if (model.face_count() == 2) return {{"--", model.face(1), model.face(2)}};
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (int i = 1; i <= model.face_count(); ++i) builder.Add(all, model.face(i));
  return draw_pairs(all, settings.seed, settings.pairs);
}

void run_file(const std::string& file, const PairSettings& settings,
              std::map<std::string, Summary>& table) {
  const std::string name = std::filesystem::path(file).stem();
  const std::vector<FacePair> pairs = pairs_of(file, settings);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Both both;
    both.ours = measured(settings, [&] { return by_blossom(pairs[i], settings); });
    if (settings.peers) both.theirs = measured(settings, [&] { return by_occt(pairs[i]); });
    print(name, pairs[i], i, both, settings.peers);
    const bool other = settings.peers && both.theirs.ending == Ending::Done &&
                       both.theirs.pieces != both.ours.pieces;
    if (!settings.keep.empty() && (both.ours.wrong() || both.ours.refused[0] != 0 || other ||
                                   both.ours.status == Status::Stopped))
      keep(settings.keep, name, pairs[i], i);
    table[pairs[i].kind].add(both);
    table["all"].add(both);
  }
}

void print_table(const std::map<std::string, Summary>& table) {
  std::printf("\n%-4s | %4s %7s %9s %7s %6s %7s %7s %7s %4s %9s | %7s %7s %6s %7s %9s | %6s %s\n",
              "kind", "jobs", "divided", "untouched", "invalid", "area", "refused", "stopped",
              "overdue", "died", "median s", "divided", "invalid", "area", "overdue", "median s",
              "ratio", "other count");
  for (const char* kind : {"nb", "c1", "c2", "c3", "--", "all"}) {
    const auto row = table.find(kind);
    if (row == table.end()) continue;
    const Summary& s = row->second;
    const double own = median(s.seconds), peer = median(s.their_seconds);
    std::printf(
        "%-4s | %4d %7d %9d %7d %6d %7d %7d %7d %4d %9.4f | %7d %7d %6d %7d %9.4f | %6.2f %d\n",
        kind, s.jobs, s.divided, s.untouched, s.invalid, s.wrong_area, s.refused, s.stopped,
        s.out_of_time, s.died, own, s.their_divided, s.their_invalid, s.their_wrong_area,
        s.their_out_of_time, peer, own > 0 ? peer / own : 0, s.other_count);
  }
}

int run_all(const PairSettings& settings) {
  std::printf("seed %llu, %d pairs of a kind and file\n",
              static_cast<unsigned long long>(settings.seed), settings.pairs);
  std::map<std::string, Summary> table;
  for (const std::string& file : settings.files) run_file(file, settings, table);
  print_table(table);
  const Summary& all = table["all"];
  return all.invalid + all.wrong_area + all.died > 0 ? 1 : 0;
}

}  // namespace
}  // namespace blossom::bench

int main(int argc, char** argv) {
  using namespace blossom::bench;
  return run_command(pair_settings({.limit = 15, .peers = true}, "--no-peer", argc, argv),
                     "bench_splits [--seed N] [--pairs N] [--limit SECONDS] [--no-peer] "
                     "[--keep FOLDER] FILE...",
                     run_all);
}
