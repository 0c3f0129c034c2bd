// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/trim.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <BRepCheck_Analyzer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/kept_tolerances.h"
#include "adapters/occt/base/limits.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/solid_trim.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/face_division.h"
#include "core/base/errors.h"
#include "core/results/result_places.h"

namespace blossom::occt {
namespace {

struct Judged {
  PieceSide side = PieceSide::Unknown;
  bool above = false;  ///< of all tools
  bool below = false;
};

// What became of a face of the part.
struct DividedFace {
  const PartFace* of = nullptr;
  std::vector<TopoDS_Face> pieces = {};
  std::vector<Judged> sides = {};  // one for each piece of a face that is to be cut
};

// A face of the part on its way through the work.
struct Job {
  const PartFace* of = nullptr;
  FaceDivision division;
  std::vector<std::pair<int, TopoDS_Face>> coincident = {};  // tools, and their faces
  bool failed = false;
};

std::string face_name(const PartFace& face) { return "face " + std::to_string(face.number); }

void fail(Job& job, const std::string& cause, TrimResult& result) {
  result.notes.push_back(face_name(*job.of) + ": " + cause + ", it stays whole");
  result.status = weaker(result.status, Status::Tolerance);
  job.failed = true;
  job.division.leave_whole();
}

// Runs a step of a job; what a broken face throws costs that face alone.
template <class Step>
void attempt(Job& job, TrimResult& result, Step&& step) {
  try {
    guarded("splitting " + face_name(*job.of), std::forward<Step>(step));
  } catch (const BadModel& error) {
    fail(job, error.what(), result);
  } catch (const Failure& error) {
    fail(job, error.what(), result);
  }
}

// The tools' faces in one list, with the tool that each comes from.
struct ToolFaces {
  std::vector<TopoDS_Face> faces;
  std::vector<int> tool;
};

ToolFaces all_faces(const std::vector<TrimTool>& tools) {
  ToolFaces all;
  for (std::size_t i = 0; i < tools.size(); ++i)
    for (const TopoDS_Face& face : tools[i].faces) {
      all.faces.push_back(face);
      all.tool.push_back(static_cast<int>(i));
    }
  return all;
}

void note_places(const FaceIntersection& pair, const PartFace& face, TrimResult& result) {
  for (const Place& place : pair.found.places)
    if (place.kind == PlaceKind::Open)
      result.notes.push_back(face_name(face) +
                             ": an unresolved region with a tool's face, nothing is cut there");
}

// The edges of a tool's face that lie in a face of the part, as cuts.
void add_common_border(const FaceIntersection& pair, const ToolFaces& tools, double tolerance,
                       Job& job) {
  const auto place = static_cast<std::size_t>(pair.face_b);
  const SurfaceProjector feet(job.of->face, tolerance);
  for (FaceCut& cut : edge_cuts(tools.faces[place], feet, kOnIt * tolerance, tolerance)) {
    cut.may_repeat = true;
    job.division.add_cut(std::move(cut), {tools.tool[place], tools.faces[place], {}, true});
  }
  job.coincident.emplace_back(tools.tool[place], tools.faces[place]);
}

void add_cuts(const FaceIntersection& pair, const ToolFaces& tools, Job& job, TrimResult& result) {
  const auto tool_face = static_cast<std::size_t>(pair.face_b);
  for (std::size_t i = 0; i < pair.found.curves.size(); ++i) {
    const IntersectionCurve& curve = pair.found.curves[i];
    job.division.add_cut(cut_of_a(pair, i), {tools.tool[tool_face], tools.faces[tool_face],
                                             curve.chart_b, curve.tangential});
  }
  note_places(pair, *job.of, result);
}

std::vector<Job> jobs_of(const std::vector<PartFace>& part, const std::vector<TrimTool>& tools,
                         const TrimOptions& options, TrimResult& result) {
  std::vector<Job> jobs;
  std::vector<TopoDS_Face> faces;
  std::vector<std::size_t> job_of;
  for (std::size_t i = 0; i < part.size(); ++i) {
    jobs.push_back({&part[i], FaceDivision(part[i].face)});
    if (!part[i].cut) continue;
    attempt(jobs[i], result, [&] { face_trims(part[i].face); });
    if (jobs[i].failed) continue;
    faces.push_back(part[i].face);
    job_of.push_back(i);
  }
  const ToolFaces all = all_faces(tools);
  const ShapeIntersection found = intersect(faces, all.faces, options.intersection);
  result.status = weaker(result.status, found.status);
  result.certificate = found.certificate;
  for (const FaceIntersection& pair : found.pairs)
    add_cuts(pair, all, jobs[job_of[static_cast<std::size_t>(pair.face_a)]], result);
  for (const FaceIntersection& pair : found.pairs) {
    Job& job = jobs[job_of[static_cast<std::size_t>(pair.face_a)]];
    if (has_overlap(pair.found) && !job.failed)
      attempt(job, result,
              [&] { add_common_border(pair, all, options.intersection.tolerances.point, job); });
  }
  return jobs;
}

// What the limit leaves undone is not a face that merely stays whole.
void report_limit(const std::vector<Job>& jobs, const WorkLimit& limit, TrimResult& result) {
  const bool failed =
      std::any_of(jobs.begin(), jobs.end(), [](const Job& job) { return job.failed; });
  if (failed && limit.reached_after_search() != nullptr) result.status = Status::Stopped;
}

void report_limit(const std::vector<Judged>& sides, const WorkLimit& limit, TrimResult& result) {
  const char* reason = limit.reached_after_search();
  const bool open = std::ranges::any_of(
      sides, [](const Judged& each) { return each.side == PieceSide::Unknown; });
  if (reason == nullptr || !open) return;
  result.notes.push_back(std::string("the sides of some pieces were not looked for: ") + reason);
  result.status = Status::Stopped;
}

void split_all(std::vector<Job>& jobs, const TrimOptions& options, const WorkLimit& limit,
               TrimResult& result) {
  const double tolerance = options.intersection.tolerances.point;
  const OpenCuts open = options.keep == Keep::All ? options.open_cuts : OpenCuts::LeaveOut;
  EdgeSplits splits(tolerance);
  const DivisionJob all{splits, tolerance, &limit};
  for (Job& job : jobs)
    if (!job.division.cuts().empty()) attempt(job, result, [&] { job.division.begin(all); });
  for (Job& job : jobs) attempt(job, result, [&] { job.division.settle(); });
  for (Job& job : jobs) {
    if (job.failed) continue;
    attempt(job, result, [&] { job.division.finish(all, open); });
    for (const std::string& note : job.division.split().notes)
      result.notes.push_back(face_name(*job.of) + ": " + note);
  }
}

// One answer out of those for the single tools.
PieceSide combined(const std::vector<ToolSide>& sides, bool solids) {
  const auto all = [&](ToolSide side) {
    return std::all_of(sides.begin(), sides.end(), [side](ToolSide s) { return s == side; });
  };
  const auto any = [&](ToolSide side) {
    return std::find(sides.begin(), sides.end(), side) != sides.end();
  };
  if (solids && any(ToolSide::Below)) return PieceSide::Inside;
  if (any(ToolSide::On)) return PieceSide::On;
  if (any(ToolSide::Unknown)) return PieceSide::Unknown;
  if (all(ToolSide::Above)) return solids ? PieceSide::Outside : PieceSide::Above;
  return all(ToolSide::Below) ? PieceSide::Below : PieceSide::Mixed;
}

std::vector<Judged> judged(const std::vector<Job>& jobs, const std::vector<TrimTool>& tools,
                           double tolerance, const WorkLimit& limit) {
  std::vector<SidedPiece> pieces;
  std::vector<const Job*> job_of;
  for (const Job& job : jobs)
    if (job.of->cut)
      for (const FacePiece& piece : job.division.split().pieces) {
        pieces.push_back({&piece, &job.division.cuts(), &job.division.sources()});
        job_of.push_back(&job);
      }
  std::vector<std::vector<ToolSide>> sides(pieces.size());
  for (std::size_t k = 0; k < tools.size(); ++k) {
    const std::vector<ToolSide> found = sides_of(pieces, tools[k], static_cast<int>(k), &limit);
    for (std::size_t i = 0; i < pieces.size(); ++i) sides[i].push_back(found[i]);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const auto& [tool, face] : job_of[i]->coincident)
      if (lies_on(pieces[i].piece->face, face, kOnIt * tolerance))
        sides[i][static_cast<std::size_t>(tool)] = ToolSide::On;
  const bool solids =
      std::all_of(tools.begin(), tools.end(), [](const TrimTool& tool) { return tool.is_solid(); });
  std::vector<Judged> result;
  for (const std::vector<ToolSide>& each : sides) {
    const auto count = [&](ToolSide side) {
      return static_cast<std::size_t>(std::count(each.begin(), each.end(), side));
    };
    result.push_back({combined(each, solids), count(ToolSide::Above) == each.size(),
                      count(ToolSide::Below) == each.size()});
  }
  return result;
}

bool is_kept(const Judged& judged, int number, const TrimOptions& options) {
  switch (options.keep) {
    case Keep::Above: return judged.above;
    case Keep::Below: return judged.below;
    case Keep::Inside: return judged.side == PieceSide::Inside;
    case Keep::Outside: return judged.side == PieceSide::Outside;
    case Keep::Number: return number == options.piece;
    case Keep::All: break;
  }
  return true;
}

void check_piece(const TrimPiece& piece, TrimResult& result) {
  if (!BRepCheck_Analyzer(piece.shape).IsValid()) {
    result.notes.push_back("piece " + std::to_string(piece.number) + " of face " +
                           std::to_string(piece.face) + " is not valid by BRepCheck");
    result.status = weaker(result.status, Status::Tolerance);
  }
}

std::vector<DividedFace> divided_faces(const std::vector<Job>& jobs,
                                       const std::vector<Judged>& sides) {
  std::vector<DividedFace> faces;
  std::size_t next = 0;
  for (const Job& job : jobs) {
    DividedFace& face = faces.emplace_back(DividedFace{job.of});
    for (const FacePiece& piece : job.division.split().pieces) {
      face.pieces.push_back(piece.face);
      if (job.of->cut) face.sides.push_back(sides[next++]);
    }
  }
  return faces;
}

// A piece whose side is not known is missing where sides are asked for.
void note_undecided(const TrimPiece& piece, const TrimOptions& options, TrimResult& result) {
  if (piece.side != PieceSide::Unknown || options.keep == Keep::All || options.keep == Keep::Number)
    return;
  result.notes.push_back("piece " + std::to_string(piece.number) +
                         ": side undecided, it is not kept");
  result.status = weaker(result.status, Status::Tolerance);
}

void collect(const std::vector<DividedFace>& faces, const TrimOptions& options,
             TrimResult& result) {
  for (const auto& [of, pieces, sides] : faces) {
    std::vector<TopoDS_Face> kept;
    const double whole = of->cut ? area(of->face) : 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const TopoDS_Face& face = pieces[i];
      if (!of->cut) {
        kept.push_back(face);
        continue;
      }
      const int number = static_cast<int>(result.pieces.size()) + 1;
      result.pieces.push_back({number, of->number, sides[i].side,
                               is_kept(sides[i], number, options),
                               face.IsSame(of->face) ? whole : area(face), face});
      if (!face.IsSame(of->face)) check_piece(result.pieces.back(), result);
      if (result.pieces.back().kept) kept.push_back(face);
      note_undecided(result.pieces.back(), options, result);
    }
    if (of->cut) result.areas[of->number] = whole;
    if (kept.size() != 1 || !kept.front().IsSame(of->face))
      result.replacements[of->number] = std::move(kept);
  }
}

bool asks_for_solids(const std::vector<PartFace>& part, const std::vector<TrimTool>& tools,
                     const TrimOptions& options) {
  return options.keep != Keep::Above && options.keep != Keep::Below && !part.empty() &&
         !tools.empty() && std::ranges::all_of(tools, &TrimTool::is_solid) &&
         std::ranges::all_of(part, &PartFace::cut);
}

// Whole parts and solids are divided as bodies are: the sides of pieces are proven by rays, and the
// areas add up. Nothing if they cannot be divided so; then each face is cut by itself.
std::optional<std::vector<DividedFace>> divided_by_solids(const std::vector<PartFace>& part,
                                                          const std::vector<TrimTool>& tools,
                                                          const TrimOptions& options,
                                                          TrimResult& result) {
  TrimTool sheet;
  for (const PartFace& face : part) sheet.faces.push_back(face.face);
  const SolidTrimResult made =
      trim_solids(sheet, tools, SolidOperation::Split, options.intersection);
  if (!made.obstacles.empty()) {
    result.notes.push_back("not divided as bodies: " + made.obstacles.front() +
                           "; each face is cut by itself");
    result.status = Status::Tolerance;
    return {};
  }
  result.status = made.status;
  result.certificate = made.certificate;
  result.notes.insert(result.notes.end(), made.merged.begin(), made.merged.end());
  result.notes.insert(result.notes.end(), made.tolerances.begin(), made.tolerances.end());
  std::vector<DividedFace> faces;
  for (const PartFace& face : part) faces.push_back({&face});
  for (const SolidFace& piece : made.faces) {
    DividedFace& face = faces[static_cast<std::size_t>(piece.from)];
    face.pieces.push_back(piece.face);
    face.sides.push_back({piece.side == SheetSide::Inside ? PieceSide::Inside
                          : piece.side == SheetSide::On   ? PieceSide::On
                                                          : PieceSide::Outside});
  }
  return faces;
}

std::vector<DividedFace> divided_one_by_one(const std::vector<PartFace>& part,
                                            const std::vector<TrimTool>& tools,
                                            const TrimOptions& options, TrimResult& result) {
  const WorkLimit limit(options.intersection);
  std::vector<Job> jobs = jobs_of(part, tools, options, result);
  split_all(jobs, options, limit, result);
  report_limit(jobs, limit, result);
  const std::vector<Judged> sides =
      judged(jobs, tools, options.intersection.tolerances.point, limit);
  report_limit(sides, limit, result);
  return divided_faces(jobs, sides);
}

void check_options(const std::vector<TrimTool>& tools, const TrimOptions& options) {
  if (options.keep != Keep::Inside && options.keep != Keep::Outside) return;
  for (std::size_t i = 0; i < tools.size(); ++i)
    if (!tools[i].is_solid())
      throw InvalidInput("trim: inside and outside need closed solids, " +
                         (tools[i].name.empty() ? "tool " + std::to_string(i + 1) : tools[i].name) +
                         " is none");
}

KeptTolerances kept_tolerances(const std::vector<PartFace>& part,
                               const std::vector<TrimTool>& tools) {
  std::vector<TopoDS_Face> faces;
  for (const PartFace& face : part) faces.push_back(face.face);
  for (const TrimTool& tool : tools)
    faces.insert(faces.end(), tool.faces.begin(), tool.faces.end());
  return KeptTolerances(faces);
}

// What grew with a cut has grown in the result alone, and there for all faces that it belongs to.
void part_from_inputs(const std::vector<PartFace>& part, BRepTools_ReShape& copies,
                      TrimResult& result) {
  const auto copied = [&](const TopoDS_Face& face) { return TopoDS::Face(copies.Apply(face)); };
  for (TrimPiece& piece : result.pieces) piece.shape = copied(piece.shape);
  for (auto& [number, faces] : result.replacements)
    std::ranges::transform(faces, faces.begin(), copied);
  for (const PartFace& face : part)
    if (const TopoDS_Face now = copied(face.face);
        !now.IsSame(face.face) && !result.replacements.contains(face.number))
      result.replacements[face.number] = {now};
}

}  // namespace

const char* to_string(PieceSide side) {
  switch (side) {
    case PieceSide::Above: return "above";
    case PieceSide::Below: return "below";
    case PieceSide::Inside: return "inside";
    case PieceSide::Outside: return "outside";
    case PieceSide::On: return "on";
    case PieceSide::Mixed: return "mixed";
    case PieceSide::Unknown: break;
  }
  return "unknown";
}

TrimResult trim(const std::vector<PartFace>& part, const std::vector<TrimTool>& tools,
                const TrimOptions& options) {
  check_options(tools, options);
  KeptTolerances kept = kept_tolerances(part, tools);
  TrimResult result;
  const SharedLimit limit(options.intersection);
  std::optional<std::vector<DividedFace>> faces;
  if (asks_for_solids(part, tools, options))
    faces = divided_by_solids(part, tools, options, result);
  if (!faces) {
    TrimOptions left = options;
    left.intersection = limit.remaining_alone();
    faces = divided_one_by_one(part, tools, left, result);
  }
  for (const TrimTool& tool : tools) {
    if (tool.loose == 0) continue;
    result.notes.push_back(describe_loose_faces(tool, tool.name.empty() ? "a tool" : tool.name));
    result.status = weaker(result.status, Status::Tolerance);
  }
  collect(*faces, options, result);
  const int count = static_cast<int>(result.pieces.size());
  if (options.keep == Keep::Number && (options.piece < 1 || options.piece > count))
    throw InvalidInput("trim: there is no piece " + std::to_string(options.piece) + ", only 1 to " +
                       std::to_string(count));
  if (const auto copies = kept.parted(); !copies.IsNull()) part_from_inputs(part, *copies, result);
  return result;
}

}  // namespace blossom::occt
