// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets of sharp edges of models, beside BRepFilletAPI_MakeFillet.
//
//   bench_fillets [--edges N] [--seed N] [--edge N]... [--part X]... [--limit SECONDS] [--no-peer]
//                 [--no-largest] FILE...
//
// Of each file up to N sharp edges (angle between the normals above 10 degrees) with one (ff1) or
// two (ff2) free-form faces are drawn, or those that `--edge` names are taken; each is rounded by
// the radii 0.01, 0.03, 0.1 and 0.3, or those after `--part`, times the least of its length and the
// roots of both areas. A table of what came out, by kind of fault, stands at the end.
//
//   valid     a blend face was made, BRepCheck_Analyzer finds nothing against the solid, and its
//             volume changed the way the edge says: less at a convex one, more at a concave one
//   refused   nothing was given out, for a reason that the line has; "told" are those with a
//   largest
//             radius that works
//   wrong     something else was given out
//   crashed   the process died, or ran out of time
//
// What is valid has the largest angle between the normals of a blend face and a face of the model
// along their contacts, by `edge_continuity`, and is G1 if that is at most 1e-6 radians, or what
// the face itself turns by along its knot lines. Contacts are edges along which one parameter of
// the blend's surface stays as it is, and the normals turn by at most one degree: others are ends
// of strips, or edges on which the ball leans. Faces of the model are those that have one of its
// surfaces.
//
// Both work in processes of their own. Seconds are of the work alone, in one thread; those that the
// largest radius takes, for which the peer has no counterpart, are counted apart. The exit code
// tells whether a result of ours is wrong or crashed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/blending/continuity.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/shapes.h"
#include "core/base/parallel.h"
#include "tests/bench/apart.h"
#include "tests/support/models.h"

namespace blossom::bench {
namespace {

constexpr double kSharp = 0.1745;       // 10 degrees
constexpr double kNoContact = 0.01745;  // 1 degree
constexpr double kSmooth = 1e-6;        // radians
constexpr std::array<double, 4> kRadii{0.01, 0.03, 0.1, 0.3};

struct Settings {
  int edges = 4;
  unsigned seed = 1;
  double limit = 20;
  bool peer = true;
  bool largest = true;
  std::vector<int> chosen;    // numbers of edges; none: they are drawn
  std::vector<double> parts;  // of an edge's size
  std::vector<std::string> files;
};

enum class Verdict { Valid, Refused, Wrong, Crashed };

// Plain values, so that it can be passed between processes.
struct Outcome {
  Verdict verdict = Verdict::Crashed;
  double seconds = 0;
  double seconds_of_largest = 0;
  bool has_largest = false;
  double angle = -1;    // between normals along contacts, radians; -1: no contact was measured
  bool smooth = false;  // G1
  char fault[16] = {};  // of what is refused
  char reason[240] = {};
};

struct Job {
  int edge = 0;
  bool concave = false;
  bool both_free = false;
  double radius = 0;
  double part = 0;
};

bool is_free_form(const TopoDS_Face& face) {
  const GeomAbs_SurfaceType type = GeomAdaptor_Surface(BRep_Tool::Surface(face)).GetType();
  return type == GeomAbs_BezierSurface || type == GeomAbs_BSplineSurface;
}

const Geom_Surface* surface_of(const TopoDS_Shape& face) {
  TopLoc_Location location;
  return BRep_Tool::Surface(TopoDS::Face(face), location).get();
}

// Of all solids, by our own integration: changes are a millionth of some models, below the noise of
// BRepGProp.
double volume_of(const TopoDS_Shape& shape) {
  double volume = 0;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    for (TopExp_Explorer it(solid.Current(), TopAbs_FACE); it.More(); it.Next())
      volume += occt::cone_volume(TopoDS::Face(it.Current()), {});
  return volume;
}

// Whether a result is what was asked for.
Verdict verdict_of(const TopoDS_Shape& before, const TopoDS_Shape& after, bool concave) {
  if (!BRepCheck_Analyzer(after).IsValid()) return Verdict::Wrong;
  TopTools_IndexedMapOfShape old_faces, faces;
  TopExp::MapShapes(before, TopAbs_FACE, old_faces);
  TopExp::MapShapes(after, TopAbs_FACE, faces);
  if (faces.Extent() == 0) return Verdict::Wrong;
  const double change = volume_of(after) - volume_of(before);
  return (concave ? change > 0 : change < 0) ? Verdict::Valid : Verdict::Wrong;
}

// Whether a curve of a blend's surface is a line of one parameter, as contacts are.
bool is_iso_line(const TopoDS_Edge& edge, const TopoDS_Face& blend) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) chart = BRep_Tool::CurveOnSurface(edge, blend, first, last);
  if (chart.IsNull()) return false;
  Bnd_Box2d box;
  for (int i = 0; i <= 16; ++i) box.Add(chart->Value(first + (last - first) * i / 16));
  double u0 = 0, v0 = 0, u1 = 0, v1 = 0;
  box.Get(u0, v0, u1, v1);
  return std::min(u1 - u0, v1 - v0) <= 1e-9 * std::max(u1 - u0, v1 - v0);
}

// By how much the normal of a face jumps at most along knot lines across which it is only
// continuous: no blend can be more tangent to it there.
double own_turn(const TopoDS_Face& face) {
  const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face));
  if (surface.IsNull()) return 0;
  double range[4], most = 0;
  BRepTools::UVBounds(face, range[0], range[1], range[2], range[3]);
  const auto jump = [&](double u, double v, bool in_u, double step) {
    gp_Dir normals[2];
    for (const int side : {0, 1}) {
      const double off = side == 0 ? -step : step;
      GeomLProp_SLProps at(surface, u + (in_u ? off : 0), v + (in_u ? 0 : off), 1, 1e-12);
      if (!at.IsNormalDefined()) return 0.0;
      normals[side] = at.Normal();
    }
    return normals[0].Angle(normals[1]);
  };
  for (const bool in_u : {true, false})
    for (int k = 2; k < (in_u ? surface->NbUKnots() : surface->NbVKnots()); ++k) {
      const int count = in_u ? surface->UMultiplicity(k) : surface->VMultiplicity(k);
      if (count < (in_u ? surface->UDegree() : surface->VDegree())) continue;
      const double knot = in_u ? surface->UKnot(k) : surface->VKnot(k);
      const double *own = in_u ? range : range + 2, *other = in_u ? range + 2 : range;
      if (!(knot > own[0] && knot < own[1])) continue;
      for (int i = 0; i <= 32; ++i) {
        const double along = other[0] + (other[1] - other[0]) * i / 32;
        const double step = 1e-9 * (own[1] - own[0]);
        most = std::max(most, jump(in_u ? knot : along, in_u ? along : knot, in_u, step));
      }
    }
  return most;
}

// The largest angle between normals along the contacts of blend faces, and whether it is no larger
// than 1e-6, or what the face turns by itself.
struct ContactAngle {
  double value = -1;
  bool smooth = true;
};

ContactAngle contact_angle(const std::vector<TopoDS_Face>& blends,
                           const std::vector<TopoDS_Face>& kept) {
  TopoDS_Compound beside;
  BRep_Builder().MakeCompound(beside);
  TopTools_MapOfShape edges, own;
  for (const TopoDS_Face& face : blends) {
    BRep_Builder().Add(beside, face);
    own.Add(face);
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) edges.Add(it.Current());
  }
  for (const TopoDS_Face& face : kept)
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      if (edges.Contains(it.Current())) {
        BRep_Builder().Add(beside, face);
        break;
      }
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(beside, TopAbs_FACE, faces);
  ContactAngle angle;
  for (const occt::EdgeContinuity& each : occt::edge_continuity(beside)) {
    if (each.kind != occt::EdgeRole::Shared || !each.found) continue;
    const auto is_blend = [&](int face) { return own.Contains(faces(face)); };
    if (is_blend(each.faces[0]) == is_blend(each.faces[1])) continue;
    const std::size_t blend = is_blend(each.faces[0]) ? 0 : 1;
    const double value = each.found->angle.value;
    if (value > kNoContact || !is_iso_line(each.edge, TopoDS::Face(faces(each.faces[blend]))))
      continue;
    angle.value = std::max(angle.value, value);
    if (value > kSmooth)
      angle.smooth = angle.smooth && value <= own_turn(TopoDS::Face(faces(each.faces[1 - blend])));
  }
  return angle;
}

void set_angle(Outcome& outcome, const ContactAngle& angle) {
  outcome.angle = angle.value;
  outcome.smooth = angle.value >= 0 && angle.smooth;
}

Outcome ours(const TopoDS_Shape& shape, const Job& job, bool search_largest) {
  Outcome outcome;
  const double start = thread_seconds();
  try {
    const auto rounded = [&](bool largest) {
      occt::FilletResult made;
      const occt::FilletOptions options{.radius = job.radius, .volumes = false, .largest = largest};
      with_threads(1, [&] { made = occt::fillet(shape, {job.edge}, options); });
      return made;
    };
    occt::FilletResult made = rounded(false);
    outcome.seconds = thread_seconds() - start;
    if (!made.refused.empty()) {
      outcome.verdict = Verdict::Refused;
      if (search_largest) {
        made = rounded(true);
        outcome.seconds_of_largest = thread_seconds() - start - 2 * outcome.seconds;
        outcome.has_largest = made.refused.front().largest.has_value();
      }
      const occt::FilletRefusal& why = made.refused.front();
      std::strncpy(outcome.fault, to_string(why.fault), sizeof outcome.fault - 1);
      std::strncpy(outcome.reason, why.text().c_str(), sizeof outcome.reason - 1);
      return outcome;
    }
    const TopoDS_Shape before = shape;
    TopoDS_Shape after = made.solids.front().solid;
    double volume = 0;
    bool valid = true;
    for (const occt::FilletedSolid& each : made.solids) {
      valid = valid && BRepCheck_Analyzer(each.solid).IsValid();
      volume += volume_of(each.solid);
    }
    const double change = volume - volume_of(before);
    outcome.verdict =
        valid && (job.concave ? change > 0 : change < 0) ? Verdict::Valid : Verdict::Wrong;
    std::vector<TopoDS_Face> blends, kept;
    for (const occt::FilletedSolid& each : made.solids)
      for (const occt::FilletFace& face : each.faces)
        (face.from > 0 ? kept : blends).push_back(face.face);
    set_angle(outcome, contact_angle(blends, kept));
  } catch (const std::exception& error) {
    outcome.verdict = Verdict::Refused;
    std::strncpy(outcome.fault, "exception", sizeof outcome.fault - 1);
    std::snprintf(outcome.reason, sizeof outcome.reason, "exception: %s", error.what());
  }
  return outcome;
}

Outcome theirs(const TopoDS_Shape& shape, const Job& job) {
  Outcome outcome;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  const double start = thread_seconds();
  try {
    BRepFilletAPI_MakeFillet maker(shape);
    maker.Add(job.radius, TopoDS::Edge(edges(job.edge)));
    maker.Build();
    outcome.seconds = thread_seconds() - start;
    outcome.verdict =
        maker.IsDone() ? verdict_of(shape, maker.Shape(), job.concave) : Verdict::Refused;
    if (outcome.verdict != Verdict::Valid) return outcome;
    std::set<const Geom_Surface*> surfaces;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      surfaces.insert(surface_of(it.Current()));
    std::vector<TopoDS_Face> blends, kept;
    for (TopExp_Explorer it(maker.Shape(), TopAbs_FACE); it.More(); it.Next())
      (surfaces.count(surface_of(it.Current())) > 0 ? kept : blends)
          .push_back(TopoDS::Face(it.Current()));
    set_angle(outcome, contact_angle(blends, kept));
  } catch (const Standard_Failure&) {
    outcome.verdict = Verdict::Refused;
  }
  return outcome;
}

std::vector<Job> drawn(const TopoDS_Shape& shape, const Settings& settings) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<occt::EdgeFacts> fit;
  for (const occt::EdgeFacts& each : occt::edge_facts(shape)) {
    const bool wanted = std::ranges::count(settings.chosen, each.number) > 0;
    if (!settings.chosen.empty() && !wanted) continue;
    const bool sharp = each.kind == occt::EdgeKind::Convex || each.kind == occt::EdgeKind::Concave;
    if (!sharp || each.angle < kSharp) continue;
    const bool any = std::ranges::any_of(
        each.faces, [&](int face) { return is_free_form(TopoDS::Face(faces(face))); });
    if (any || wanted) fit.push_back(each);
  }
  std::mt19937 random(settings.seed);
  std::ranges::shuffle(fit, random);
  if (settings.chosen.empty() && static_cast<int>(fit.size()) > settings.edges)
    fit.resize(static_cast<std::size_t>(settings.edges));
  std::vector<Job> jobs;
  for (const occt::EdgeFacts& each : fit)
    for (const double part : settings.parts) {
      Job job{each.number, each.kind == occt::EdgeKind::Concave, true, 0, part};
      double size = each.length;
      for (const int face : each.faces) {
        job.both_free = job.both_free && is_free_form(TopoDS::Face(faces(face)));
        size = std::min(size, std::sqrt(occt::area(TopoDS::Face(faces(face)))));
      }
      job.radius = part * size;
      jobs.push_back(job);
    }
  return jobs;
}

struct Table {
  std::array<int, 4> count{};
  std::map<std::string, int> faults;
  double seconds = 0, seconds_of_largest = 0;
  int told = 0;    // of those refused
  int smooth = 0;  // of those valid
  double angle = 0;

  void add(const Outcome& outcome) {
    ++count[static_cast<std::size_t>(outcome.verdict)];
    if (outcome.fault[0] != 0) ++faults[outcome.fault];
    seconds += outcome.seconds;
    seconds_of_largest += outcome.seconds_of_largest;
    told += outcome.has_largest ? 1 : 0;
    if (outcome.verdict != Verdict::Valid) return;
    smooth += outcome.smooth ? 1 : 0;
    angle = std::max(angle, outcome.angle);
  }
  void print(const char* who) const {
    std::printf("%-6s valid %4d  refused %4d  wrong %4d  crashed %4d  %8.2f s\n", who, count[0],
                count[1], count[2], count[3], seconds);
    std::printf("  G1             %4d of those valid; largest angle %.2g\n", smooth, angle);
    if (told > 0) std::printf("  told           %4d  %40.2f s\n", told, seconds_of_largest);
    for (const auto& [fault, times] : faults) std::printf("  %-14s %4d\n", fault.c_str(), times);
  }
};

constexpr std::array<const char*, 4> kWords{"valid", "refused", "wrong", "crashed"};

const char* word(const Outcome& outcome) {
  return kWords[static_cast<std::size_t>(outcome.verdict)];
}

void run(const std::string& file, const Settings& settings, Table& own, Table& peer) {
  const occt::Model model = testing::repaired_model(file);
  for (const Job& job : drawn(model.shape(), settings)) {
    Outcome a, b;
    apart<Outcome>(settings.limit, a, [&] { return ours(model.shape(), job, settings.largest); });
    own.add(a);
    if (settings.peer) {
      apart<Outcome>(settings.limit, b, [&] { return theirs(model.shape(), job); });
      peer.add(b);
    }
    std::printf("%s edge %d %s %s r %g (%g): %s %.2g %.4f s, OCCT %s %.2g %.4f s  %s\n",
                file.c_str(), job.edge, job.concave ? "concave" : "convex",
                job.both_free ? "ff2" : "ff1", job.radius, job.part, word(a), a.angle, a.seconds,
                settings.peer ? word(b) : "-", b.angle, b.seconds, a.reason);
    std::fflush(stdout);
  }
}

Settings settings_of(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool more = i + 1 < argc;
    if (word == "--edges" && more)
      settings.edges = std::stoi(argv[++i]);
    else if (word == "--seed" && more)
      settings.seed = static_cast<unsigned>(std::stoul(argv[++i]));
    else if (word == "--limit" && more)
      settings.limit = std::stod(argv[++i]);
    else if (word == "--edge" && more)
      settings.chosen.push_back(std::stoi(argv[++i]));
    else if (word == "--part" && more)
      settings.parts.push_back(std::stod(argv[++i]));
    else if (word == "--no-peer")
      settings.peer = false;
    else if (word == "--no-largest")
      settings.largest = false;
    else
      settings.files.push_back(word);
  }
  if (settings.parts.empty()) settings.parts.assign(kRadii.begin(), kRadii.end());
  return settings;
}

}  // namespace
}  // namespace blossom::bench

int main(int argc, char** argv) {
  using namespace blossom::bench;
  const Settings settings = settings_of(argc, argv);
  blossom::occt::quiet_messages();
  Table own, peer;
  for (const std::string& file : settings.files) try {
      run(file, settings, own, peer);
    } catch (const std::exception& error) {
      std::printf("%s: %s\n", file.c_str(), error.what());
    }
  own.print("ours");
  if (settings.peer) peer.print("OCCT");
  return own.count[2] + own.count[3] > 0 ? 1 : 0;
}
