// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/sheet_trim.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/face_borders.h"
#include "adapters/occt/blending/sheet/grown_surface.h"
#include "adapters/occt/blending/sheet/wire_nesting.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

// An edge in a wire of the forward face.
struct Link {
  TopoDS_Edge edge;
  TopoDS_Vertex from, to;
  Vec2 start, end;  // in the chart
  int next = -1;
};

Link link_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  Link made{edge,
            TopExp::FirstVertex(edge, Standard_True),
            TopExp::LastVertex(edge, Standard_True),
            {},
            {}};
  Interval range;
  const Handle(Geom2d_Curve) chart = chart_curve_of(edge, face, range);
  if (chart.IsNull()) return made;
  if (edge.Orientation() == TopAbs_REVERSED) std::swap(range.from, range.to);
  const gp_Pnt2d a = chart->Value(range.from), b = chart->Value(range.to);
  made.start = {a.X(), a.Y()};
  made.end = {b.X(), b.Y()};
  return made;
}

// Edges without length whose vertex no other edge has any more are gone with it.
void drop_lost_points(std::vector<Link>& links) {
  const auto is_lost = [&](const Link& link) {
    return BRep_Tool::Degenerated(link.edge) &&
           std::none_of(links.begin(), links.end(), [&](const Link& other) {
             return !BRep_Tool::Degenerated(other.edge) &&
                    (other.from.IsSame(link.from) || other.to.IsSame(link.from));
           });
  };
  std::vector<Link> kept;
  for (const Link& link : links)
    if (!is_lost(link)) kept.push_back(link);
  links = std::move(kept);
}

// Each end goes with the nearest start at its vertex, nearest pairs first.
bool connect(std::vector<Link>& links, const Vec2& scale) {
  struct Pair {
    double gap;
    std::size_t end, start;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < links.size(); ++i)
    for (std::size_t k = 0; k < links.size(); ++k)
      if (links[i].to.IsSame(links[k].from)) {
        const Vec2 off = links[k].start - links[i].end;
        pairs.push_back({norm(Vec2{off[0] * scale[0], off[1] * scale[1]}), i, k});
      }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.gap < b.gap; });
  std::vector<bool> taken(links.size());
  std::size_t count = 0;
  for (const Pair& pair : pairs) {
    if (links[pair.end].next >= 0 || taken[pair.start]) continue;
    links[pair.end].next = static_cast<int>(pair.start);
    taken[pair.start] = true;
    ++count;
  }
  return count == links.size();
}

std::optional<Wires> wires_of(const std::vector<TopoDS_Edge>& edges, const TopoDS_Face& face,
                              const Vec2& scale) {
  std::vector<Link> links;
  for (const TopoDS_Edge& edge : edges) links.push_back(link_of(edge, face));
  drop_lost_points(links);
  if (!connect(links, scale)) return std::nullopt;
  Wires wires;
  std::vector<bool> used(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (used[i]) continue;
    wires.emplace_back();
    for (std::size_t k = i; !used[k]; k = static_cast<std::size_t>(links[k].next)) {
      used[k] = true;
      wires.back().push_back(links[k].edge);
    }
  }
  return wires;
}

TopoDS_Face face_with(const Wires& wires, const TopoDS_Face& of) {
  const BRep_Builder builder;
  TopoDS_Face face = TopoDS::Face(of.EmptyCopied());
  face.Orientation(TopAbs_FORWARD);
  for (const auto& edges : wires) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const TopoDS_Edge& edge : edges) builder.Add(wire, edge);
    wire.Closed(Standard_True);
    builder.Add(face, wire);
  }
  // What lies inside of the face stays there.
  for (TopoDS_Iterator wire(of); wire.More(); wire.Next()) {
    if (wire.Value().ShapeType() != TopAbs_WIRE) continue;
    const TopoDS_Iterator edge(wire.Value());
    if (edge.More() && edge.Value().Orientation() == TopAbs_INTERNAL)
      builder.Add(face, wire.Value());
  }
  face.Orientation(of.Orientation());
  return face;
}

TopoDS_Edge turned(const TopoDS_Edge& edge, bool reversed) {
  return reversed ? TopoDS::Edge(edge.Reversed()) : edge;
}

class Trimming {
 public:
  Trimming(const BodyEdges& body, BlendSheet& sheet, double tolerance)
      : body_(body),
        sheet_(sheet),
        tolerance_(tolerance),
        kept_(kept_pieces(body, sheet.splits(), sheet.border())) {}

  std::vector<TrimmedFace> faces();
  std::map<int, std::vector<TopoDS_Edge>> edges() const;

 private:
  std::set<int> touched_faces() const;
  std::vector<TopoDS_Edge> edges_left(int face);
  void add_border(std::vector<TopoDS_Edge> edges, const TopoDS_Face& face, const Vec2& scale,
                  int from, int edge);
  void add_faces(const FaceBorder& border, std::vector<TrimmedFace>& all) const;

  const BodyEdges& body_;
  BlendSheet& sheet_;
  double tolerance_;
  std::map<int, std::vector<EdgePiece>> kept_;
  std::vector<FaceBorder> borders_;
  std::vector<ReplacedEdge> replaced_;
};

// The faces that get edges, or of whose edges something goes.
std::set<int> Trimming::touched_faces() const {
  std::set<int> touched;
  for (const auto& [face, edges] : sheet_.added()) touched.insert(face);
  for (const auto& [edge, pieces] : kept_) {
    // A point has one face alone, which the edges at its vertex belong to as well.
    if (BRep_Tool::Degenerated(body_.edge(edge))) continue;
    for (const bool forward : {true, false}) touched.insert(body_.use(edge, forward).face);
  }
  return touched;
}

// As the forward face uses them.
std::vector<TopoDS_Edge> Trimming::edges_left(int face) {
  const bool reversed = body_.face(face).Orientation() == TopAbs_REVERSED;
  std::vector<TopoDS_Edge> edges;
  for (const EdgeUseInFace& use : body_.uses(face)) {
    const auto kept = kept_.find(use.edge);
    if (kept == kept_.end()) {
      edges.push_back(TopoDS::Edge(
          body_.edge(use.edge).Oriented(use.coedge->reversed ? TopAbs_REVERSED : TopAbs_FORWARD)));
      continue;
    }
    for (const EdgePiece& piece : kept->second)
      edges.push_back(TopoDS::Edge(
          piece.edge.Oriented(use.forward != reversed ? TopAbs_FORWARD : TopAbs_REVERSED)));
  }
  if (const auto known = sheet_.added().find(face); known != sheet_.added().end())
    for (const TopoDS_Edge& edge : known->second) edges.push_back(turned(edge, reversed));
  return edges;
}

void Trimming::add_border(std::vector<TopoDS_Edge> edges, const TopoDS_Face& face,
                          const Vec2& scale, int from, int edge) {
  borders_.push_back({TopoDS::Face(face.Oriented(TopAbs_FORWARD)), std::move(edges), scale, from,
                      edge, face.Orientation()});
}

// What a border encloses: a face, several, or none.
void Trimming::add_faces(const FaceBorder& border, std::vector<TrimmedFace>& all) const {
  const auto wires = wires_of(border.edges, border.of, border.scale);
  if (!wires)
    throw FilletRefused(
        {FilletFault::Result,
         border.edge,
         border.from > 0
             ? "what is left of face " + std::to_string(border.from) +
                   " has an open border: the ends of blends at it do not fit together"
             : std::string("its strip has an open border: its ends do not fit together"),
         {},
         {},
         {}});
  const TopoDS_Face of = TopoDS::Face(border.of.Oriented(border.orientation));
  for (const Wires& each : nested(*wires, border.of))
    if (!each.empty()) all.push_back({face_with(each, of), border.from, border.edge});
}

std::vector<TrimmedFace> Trimming::faces() {
  std::vector<TrimmedFace> all;
  const std::set<int> touched = touched_faces();
  for (const int number : touched) {
    const std::vector<TopoDS_Edge> edges = edges_left(number);
    add_border(edges, grown_to_edges(body_.face(number), edges), body_.trims(number).scale, number,
               0);
  }
  for (const BlendPatch& patch : sheet_.patches()) {
    const bool reversed = patch.face.Orientation() == TopAbs_REVERSED;
    std::vector<TopoDS_Edge> edges;
    for (const TopoDS_Edge& edge : patch.edges) edges.push_back(turned(edge, reversed));
    add_border(std::move(edges), patch.face, {1, 1}, 0, patch.edge);
  }
  replaced_ = close_slivers(borders_, body_, tolerance_);
  for (int number = 1; number <= body_.face_count(); ++number)
    if (touched.count(number) == 0) all.push_back({body_.face(number), number, 0});
  for (const FaceBorder& border : borders_) add_faces(border, all);
  return all;
}

std::map<int, std::vector<TopoDS_Edge>> Trimming::edges() const {
  std::map<int, std::vector<TopoDS_Edge>> left;
  for (const auto& [edge, pieces] : kept_) {
    std::vector<TopoDS_Edge>& of = left[edge];
    for (const EdgePiece& piece : pieces) of.push_back(piece.edge);
  }
  for (const ReplacedEdge& each : replaced_) {
    if (const int number = body_.number(each.lost); number > 0)
      left.try_emplace(number, std::vector{each.lost});
    for (auto& [edge, pieces] : left)
      for (std::size_t i = pieces.size(); i-- > 0;) {
        if (!pieces[i].IsSame(each.lost)) continue;
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
        pieces.insert(pieces.end(), each.now.begin(), each.now.end());
      }
  }
  return left;
}

}  // namespace

TrimmedBody trimmed_by_sheet(const BodyEdges& body, BlendSheet& sheet, double tolerance) {
  Trimming trimming(body, sheet, tolerance);
  return {trimming.faces(), trimming.edges()};
}

}  // namespace blossom::occt
