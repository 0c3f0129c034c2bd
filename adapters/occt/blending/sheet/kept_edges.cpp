// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/kept_edges.h"

#include <utility>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"

namespace blossom::occt {
namespace {

enum class Fate { Open, Stays, Goes };

class Flood {
 public:
  Flood(const BodyEdges& body, EdgeSplits& splits, const SheetBorder& border);

  std::map<int, std::vector<EdgePiece>> kept();

 private:
  struct Place {
    int edge;
    std::size_t piece;
  };
  std::vector<Fate>& fates(int edge);
  void mark(const SheetBorder& border);
  void drop(const Place& place);
  void spread(const TopoDS_Vertex& vertex);
  double share_that_fits(int edge);

  const BodyEdges& body_;
  EdgeSplits& splits_;
  const SheetBorder& border_;
  TopTools_IndexedDataMapOfShapeListOfShape edges_at_;
  TopTools_MapOfShape barriers_;
  std::map<int, std::vector<Fate>> fates_;
  std::vector<Place> open_;
};

Flood::Flood(const BodyEdges& body, EdgeSplits& splits, const SheetBorder& border)
    : body_(body), splits_(splits), border_(border) {
  TopExp::MapShapesAndUniqueAncestors(body.body(), TopAbs_VERTEX, TopAbs_EDGE, edges_at_);
  for (const TopoDS_Vertex& vertex : border.vertices) barriers_.Add(vertex);
  for (const EdgeCut& cut : border.cuts)
    barriers_.Add(splits.vertex(body.edge(cut.edge), cut.split));
  mark(border);
}

std::vector<Fate>& Flood::fates(int edge) {
  const auto known = fates_.find(edge);
  if (known != fates_.end()) return known->second;
  return fates_.emplace(edge, std::vector<Fate>(splits_.pieces(body_.edge(edge)).size()))
      .first->second;
}

// Where two cuts share a split, what goes by one of them goes.
void Flood::mark(const SheetBorder& border) {
  for (const Fate fate : {Fate::Stays, Fate::Goes})
    for (const EdgeCut& cut : border.cuts) {
      const auto& pieces = splits_.pieces(body_.edge(cut.edge));
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bool is_after = pieces[i].from == cut.split, is_before = pieces[i].to == cut.split;
        if (!is_after && !is_before) continue;
        // Both of a closed edge that is cut at its vertex.
        const bool stays = cut.keep_after ? is_after : is_before;
        if (stays != (fate == Fate::Stays)) continue;
        if (stays)
          fates(cut.edge)[i] = fate;
        else
          drop({cut.edge, i});
      }
    }
  for (const int edge : border.filleted) {
    std::vector<Fate>& of = fates(edge);
    for (std::size_t i = 0; i < of.size(); ++i)
      if (of[i] == Fate::Open) drop({edge, i});
  }
}

void Flood::drop(const Place& place) {
  Fate& fate = fates(place.edge)[place.piece];
  if (fate != Fate::Goes) open_.push_back(place);
  fate = Fate::Goes;
}

// Of what cuts take of an edge, what there is of it, by the edge's parameter.
double Flood::share_that_fits(int edge) {
  Interval own;
  BRep_Tool::Range(body_.edge(edge), own.from, own.to);
  double taken = 0;
  for (const EdgeCut& cut : border_.cuts) {
    if (cut.edge != edge) continue;
    for (const EdgePiece& piece : splits_.pieces(body_.edge(edge))) {
      if (cut.keep_after && piece.from == cut.split) taken += piece.range.from - own.from;
      if (!cut.keep_after && piece.to == cut.split) taken += own.to - piece.range.to;
    }
  }
  return taken > length(own) ? length(own) / taken : 1;
}

// What ends in a vertex that goes, goes as well.
void Flood::spread(const TopoDS_Vertex& vertex) {
  if (barriers_.Contains(vertex)) return;
  const auto take = [&](int edge) {
    const auto& pieces = splits_.pieces(body_.edge(edge));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const TopoDS_Edge& piece = pieces[i].edge;
      if (!TopExp::FirstVertex(piece).IsSame(vertex) && !TopExp::LastVertex(piece).IsSame(vertex))
        continue;
      if (fates(edge)[i] == Fate::Stays)
        throw FilletRefused({FilletFault::EdgeConsumed,
                             edge,
                             "blends would take more of it than there is",
                             pieces[i].range.from,
                             point_of(vertex),
                             {},
                             false,
                             share_that_fits(edge)});
      drop({edge, i});
    }
  };
  if (edges_at_.Contains(vertex)) {
    for (const TopoDS_Shape& edge : edges_at_.FindFromKey(vertex))
      take(body_.number(TopoDS::Edge(edge)));
    return;
  }
  for (const auto& [edge, of] : std::map(fates_)) take(edge);  // a split that no cut is at
}

std::map<int, std::vector<EdgePiece>> Flood::kept() {
  while (!open_.empty()) {
    const Place at = open_.back();
    open_.pop_back();
    const TopoDS_Edge piece = splits_.pieces(body_.edge(at.edge))[at.piece].edge;
    spread(TopExp::FirstVertex(piece));
    spread(TopExp::LastVertex(piece));
  }
  std::map<int, std::vector<EdgePiece>> kept;
  for (const auto& [edge, of] : fates_) {
    const auto& pieces = splits_.pieces(body_.edge(edge));
    std::vector<EdgePiece>& stay = kept[edge];
    for (std::size_t i = 0; i < of.size(); ++i)
      if (of[i] != Fate::Goes) stay.push_back(pieces[i]);
  }
  return kept;
}

}  // namespace

std::map<int, std::vector<EdgePiece>> kept_pieces(const BodyEdges& body, EdgeSplits& splits,
                                                  const SheetBorder& border) {
  return Flood(body, splits, border).kept();
}

}  // namespace blossom::occt
