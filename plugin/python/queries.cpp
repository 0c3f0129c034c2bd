// SPDX-License-Identifier: LGPL-2.1-or-later
// Questions about points, planes, rays and distances, and about models as they are.

#include <memory>
#include <utility>

#include "adapters/occt/soundness.h"
#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "plugin/pictures/results/continuity.h"
#include "plugin/pictures/results/models.h"
#include "plugin/python/answers.h"
#include "plugin/reports/blends/continuity.h"
#include "plugin/reports/models/edges.h"
#include "plugin/reports/models/info.h"
#include "plugin/reports/models/soundness.h"
#include "plugin/reports/queries/distance.h"
#include "plugin/reports/queries/mass.h"
#include "plugin/reports/queries/rays.h"

namespace blossom::python {
namespace {

// An answer whose report is all that there is.
Answer told(reports::Json report) {
  auto shared = std::make_shared<const reports::Json>(std::move(report));
  return {.report = [shared] { return *shared; }, .model = {}, .records = {}};
}

Vec3 unit_of(const Vec3& vector, const char* what) {
  const double largest = max_norm(vector);
  if (!(largest > 0)) throw InvalidInput(std::string(what) + ": the zero vector has no direction");
  return unit(vector * (1 / largest));
}

// Asks about distances of two models.
template <class Ask, class Report>
Answer compare(const SharedModel& a, const SharedModel& b, const Control& control, const Ask& ask,
               const Report& report) {
  return told(interruptible(control, [&](const Watch& watch) {
    const BothTurns turns(*a, *b, watch);
    const double start = watch.seconds();
    reports::MeasuredInput& side_a = a->measured(watch);
    reports::MeasuredInput& side_b = b->measured(watch);
    reports::DistanceAnswer answer =
        ask(side_a, side_b, control.engine.tolerances.point, [&watch] { return watch.distance(); });
    answer.seconds = watch.seconds() - start;
    return with_reading(report(side_a, side_b, answer), {a, b});
  }));
}

// Between two checks the work can be ended.
occt::CheckRunner checks_of(const Watch& watch) {
  return [&watch](const std::string&, const std::function<void()>& work) {
    watch.stop();
    work();
    return true;
  };
}

}  // namespace

occt::Plane plane_of(const Vec3& point, const Vec3& normal) {
  return {point, unit_of(normal, "normal")};
}

Answer cast_ray(const SharedModel& model, const Vec3& from, const Vec3& direction, bool first_only,
                bool line, const Control& control) {
  reports::RayAnswer answer{
      .line = line, .first_only = first_only, .tolerance = control.engine.tolerances.point};
  answer.ray.origin = from;
  answer.ray.direction = unit_of(direction, "direction");
  if (line) answer.ray.from = -kInfinity;
  return told(interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    reports::Input& input = model->repaired_input(watch);
    const double start = watch.seconds();
    try {
      const occt::ShapeRays& rays = model->rays(answer.tolerance, watch);
      answer.hits = first_only ? rays.first_hits(answer.ray) : rays.all_hits(answer.ray);
    } catch (const occt::LimitFailure&) {  // nothing is known, then
      answer.status = Status::Stopped;
    }
    answer.seconds = watch.seconds() - start;
    for (const occt::ShapeHit& hit : answer.hits)
      answer.status = weaker(answer.status, hit.hit.status);
    return with_reading(reports::ray_report(input, answer), {model});
  }));
}

Answer least_distance(const SharedModel& a, const SharedModel& b, const Control& control) {
  return compare(a, b, control, reports::distance_between, reports::distance_report);
}

Answer does_intersect(const SharedModel& a, const SharedModel& b, const Control& control) {
  return compare(a, b, control, reports::meeting_of, reports::meeting_report);
}

Answer nearest_point(const SharedModel& model, const Vec3& at, bool all, const Control& control) {
  return told(interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    const double start = watch.seconds();
    reports::MeasuredInput& side = model->measured(watch);
    reports::PointAnswer answer = reports::nearest_to(
        side, at, all, control.engine.tolerances.point, [&watch] { return watch.distance(); });
    answer.seconds = watch.seconds() - start;
    return with_reading(reports::point_report(side, answer), {model});
  }));
}

Answer mass(const SharedModel& model, const Control& control) {
  return told(interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    model->faces(watch);
    const reports::Input& input = model->repaired_input(watch);
    const double start = watch.seconds();
    const IntersectionOptions left = watch.engine();
    const WorkLimit limit(left);
    reports::MassAnswer answer = reports::masses_of(input, limit);
    answer.seconds = watch.seconds() - start;
    return with_reading(reports::mass_report(input, answer), {model});
  }));
}

Answer check(const SharedModel& model, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    model->faces(watch);
    const reports::Input& input = model->repaired_input(watch);
    watch.stop();
    const occt::CheckRunner checks = checks_of(watch);
    const occt::Soundness found = model->is_part()
                                      ? occt::soundness(input.model.shape(), input.numbers, checks)
                                      : occt::soundness(input.model.shape(), checks);
    Answer answer = told(with_reading(reports::soundness_report(input, found), {model}));
    answer.picture = in_turns({model}, [found, own = kept_input(input)] {
      return pictures::soundness_picture(*own, found);
    });
    return answer;
  });
}

Answer continuity(const SharedModel& model, const ContinuityTolerances& tolerances,
                  const std::string& require, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    model->faces(watch);
    const reports::Input& input = model->repaired_input(watch);
    const reports::ContinuityAnswer answer =
        reports::measured_continuity_of(input, tolerances, require, [&watch] { watch.stop(); });
    Answer made = told(with_reading(reports::continuity_report(input, answer), {model}));
    made.picture = in_turns({model}, [answer, own = kept_input(input)] {
      return pictures::continuity_picture(*own, answer);
    });
    return made;
  });
}

Answer info(const SharedModel& model, bool edges, bool faces, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    const reports::Input& input = model->input();
    occt::KeptForms forms;
    const auto problems = occt::face_problems(input.faces, input.numbers, checks_of(watch), &forms);
    const reports::ModelFacts facts = reports::model_facts(
        input, problems, faces ? reports::FaceDetail::Full : reports::FaceDetail::Brief,
        [&watch] { return watch.ended(); }, &forms);
    reports::Json report = reports::info_report(input, facts);
    if (edges) {
      const std::set<int> own = reports::edge_numbers(input);
      std::vector<occt::EdgeFacts> facts_of = occt::edge_facts(input.model.shape());
      if (model->is_part())
        std::erase_if(facts_of, [&](const auto& edge) { return !own.contains(edge.number); });
      report["edges"] = reports::edges_json(facts_of);
    }
    Answer answer = told(with_reading(std::move(report), {model}));
    answer.picture = in_turns(
        {model}, [facts, own = kept_input(input)] { return pictures::model_picture(*own, facts); });
    return answer;
  });
}

}  // namespace blossom::python
