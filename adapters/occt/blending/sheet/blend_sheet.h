// SPDX-License-Identifier: LGPL-2.1-or-later
// The sheet that takes the place of filleted edges: strips, what they end in, corner patches, and
// what it cuts off the edges and faces of the body.
//
// Ends are made first, vertex by vertex: where strips end in the same place, or in an edge of the
// body, they have one vertex there. Everything else is built on these vertices, so that the sheet
// and the cut faces close without being sewn.

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Geom2d_BezierCurve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/sheet/fill_faces.h"
#include "adapters/occt/blending/sheet/kept_edges.h"
#include "adapters/occt/blending/strips/ball_walk.h"
#include "adapters/occt/blending/strips/end_curves.h"
#include "adapters/occt/blending/strips/face_contacts.h"
#include "adapters/occt/blending/strips/notches.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "adapters/occt/splitting/edges/edge_splits.h"

namespace blossom::occt {

/// How a strip ends: at which t of its contacts, in which vertices, and along which edges.
struct StripEnd {
  std::array<double, 2> t{};
  std::array<TopoDS_Vertex, 2> vertices;
  /// Edges that contacts go over here: their crossings beside the end are none between the ends.
  std::array<int, 2> over{};
  std::vector<PathEdge> path;  ///< from vertices[0] to vertices[1]
};

/// Where a contact meets an edge; the edge is cut there.
struct ContactCut {
  double t = 0;
  TopoDS_Vertex vertex;
  std::vector<PathEdge> round{};  ///< to the next cut over other faces; none: along the contact
};

struct PlacedStrip {
  RolledStrip strip;
  double inside = 0;             ///< a t between the ends
  std::array<StripEnd, 2> ends;  ///< at the least and the largest t
  /// Seams and notches that contacts go over between the ends, by t.
  std::array<std::vector<ContactCut>, 2> seams;
  bool left_out = false;  ///< the strip before it ends the walk
};

/// A new face, or what a face of the body gets: edges as the outward face uses them.
struct BlendPatch {
  TopoDS_Face face;  ///< without wires, oriented outwards
  std::vector<TopoDS_Edge> edges;
  int edge = 0;  ///< the number of the filleted edge it is named after
};

class BlendSheet {
 public:
  /// body         kept by reference
  /// tolerance    model units
  /// is_chamfer   corners of several strips are planes, else balls
  /// setback      as in `FilletOptions`
  BlendSheet(const BodyEdges& body, double tolerance, bool is_chamfer,
             const std::optional<double>& setback);

  /// All strips, before the ends are made.
  void add(const BallWalk& walk);

  /// Makes all ends and patches.
  /// throws   FilletRefused, BadModel
  void build();

  const std::vector<BlendPatch>& patches() const { return patches_; }
  const std::map<int, std::vector<TopoDS_Edge>>& added() const { return added_; }
  const SheetBorder& border() const { return border_; }
  /// What a user may want to know of how strips end.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Whether a strip ends before its edge does, or does not quite meet the next one.
  bool is_tolerant() const { return is_tolerant_; }
  bool is_filleted(int edge) const { return filleted_.count(edge) > 0; }
  EdgeSplits& splits() { return splits_; }

 private:
  using Ring = std::vector<VertexSector>;
  using Cut = ContactCut;
  /// An end of a strip: that of the least t, or of the largest.
  struct EndPlace {
    std::size_t strip = 0;
    std::size_t end = 0;
  };
  struct Joint {
    EndPlace before, after;
    WalkJoint walked;
  };

  PlacedStrip& strip_of(const DirectedEdge& half);
  const PlacedStrip& strip_of(const DirectedEdge& half) const;
  StripEnd& end_of(const DirectedEdge& half);
  bool is_low_end(const DirectedEdge& half) const;
  double end_t(const DirectedEdge& half);
  /// The contacts of a strip that lie to the left and right of who walks away from one of its ends.
  std::size_t left_side(const DirectedEdge& half) const { return is_low_end(half) ? 0 : 1; }
  std::size_t right_side(const DirectedEdge& half) const { return is_low_end(half) ? 1 : 0; }

  void end_at(const DirectedEdge& half);
  Ring ring_at(const DirectedEdge& half, std::vector<int>& passed) const;
  void end_beside_passed(const Ring& ring, std::size_t sector, bool on_left,
                         std::map<std::size_t, double>& cuts);
  void end_at_passed(const Ring& ring);
  bool keeps_side(const Ring& ring, std::size_t first_patch) const;
  void pass(const Ring& ring, const std::vector<int>& passed);
  void or_else(const std::vector<DirectedEdge>& halves, const std::function<void()>& ended,
               const std::function<bool(const std::string& why)>& other);
  bool is_set_back(const Ring& ring);
  void blunt_unless(const std::vector<DirectedEdge>& halves, const std::function<void()>& ended);
  bool end_in_point(const std::vector<DirectedEdge>& halves);
  TopoDS_Vertex narrow_vertex(const DirectedEdge& half, const NarrowEnd& point);
  void end_in_point(const DirectedEdge& half, const NarrowEnd& point);
  void cap(const Ring& ring);
  bool blunt(const Ring& ring, const std::string& why);
  bool is_walled(const Ring& ring, const std::string& why);
  bool leave_out_last(const DirectedEdge& half);
  double wall_t(const Ring& ring);
  TopoDS_Edge wall_border(const EndCurve& down, const TopoDS_Vertex& contact,
                          const TopoDS_Vertex& corner, bool on_left, int face);
  std::optional<TopoDS_Vertex> wall_foot(const DirectedEdge& half, double t);
  std::optional<ContactCrossing> way_out(const DirectedEdge& half, std::size_t side);
  Cut end_cut(const DirectedEdge& half, std::size_t side, int& beyond, int& edge);
  bool turns_back(const Ring& ring, bool on_left);
  Cut grown_cut(const Ring& ring, bool on_left, int& beyond, int& edge);
  /// Along which curve a face goes on past a vertex, and at which t of a contact it comes to that.
  struct GrownWay {
    int face = 0;
    double t = 0;
    Vec3 place;
    EndCurve down;
  };
  std::optional<GrownWay> way_up_to(const Ring& ring, bool on_left, int growing, std::string& why);
  Cut grow_along(const Ring& ring, bool on_left, const GrownWay& way);
  bool takes_over(const Ring& ring, int taking, int giving, int edge, const TopoDS_Vertex& cut);
  /// Where a strip's end has come to: by its contact, or over an edge.
  struct StripPlace {
    EdgeThrough through;
    int edge = 0;
    bool is_contact = false;
  };
  std::optional<Vec3> way_over(const RolledStrip& strip, int face, const StripPlace& from) const;
  /// Where a strip goes over an edge of a face, from the inside.
  struct WayOut {
    EdgeThrough through;
    const EdgeUseInFace* use = nullptr;
    bool is_seam = false;
    double share = 0;  ///< of the way from the strip's left contact to its right one
  };
  std::optional<WayOut> next_way_out(const DirectedEdge& half, const Interval& part, int face,
                                     const StripPlace& from);
  int cross_face(const Ring& ring, const Interval& part, int face, StripPlace& from,
                 TopoDS_Vertex& start);
  int cross_grown(const Ring& ring, const Interval& part, int face, StripPlace& from,
                  TopoDS_Vertex& start);
  void join(const Joint& joint);
  void join_to_face(const EndPlace& place, std::size_t side, const ContactCrossing& over);
  TopoDS_Vertex joint_vertex(const PlacedStrip& of, std::size_t side, double t,
                             const std::optional<ContactCrossing>& over);
  /// A contact at a mitre, and its face's use of the edge between the strips, if there is one.
  struct MitreContact {
    DirectedEdge half;
    std::size_t side = 0;
    const EdgeUseInFace* use = nullptr;
  };
  /// One side of a mitre: where the strips meet, and where each of them leaves its own face, from
  /// where it goes on to there over a face between them, if that is elsewhere.
  struct MitreSide {
    TopoDS_Vertex joined;
    std::array<TopoDS_Vertex, 2> feet;  // of the first strip and the second one
    std::array<int, 2> over{};
  };
  MitreSide mitre_in_face(const MitreContact& a, const MitreContact& b);
  MitreSide mitre_at_edge(const MitreContact& a, const MitreContact& b,
                          const DirectedEdge& between);
  MitreSide mitre_over_face(const MitreContact& a, const MitreContact& b,
                            const DirectedEdge& beside_a, const DirectedEdge& beside_b, int face);
  MitreSide mitre_side(const Ring& ring, std::size_t other, bool on_left);
  bool can_be_mitred(const Ring& ring, std::size_t other);
  void mitre(const Ring& ring, std::size_t other);
  void path_over(const DirectedEdge& half, const MitreSide& side, std::size_t of, bool inwards);
  bool alternate(const Ring& ring) const;
  std::optional<Vec3> common_point(const std::vector<DirectedEdge>& halves, const Vec3& near) const;
  bool mitre_round(const Ring& ring);
  PathEdge mitre_edge(const DirectedEdge& a, const DirectedEdge& b, const TopoDS_Vertex& from,
                      const TopoDS_Vertex& to, double reach);
  void turn_path(const DirectedEdge& half);
  std::optional<std::array<double, 2>> border_crossing(const Ring& ring, std::size_t sector);
  bool borders_cross(const Ring& ring);
  TopoDS_Edge line_across(const TopoDS_Face& plane, int face, const TopoDS_Vertex& from,
                          const TopoDS_Vertex& to) const;
  bool flat_corner(const Ring& ring);
  std::optional<TopoDS_Edge> flat_end(const DirectedEdge& half, const TopoDS_Face& plane,
                                      const TopoDS_Vertex& from, const TopoDS_Vertex& to);
  bool crossed_corner(const Ring& ring);
  /// A strip of a walk that begins in a vertex: where it ends towards that, and where the next
  /// strip begins.
  struct WalkPlace {
    std::size_t strip = 0;
    double inwards = 1;
    double ends = 0;
    std::optional<double> goes_on;
  };
  std::vector<WalkPlace> walk_from(const DirectedEdge& half);
  /// Where the ball of a corner is in the strips of an edge.
  struct BallEnd {
    int left_out = 0;  // strips that begin beyond it
    std::size_t strip = 0;
    double t = 0;
  };
  struct BallSide {
    std::size_t sector = 0;
    BallEnd end;
  };
  /// Where it touches a face, or a smooth edge.
  struct BallFoot {
    Vec3 point;
    std::optional<std::size_t> sector;  // that the edge begins
    double parameter = 0;               // of the edge
  };
  std::vector<std::size_t> alike_strips(const Ring& ring) const;
  std::optional<Vec3> corner_centre(const Ring& ring, const std::vector<std::size_t>& strips);
  std::optional<BallEnd> ball_end(const DirectedEdge& half, const Vec3& centre);
  std::optional<BallFoot> ball_foot(const Ring& ring, const BallSide& from,
                                    const BallSide& to) const;
  TopoDS_Vertex ball_vertex(const Ring& ring, const BallFoot& foot, const DirectedEdge& a,
                            const DirectedEdge& b);
  BlendPatch ball_patch(const RolledStrip& strip, const Vec3& centre,
                        const std::vector<TopoDS_Vertex>& feet);
  void end_in_circle(const DirectedEdge& half, BlendPatch& patch);
  bool ball_corner(const Ring& ring);
  void corner(const Ring& ring);
  /// A side of the hole that a fill closes in a corner: a section of a strip, a slanting line on
  /// one, or a path in a face.
  struct SetbackSide {
    FillSide side;
    TopoDS_Vertex from{};
    std::optional<DirectedEdge> half{};  // of a strip
    int face = 0;                        // of a path
    Handle(Geom2d_BezierCurve) chart{};  // of a path, or a slanting line
  };
  double setback_t(const Ring& ring, std::size_t sector);
  double wanted_setback_t(const DirectedEdge& half, double stop, double width);
  std::optional<double> stop_beside(const Ring& ring, std::size_t sector, bool on_left);
  double setback_cut(const Ring& ring, std::size_t sector);
  SetbackSide section_side_of(const DirectedEdge& half);
  void note_gap(int edge, double gap, double apart);
  SetbackSide slanted_side(const DirectedEdge& half);
  SetbackSide path_side(const Ring& ring, std::size_t sector,
                        const std::map<std::size_t, double>& cuts);
  void check_room(const Ring& ring, std::size_t sector, const SetbackSide& path) const;
  PathEdge section_edge(const DirectedEdge& half, const FillBorder& border);
  PathEdge setback_edge(const SetbackSide& side, const FillBorder& border);
  void fill_corner(const Ring& ring, const std::vector<SetbackSide>& sides);
  void set_back(const Ring& ring);

  [[noreturn]] void refuse_miss(const DirectedEdge& half, std::size_t side,
                                const EdgeUseInFace& use, const DirectedEdge& cut) const;
  TopoDS_Vertex cut_edge(const DirectedEdge& cut, double parameter, const TopoDS_Face& asking);
  TopoDS_Vertex cut_edge(const ContactCrossing& crossing, const TopoDS_Face& asking);
  void join_section(const EndPlace& before, const EndPlace& after);
  TopoDS_Vertex new_vertex(const Vec3& point);
  TopoDS_Vertex vertex_in(int face, const Vec3& place);
  Interval part_near(const DirectedEdge& half, const std::array<double, 2>& t);
  TopoDS_Edge section(const PlacedStrip& of, const StripEnd& end);
  void cap_face(const DirectedEdge& half, const Interval& part, int face, const TopoDS_Vertex& from,
                const TopoDS_Vertex& to);
  /// Where a curve in a face goes over the line of the face's seam.
  struct SeamMeeting {
    int edge = 0;
    int across = 0;        // 0: the seam has one u, 1: one v
    double t = 0;          // of the curve
    bool at_start = true;  // beyond that end of the seam
  };
  std::vector<PathEdge> edges_along(const RolledStrip& strip, const EndCurve& curve, int face,
                                    const TopoDS_Vertex& from, const TopoDS_Vertex& to);
  std::optional<SeamMeeting> seam_meeting(const EndCurve& curve, int face, double reach);
  std::optional<SeamMeeting> seam_at_end(const EndCurve& curve, bool at_start, int face,
                                         double reach);
  void grow_seam(const SeamMeeting& seam, const TopoDS_Vertex& met, int face);
  const EdgeUseInFace& arriving(const Ring& ring, std::size_t sector) const;
  /// The border of a strip on a wall of a notch, and the edge over which it leaves the wall; null:
  /// it comes out of the notch.
  struct WallWay {
    const EdgeUseInFace* use = nullptr;
    EdgeThrough through;
    EndCurve curve;
  };
  std::optional<WallWay> wall_way(const PlacedStrip& of, const Interval& part, int face,
                                  int entered, const TopoDS_Vertex& from,
                                  const TopoDS_Vertex* enters, bool grows);
  TopoDS_Vertex cut_wall(const PlacedStrip& of, const WallWay& way, int face);
  std::vector<PathEdge> notch_path(const PlacedStrip& of, std::size_t side, const Notch& notch,
                                   const TopoDS_Vertex& leaves, const TopoDS_Vertex& enters);
  void add_wall(const PlacedStrip& of, std::size_t side, int face, const WallWay& way,
                const TopoDS_Vertex& from, const TopoDS_Vertex& to, std::vector<PathEdge>& path);
  void cut_notches(PlacedStrip& of, std::size_t side, const std::vector<Notch>& all);
  void cut_seams(PlacedStrip& of, std::size_t side);
  void add_contact(PlacedStrip& of, std::size_t side, BlendPatch& patch);
  TopoDS_Edge apex_edge(const PlacedStrip& of, std::size_t side, const TopoDS_Face& face) const;
  void finish(PlacedStrip& of);
  [[noreturn]] void refuse(const DirectedEdge& half, FilletFault fault,
                           const std::string& cause) const;
  /// What refusals call the line along which a blend meets its face, and what is too large of it.
  std::string contact_words() const {
    return is_chamfer_ ? "the chamfer's border" : "the ball's contact";
  }
  std::string too_large() const {
    return is_chamfer_ ? "the distance is too large" : "the radius is too large";
  }

  const BodyEdges& body_;
  double tolerance_;
  bool is_chamfer_;
  std::optional<double> setback_;
  EdgeSplits splits_;
  std::vector<PlacedStrip> strips_;
  std::vector<Joint> joints_;
  std::map<std::pair<int, bool>, EndPlace> ends_at_;  // by half-edge
  std::vector<DirectedEdge> open_;
  std::set<int> filleted_;
  std::map<int, FilletRefusal> passed_;  // by edge, which are among the former
  SheetBorder border_;
  std::map<int, std::vector<TopoDS_Edge>> added_;  // by face
  std::vector<BlendPatch> patches_;
  std::vector<DirectedEdge> done_;
  std::vector<TopoDS_Vertex> made_;  // inside of faces
  std::vector<std::string> notes_;
  bool is_tolerant_ = false;
};

}  // namespace blossom::occt
