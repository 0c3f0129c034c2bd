// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections with one plane and with many.

#include <algorithm>
#include <memory>
#include <utility>

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_TrimmedCurve.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "plugin/drawings/section_drawing.h"
#include "plugin/pictures/results/sections.h"
#include "plugin/python/answers.h"
#include "plugin/python/arrays.h"
#include "plugin/reports/models/edges.h"
#include "plugin/reports/queries/plane_cuts.h"
#include "plugin/reports/queries/section.h"

namespace py = pybind11;
using namespace py::literals;

namespace blossom::python {
namespace {

// The curve as a B-spline, with the parameters that it has.
Handle(Geom_BSplineCurve) spline_of(const occt::SectionCurve& curve) {
  Handle(Geom_Curve) whole = curve.curve;
  Interval range = curve.range;
  if (!curve.edge.IsNull()) whole = BRep_Tool::Curve(curve.edge, range.from, range.to);
  return GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(whole, range.from, range.to));
}

void add_splines(const occt::PlaneSection& section, py::list& splines) {
  for (const occt::SectionCurve& curve : section.curves)
    splines.append(spline_record(spline_of(curve)));
}

// Faces, or edges without any.
const reports::Input& sectioned(LoadedModel& model, const Watch& watch) {
  const reports::Input& input = model.repaired_input(watch);
  if (input.faces.empty() && reports::edges_without_faces(input).empty())
    throw occt::BadModel(model.name() + ": there is no face and no edge in it");
  return input;
}

struct Cut {
  SharedModel model;
  occt::Plane plane;
  double tolerance = 0;
  occt::PlaneSection section;
  double seconds = 0;
};

struct Cuts {
  SharedModel model;
  reports::SectionsAnswer answer;
};

// Part by part. For the work's thread, which has the model's turn.
reports::SectionsAnswer cut_parts(LoadedModel& model,
                                  const std::vector<reports::NamedPlane>& planes, double tolerance,
                                  const Watch& watch) {
  const reports::Input& input = sectioned(model, watch);
  return reports::sections_of(input, planes,
                              {tolerance, [&] { return watch.engine(); }, [&] { watch.stop(); }});
}

void draw(const reports::SectionsAnswer& answer, const std::string& file, const Watch& watch) {
  const auto is_empty = [](const reports::SectionsOfPlane& plane) { return plane.parts.empty(); };
  if (std::ranges::all_of(answer.planes, is_empty))
    throw occt::Failure(file + ": there is nothing to draw, since no plane meets the model");
  drawings::write_section_drawing(answer, file, [&watch] { watch.stop(); });
}

// The parts of a section with one plane count only in its drawing, so they are cut for that.
void draw_cut(const Cut& cut, const std::string& file, const Control& control) {
  interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = cut.model->turn(watch);
    draw(cut_parts(*cut.model, {{cut.plane, "section"}}, cut.tolerance, watch), file, watch);
  });
}

void draw_cuts(const Cuts& cuts, const std::string& file, const Control& control) {
  interruptible(control, [&](const Watch& watch) { draw(cuts.answer, file, watch); });
}

}  // namespace

Answer section(const SharedModel& model, const Vec3& point, const Vec3& normal,
               const Control& control) {
  auto cut = std::make_shared<Cut>(
      Cut{model, plane_of(point, normal), control.engine.tolerances.point, {}, 0});
  interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    const reports::Input& input = sectioned(*model, watch);
    const double start = watch.seconds();
    cut->section = occt::plane_section(input.faces, cut->plane, watch.engine(),
                                       reports::edges_without_faces(input));
    cut->seconds = watch.seconds() - start;
  });
  return {.report =
              [cut] {
                const LoadedModel::Turn turn = cut->model->turn(Watch());
                return with_reading(
                    reports::section_report(cut->model->input(), cut->plane, cut->tolerance,
                                            cut->section, cut->seconds),
                    {cut->model});
              },
          .model =
              [cut] {
                return std::make_shared<LoadedModel>("section", occt::compound_of(cut->section));
              },
          .records =
              [cut] {
                py::list splines;
                add_splines(cut->section, splines);
                return py::dict("splines"_a = splines);
              },
          .draw = [cut](const std::string& file,
                        const Control& wanted) { draw_cut(*cut, file, wanted); },
          .picture = in_turns({cut->model}, [cut] {
            return pictures::section_picture(cut->model->input(), cut->section,
                                             stated_status(cut->section.status, {cut->model}));
          })};
}

Answer sections(const SharedModel& model, const std::vector<reports::NamedPlane>& planes,
                const Control& control) {
  auto cuts = std::make_shared<Cuts>(Cuts{model, {}});
  interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    cuts->answer = cut_parts(*model, planes, control.engine.tolerances.point, watch);
  });
  return {.report =
              [cuts] {
                const LoadedModel::Turn turn = cuts->model->turn(Watch());
                return with_reading(reports::sections_report(cuts->model->input(), cuts->answer),
                                    {cuts->model});
              },
          .model = [cuts]() -> SharedModel {
            occt::Model made = reports::model_of(cuts->answer);
            if (made.shape().IsNull()) return nullptr;
            return std::make_shared<LoadedModel>("sections", std::move(made),
                                                 reports::Repairing::None);
          },
          .records =
              [cuts] {
                py::list splines;
                for (const reports::SectionsOfPlane& plane : cuts->answer.planes)
                  for (const reports::PartSection& part : plane.parts)
                    add_splines(part.section, splines);
                return py::dict("splines"_a = splines);
              },
          .draw = [cuts](const std::string& file,
                         const Control& wanted) { draw_cuts(*cuts, file, wanted); },
          .picture = in_turns({cuts->model}, [cuts] {
            return pictures::sections_picture(cuts->model->input(), cuts->answer);
          })};
}

}  // namespace blossom::python
