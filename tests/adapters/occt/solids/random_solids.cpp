// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/adapters/occt/solids/random_solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Quaternion.hxx>

#include "adapters/occt/soundness.h"

namespace blossom::testing {
namespace {

using std::numbers::pi;

double angle_of_side(const SimpleSolid& prism) { return 2 * pi / prism.corners; }

double one_of(Random& random, const std::vector<double>& values) {
  return values[static_cast<std::size_t>(pick(random, 0, static_cast<int>(values.size()) - 1))];
}

bool chance(Random& random, double probability) { return uniform(random, 0, 1) < probability; }

double size(Random& random) {
  return chance(random, 0.7) ? one_of(random, {0.5, 1, 1, 1.5, 2, 2, 3, 4})
                             : uniform(random, 0.3, 4);
}

gp_Dir direction(Random& random) {
  for (;;) {
    const gp_Vec v(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    if (v.Magnitude() > 0.1 && v.Magnitude() < 1) return {v};
  }
}

gp_Dir axis(Random& random) {
  return std::array{gp::DX(), gp::DY(), gp::DZ()}[static_cast<std::size_t>(pick(random, 0, 2))];
}

gp_Trsf turning(const gp_Dir& about, double angle) {
  gp_Trsf made;
  made.SetRotation(gp_Ax1(gp::Origin(), about), angle);
  return made;
}

gp_Trsf shift(const gp_Vec& by) {
  gp_Trsf made;
  made.SetTranslation(by);
  return made;
}

// By a multiple of a part of a right angle, or freely.
gp_Trsf random_turn(Random& random) {
  const double kind = uniform(random, 0, 1);
  if (kind < 0.35) return {};
  const auto multiple = [&](int parts) {
    return turning(axis(random), pick(random, 1, 4 * parts - 1) * pi / (2 * parts));
  };
  if (kind < 0.6) return multiple(1);
  if (kind < 0.7) return multiple(2);
  if (kind < 0.8) return multiple(3);
  return turning(direction(random), uniform(random, 0, 2 * pi));
}

SimpleSolid random_solid(Random& random) {
  SimpleSolid solid;
  solid.kind = static_cast<Simple>(pick(random, 0, 5));
  solid.a = size(random);
  solid.b = size(random);
  solid.c = size(random);
  if (solid.kind == Simple::Cone)
    solid.b = chance(random, 0.4) ? 0 : solid.a * one_of(random, {0.25, 0.5, 2, 1.5});
  if (solid.kind == Simple::Torus) solid.b = solid.a * one_of(random, {0.25, 0.5, 0.2, 0.75});
  if (solid.kind == Simple::Prism) solid.corners = pick(random, 3, 8);
  return solid;
}

// Points of a solid at which others touch it, in its own place.
std::vector<gp_Pnt> landmarks(const SimpleSolid& s) {
  std::vector<gp_Pnt> all;
  switch (s.kind) {
    case Simple::Box:
      for (const double x : {0.0, 0.5, 1.0})
        for (const double y : {0.0, 0.5, 1.0})
          for (const double z : {0.0, 0.5, 1.0}) all.emplace_back(x * s.a, y * s.b, z * s.c);
      break;
    case Simple::Cylinder:
    case Simple::Cone:
      for (const double z : {0.0, 0.5, 1.0}) {
        const double r = s.kind == Simple::Cone ? (1 - z) * s.a + z * s.b : s.a;
        all.emplace_back(0, 0, z * s.c);
        for (const double angle : {0.0, pi / 2, pi, 1.0})
          all.emplace_back(r * std::cos(angle), r * std::sin(angle), z * s.c);
      }
      break;
    case Simple::Sphere:
      all = {{0, 0, 0}, {0, 0, s.a}, {0, 0, -s.a}, {s.a, 0, 0}, {0, s.a, 0}, {-s.a, 0, 0}};
      break;
    case Simple::Torus:
      all = {{0, 0, 0},      {s.a + s.b, 0, 0}, {s.a - s.b, 0, 0}, {s.a, 0, s.b},
             {0, s.a, -s.b}, {-s.a, 0, s.b},    {0, s.a + s.b, 0}};
      break;
    case Simple::Prism:
      for (const double z : {0.0, 0.5, 1.0})
        for (const double corner : {0.0, 0.5, 1.0}) {
          const double r = corner == 0.5 ? s.a * std::cos(angle_of_side(s) / 2) : s.a;
          const double angle = corner * angle_of_side(s);
          all.emplace_back(r * std::cos(angle), r * std::sin(angle), z * s.c);
        }
      break;
  }
  return all;
}

gp_Pnt landmark(Random& random, const SimpleSolid& solid) {
  const std::vector<gp_Pnt> all = landmarks(solid);
  return all[static_cast<std::size_t>(pick(random, 0, static_cast<int>(all.size()) - 1))];
}

double power_of_ten(Random& random, double low, double high) {
  return std::pow(10, uniform(random, low, high));
}

gp_Vec grid_shift(Random& random) {
  const auto step = [&] { return one_of(random, {0, 0, 0, 0.5, 1, 1, 2, -1, -2, -0.5, 1.5}); };
  const double x = step(), y = step(), z = step();
  return {x, y, z};
}

gp_Trsf random_place(Random& random, const SimpleSolid& a, const SimpleSolid& b) {
  const gp_Trsf turning = random_turn(random);
  const double kind = uniform(random, 0, 1);
  if (kind < 0.45) return shift(grid_shift(random)) * turning;
  if (kind < 0.8) {
    const gp_Pnt to = landmark(random, a);
    return shift(gp_Vec(landmark(random, b).Transformed(turning), to)) * turning;
  }
  return shift(gp_Vec(direction(random)) * uniform(random, 0, 3)) * turning;
}

gp_Trsf random_world(Random& random) {
  gp_Trsf world = random_turn(random);
  const double scale = chance(random, 0.5) ? 1 : power_of_ten(random, -3, 4);
  world.SetScaleFactor(scale);
  const double moved = uniform(random, 0, 1);
  gp_Vec by(0, 0, 0);
  if (moved > 0.6)
    by = gp_Vec(pick(random, -9, 9), pick(random, -9, 9), pick(random, -9, 9)) * scale;
  if (moved > 0.8) by = gp_Vec(direction(random)) * power_of_ten(random, 2, 5);
  return shift(by) * world;
}

TopoDS_Shape own_shape(const SimpleSolid& s) {
  switch (s.kind) {
    case Simple::Box: return BRepPrimAPI_MakeBox(s.a, s.b, s.c).Shape();
    case Simple::Cylinder: return BRepPrimAPI_MakeCylinder(s.a, s.c).Shape();
    case Simple::Cone: return BRepPrimAPI_MakeCone(s.a, s.b, s.c).Shape();
    case Simple::Sphere: return BRepPrimAPI_MakeSphere(s.a).Shape();
    case Simple::Torus: return BRepPrimAPI_MakeTorus(s.a, s.b).Shape();
    case Simple::Prism: break;
  }
  BRepBuilderAPI_MakePolygon outline;
  for (int i = 0; i < s.corners; ++i) {
    const double angle = i * angle_of_side(s);
    outline.Add(gp_Pnt(s.a * std::cos(angle), s.a * std::sin(angle), 0));
  }
  outline.Close();
  const TopoDS_Face base = BRepBuilderAPI_MakeFace(outline.Wire()).Face();
  return BRepPrimAPI_MakePrism(base, gp_Vec(0, 0, s.c)).Shape();
}

double own_volume(const SimpleSolid& s) {
  switch (s.kind) {
    case Simple::Box: return s.a * s.b * s.c;
    case Simple::Cylinder: return pi * s.a * s.a * s.c;
    case Simple::Cone: return pi / 3 * s.c * (s.a * s.a + s.a * s.b + s.b * s.b);
    case Simple::Sphere: return 4 * pi / 3 * s.a * s.a * s.a;
    case Simple::Torus: return 2 * pi * pi * s.a * s.b * s.b;
    case Simple::Prism: break;
  }
  return 0.5 * s.corners * s.a * s.a * std::sin(angle_of_side(s)) * s.c;
}

double own_area(const SimpleSolid& s) {
  switch (s.kind) {
    case Simple::Box: return 2 * (s.a * s.b + s.b * s.c + s.a * s.c);
    case Simple::Cylinder: return 2 * pi * s.a * (s.a + s.c);
    case Simple::Cone:
      return pi * (s.a * s.a + s.b * s.b + (s.a + s.b) * std::hypot(s.a - s.b, s.c));
    case Simple::Sphere: return 4 * pi * s.a * s.a;
    case Simple::Torus: return 4 * pi * pi * s.a * s.b;
    case Simple::Prism: break;
  }
  const double half = angle_of_side(s) / 2;
  return s.corners * s.a * (s.a * std::sin(2 * half) + 2 * std::sin(half) * s.c);
}

// In a solid's own place. Boxes of Open CASCADE need not hold all of a torus.
struct OwnBox {
  Vec3 low, high;

  double volume() const { return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]); }
};

OwnBox own_box(const SimpleSolid& s) {
  const auto round = [](double r, double from, double to) {
    return OwnBox{{-r, -r, from}, {r, r, to}};
  };
  switch (s.kind) {
    case Simple::Box: return {{0, 0, 0}, {s.a, s.b, s.c}};
    case Simple::Cylinder: return round(s.a, 0, s.c);
    case Simple::Cone: return round(std::max(s.a, s.b), 0, s.c);
    case Simple::Sphere: return round(s.a, -s.a, s.a);
    case Simple::Torus: return round(s.a + s.b, -s.b, s.b);
    case Simple::Prism: break;
  }
  return round(s.a, 0, s.c);
}

bool prism_holds(const SimpleSolid& s, const gp_Pnt& p) {
  const double half = angle_of_side(s) / 2;
  for (int i = 0; i < s.corners; ++i) {
    const double angle = (2 * i + 1) * half;
    if (p.X() * std::cos(angle) + p.Y() * std::sin(angle) > s.a * std::cos(half)) return false;
  }
  return true;
}

}  // namespace

TopoDS_Shape SimpleSolid::shape_in(const gp_Trsf& world) const {
  const gp_Trsf whole = world * place;
  SimpleSolid scaled = *this;
  for (double* const length : {&scaled.a, &scaled.b, &scaled.c}) *length *= whole.ScaleFactor();
  // A scaling whose factor is set to 1 counts as the identity, and would not move anything.
  gp_Trsf moved;
  moved.SetTransformation(whole.GetRotation(), whole.TranslationPart());
  return BRepBuilderAPI_Transform(own_shape(scaled), moved, true).Shape();
}

double SimpleSolid::volume() const {
  return own_volume(*this) * std::pow(std::abs(place.ScaleFactor()), 3);
}

double SimpleSolid::area() const { return own_area(*this) * std::pow(place.ScaleFactor(), 2); }

bool SimpleSolid::holds(const Vec3& point) const {
  const gp_Pnt p = gp_Pnt(point[0], point[1], point[2]).Transformed(place.Inverted());
  const double r = std::hypot(p.X(), p.Y());
  const bool level = p.Z() >= 0 && p.Z() <= c;
  switch (kind) {
    case Simple::Box: return level && p.X() >= 0 && p.X() <= a && p.Y() >= 0 && p.Y() <= b;
    case Simple::Cylinder: return level && r <= a;
    case Simple::Cone: return level && r <= a + (b - a) * p.Z() / c;
    case Simple::Sphere: return std::hypot(r, p.Z()) <= a;
    case Simple::Torus: return std::hypot(r - a, p.Z()) <= b;
    case Simple::Prism: return level && prism_holds(*this, p);
  }
  return false;
}

std::string SimpleSolid::words() const {
  static constexpr std::array kNames{"box", "cylinder", "cone", "sphere", "torus", "prism"};
  std::ostringstream text;
  text << kNames[static_cast<std::size_t>(kind)] << '(' << a << ", " << b << ", " << c;
  if (corners > 0) text << ", " << corners << " corners";
  text << ')';
  return text.str();
}

std::string SolidJob::words() const {
  std::ostringstream text;
  text << a.words() << " and " << b.words() << ", scale " << scale();
  if (off != 0) text << ", moved by " << off;
  if (turn != 0) text << ", turned by " << turn;
  return text.str();
}

SolidJob random_job(Random& random) {
  SolidJob job;
  job.a = random_solid(random);
  job.b = random_solid(random);
  job.b.place = random_place(random, job.a, job.b);
  if (chance(random, 0.2)) {
    const gp_Dir along = chance(random, 0.5) ? axis(random) : direction(random);
    job.off = power_of_ten(random, -10, -4);
    job.b.place = shift(gp_Vec(along) * job.off) * job.b.place;
  }
  if (chance(random, 0.05)) {
    const gp_Dir about = direction(random);
    job.turn = power_of_ten(random, -10, -4);
    job.b.place = turning(about, job.turn) * job.b.place;
  }
  job.world = random_world(random);
  job.off *= job.scale();
  return job;
}

SimpleSolid random_tool(Random& random) {
  SimpleSolid tool = random_solid(random);
  tool.place = shift(grid_shift(random)) * random_turn(random);
  return tool;
}

CountedVolume counted_common(const SolidJob& job) {
  const bool first = job.a.volume() < job.b.volume();
  const SimpleSolid &smaller = first ? job.a : job.b, &larger = first ? job.b : job.a;
  const OwnBox box = own_box(smaller);
  constexpr int kPoints = 4000000;
  // The additive sequence of the plastic number's cousin in three dimensions.
  constexpr std::array kSteps{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  int inside = 0;
  for (int i = 0; i < kPoints; ++i) {
    const auto at = [&](std::size_t k, double from, double to) {
      const double x = 0.5 + i * kSteps[k];
      return from + (to - from) * (x - std::floor(x));
    };
    const gp_Pnt p = gp_Pnt(at(0, box.low[0], box.high[0]), at(1, box.low[1], box.high[1]),
                            at(2, box.low[2], box.high[2]))
                         .Transformed(smaller.place);
    const Vec3 point{p.X(), p.Y(), p.Z()};
    inside += smaller.holds(point) && larger.holds(point);
  }
  const double whole = box.volume() * std::pow(job.scale(), 3);
  return {whole * inside / kPoints, whole * 1e-4};
}

std::string unsound(const TopoDS_Shape& shape) {
  if (!BRepCheck_Analyzer(shape).IsValid()) return "not valid by BRepCheck";
  const occt::Soundness found = occt::soundness(shape);
  if (!found.problems.empty()) return found.problems.front();
  for (const occt::FaceSoundness& face : found.faces)
    if (!face.problems.empty()) return face.problems.front().text();
  for (const occt::EdgeSoundness& edge : found.edges)
    if (!edge.problems.empty()) return edge.problems.front().text();
  return "";
}

int setting(const char* name, int otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoi(text);
}

}  // namespace blossom::testing
