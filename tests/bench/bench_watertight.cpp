// SPDX-License-Identifier: GPL-3.0-or-later
// Whole models and cut ones as patches and triangles without gaps, checked.
//
//   bench_watertight [--limit SECONDS] [--tolerance T] [--parts N] [--copies] [--keep FOLDER]
//   FILE...
//
// Jobs of a model: the whole of it ("whole"), and without what lies in a box over one half of its
// own box, halved across the longest way ("half"); with --copies also cut, common and fuse with the
// copies c1 and c2 of bench_solids. A model that is no closed solid is cut face by face.
//
// A line for each job, as a row of a table. "Free" are sides with one piece where the model has
// none, "many" those with more than two; pieces that "may fold" are not proven to turn nowhere.
// CGAL looks at meshes: of N parts a side that neighbours share; of more where triangles cross, and
// which of these crossings are the model's own (watertight_meshes.h); and Open CASCADE's, of the
// faces as given, too. It says whether they are manifold, closed, and counts pairs of triangles
// that cross. Seconds are processor time of the cut, and of the pieces with their checks. --keep
// writes the shapes as .brep.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "adapters/occt/trim.h"
#include "adapters/occt/watertight.h"
#include "core/base/errors.h"
#include "tests/bench/apart.h"
#include "tests/bench/command_line.h"
#include "tests/bench/moved_copy.h"
#include "tests/bench/watertight_meshes.h"
#include "tests/support/models.h"

namespace blossom::bench {
namespace {

struct Settings {
  double limit = 60;
  double tolerance = 1e-6;
  int parts = 4;
  bool copies = false;
  std::string folder;
  std::vector<std::string> files;
};

struct Job {
  std::string name;
  TopoDS_Shape tool;  // null: the whole model
  occt::SolidOperation operation = occt::SolidOperation::Cut;
};

// What comes of a job; plain values, so that it can be passed between processes.
struct Outcome {
  Ending ending = Ending::Died;
  std::array<char, 400> obstacle{};
  double cut_seconds = 0, seconds = 0, deviation = 0;
  int faces = 0, given_free = 0, patches = 0, triangles = 0, free = 0, many = 0, may_fold = 0;
  WatertightMeshes meshes;
};

void tell(Outcome& outcome, const std::string& obstacle) {
  obstacle.copy(outcome.obstacle.data(), outcome.obstacle.size() - 1);
}

TopoDS_Shape half_box(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  std::array<double, 3> low{}, high{};
  box.Get(low[0], low[1], low[2], high[0], high[1], high[2]);
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (high[k] - low[k] > high[longest] - low[longest]) longest = k;
  const double beyond = 0.1 * (high[longest] - low[longest]);
  const double middle = 0.5 * (low[longest] + high[longest]);
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = k == longest ? middle : low[k] - beyond;
    high[k] += beyond;
  }
  return BRepPrimAPI_MakeBox(gp_Pnt(low[0], low[1], low[2]), gp_Pnt(high[0], high[1], high[2]));
}

std::vector<Job> jobs_of(const TopoDS_Shape& shape, const Settings& settings) {
  std::vector<Job> jobs{{"whole", {}}, {"half", half_box(shape)}};
  if (!settings.copies) return jobs;
  const std::array operations{std::pair{"cut", occt::SolidOperation::Cut},
                              std::pair{"common", occt::SolidOperation::Common},
                              std::pair{"fuse", occt::SolidOperation::Fuse}};
  for (const auto& [kind, degrees, part] :
       {std::tuple{"c1", 23.0, 0.06}, std::tuple{"c2", 2.0, 0.004}})
    for (const auto& [name, operation] : operations)
      jobs.push_back({std::string(kind) + " " + name, moved_copy(shape, degrees, part), operation});
  return jobs;
}

// The faces of a model that is no closed solid, without what lies in the tool.
TopoDS_Shape faces_outside(occt::Model& model, const occt::TrimTool& tool,
                           const IntersectionOptions& engine) {
  std::vector<occt::PartFace> faces;
  for (int number = 1; number <= model.face_count(); ++number)
    faces.push_back({number, model.face(number), true});
  occt::TrimOptions options;
  options.keep = occt::Keep::Outside;
  options.intersection = engine;
  const occt::TrimResult made = occt::trim(faces, {tool}, options);
  if (made.status == Status::Stopped) throw occt::BadModel("the intersection is not complete");
  model.replace_faces(made.replacements);
  return model.shape();
}

TopoDS_Shape cut_shape(occt::Model& model, const Job& job) {
  if (job.tool.IsNull()) return model.shape();
  IntersectionOptions engine;
  engine.threads = 1;
  const occt::TrimTool part = occt::trim_tool(model.shape()), tool = occt::trim_tool(job.tool);
  try {
    const occt::SolidTrimResult made = occt::trim_solids(part, {tool}, job.operation, engine);
    if (!made.obstacles.empty()) throw occt::BadModel("no solid: " + made.obstacles.front());
    return occt::compound_of(made.solids);
  } catch (const InvalidInput&) {
    if (job.name != "half") throw;
    return faces_outside(model, tool, engine);
  }
}

int free_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  int count = 0;
  for (int k = 1; k <= faces.Extent(); ++k)
    count += faces(k).Extent() == 1 && !BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(k)));
  return count;
}

void count(const WatertightPieces& pieces, Outcome& outcome) {
  std::vector<int> uses(pieces.sides.size(), 0);
  for (const WatertightPiece& piece : pieces.pieces) {
    ++(std::holds_alternative<BezierTriangle>(piece.form) ? outcome.triangles : outcome.patches);
    for (const int side : piece.sides) ++uses[static_cast<std::size_t>(side)];
  }
  for (std::size_t k = 0; k < uses.size(); ++k) {
    outcome.free += uses[k] == 1 && !pieces.sides[k].curve.points.empty();
    outcome.many += uses[k] > 2 && !pieces.sides[k].curve.points.empty();
  }
  outcome.may_fold = static_cast<int>(pieces.turned.size());
}

Outcome outcome_of(const std::string& file, const Job& job, const Settings& settings) {
  Outcome outcome;
  occt::Model model = testing::repaired_model(file);
  double start = processor_seconds();
  const TopoDS_Shape shape = cut_shape(model, job);
  outcome.cut_seconds = processor_seconds() - start;
  outcome.given_free = free_edges(shape);
  WatertightOptions options;
  options.tolerance = settings.tolerance;
  start = processor_seconds();
  const occt::WatertightShape made = occt::watertight(shape, options);
  outcome.seconds = processor_seconds() - start;
  tell(outcome, made.pieces.obstacle);
  if (!made.pieces.obstacle.empty()) return outcome;
  outcome.deviation = made.pieces.deviation;
  outcome.faces = static_cast<int>(made.faces.size());
  count(made.pieces, outcome);
  outcome.meshes = watertight_meshes(made, occt::faces_of(shape), settings.parts);
  if (settings.folder.empty()) return outcome;
  occt::Model kept;
  kept.add(made.shape, job.name);
  const std::string stem = std::filesystem::path(file).stem().string();
  occt::write_model(kept,
                    std::filesystem::path(settings.folder) / (stem + " " + job.name + ".brep"));
  return outcome;
}

// What does not end or breaks a rule is an outcome like others here.
Outcome measured(const std::string& file, const Job& job, const Settings& settings) {
  Outcome result;
  const Ending ending = apart<Outcome>(settings.limit, result, [&] {
    try {
      return outcome_of(file, job, settings);
    } catch (const InvalidInput& error) {
      Outcome refused;
      tell(refused, error.what());
      return refused;
    } catch (const occt::BadModel& error) {
      Outcome refused;
      tell(refused, error.what());
      return refused;
    }
  });
  if (ending != Ending::Done) result = {};
  result.ending = ending;
  return result;
}

// Closed where the model is, and nothing crosses but what the model's own faces do.
bool is_sound(const Outcome& outcome) {
  const WatertightMeshes& meshes = outcome.meshes;
  return outcome.ending == Ending::Done && outcome.obstacle[0] == 0 && outcome.many == 0 &&
         (outcome.free > 0) == (outcome.given_free > 0) && meshes.refined.manifold &&
         meshes.refined.closed == (outcome.free == 0) &&
         meshes.refined.self_intersections == meshes.of_model;
}

std::string told(const cgal::MeshCheck& mesh) {
  return (mesh.manifold ? mesh.closed ? "closed" : "manifold" : "no manifold") + std::string(", ") +
         std::to_string(mesh.self_intersections);
}

std::string told(const OcctMesh& mesh) {
  std::array<char, 16> deflection{};
  std::snprintf(deflection.data(), deflection.size(), "%.0e", mesh.deflection);
  return (mesh.meshed ? told(mesh.check) : "not meshed") + " at " + deflection.data();
}

std::string told(const WatertightMeshes& meshes) {
  std::string text = told(meshes.even) + " | ";
  if (meshes.even.self_intersections > 0)
    text += told(meshes.refined) + " at " + std::to_string(meshes.finest) + " parts";
  if (meshes.refined.self_intersections > 0)
    text += ": " + std::to_string(meshes.of_model) + " of the model, " +
            std::to_string(meshes.at_edges) + " at edges, " + std::to_string(meshes.others) +
            " others";
  text += " | " + told(meshes.given) + " | " + told(meshes.first);
  if (meshes.last.deflection < meshes.first.deflection) text += "; " + told(meshes.last);
  return text;
}

void print(const std::string& name, const Outcome& outcome) {
  std::printf("| %s | ", name.c_str());
  if (outcome.ending != Ending::Done)
    std::printf("%s |\n", outcome.ending == Ending::OutOfTime ? "out of time" : "died");
  else if (outcome.obstacle[0] != 0)
    std::printf("refused: %s | %.2f + %.2f |\n", outcome.obstacle.data(), outcome.cut_seconds,
                outcome.seconds);
  else
    std::printf("%s | %s | %d, %d | %d | %.1e | %d, %d, %d | %.2f + %.2f |\n",
                is_sound(outcome) ? "sound" : "NOT SOUND", told(outcome.meshes).c_str(),
                outcome.free, outcome.many, outcome.may_fold, outcome.deviation, outcome.faces,
                outcome.patches, outcome.triangles, outcome.cut_seconds, outcome.seconds);
  std::fflush(stdout);
}

std::optional<Settings> settings_from(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : "0"; };
    if (word == "--limit")
      settings.limit = std::atof(value());
    else if (word == "--tolerance")
      settings.tolerance = std::atof(value());
    else if (word == "--parts")
      settings.parts = std::atoi(value());
    else if (word == "--copies")
      settings.copies = true;
    else if (word == "--keep")
      settings.folder = value();
    else
      settings.files.push_back(word);
  }
  if (settings.files.empty() || !(settings.tolerance > 0) || settings.parts < 1)
    return std::nullopt;
  return settings;
}

int run_all(const Settings& settings) {
  std::printf(
      "| job | result | samples | refined | given | BRepMesh | free, many | may fold | within | "
      "faces, patches, triangles | s |\n|---|---|---|---|---|---|---|---:|---:|---|---|\n");
  int unsound = 0;
  for (const std::string& file : settings.files) {
    const occt::Model model = testing::repaired_model(file);
    for (const Job& job : jobs_of(model.shape(), settings)) {
      const Outcome outcome = measured(file, job, settings);
      print(std::filesystem::path(file).stem().string() + " " + job.name, outcome);
      unsound += outcome.obstacle[0] == 0 && !is_sound(outcome);
    }
  }
  return unsound > 0 ? 1 : 0;
}

}  // namespace
}  // namespace blossom::bench

int main(int argc, char** argv) {
  using namespace blossom::bench;
  return run_command(settings_from(argc, argv),
                     "bench_watertight [--limit SECONDS] [--tolerance T] [--parts N] [--copies] "
                     "[--keep FOLDER] FILE...",
                     run_all);
}
