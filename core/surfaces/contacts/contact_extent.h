// SPDX-License-Identifier: LGPL-2.1-or-later
// How long contacts are, and whether they are curves or points.

#pragma once

#include <utility>
#include <vector>

#include "core/surfaces/contacts/contact_chain.h"

namespace blossom {

/// Ends of contacts this close to each other or to a cluster may be joined. Of the size.
inline constexpr double kContactJoinRadius = 1e-3;

using ContactSteps = std::vector<std::pair<double, double>>;  ///< gaps and lengths, model units

class ContactExtent {
 public:
  /// size, tolerance   model units
  ContactExtent(SurfaceCells& a, double size, double tolerance)
      : a_(a), size_(size), tolerance_(tolerance) {}

  /// Box, length and kind (`curve`) of a contact with a path.
  void measure(ContactChain& chain) const;

  /// Contacts that clusters keep apart may be parts of one strip, each too short for one: all of
  /// them become curves then. The clusters' own contacts begin at index `clusters_from`.
  void measure_across(std::vector<ContactChain>& chains, std::size_t clusters_from) const;

 private:
  Vec3 point(const ContactPoint& p) const;
  ContactSteps steps_of(const ContactChain& chain) const;
  bool is_strip(const ContactSteps& steps, double length) const;
  bool ends_in(const ContactChain& chain, const ContactChain& cluster) const;

  SurfaceCells& a_;
  const double size_, tolerance_;
};

}  // namespace blossom
