// SPDX-License-Identifier: LGPL-2.1-or-later
// A model that stays in memory with what questions about it have made ready.

#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/ray_casting.h"
#include "adapters/occt/shapes.h"
#include "plugin/python/control.h"
#include "plugin/reports/models/measured_input.h"
#include "plugin/reports/models/selection.h"

namespace blossom::python {

/// A file's model, one that was made, or a shape of the caller's, which is never changed; or some
/// faces of one.
class LoadedModel {
 public:
  /// name     what reports and messages call it
  /// repair   whether it is repaired when the first question needs that, as files are
  LoadedModel(std::string name, occt::Model model, reports::Repairing repair);
  LoadedModel(std::string name, const TopoDS_Shape& shape);

  /// Some faces, by their numbers in the model, which they keep, and what words name, as inputs of
  /// the command line: parts and solids have an inside. Words are of the model with its loose faces
  /// sewn, which gives solids and edges other numbers, so they have it sewn first.
  /// throws   BadModel if there is no such face, or nothing is called so
  std::shared_ptr<LoadedModel> part(const std::vector<int>& numbers,
                                    const std::vector<std::string>& words, const std::string& name);

  const std::string& name() const { return name_; }
  bool is_part() const { return !numbers_.empty() || !named_.edges.empty(); }
  const TopoDS_Shape& whole_shape() const;
  /// Only the chosen faces, if some are.
  TopoDS_Shape shape();
  int face_count() const;
  /// What a file is and what reading it lost; null if it is none.
  const occt::Model* file() const;
  /// Of a face by its place among the faces of a question.
  int number_of(int face) const {
    return numbers_.empty() ? face + 1 : numbers_[static_cast<std::size_t>(face)];
  }

  /// The members below belong to one question at a time.
  using Turn = std::unique_lock<std::timed_mutex>;
  /// Waits for other questions.
  /// throws   CancelledWork
  Turn turn(const Watch& watch) const;
  /// Whether two parts of one model wait for the same turn.
  bool shares_turn(const LoadedModel& other) const { return working_ == other.working_; }
  /// What turns are ordered by.
  const void* turn_order() const { return working_.get(); }

  /// Faces, repaired if they are a file's.
  /// throws   BadModel if there is none
  const std::vector<TopoDS_Face>& faces(const Watch& watch,
                                        reports::LooseFaces loose = reports::LooseFaces::Sewn);
  /// Made of a caller's shape when first needed.
  occt::Model& model();
  /// What reports speak of, repaired if wanted.
  reports::Input& input();
  reports::Input& repaired_input(const Watch& watch,
                                 reports::LooseFaces loose = reports::LooseFaces::Sewn);
  /// Ready for distances.
  reports::MeasuredInput& measured(const Watch& watch);
  const occt::ShapeRays& rays(double tolerance, const Watch& watch);
  /// All of a file's faces but those that cannot be searched (reports::drop_unusable_faces); null
  /// if all can, or some are chosen.
  std::shared_ptr<LoadedModel> usable_part(const Watch& watch);

  /// Of such a part.
  const reports::UnusableFaces& left_out() const { return left_out_; }

 private:
  LoadedModel() = default;
  void sew(const Watch& watch, occt::Sewable which = occt::Sewable::All);

  std::string name_;
  reports::Repairing repair_ = reports::Repairing::None;
  TopoDS_Shape given_;          // of a caller
  std::vector<int> numbers_;    // none, and no edges: all
  reports::Selection named_{};  // beside them, or among them
  std::shared_ptr<occt::Model> model_;
  std::shared_ptr<std::timed_mutex> working_ = std::make_shared<std::timed_mutex>();
  bool repaired_ = false;
  bool sewn_ = false, open_sewn_ = false;
  occt::Sewing sewing_;
  std::vector<TopoDS_Face> faces_;
  std::optional<reports::MeasuredInput> measured_;
  std::optional<occt::ShapeRays> rays_;
  double rays_tolerance_ = 0;
  std::shared_ptr<LoadedModel> usable_;
  bool usable_known_ = false;
  reports::UnusableFaces left_out_;
};

using SharedModel = std::shared_ptr<LoadedModel>;

/// What `ask(model)`, which makes no objects of Python, says while no other question changes the
/// model. For callers with Python's lock, which waits elsewhere.
template <class Model, class Ask>
auto in_turn(Model& model, Ask&& ask) {
  const pybind11::gil_scoped_release released;
  const LoadedModel::Turn turn = model.turn(Watch());
  return ask(model);
}

/// The turns of both models of a question; they may be one.
struct BothTurns {
  BothTurns(LoadedModel& a, LoadedModel& b, const Watch& watch);
  LoadedModel::Turn first, second;
};

using Turns = std::list<LoadedModel::Turn>;

/// The turns of all models, each once and in one order for everybody.
Turns turns_of(std::vector<SharedModel> models, const Watch& watch);

}  // namespace blossom::python
