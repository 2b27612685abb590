// Loops of the tangential solver: the natural residual, the linearised elements, and edges.
#include "rolling/traction_loops.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::traction_loops_test {
namespace {

template <typename Real> class TractionLoops : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(TractionLoops, Precisions);

template <typename Real> constexpr double rounding = 200.0 * std::numeric_limits<Real>::epsilon();

/// Elements in slip at the angles of `turns`, with the slip that belongs to it.
template <typename Real> struct Slipping {
  explicit Slipping(std::size_t n, double turn = 0.0) : q(2 * n), s(2 * n), g(n), edge(2 * n) {
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 0.4 * static_cast<double>(i) + turn;
      const double bound = 1.0 + 0.1 * static_cast<double>(i);
      const double speed = 0.2 + 0.05 * static_cast<double>(i);
      g[i] = static_cast<Real>(bound);
      q[i] = static_cast<Real>(bound * std::cos(angle));
      q[n + i] = static_cast<Real>(bound * std::sin(angle));
      s[i] = static_cast<Real>(-speed * std::cos(angle));
      s[n + i] = static_cast<Real>(-speed * std::sin(angle));
    }
  }
  std::vector<Real> q, s, g, edge;
};

template <typename Real> struct Elements7 {
  explicit Elements7(std::size_t n) : values(7 * n) {
    Real* v = values.data();
    at = {v, v + n, v + 2 * n, v + 3 * n, v + 4 * n, v + 5 * n, v + 6 * n};
  }
  std::vector<Real> values;
  LinearisedElements<Real> at{};
};

TYPED_TEST(TractionLoops, SolutionsHaveNoResidual) {
  constexpr std::size_t n = 13;
  Slipping<TypeParam> slipping(n);
  ResidualSums sums = natural_residual(slipping.q.data(), slipping.s.data(), slipping.g.data(),
                                       slipping.edge.data(), 0.7, n);
  EXPECT_NEAR(sums.ratio(), 0.0, rounding<TypeParam>);
  EXPECT_GT(sums.size, 10.0);
  // In adhesion: any traction within the bound, no slip.
  for (TypeParam& q : slipping.q) {
    q *= TypeParam(0.5);
  }
  slipping.s.assign(2 * n, TypeParam{0});
  sums = natural_residual(slipping.q.data(), slipping.s.data(), slipping.g.data(),
                          slipping.edge.data(), 0.7, n);
  EXPECT_EQ(sums.change, 0.0);
}

TYPED_TEST(TractionLoops, ResidualIsTheDistanceFromTheCutTraction) {
  const TypeParam q[] = {TypeParam(0.3), TypeParam(0.4)};
  const TypeParam s[] = {TypeParam(-0.6), TypeParam(-0.8)}; // q - s = (0.9, 1.2): 1.5 long
  const TypeParam g[] = {TypeParam(1.0)};
  const TypeParam edge[] = {TypeParam(0.0), TypeParam(0.0)};
  const ResidualSums sums = natural_residual(q, s, g, edge, 1.0, 1);
  EXPECT_NEAR(sums.change, 0.5, rounding<TypeParam>);
  EXPECT_NEAR(sums.size, 1.0, rounding<TypeParam>);
  const TypeParam outside[] = {TypeParam(0.0)};
  EXPECT_EQ(natural_residual(q, s, outside, edge, 1.0, 1).ratio(), 0.0);
}

/// The slip's direction turns by a small angle: tractions that follow on the bound meet the
/// linearised equation P (s + ds) + ratio dq = 0 to second order.
TYPED_TEST(TractionLoops, LinearisedSlipFollowsTheSlipsDirection) {
  constexpr std::size_t n = 9;
  const double turn = sizeof(TypeParam) == 4 ? 1e-2 : 1e-4;
  const Slipping<TypeParam> now(n);
  const Slipping<TypeParam> then(n, turn);
  Elements7<TypeParam> elements(n);
  std::vector<TypeParam> change(2 * n);
  linearise(now.q.data(), now.s.data(), now.g.data(), now.edge.data(), {0.7, 1.0, 1.0, 0.0},
            elements.at, change.data(), n);
  std::vector<TypeParam> dq(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i) {
    EXPECT_NEAR(change[i], 0.0, rounding<TypeParam>) << "on the bound already";
    dq[i] = then.q[i] - now.q[i];
  }
  std::vector<TypeParam> rest(2 * n);
  project(elements.at, then.s.data(), dq.data(), rest.data(), n);
  for (const TypeParam value : rest) {
    EXPECT_NEAR(value, 0.0, 3.0 * turn * turn + rounding<TypeParam>);
  }
}

TYPED_TEST(TractionLoops, AdhesionLeavesAllDirectionsAndOutsideNone) {
  const TypeParam q[] = {TypeParam(0.1), TypeParam(0.3), TypeParam(0.2), TypeParam(0.4)};
  const TypeParam s[] = {TypeParam(0), TypeParam(0), TypeParam(0), TypeParam(0)};
  const TypeParam g[] = {TypeParam(1), TypeParam(0)};
  const TypeParam edge[] = {TypeParam(0), TypeParam(0), TypeParam(0), TypeParam(0)};
  Elements7<TypeParam> elements(2);
  TypeParam change[4];
  linearise(q, s, g, edge, {0.7, 2.0, 4.0, 0.0}, elements.at, change, 2);
  const TypeParam in[] = {TypeParam(3), TypeParam(5), TypeParam(7), TypeParam(9)};
  const TypeParam z[] = {TypeParam(1), TypeParam(1), TypeParam(1), TypeParam(1)};
  TypeParam out[4];
  project(elements.at, in, z, out, 2);
  EXPECT_EQ(out[0], TypeParam(3));
  EXPECT_EQ(out[2], TypeParam(7));
  EXPECT_EQ(out[1], TypeParam(0));
  EXPECT_EQ(out[3], TypeParam(0));
  EXPECT_EQ(elements.at.inverse_xx[0], TypeParam(0.5));
  EXPECT_EQ(elements.at.inverse_yy[0], TypeParam(0.25));
  EXPECT_EQ(elements.at.inverse_xx[1], TypeParam(0));
  EXPECT_EQ(change[0], TypeParam(0)) << "within its bound";
  EXPECT_EQ(change[1], -q[1]) << "no traction outside";
}

TYPED_TEST(TractionLoops, CutTractionsAreOnTheBoundAgainstTheSlip) {
  constexpr std::size_t n = 9;
  Slipping<TypeParam> slipping(n);
  for (std::size_t i = 0; i < 2 * n; ++i) {
    slipping.q[i] *= TypeParam(i % n < 4 ? 1.7 : 0.2);
  }
  slipping.s.assign(2 * n, TypeParam(0.0));
  const std::vector<TypeParam> before = slipping.q;
  cut_to_bound(slipping.q.data(), slipping.s.data(), slipping.g.data(), slipping.edge.data(), 0.7,
               n);
  for (std::size_t i = 0; i < n; ++i) {
    const double length = std::hypot(slipping.q[i], slipping.q[n + i]);
    const double share = i < 4 ? 1.0 / 1.7 : 1.0;
    EXPECT_NEAR(length, (i < 4 ? 1.0 : 0.2) * slipping.g[i], rounding<TypeParam>);
    EXPECT_NEAR(slipping.q[i], share * before[i], rounding<TypeParam>);
  }
}

TYPED_TEST(TractionLoops, EdgesAddToDisplacements) {
  for (const std::size_t n : {1U, 5U, 16U, 37U}) {
    std::vector<TypeParam> a(n), b(n), edge(2 * n), z(2 * n), out(2 * n, TypeParam(0.5));
    for (std::size_t i = 0; i < n; ++i) {
      a[i] = static_cast<TypeParam>(std::sin(1.0 + static_cast<double>(i)));
      b[i] = static_cast<TypeParam>(std::cos(2.0 * static_cast<double>(i)));
      edge[i] = static_cast<TypeParam>(0.07 * static_cast<double>(i % 3));
      edge[n + i] = static_cast<TypeParam>(0.1 * static_cast<double>(i % 3));
      z[i] = a[i];
      z[n + i] = b[i];
    }
    add_edges(edge.data(), z.data(), out.data(), n);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(out[i], 0.5 + edge[i] * a[i], rounding<TypeParam>);
      EXPECT_NEAR(out[n + i], 0.5 + edge[n + i] * b[i], rounding<TypeParam>);
    }
  }
}

} // namespace
} // namespace wrc::test::traction_loops_test
