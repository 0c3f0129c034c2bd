// SPDX-License-Identifier: LGPL-2.1-or-later
// The questions of the module and what it hands to Python as answers.

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/plane_section.h"
#include "core/base/status.h"
#include "core/blending/continuity/continuity.h"
#include "core/tessellation/facet_options.h"
#include "plugin/meshes/mesh_files.h"
#include "plugin/nets/pieces.h"
#include "plugin/nets/whole_parts.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/python/control.h"
#include "plugin/python/loaded_model.h"
#include "plugin/reports/blends/fillet.h"
#include "plugin/reports/blends/strip.h"
#include "plugin/reports/queries/section.h"
#include "plugin/reports/text/json.h"

namespace blossom::python {

/// Each is made when it is asked for. Functions hold what they need of models and results.
struct Answer {
  std::function<reports::Json()> report;  ///< as the command line writes it
  std::function<SharedModel()> model;     ///< the shape that was made; none if that is nothing
  /// What has more than the report, as arrays of numpy. With Python's lock.
  std::function<pybind11::dict()> records;
  /// Writes a drawing, .dxf or .svg; none if the answer is no section.
  std::function<void(const std::string& file, const Control& control)> draw{};
  /// What there is to see of it, in the turns of its models; none if that is its shape alone.
  std::function<pictures::Picture(const Watch& watch)> picture{};
};

/// How an answer is shown.
struct Look {
  std::string form;  ///< "png", "html" or "glb"
  std::string view;  ///< as pictures::view_direction takes it; empty for the usual one
  int width = 0;     ///< pixels
  int height = 0;
  bool zebra = false;  ///< stripes on the faces
};

/// Writes the picture of an answer that has one.
/// returns   what is to be said of it
/// throws    InvalidInput if the view or the size is none
std::vector<std::string> show(const Answer& answer, const std::string& file, const Look& look,
                              const Control& control);

/// A picture that `make()` makes in the turns of models. What it holds outlives them: see
/// kept_input.
template <class Make>
auto in_turns(std::vector<SharedModel> models, Make make) {
  return [models = std::move(models), make = std::move(make)](const Watch& watch) {
    const Turns turns = turns_of(models, watch);
    return pictures::Picture(make());
  };
}

/// An input as a question has seen it, whatever others make of the model.
inline std::shared_ptr<const reports::Input> kept_input(const reports::Input& input) {
  return std::make_shared<const reports::Input>(input);
}

/// A report as `--json` gives it: with what reading these models lost, and a status no better than
/// that allows.
reports::Json with_reading(reports::Json report, const std::vector<SharedModel>& models);

/// A status as it may be said of an answer: at most Tolerance if shapes are missing.
Status stated_status(Status status, const std::vector<SharedModel>& models);

Answer intersect(const SharedModel& a, const SharedModel& b, const Control& control);
/// all_faces   different faces with each other, too
Answer self_intersect(const SharedModel& model, bool all_faces, const Control& control);

/// normal   of any length but 0, as is a direction
Answer section(const SharedModel& model, const Vec3& point, const Vec3& normal,
               const Control& control);
/// Part by part, planes in their order.
Answer sections(const SharedModel& model, const std::vector<reports::NamedPlane>& planes,
                const Control& control);
Answer cast_ray(const SharedModel& model, const Vec3& from, const Vec3& direction, bool first_only,
                bool line, const Control& control);
Answer least_distance(const SharedModel& a, const SharedModel& b, const Control& control);
Answer does_intersect(const SharedModel& a, const SharedModel& b, const Control& control);
Answer nearest_point(const SharedModel& model, const Vec3& at, bool all, const Control& control);
Answer mass(const SharedModel& model, const Control& control);
Answer check(const SharedModel& model, const Control& control);
Answer continuity(const SharedModel& model, const ContinuityTolerances& tolerances,
                  const std::string& require, const Control& control);
/// edges   list all edges of the model, too
/// faces   measure faces: radii, axes, areas, colours
Answer info(const SharedModel& model, bool edges, bool faces, const Control& control);

Answer trim(const SharedModel& part, const std::vector<SharedModel>& tools,
            const std::vector<occt::Plane>& planes, const std::string& keep,
            const Control& control);
Answer combine_solids(const std::string& operation, const SharedModel& part,
                      const std::vector<SharedModel>& tools, const std::vector<occt::Plane>& planes,
                      const Control& control);
Answer watertight(const SharedModel& model, const Control& control);
Answer strip_between(const SharedModel& a, const SharedModel& b, const reports::StripWishes& wishes,
                     const Control& control);

/// of           fillets or chamfers
/// full_round   fillets by the radii of two edges that leave nothing of the face between these
Answer blend_edges(const SharedModel& part, const reports::EdgeWish& edges,
                   const occt::FilletOptions& of, bool full_round, const Control& control);

/// b      null: pairs of parts of `a`
/// far    list pairs of which only the boxes were looked at, too
Answer clash(const SharedModel& a, const SharedModel& b, std::optional<double> clearance, bool far,
             const Control& control);

/// options   a deviation of 0 is a thousandth of the model's size, here and below
Answer mesh(const SharedModel& model, const FacetOptions& options, const Control& control);
/// file   .stl, .ply, .obj, .off or .glb, which has names and colours
/// text   .stl, .ply and .off are not binary
void write_mesh(const SharedModel& model, const FacetOptions& options, const std::string& file,
                bool text, const Control& control);
/// Likewise a mesh that there is already; not .glb.
void write_triangles(const meshes::FileMesh& mesh, const std::string& file, bool text,
                     const Control& control);

struct FillWish {
  std::vector<int> edges{};               ///< numbers; none: all that are open
  std::vector<std::string> continuity{};  ///< "G0", "G1", "G2": one, or one for each edge
  std::string layout{};                   ///< "auto", "star", "ring", "deep-ring"
  double angle = 0;                       ///< between normals that count as one, radians
  bool sew = false;                       ///< joined to the model
};
Answer fill(const SharedModel& model, const FillWish& wish, const Control& control);

/// cut   an interval is of the model's edges, anything else of its faces
Answer subdivide(const SharedModel& model, const nets::Cut& cut, const Control& control);
/// Each face, or edge, as one B-spline.
Answer subdivide_whole(const SharedModel& model, const nets::WholeCut& cut, const Control& control);
/// to   "bezier", "monomial" or "triangles"; the control's tolerance is how far borders
///      may lie from trims
Answer convert(const SharedModel& model, const std::string& to, const Control& control);

/// The answer with a report that is made already, and the shape of a model; none if that is null.
Answer made_answer(reports::Json report, SharedModel model);

/// The records of an answer that is nets. With Python's lock.
pybind11::dict net_records(const std::vector<nets::Net>& made);

/// A plane whose normal has the length 1.
/// throws   InvalidInput if the normal is 0
occt::Plane plane_of(const Vec3& point, const Vec3& normal);

}  // namespace blossom::python
