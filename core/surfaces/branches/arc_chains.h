// SPDX-License-Identifier: LGPL-2.1-or-later
// Arcs of cells joined into whole branches by the identity of their border points.

#pragma once

#include <array>
#include <vector>

#include "core/cells/surface_cells.h"
#include "core/surfaces/contacts/contact_chain.h"
#include "core/surfaces/contacts/critical_places.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// An arc in a chain; `forward` runs it from `from` to `to`.
struct ChainLink {
  int arc = 0;
  bool forward = true;
};

/// Where a chain ends.
struct ChainEnd {
  CurveEnd kind = CurveEnd::Closed;
  int cluster = -1;  ///< for CurveEnd::Place: the cluster of critical pairs it ends in, or -1
  int contact = -1;  ///< likewise the contact; if both are -1 nothing explains the end
};

struct Chain {
  std::vector<ChainLink> links;
  std::array<ChainEnd, 2> ends;
  bool closed = false;
};

/// Joins arcs end to end. Inside the surfaces exactly two arcs meet in a border point; on a
/// border one ends. An end that is neither, nor in a cluster, has no explanation: its chain gets
/// CurveEnd::Place without a cluster, and the result may not be called complete.
/// contacts   branches may end in their arms
/// clusters     of critical pairs, in which branches may end
std::vector<Chain> chains_of(const PairSearchResult& found, const SurfaceCells& a,
                             const SurfaceCells& b, const std::vector<ContactChain>& contacts,
                             const std::vector<CriticalCluster>& clusters);

/// The ends of arcs that nothing explains: not on a border, not joined, in no contact or cluster.
std::vector<ArcEnd> loose_ends(const PairSearchResult& found, const SurfaceCells& a,
                               const SurfaceCells& b, const std::vector<ContactChain>& contacts);

/// Of a surface with itself: which of two points is the one on a is a matter of taste. Arcs, and
/// with them whole chains, are turned until the ends that are one agree on it. A loop on which the
/// two change places cannot agree everywhere: the ends where it does not are listed in
/// `found.swapped`, and its chain begins and ends there. Corner contacts at ends of arcs are
/// dropped.
void agree_on_sides(PairSearchResult& found, const SurfaceCells& cells);

/// The corner contacts at which no arc ends, each once: contacts of the surfaces at one of their
/// corners.
std::vector<CornerContact> lone_corner_contacts(const PairSearchResult& found,
                                                const SurfaceCells& a, const SurfaceCells& b);

}  // namespace blossom
