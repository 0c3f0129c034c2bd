// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/results.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "adapters/occt/exchange/brep_bytes.h"
#include "adapters/occt/intersection_edges.h"

namespace py = pybind11;

namespace blossom::python {
namespace {

struct Intersection {
  SharedAnswer answer;
};

struct Curve {
  SharedAnswer answer;
  const occt::FaceIntersection* pair = nullptr;
  std::size_t number = 0;

  const IntersectionCurve& get() const { return pair->found.curves[number]; }
};

// Pieces between seams that are one curve.
struct Chain {
  SharedAnswer answer;
  const occt::FaceIntersection* pair = nullptr;
  const CurveChain* chain = nullptr;
  std::size_t first = 0;  // place of the pair's first curve among all curves
};

struct Contact {
  SharedAnswer answer;
  const occt::FaceIntersection* pair = nullptr;
  const SurfacePoint* where = nullptr;
  const occt::BorderPlace* border = nullptr;  // null for a node
};

struct OverlapOf {
  SharedAnswer answer;
  const occt::FaceIntersection* pair = nullptr;
  const Overlap* overlap = nullptr;
};

struct PlaceOf {
  SharedAnswer answer;
  const occt::FaceIntersection* pair = nullptr;
  const Place* place = nullptr;
};

// Face numbers are 1-based at every door.
template <class Part>
int face_a(const Part& part) {
  return part.pair->face_a + 1;
}
template <class Part>
int face_b(const Part& part) {
  return part.pair->face_b + 1;
}

/// A view that cannot be written to; it keeps the answer alive.
template <std::size_t Rank>
py::array view(const SharedAnswer& answer, const double* first,
               const std::array<py::ssize_t, Rank>& shape,
               const std::array<py::ssize_t, Rank>& strides) {
  auto* owner = new SharedAnswer(answer);
  const py::capsule base(owner, [](void* held) { delete static_cast<SharedAnswer*>(held); });
  py::array array(py::dtype::of<double>(), shape, strides, first, base);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <int Dim>
py::array view(const SharedAnswer& answer, const Vec<double, Dim>& vector) {
  return view<1>(answer, vector.coordinates.data(), {Dim}, {sizeof(double)});
}

/// One member of all points: (n, Dim), without a copy.
template <int Dim>
py::array members(const SharedAnswer& answer, const std::vector<SurfacePoint>& all,
                  Vec<double, Dim> SurfacePoint::*member) {
  const auto count = static_cast<py::ssize_t>(all.size());
  const double* first = all.empty() ? nullptr : (all.front().*member).coordinates.data();
  return view<2>(answer, first, {count, Dim}, {sizeof(SurfacePoint), sizeof(double)});
}

template <int Dim>
py::array samples(const Curve& curve, Vec<double, Dim> SurfacePoint::*member) {
  return members(curve.answer, curve.get().samples, member);
}

template <int Dim>
py::array boundary(const OverlapOf& o, Vec<double, Dim> SurfacePoint::*member) {
  return members(o.answer, o.overlap->boundary, member);
}

py::dict deviation(const Deviation& deviation) {
  using namespace py::literals;
  return py::dict("a"_a = deviation.a, "b"_a = deviation.b, "between"_a = deviation.between);
}

py::object conic(const Curve& curve) {
  using namespace py::literals;
  const std::optional<Conic>& conic = curve.get().conic;
  if (!conic) return py::none();
  const Interval range = curve.get().curve.domain();
  return py::dict("type"_a = to_string(conic->kind), "centre"_a = conic->centre.coordinates,
                  "x"_a = conic->x.coordinates, "y"_a = conic->y.coordinates,
                  "major"_a = conic->major, "minor"_a = conic->minor,
                  "range"_a = std::pair{range.from, range.to});
}

py::dict certificate(const Certificate& proof) {
  using namespace py::literals;
  return py::dict(
      "excluded"_a = proof.excluded, "certified"_a = proof.certified, "critical"_a = proof.critical,
      "cells_bezier"_a = proof.cells_bezier, "cells_monomial"_a = proof.cells_monomial,
      "depth"_a = proof.depth, "identified"_a = proof.identified,
      "identified_within"_a = proof.identified_within, "rounding_bound"_a = proof.rounding_bound,
      "least_angle"_a = proof.least_angle, "reasons"_a = proof.reasons);
}

py::list curves(const Intersection& self) {
  py::list list;
  for (const occt::FaceIntersection& pair : self.answer->found.pairs)
    for (std::size_t i = 0; i < pair.found.curves.size(); ++i)
      list.append(Curve{self.answer, &pair, i});
  return list;
}

py::list chains(const Intersection& self) {
  py::list list;
  std::size_t first = 0;
  for (const occt::FaceIntersection& pair : self.answer->found.pairs) {
    for (const CurveChain& chain : pair.chains)
      list.append(Chain{self.answer, &pair, &chain, first});
    first += pair.found.curves.size();
  }
  return list;
}

py::list pieces(const Chain& self) {
  py::list list;
  for (const ChainUse& use : self.chain->uses)
    list.append(py::make_tuple(self.first + static_cast<std::size_t>(use.curve), use.forward));
  return list;
}

double length(const Chain& self) {
  double sum = 0;
  for (const ChainUse& use : self.chain->uses)
    sum += self.pair->found.curves[static_cast<std::size_t>(use.curve)].length;
  return sum;
}

py::list points(const Intersection& self) {
  py::list list;
  for (const occt::FaceIntersection& pair : self.answer->found.pairs)
    for (std::size_t i = 0; i < pair.found.points.size(); ++i)
      list.append(Contact{self.answer, &pair, &pair.found.points[i], &pair.borders[i]});
  return list;
}

py::list nodes(const Intersection& self) {
  py::list list;
  for (const occt::FaceIntersection& pair : self.answer->found.pairs)
    for (const SurfacePoint& where : pair.found.nodes)
      list.append(Contact{self.answer, &pair, &where});
  return list;
}

py::object on_a(const Contact& c) {
  if (c.border == nullptr) return py::none();
  const occt::BorderNumber found = c.answer->numbers_a.of(c.border->on_a, face_a(c));
  return py::make_tuple(found.kind, found.number);
}

py::object on_b(const Contact& c) {
  if (c.border == nullptr) return py::none();
  const occt::BorderNumber found = c.answer->numbers_b.of(c.border->on_b, face_b(c));
  return py::make_tuple(found.kind, found.number);
}

py::list overlaps(const Intersection& self) {
  py::list list;
  for (const occt::FaceIntersection& pair : self.answer->found.pairs)
    for (const Overlap& overlap : pair.found.overlaps)
      list.append(OverlapOf{self.answer, &pair, &overlap});
  return list;
}

py::list places(const Intersection& self) {
  py::list list;
  for (const occt::FaceIntersection& pair : self.answer->found.pairs)
    for (const Place& place : pair.found.places) list.append(PlaceOf{self.answer, &pair, &place});
  return list;
}

std::string summary(const Intersection& self) {
  const auto count = [](const py::list& list) { return std::to_string(list.size()); };
  return "<blossom.Intersection: " + std::string(to_string(self.answer->found.status)) + ", " +
         count(chains(self)) + " curves, " + count(points(self)) + " points, " +
         count(places(self)) + " places>";
}

void add_curve(py::module_& module) {
  py::class_<Curve>(module, "Curve", "One curve, from border or node to border or node, or closed.")
      .def_property_readonly("points",
                             [](const Curve& c) { return samples(c, &SurfacePoint::point); })
      .def_property_readonly("uv_a", [](const Curve& c) { return samples(c, &SurfacePoint::uv_a); })
      .def_property_readonly("uv_b", [](const Curve& c) { return samples(c, &SurfacePoint::uv_b); })
      .def_property_readonly("closed", [](const Curve& c) { return c.get().closed; })
      .def_property_readonly("tangential", [](const Curve& c) { return c.get().tangential; })
      .def_property_readonly("length", [](const Curve& c) { return c.get().length; })
      .def_property_readonly("conic", &conic,
                             "None, or a dict: type (line, circle, ellipse, parabola, hyperbola), "
                             "centre, x, y, major, minor, range of its parameter.")
      .def_property_readonly("degree", [](const Curve& c) { return c.get().curve.degree; })
      .def_property_readonly("poles", [](const Curve& c) { return c.get().curve.points.size(); })
      .def_property_readonly("deviation",
                             [](const Curve& c) { return deviation(c.get().deviation); })
      .def_property_readonly("deviation_proven",
                             [](const Curve& c) { return c.get().deviation.proven; })
      .def_property_readonly("face_a", &face_a<Curve>)
      .def_property_readonly("face_b", &face_b<Curve>);
}

void add_chain(py::module_& module) {
  py::class_<Chain>(module, "Chain", "Curves that go on across the seams of a closed surface.")
      .def_property_readonly("curves", &pieces,
                             "In order, the place in Intersection.curves and whether it is walked "
                             "from its first point to its last one.")
      .def_property_readonly("closed", [](const Chain& c) { return c.chain->closed; })
      .def_property_readonly("length", &length)
      .def_property_readonly("face_a", &face_a<Chain>)
      .def_property_readonly("face_b", &face_b<Chain>);
}

void add_contact(py::module_& module) {
  py::class_<Contact>(module, "Contact", "A point that both faces have in common.")
      .def_property_readonly("point",
                             [](const Contact& c) { return view(c.answer, c.where->point); })
      .def_property_readonly("uv_a", [](const Contact& c) { return view(c.answer, c.where->uv_a); })
      .def_property_readonly("uv_b", [](const Contact& c) { return view(c.answer, c.where->uv_b); })
      .def_property_readonly("on_a", &on_a,
                             "What of a the point is on, within tolerance: its kind (face, edge or "
                             "vertex) and number. None for a node.")
      .def_property_readonly("on_b", &on_b)
      .def_property_readonly("face_a", &face_a<Contact>)
      .def_property_readonly("face_b", &face_b<Contact>);
}

void add_overlap(py::module_& module) {
  py::class_<OverlapOf>(module, "Overlap",
                        "An area that both faces have in common; the boundary repeats its first "
                        "point and has the area to its left, seen from the tip of a's normal.")
      .def_property_readonly("boundary",
                             [](const OverlapOf& o) { return boundary(o, &SurfacePoint::point); })
      .def_property_readonly("uv_a",
                             [](const OverlapOf& o) { return boundary(o, &SurfacePoint::uv_a); })
      .def_property_readonly("uv_b",
                             [](const OverlapOf& o) { return boundary(o, &SurfacePoint::uv_b); })
      .def_property_readonly("face_a", &face_a<OverlapOf>)
      .def_property_readonly("face_b", &face_b<OverlapOf>);
}

void add_place(py::module_& module) {
  py::class_<PlaceOf>(module, "Place",
                      "A box in which the faces stay within tolerance, or which stayed open.")
      .def_property_readonly("kind", [](const PlaceOf& p) { return to_string(p.place->kind); })
      .def_property_readonly(
          "box",
          [](const PlaceOf& p) {
            return std::pair{p.place->box_low.coordinates, p.place->box_high.coordinates};
          })
      .def_property_readonly("gap",
                             [](const PlaceOf& p) {
                               return std::pair{p.place->gap_low, p.place->gap_high};
                             })
      .def_property_readonly("face_a", &face_a<PlaceOf>)
      .def_property_readonly("face_b", &face_b<PlaceOf>);
}

}  // namespace

void add_results(py::module_& module) {
  add_curve(module);
  add_chain(module);
  add_contact(module);
  add_overlap(module);
  add_place(module);
  py::class_<Intersection>(module, "Intersection", "All intersections of two shapes.")
      .def_property_readonly(
          "status", [](const Intersection& s) { return to_string(s.answer->found.status); })
      .def_property_readonly("curves", &curves)
      .def_property_readonly("chains", &chains)
      .def_property_readonly("points", &points)
      .def_property_readonly("nodes", &nodes)
      .def_property_readonly("overlaps", &overlaps)
      .def_property_readonly("places", &places)
      .def_property_readonly(
          "certificate",
          [](const Intersection& s) { return certificate(s.answer->found.certificate); })
      .def_property_readonly("seconds", [](const Intersection& s) { return s.answer->seconds; })
      .def(
          "to_brep",
          [](const Intersection& s) {
            std::string text;
            {
              const py::gil_scoped_release released;
              text = occt::brep_text(occt::compound_of(s.answer->found));
            }
            return py::bytes(text);
          },
          "The edges, and vertices at isolated contacts, as a compound in BRep text.")
      .def("__repr__", &summary);
}

py::object python_answer(Answer answer) {
  return py::cast(Intersection{std::make_shared<const Answer>(std::move(answer))});
}

}  // namespace blossom::python
