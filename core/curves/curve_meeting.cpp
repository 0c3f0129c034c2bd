// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/curve_meeting.h"

#include <algorithm>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/curves/curve_assembly.h"
#include "core/curves/curve_closing.h"
#include "core/curves/curve_search.h"

namespace blossom {
namespace {

struct Extent {
  Vec3 low{kUnbounded, kUnbounded, kUnbounded};
  Vec3 high{-kUnbounded, -kUnbounded, -kUnbounded};

  void add(const CurveSpans& curve) {
    for (const CurveSpan& span : curve.spans)
      for (const Vec4& p : span.curve.points)
        for (int k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], p[k] / p[3]);
          high[k] = std::max(high[k], p[k] / p[3]);
        }
  }

  // The middle, if the curves are far from zero for their size; else the origin stays, and the
  // points keep their bits.
  Vec3 origin() const {
    const Vec3 middle = (low + high) * 0.5;
    return max_norm(middle) > max_norm(high - low) ? middle : Vec3{};
  }

  int dimension() const { return low[2] == 0 && high[2] == 0 ? 2 : 3; }
};

void check(const CurveSpans& curve, const char* name, const IntersectionOptions& options) {
  validate(curve, name);
  if (!(options.tolerances.point > 0))
    throw InvalidInput("intersect: the tolerance must be positive");
}

void add_open(const CurveTree& a, const CurveTree& b, const std::vector<CurveContact>& pairs,
              CurveIntersection& result) {
  for (const CurveContact& pair : pairs) {
    const CurveCell& on_a = a[a.place(pair.a.from).span];
    const CurveCell& on_b = b[b.place(pair.b.from).span];
    CurvePlace place{PlaceKind::Open, on_a.low, on_a.high, 0, 0, pair.a, pair.b};
    place.gap_high = distance(on_a.low, on_a.high) + distance(on_b.low, on_b.high) +
                     distance(on_a.low, on_b.low);
    result.places.push_back(place);
  }
}

CurveIntersection meet(CurveTree& a, CurveTree& b, const Vec3& origin, double error,
                       const IntersectionOptions& options) {
  const double tolerance = options.tolerances.point + error;
  CurveAssembly assembly(a, b, tolerance);
  assembly.find_ends();
  const std::vector<SharedSpans> shared = assembly.shared_parts();
  const CurveFindings found = CurveSearch(a, b, options, tolerance).run(shared);
  CurveIntersection result = assembly.finish(shared, found);
  add_open(a, b, found.open, result);
  CurveCertificate& certificate = result.certificate;
  certificate.contacts = static_cast<long>(found.contacts.size());
  certificate.depth = std::max(a.depth(), b.depth());
  certificate.rounding_bound = std::max(a.largest_margin(), b.largest_margin());
  close_search(result, found, origin, error > 0 ? "a curve is an approximation" : nullptr,
               found.stopped);
  return result;
}

}  // namespace

CurveIntersection meeting_of(const CurveSpans& a, const CurveSpans& b,
                             const IntersectionOptions& options) {
  check(a, "curve a", options);
  check(b, "curve b", options);
  Extent extent;
  extent.add(a);
  extent.add(b);
  const Vec3 origin = extent.origin();
  CurveTree tree_a(a, origin, extent.dimension()), tree_b(b, origin, extent.dimension());
  return meet(tree_a, tree_b, origin, a.error + b.error, options);
}

CurveIntersection meeting_of_itself(const CurveSpans& curve, const IntersectionOptions& options) {
  check(curve, "the curve", options);
  Extent extent;
  extent.add(curve);
  const Vec3 origin = extent.origin();
  CurveTree tree(curve, origin, extent.dimension());
  return meet(tree, tree, origin, 2 * curve.error, options);
}

}  // namespace blossom
