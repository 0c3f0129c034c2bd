// SPDX-License-Identifier: LGPL-2.1-or-later
// One walk of a ball along a run of edges.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/strips/ball_walk.h"
#include "adapters/occt/blending/strips/face_contacts.h"
#include "adapters/occt/blending/strips/notches.h"
#include "adapters/occt/blending/strips/run_profiles.h"

namespace blossom::occt {

/// Of a strip's two contacts that to the left of the way.
inline std::size_t contact_at(const WalkedStrip& of, std::size_t walking_side) {
  return of.forward ? walking_side : 1 - walking_side;
}

/// The parameter of the point of an edge that is nearest to a point.
double nearest_on_edge(const BodyEdges& body, int edge, const Vec3& point);

/// The edges on which the ball leans, to the left and right of the way.
inline std::array<int, 2> held_by(const WalkedStrip& of) {
  return {of.strip.bend[contact_at(of, 0)], of.strip.bend[contact_at(of, 1)]};
}

/// Where the ball leaves a strip for the next one.
struct WalkExit {
  double t = 0;
  std::array<std::optional<ContactCrossing>, 2> over{};  // by walking side
  bool ends = false;                                     // the walk does, and nothing follows
  int sharp_edge = 0;                                    // at which it ends, if at one
  std::array<int, 2> held{};                             // edges on which the ball leans behind it
};

/// Between which places of the run a walk has to be cut: at a sharp edge that begins in the vertex
/// between two that follow each other, which the ball cannot go over, or at edges in between that
/// it passes.
struct RunCut {
  std::size_t after = 0, before = 0;
  std::vector<PassedEdge> passed{};
};

class BallWalker {
 public:
  using Strips = std::vector<std::optional<WalkedStrip>>;  // by place in the run

  /// known    strips beside edges of the run that are made already
  /// passed   edges between this run and others, or its own ends
  BallWalker(const BodyEdges& body, const EdgeRun& run, const WalkOptions& options, Strips known,
             const std::set<int>& passed)
      : body_(body),
        run_(run),
        options_(options),
        passed_(passed),
        profiles_(body, run, options.fillet),
        made_(std::move(known)) {}

  BallWalk walk();
  /// Where the run has to be cut, for a walk that came to no end.
  const std::optional<RunCut>& cut() const { return cut_; }
  /// As far as they were made, and grew, on the way.
  const Strips& strips() const { return made_; }

 private:
  using Part = std::vector<std::pair<WalkJoint, WalkedStrip>>;

  std::array<int, 2> faces_of(std::size_t place) const;
  bool is_loop() const;
  /// Whether strips lie in the planes across edges, as those of one radius need not.
  bool is_guided() const { return !profiles_.everywhere(); }
  const WalkedStrip& strip_at(std::size_t place);
  std::optional<WalkedStrip> strip_if_any(std::size_t place);
  static bool leans_beside(const WalkedStrip& of);
  std::size_t start();
  bool is_aside(const WalkedStrip& of, std::size_t side,
                const std::vector<ContactCrossing>& all) const;
  std::optional<double> place_between(const WalkedStrip& of) const;
  bool goes_beside(const WalkedStrip& of) const;
  std::optional<ContactCrossing> border_between(int face, const Vec2& from, const Vec2& to,
                                                int entered) const;
  std::optional<WalkedStrip> start_behind(std::size_t place);
  bool is_start(const std::array<int, 2>& faces, const std::array<int, 2>& held) const;
  bool leans(const ContactCrossing& over) const;
  bool runs_along(const WalkedStrip& of, double t, const ContactCrossing& over) const;
  bool holds(const WalkedStrip& of, double t, const ContactCrossing& over) const;
  bool holds_sharp(const WalkedStrip& of, std::size_t place, int step, const WalkExit& end,
                   const ContactCrossing& over) const;
  bool begins_at(int edge, const DirectedEdge& half) const;
  bool is_end_edge(int edge) const;
  double turned_past(const WalkedStrip& of, std::size_t side, const EdgeUseInFace& use,
                     double t) const;
  ContactCrossing in_common_vertex(const WalkedStrip& of, std::size_t side,
                                   ContactCrossing at) const;
  WalkExit onto_edge(const WalkedStrip& of, std::size_t side, const ContactCrossing& met,
                     int step) const;
  std::optional<double> turns_onto(const WalkedStrip& of, std::size_t side,
                                   const EdgeUseInFace& use, const Interval& way) const;
  std::optional<WalkExit> off_edge(const WalkedStrip& of, double from, int ahead) const;
  bool start_over(const WalkedStrip& of, std::size_t side, const Vec2& from, int entered,
                  WalkExit& over) const;
  std::optional<WalkExit> end_in_point(
      const WalkedStrip& of, int step, double from,
      const std::array<std::optional<ContactCrossing>, 2>& first) const;
  Part way(WalkedStrip& from, std::size_t place, int step);
  WalkExit exit(WalkedStrip& of, std::size_t place, int step, double from,
                const std::array<int, 2>& entered);
  std::optional<ContactCrossing> first_crossing(const WalkedStrip& of, std::size_t side,
                                                double from, int ahead, int entered) const;
  bool is_past_end(const Vec3& centre) const;
  bool is_past_run(const WalkedStrip& of, const WalkExit& exit, std::size_t place, int step) const;
  std::vector<Notch> notches_beside(const WalkedStrip& of, std::size_t contact,
                                    const std::vector<ContactCrossing>& crossed) const;
  std::array<int, 2> faces_behind(const WalkedStrip& of, const WalkExit& exit) const;
  Vec2 chart_behind(const WalkedStrip& of, const WalkExit& exit, std::size_t side) const;
  std::optional<std::size_t> place_with(const std::array<int, 2>& faces, std::size_t place,
                                        int step) const;
  WalkedStrip pair_strip(const WalkedStrip& of, const WalkExit& exit,
                         const std::array<int, 2>& faces, std::size_t place, bool as_loop = false);
  bool turns_to_next(const WalkedStrip& of, std::size_t place, int step) const;
  bool is_before_next(const WalkedStrip& of, std::size_t place, int step, double t) const;
  std::pair<WalkedStrip, double> guided_following(const WalkedStrip& of, const WalkExit& exit,
                                                  const std::array<int, 2>& faces,
                                                  std::size_t& place, int step);
  double same_place(const WalkedStrip& of, double t) const;
  bool grow(WalkedStrip& of, bool at_start) const;
  bool grow_past(WalkedStrip& of, double t, int ahead) const;
  WalkExit over_edges(const WalkedStrip& of, std::size_t side, const ContactCrossing& first,
                      const std::optional<ContactCrossing>& other) const;
  bool reaches(WalkedStrip& next, const WalkedStrip& of, double end, double reach, double& t) const;
  bool goes_on_across(const WalkedStrip& of, const ContactCrossing& over, std::size_t place,
                      int step) const;
  double reach_at(const WalkedStrip& of, const WalkExit& exit) const;
  std::pair<WalkedStrip, double> following(const WalkedStrip& of, const WalkExit& exit,
                                           std::size_t& place, int step);
  std::optional<std::pair<WalkedStrip, double>> following_or_cut(const WalkedStrip& of,
                                                                 const WalkExit& exit,
                                                                 std::size_t& place, int step);
  BallWalk round(WalkedStrip strip) const;
  std::optional<RunCut> joint_at(int edge, std::size_t place, int step) const;
  std::optional<RunCut> passing(std::size_t place, int step, const FilletRefusal& why);
  bool is_before_end(const WalkedStrip& of, std::size_t place, int step, const WalkExit& end,
                     std::size_t& nearest) const;
  void check_end(const WalkedStrip& of, std::size_t place, int step, const WalkExit& end) const;
  struct Course {
    std::size_t place = 0;  // of the nearest edge
    double ahead = 0;       // negative where it goes back along that
    bool past_end = false;  // of that edge
  };
  Course course(const WalkedStrip& of, int step, double t) const;
  void check_course(const WalkedStrip& of, int step, const Interval& way) const;
  DirectedEdge end_half(int step) const { return step > 0 ? run_.last() : run_.first(); }
  bool is_shared(int step) const;
  bool is_passed(int step) const;
  [[noreturn]] void refuse(FilletFault fault, std::size_t place, const std::string& cause,
                           const Vec3& centre) const {
    throw FilletRefused({fault, run_.edges[place].edge, cause, std::nullopt, centre, {}});
  }
  std::optional<std::size_t> next_place(std::size_t place, int step) const;

  const BodyEdges& body_;
  const EdgeRun& run_;
  const WalkOptions& options_;
  const std::set<int>& passed_;
  RunProfiles profiles_;
  Strips made_;
  std::optional<WalkedStrip> behind_;  // where it starts, if beside no edge of the run
  bool came_back_ = false;             // to there
  std::optional<RunCut> cut_;
};

}  // namespace blossom::occt
