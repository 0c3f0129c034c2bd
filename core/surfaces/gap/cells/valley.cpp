// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/cells/valley.h"

#include <algorithm>
#include <cmath>

#include "core/forms/evaluation.h"
#include "core/math/functions/sign_change.h"
#include "core/surfaces/gap/cells/valley_labels.h"
#include "core/surfaces/gap/limits.h"
#include "core/surfaces/gap/model_points.h"

namespace blossom {
namespace {

constexpr double kSlowLength =
    1.0 / 64;                      // of the size: a gap that changes by less than kSlowChange
constexpr double kSlowChange = 4;  // tolerances over this length is a contact, not a fold
constexpr int kBranchSteps = 6;
constexpr double kTurn = 0.5;  // cosine: chords of a branch that turn more are looked at
constexpr std::size_t kMaxBranchPoints = 24;
// Of a branch's width in w: where the model is farther off its ends, points between them are beside
// the branch.
constexpr double kMaxOff = 0.5;
constexpr double kRootWidth = 0x1p-51;  // of the cell

// The slope of a gap, by w, that is slow.
double slow_slope(const RationalBezierPatch& patch, const Cell& a, const Vec2& w_axis,
                  const ValleyOptions& options) {
  const PatchJet jet = jet_at(patch, at(a.u, 0.5), at(a.v, 0.5), 1);
  const double speed =
      norm(jet.u * (0.5 * length(a.u) * w_axis[0]) + jet.v * (0.5 * length(a.v) * w_axis[1]));
  return kSlowChange * options.tolerance * speed / (kSlowLength * options.size);
}

// Sweeps along the valley of a cell and collects its branches and contacts.
class Reader {
 public:
  Reader(const RationalBezierPatch& patch_a, const Cell& a, const RationalBezierPatch& patch_b,
         const GapModel& model, const ValleyShape& shape, const ValleyOptions& options)
      : patch_a_(patch_a),
        a_(a),
        patch_b_(patch_b),
        shape_(shape),
        points_(patch_a, a, patch_b, model, shape),
        labels_(shape, options.tolerance, slow_slope(patch_a, a, shape.w_axis, options)) {}

  bool run(ValleyCell& found) {
    found_ = &found;
    if (labels_.read() && sweep()) return true;
    found = {};
    for (int edge = 0; edge < 4; ++edge)
      if (labels_.valley_along(edge)) return add_edge_contact(edge);
    return false;
  }

 private:
  bool add_edge_contact(int edge) {
    const std::size_t fixed = edge < 2 ? 0 : 1;
    const Interval& side = fixed == 0 ? a_.u : a_.v;
    const Interval& run = fixed == 0 ? a_.v : a_.u;
    CellContact contact;
    contact.leaves = {true, true};
    for (int k = 0; k <= kContactSteps; ++k) {
      const double t = k / static_cast<double>(kContactSteps);
      const Vec2 wz = shape_.on_edge(edge, 2 * t - 1);
      Point4 start = points_.at(wz[0], wz[1]);
      start[fixed] = edge % 2 == 0 ? side.from : side.to;
      start[1 - fixed] = at(run, t);
      const auto x = foot_point(patch_a_, patch_b_, start, points_.reach());
      if (!x) return false;
      contact.path.push_back(*x);
      contact.gaps.push_back(points_.gap(*x));
    }
    found_->contacts.push_back(contact);
    return true;
  }

  // --- the sweep

  struct Open {
    bool active = false;
    bool fold = false;
    double w = 0;
    Point4 start{};
    int contact = -1;
  };

  struct Stop {
    bool fold = false;
    double w = 0;
    Point4 point{};
    int contact = -1;
  };

  // A change of the valley: from one label to the next, at w; `enter`, `leave` at borders.
  struct Change {
    double w;
    std::optional<ValleyLabel> before, after;
    const BorderEvent* border = nullptr;
  };

  bool sweep() {
    std::vector<Change> changes;
    const auto& crossings = labels_.crossings();
    for (std::size_t i = 0; i < labels_.valleys().size(); ++i) {
      const auto& pieces = labels_.valleys()[i];
      changes.push_back({pieces.front().from, {}, pieces.front().label, &crossings[2 * i]});
      for (std::size_t k = 1; k < pieces.size(); ++k)
        changes.push_back({pieces[k].from, pieces[k - 1].label, pieces[k].label, nullptr});
      changes.push_back({pieces.back().to, pieces.back().label, {}, &crossings[2 * i + 1]});
    }
    std::vector<BorderEvent> roots = labels_.roots();
    std::sort(roots.begin(), roots.end(),
              [](const BorderEvent& a, const BorderEvent& b) { return a.w < b.w; });
    std::size_t r = 0, c = 0;
    while (r < roots.size() || c < changes.size()) {
      const bool root_first =
          c == changes.size() || (r < roots.size() && roots[r].w < changes[c].w);
      if (!(root_first ? meet_root(roots[r++]) : meet_change(changes[c++]))) return false;
    }
    return !slot_[0].active && !slot_[1].active && open_contact_ < 0;
  }

  bool meet_root(const BorderEvent& root) {
    if (open_contact_ >= 0) return false;
    const auto point = border_point(root);
    if (!point) return false;
    const int side = root.upper ? 1 : 0;
    Open& slot = slot_[static_cast<std::size_t>(side)];
    if (!slot.active) {
      slot = {true, false, root.w, *point, -1};
      return true;
    }
    return close(side, {false, root.w, *point, -1});
  }

  bool meet_change(const Change& change) {
    if (change.border != nullptr) {
      const ValleyLabel label = change.before ? *change.before : *change.after;
      if (label != ValleyLabel::Contact) return true;
      return change.after ? begin_contact(change.w, change.border)
                          : end_contact(change.w, change.border);
    }
    if (*change.before == ValleyLabel::Contact) {
      if (!end_contact(change.w, nullptr)) return false;
      if (*change.after == ValleyLabel::Above) return true;
      return open_both(change.w, static_cast<int>(found_->contacts.size()) - 1);
    }
    if (*change.after == ValleyLabel::Contact) {
      if (*change.before == ValleyLabel::Below &&
          !close_both(change.w, static_cast<int>(found_->contacts.size())))
        return false;
      return begin_contact(change.w, nullptr);
    }
    return *change.after == ValleyLabel::Below ? open_fold(change.w) : close_fold(change.w);
  }

  bool begin_contact(double w, const BorderEvent* border) {
    if (slot_[0].active || slot_[1].active) return false;
    open_contact_ = 1;
    contact_from_ = w;
    contact_border_ = border;
    return true;
  }

  bool end_contact(double w, const BorderEvent* border) {
    CellContact contact;
    contact.leaves = {contact_border_ != nullptr, border != nullptr};
    for (int k = 0; k <= kContactSteps; ++k) {
      const double at_w = contact_from_ + (w - contact_from_) * k / kContactSteps;
      const BorderEvent* on = k == 0 ? contact_border_ : k == kContactSteps ? border : nullptr;
      const auto z = shape_.valley_at(at_w);
      if (on == nullptr && !z) return false;
      const auto x = on == nullptr ? points_.on_touch(at_w, *z, false)
                                   : points_.on_touch_at(on->edge, on->w, on->z, false);
      if (!x) return false;
      contact.path.push_back(*x);
      contact.gaps.push_back(points_.gap(*x));
    }
    found_->contacts.push_back(contact);
    open_contact_ = -1;
    return true;
  }

  bool open_both(double w, int contact) {
    for (const int side : {0, 1}) {
      const auto point = branch_point(w, side);
      if (!point) return false;
      slot_[static_cast<std::size_t>(side)] = {true, false, w, *point, contact};
    }
    return true;
  }

  bool close_both(double w, int contact) {
    for (const int side : {0, 1}) {
      const auto point = branch_point(w, side);
      if (!point || !slot_[static_cast<std::size_t>(side)].active ||
          !close(side, {false, w, *point, contact}))
        return false;
    }
    return true;
  }

  bool open_fold(double w) {
    if (slot_[0].active || slot_[1].active) return false;
    const auto point = polished_fold(w);
    if (!point) return false;
    for (Open& slot : slot_) slot = {true, true, w, *point, -1};
    return true;
  }

  bool close_fold(double w) {
    if (!slot_[0].active || !slot_[1].active) return false;
    const auto point = polished_fold(w);
    return point && close(0, {true, w, *point, -1}) && close(1, {true, w, *point, -1});
  }

  // Points in between, denser towards folds, where w stands still.
  bool close(int side, const Stop& stop) {
    Open& slot = slot_[static_cast<std::size_t>(side)];
    const double off =
        std::abs(points_.w_of(slot.start) - slot.w) + std::abs(points_.w_of(stop.point) - stop.w);
    if (off > kMaxOff * std::abs(stop.w - slot.w)) return false;
    CellBranch branch;
    branch.contact = {slot.contact, stop.contact};
    branch.path.push_back(slot.start);
    std::vector<double> places{slot.w};
    for (int k = 1; k < kBranchSteps; ++k) {
      const double t = k / static_cast<double>(kBranchSteps);
      double s = t;
      if (slot.fold && stop.fold)
        s = 0.5 - 0.5 * std::cos(M_PI * t);
      else if (slot.fold)
        s = t * t;
      else if (stop.fold)
        s = t * (2 - t);
      const auto point = branch_point(slot.w + s * (stop.w - slot.w), side);
      if (!point) return false;
      branch.path.push_back(*point);
      places.push_back(slot.w + s * (stop.w - slot.w));
    }
    branch.path.push_back(stop.point);
    places.push_back(stop.w);
    round_turns(branch.path, places, side);
    found_->branches.push_back(std::move(branch));
    slot.active = false;
    return true;
  }

  // True if a path turns by more than kTurn before or after its chord i.
  static bool turns_at(const std::vector<Point4>& path, std::size_t i) {
    const auto chord = [&](std::size_t k) {
      return unit(Vec2{path[k + 1][0] - path[k][0], path[k + 1][1] - path[k][1]});
    };
    return (i > 0 && dot(chord(i - 1), chord(i)) < kTurn) ||
           (i + 2 < path.size() && dot(chord(i), chord(i + 1)) < kTurn);
  }

  // Where a branch turns sharply a chord may lead off it, to its other side even: points are added
  // until none does.
  void round_turns(std::vector<Point4>& path, std::vector<double>& w, int side) const {
    for (std::size_t i = 0; i + 1 < path.size();) {
      const bool leads = path.size() >= kMaxBranchPoints || !turns_at(path, i) ||
                         leads_to(patch_a_, patch_b_, {path[i], path[i]}, path[i + 1]);
      const double middle = 0.5 * (w[i] + w[i + 1]);
      const auto point = leads ? std::nullopt : branch_point(middle, side);
      if (point) {
        path.insert(path.begin() + static_cast<std::ptrdiff_t>(i) + 1, *point);
        w.insert(w.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
      } else {
        ++i;
      }
    }
  }

  // --- points

  std::optional<Point4> border_point(const BorderEvent& root) const {
    Point4 start = points_.at(root.w, root.z);
    const Point4 plane = points_.fix_edge(root.edge, start);
    auto x = curve_point(patch_a_, patch_b_, start, plane, points_.reach());
    if (x) points_.fix_edge(root.edge, *x);
    return x;
  }

  // The zero below or above the valley at w, within the cell.
  std::optional<Point4> branch_point(double w, int side) const {
    const auto valley = shape_.valley_at(w);
    if (!valley) return std::nullopt;
    const Polynomial across = along_y(shape_.gap, w);
    const auto gap = [&](double z) { return value(across, z); };
    const double valley_gap = gap(*valley);
    if (!(valley_gap < 0)) return std::nullopt;
    const double outer = shape_.chord_end(w, side), outer_gap = gap(outer);
    if (!(outer_gap > 0)) return std::nullopt;
    const double z = narrowed(gap, {*valley, outer}, valley_gap, outer_gap, kRootWidth).above;
    return curve_point(patch_a_, patch_b_, points_.at(w, z), points_.line(), points_.reach());
  }

  std::optional<Point4> polished_fold(double w) const {
    const auto z = shape_.valley_at(w);
    if (!z) return std::nullopt;
    return fold_point(patch_a_, patch_b_, points_.at(w, *z), points_.across(), points_.reach());
  }

  const RationalBezierPatch& patch_a_;
  const Cell& a_;
  const RationalBezierPatch& patch_b_;
  const ValleyShape& shape_;
  const ModelPoints points_;
  ValleyLabels labels_;
  ValleyCell* found_ = nullptr;

  std::array<Open, 2> slot_;
  int open_contact_ = -1;
  double contact_from_ = 0;
  const BorderEvent* contact_border_ = nullptr;
};

}  // namespace

std::optional<ValleyCell> valley_cell(const RationalBezierPatch& patch_a, const Cell& a,
                                      const RationalBezierPatch& patch_b, const GapModel& model,
                                      const ValleyOptions& options) {
  const auto shape = ValleyShape::of(model);
  ValleyCell found;
  if (!shape || !Reader(patch_a, a, patch_b, model, *shape, options).run(found))
    return std::nullopt;
  return found;
}

}  // namespace blossom
