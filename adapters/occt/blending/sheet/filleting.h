// SPDX-License-Identifier: LGPL-2.1-or-later
// A shape with what is needed to fillet it again and again.

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/own_copy.h"
#include "adapters/occt/blending/sheet/sheet_trim.h"
#include "adapters/occt/blending/strips/ball_walk.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/queries/cone_volumes.h"
#include "core/base/work_limit.h"
#include "core/math/vec.h"

namespace blossom::occt {

inline constexpr const char* kFilleting = "rounding edges";

/// The faces of one solid of a shape.
struct SolidPart {
  TopoDS_Solid solid;  // of the shape that was given
  std::set<int> faces;
  bool one_shell = true;
  std::optional<bool> inside_out{};  ///< as far as it is known
};

/// A solid with fillets, and what is left in it of the edges that it had, by number; others are
/// whole.
struct Grouped {
  FilletedSolid made;
  std::map<int, std::vector<TopoDS_Edge>> edges;
};

/// The shape, its edges and its solids.
class Filleting {
 public:
  /// limit   of work that this is a part of; null: its time begins to run
  Filleting(const TopoDS_Shape& shape, const FilletOptions& options,
            std::shared_ptr<const WorkLimit> limit = nullptr)
      : given_(shape),
        body_(flat_copy(shape)),
        options_(options),
        limit_(limit ? std::move(limit)
                     : std::make_shared<const WorkLimit>(options_.intersection)) {
    find_parts(shape);
  }

  const BodyEdges& body() const { return body_; }
  /// Of all solids that were given.
  double volume_given();

  /// All these edges, or a refusal.
  ///
  /// size   in place of the radius of the options, for edges without one of their own, or of the
  ///        first distance of a chamfer, to which the second one keeps its ratio; model units
  std::vector<FilletedSolid> made(const FilletEdges& edges, double size);
  /// Radii of edges' own, from now on.
  void set_own(std::map<int, EdgeRadius> own) {
    options_.own = std::move(own);
    rolled_.reset();
  }
  const std::map<int, EdgeRadius>& own() const { return options_.own; }
  /// The balls alone, of those edges that are rounded first; or a refusal.
  void roll(const FilletEdges& edges, double size);
  bool is_chamfer() const { return options_.chamfer.has_value(); }
  /// Whether volumes are measured as exactly as can be, from now on; else what is made is only
  /// sure to get smaller or larger as it should. Returns what was so before.
  bool set_volumes(bool wanted) { return std::exchange(options_.volumes, wanted); }
  /// Of what was made last.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Likewise: whether a blend ends before its edge does, or does not quite meet another one.
  bool is_tolerant() const { return is_tolerant_; }
  /// Likewise: edges that were not asked for, in which others go on once there are blends between.
  const std::set<int>& gone_on() const { return gone_on_; }

 private:
  static TopoDS_Shape flat_copy(const TopoDS_Shape& shape) {
    TopoDS_Shape copy = own_copy(shape);
    flatten(copy);
    return copy;
  }
  void find_parts(const TopoDS_Shape& shape);
  void renew_body();
  bool is_inside_out(const SolidPart& part);
  SolidPart& part_of(int edge);
  double volume_of(const SolidPart& part);
  bool is_kept(const TrimmedFace& face) const;
  double volume_beside(int edge, const std::vector<TopoDS_Edge>& left, const Vec3& apex) const;
  double change(const SolidPart& part, const TrimmedBody& trimmed, const Vec3& apex,
                double enough) const;
  double sure_change(const SolidPart& part, const TrimmedBody& trimmed,
                     const FilletEdges& edges) const;
  FilletedSolid closed(const SolidPart& part, const std::vector<TrimmedFace>& faces,
                       const FilletEdges& edges);
  std::vector<BallWalk> walks(const FilletEdges& edges) const;
  std::vector<BallWalk> walks_or_rolled(const FilletEdges& edges);
  Grouped with_group(const SolidPart& part, const FilletEdges& edges);
  double size() const { return is_chamfer() ? options_.chamfer->first : options_.radius; }
  void set_size(double size);
  struct Renamed {
    FilletEdges edges;      // with those in which they go on
    std::map<int, int> of;  // numbers before, by numbers now
    std::map<int, EdgeRadius> own{};
    FilletEdges asked() const;
    std::set<int> gone_on() const;
  };
  int number_before(const TopoDS_Edge& edge, const Grouped& done) const;
  Renamed renamed(const Filleting& next, const Grouped& done, const FilletEdges& group) const;
  std::string in_own_words(const std::string& text, const Filleting& next,
                           const Grouped& done) const;
  double square_of_radius(int edge) const;
  std::optional<FilletedSolid> made_before(const FilletEdges& edges, std::set<int> others);
  FilletedSolid with_next(const Grouped& done, const FilletEdges& group);
  const TopoDS_Face& face_given(int number) const {
    return faces_given_[static_cast<std::size_t>(number) - 1];
  }

  TopoDS_Shape given_;
  BodyEdges body_;        // of a copy, as what is made widens tolerances in it
  bool is_used_ = false;  // by what was made last
  FilletOptions options_;
  std::shared_ptr<const WorkLimit> limit_;
  std::vector<SolidPart> parts_;
  std::vector<TopoDS_Face> faces_given_;  // by number
  std::vector<std::string> notes_;
  bool is_tolerant_ = false;
  std::set<int> gone_on_;
  std::set<int> ended_before_;  // edges in which those that are rounded do not go on
  ConeVolumes cones_{Vec3{}};   // over given faces and those of results
  struct Rolled {
    double size = 0;
    FilletEdges edges;
    std::vector<BallWalk> walks;
  };
  std::optional<Rolled> rolled_;  // last, and not yet used
};

}  // namespace blossom::occt
