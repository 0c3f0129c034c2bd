// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/bulk/bulk_triangles.h"

#include "core/forms/detail/checks.h"
#include "core/forms/triangle.h"
#include "core/math/binomial.h"
#include "core/subdivision/bulk/detail/bulk_checks.h"
#include "core/subdivision/bulk/detail/bulk_kernels.h"

namespace blossom {
namespace {

using detail::check_count;
using Triangle = BezierTriangle;

detail::TrianglePlanView view(const TrianglePlan& plan) {
  return {plan.degree_u(), plan.degree_v(), plan.weights().data(), plan.targets().data(),
          plan.inverses().data()};
}

detail::CornersView view(const TriangleLists& list) {
  return {{list.a_u.data(), list.b_u.data(), list.c_u.data()},
          {list.a_v.data(), list.b_v.data(), list.c_v.data()}};
}

void check_list(const char* function, const char* name, std::span<const double> list,
                std::size_t count) {
  check_count(function, name, list.size(), count);
  detail::check_finite(function, name, list);
}

// The number of blocks, once everything fits.
int check(const char* function, const TrianglePlan& plan, int planes, std::span<const double> net,
          const TriangleLists& list, std::span<double> out) {
  const NetShape shape{plan.degree_u() + 1, plan.degree_v() + 1, planes};
  detail::check_shape(function, shape);
  check_count(function, "net", net.size(), static_cast<std::size_t>(shape.size()));
  const std::size_t count = list.a_u.size();
  if (count % kLanes != 0)
    throw InvalidInput(std::string(function) + ": the number of triangles must be a multiple of " +
                       std::to_string(kLanes) + ", got " + std::to_string(count));
  check_list(function, "a_u", list.a_u, count);
  check_list(function, "a_v", list.a_v, count);
  check_list(function, "b_u", list.b_u, count);
  check_list(function, "b_v", list.b_v, count);
  check_list(function, "c_u", list.c_u, count);
  check_list(function, "c_v", list.c_v, count);
  check_count(function, "out", out.size(),
              count * static_cast<std::size_t>(planes * plan.points()));
  return static_cast<int>(count / kLanes);
}

}  // namespace

TrianglePlan::TrianglePlan(int degree_u, int degree_v) : degree_u_(degree_u), degree_v_(degree_v) {
  detail::check_degree("TrianglePlan", degree_u);
  detail::check_degree("TrianglePlan", degree_v);
  const int n = degree_u, m = degree_v, total = degree();
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
      for (int r = 0; r <= m; ++r)
        for (int s = 0; r + s <= m; ++s) {
          const int nu = i + r, mu = j + s, lambda = total - nu - mu;
          const double ways = binomial(nu, i) * binomial(mu, j) * binomial(lambda, n - i - j);
          weights_.push_back(ways / binomial(total, n));
          targets_.push_back(static_cast<int>(Triangle::index(total, nu, mu)));
        }
  for (int k = 0; k <= total; ++k)
    for (int j = 0; j <= k; ++j) inverses_.push_back(1 / trinomial(total, k - j, j));
}

void subdivide_triangles(NetForm form, const TrianglePlan& plan, int planes,
                         std::span<const double> net, const TriangleLists& triangles,
                         std::span<double> out, SimdLevel level) {
  const int blocks = check("subdivide_triangles", plan, planes, net, triangles, out);
  detail::kernels(level).triangles_t4(form, view(plan), planes, net.data(), view(triangles), blocks,
                                      out.data());
}

void subdivide_triangles_by_differences(const TrianglePlan& plan, int planes,
                                        std::span<const double> coefficients,
                                        const TriangleLists& triangles, std::span<double> out,
                                        SimdLevel level) {
  const int blocks =
      check("subdivide_triangles_by_differences", plan, planes, coefficients, triangles, out);
  detail::kernels(level).triangles_t1(view(plan), planes, coefficients.data(), view(triangles),
                                      blocks, out.data());
}

}  // namespace blossom
