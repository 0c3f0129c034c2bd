// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/notches.h"

#include <algorithm>
#include <cmath>

namespace blossom::occt {

bool is_smooth_at(const BodyEdges& body, const ContactCrossing& crossing) {
  const BodyEdges::Corner a = body.corner(*crossing.use, crossing.edge_parameter);
  const BodyEdges::Corner b =
      body.corner(body.use(crossing.use->edge, !crossing.use->forward), crossing.edge_parameter);
  return std::atan2(norm(cross(a.normal, b.normal)), dot(a.normal, b.normal)) < kSmoothEdge;
}

bool is_seam_at(const BodyEdges& body, const ContactCrossing& crossing) {
  return body.use(crossing.use->edge, !crossing.use->forward).face == crossing.use->face;
}

std::vector<Notch> notches(const BodyEdges& body, const RolledStrip& strip, std::size_t side,
                           std::vector<ContactCrossing> all) {
  std::erase_if(all, [&](const ContactCrossing& each) { return is_seam_at(body, each); });
  std::vector<Notch> found;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const Interval between{all[i].t, all[i + 1].t};
    if (length(between) <= 0 || is_smooth_at(body, all[i]) || is_smooth_at(body, all[i + 1]))
      continue;
    if (!lies_on(body, strip.contacts[side], at(between, 0.5)))
      found.push_back({all[i], all[i + 1]});
  }
  return found;
}

}  // namespace blossom::occt
