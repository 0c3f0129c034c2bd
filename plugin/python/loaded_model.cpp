// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/loaded_model.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <utility>

#include <TopExp_Explorer.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/intersection_edges.h"

namespace blossom::python {
namespace {

[[noreturn]] void refuse_without_faces(const std::string& name, const TopoDS_Shape& shape) {
  const bool has_edges = !shape.IsNull() && TopExp_Explorer(shape, TopAbs_EDGE).More();
  throw occt::BadModel(
      name + ": there is no face in it" +
      (has_edges ? "; intersect(), section(), solid() and distance() take edges and wires" : ""));
}

constexpr std::chrono::milliseconds kPause{20};  // between questions whether to wait any longer

}  // namespace

LoadedModel::LoadedModel(std::string name, occt::Model model, reports::Repairing repair)
    : name_(std::move(name)),
      repair_(repair),
      model_(std::make_shared<occt::Model>(std::move(model))) {}

LoadedModel::LoadedModel(std::string name, const TopoDS_Shape& shape)
    : name_(std::move(name)), given_(shape) {}

std::shared_ptr<LoadedModel> LoadedModel::part(const std::vector<int>& numbers,
                                               const std::vector<std::string>& words,
                                               const std::string& name) {
  if (!words.empty()) sew(Watch());
  for (const int number : numbers) model().face(number);
  const reports::Selection named = reports::selection_of(model(), words);
  std::set<int> faces(numbers.begin(), numbers.end());
  faces.insert(named.faces.begin(), named.faces.end());
  std::shared_ptr<LoadedModel> made(new LoadedModel);
  made->name_ = name;
  made->repair_ = repair_;
  made->given_ = given_;
  made->numbers_ = words.empty() ? numbers : std::vector<int>(faces.begin(), faces.end());
  made->named_ = named;
  made->model_ = model_;
  made->working_ = working_;
  made->sewn_ = sewn_;
  made->open_sewn_ = open_sewn_;
  made->sewing_ = sewing_;
  return made;
}

occt::Model& LoadedModel::model() {
  if (!model_) {
    model_ = std::make_shared<occt::Model>();
    model_->add(given_, "");
  }
  return *model_;
}

const TopoDS_Shape& LoadedModel::whole_shape() const { return model_ ? model_->shape() : given_; }

TopoDS_Shape LoadedModel::shape() {
  if (!is_part()) return whole_shape();
  const reports::Input& part = input();
  return part.selected.IsNull() ? occt::compound_of(part.faces) : part.selected;
}

int LoadedModel::face_count() const {
  if (is_part()) return static_cast<int>(numbers_.size());
  return model_ ? model_->face_count() : static_cast<int>(occt::faces_of(given_).size());
}

const occt::Model* LoadedModel::file() const {
  return model_ && !model_->file().empty() ? model_.get() : nullptr;
}

LoadedModel::Turn LoadedModel::turn(const Watch& watch) const {
  Turn turn(*working_, std::defer_lock);
  while (!turn.try_lock_for(kPause)) watch.stop();
  return turn;
}

const std::vector<TopoDS_Face>& LoadedModel::faces(const Watch& watch, reports::LooseFaces loose) {
  if (model_ || loose == reports::LooseFaces::Sewn) {
    const reports::Input& input = repaired_input(watch, loose);
    if (input.faces.empty()) refuse_without_faces(name_, input.shape);
    return input.faces;
  }
  if (faces_.empty()) faces_ = occt::faces_of(given_);
  if (faces_.empty()) refuse_without_faces(name_, given_);
  return faces_;
}

reports::Input& LoadedModel::input() {
  if (measured_) return measured_->input;
  occt::Model& all = model();
  reports::Input input{name_, model_, all};
  input.sewing = sewing_;
  input.shape = all.shape();
  input.numbers = numbers_;
  for (int number = 1; number <= all.face_count() && !is_part(); ++number)
    input.numbers.push_back(number);
  if (is_part()) reports::choose(named_, input);
  for (const int number : input.numbers) input.faces.push_back(all.face(number));
  measured_.emplace(std::move(input));
  return measured_->input;
}

// Once; what is sewn already by another part of the model is told again. Models that answers made
// are as they were meant to be.
void LoadedModel::sew(const Watch& watch, occt::Sewable which) {
  if (sewn_ || (file() == nullptr && given_.IsNull())) return;
  if (which == occt::Sewable::Open && open_sewn_) return;
  sewing_ = model().sew(
      {}, [&watch] { watch.stop(); }, which);
  sewn_ = which == occt::Sewable::All;
  open_sewn_ = true;
  measured_.reset();
  rays_.reset();
  repaired_ = false;
}

reports::Input& LoadedModel::repaired_input(const Watch& watch, reports::LooseFaces loose) {
  if (loose == reports::LooseFaces::Sewn) sew(watch);
  if (loose == reports::LooseFaces::OpenSewn) sew(watch, occt::Sewable::Open);
  reports::Input& known = input();
  if (repair_ == reports::Repairing::None || repaired_) return known;
  const std::function<void()> stop = [&watch] { watch.stop(); };
  known.repairs = is_part() ? known.model.repair(known.numbers, stop) : known.model.repair(stop);
  repaired_ = true;
  return known;
}

reports::MeasuredInput& LoadedModel::measured(const Watch& watch) {
  repaired_input(watch);
  if (!measured_->bodies) measured_->prepare();
  return *measured_;
}

const occt::ShapeRays& LoadedModel::rays(double tolerance, const Watch& watch) {
  if (rays_ && rays_tolerance_ == tolerance) return *rays_;
  const IntersectionOptions left = watch.engine();
  const WorkLimit limit(left);
  rays_.emplace(faces(watch), tolerance, &limit);
  rays_tolerance_ = tolerance;
  return *rays_;
}

std::shared_ptr<LoadedModel> LoadedModel::usable_part(const Watch& watch) {
  if (usable_known_ || file() == nullptr || is_part()) return usable_;
  reports::Input input = repaired_input(watch, reports::LooseFaces::Kept);
  reports::UnusableFaces dropped = reports::drop_unusable_faces(input);
  if (!dropped.open.empty() || !dropped.lines.empty()) {
    usable_ = part(input.numbers, {}, name_);
    usable_->named_.solids.insert(input.solids.begin(), input.solids.end());
    usable_->left_out_ = std::move(dropped);
  }
  usable_known_ = true;
  return usable_;
}

BothTurns::BothTurns(LoadedModel& a, LoadedModel& b, const Watch& watch) {
  // By address, so that two questions about the same two models never wait for each other.
  LoadedModel* const lower = std::less<>()(a.turn_order(), b.turn_order()) ? &a : &b;
  LoadedModel* const upper = lower == &a ? &b : &a;
  first = lower->turn(watch);
  if (!lower->shares_turn(*upper)) second = upper->turn(watch);
}

Turns turns_of(std::vector<SharedModel> models, const Watch& watch) {
  std::ranges::sort(models, std::less<>(), [](const SharedModel& m) { return m->turn_order(); });
  Turns turns;
  for (std::size_t i = 0; i < models.size(); ++i)
    if (i == 0 || !models[i]->shares_turn(*models[i - 1])) turns.push_back(models[i]->turn(watch));
  return turns;
}

}  // namespace blossom::python
