// Each vectorised loop against its formula, element by element, for lengths with every remainder.
#include "mechanics/projected_cg_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace wrc::test::projected_cg_loops_test {
namespace {

/// Rounding of sums of up to 70 numbers of the order of 1.
template <typename Real> constexpr double rounding = 100.0 * std::numeric_limits<Real>::epsilon();

template <typename Real> std::vector<Real> numbers(std::size_t n, double phase) {
  std::vector<Real> values(n);
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = static_cast<Real>(std::sin(phase + 2.3 * static_cast<double>(i)));
  }
  return values;
}

/// 1 on two of three elements.
template <typename Real> std::vector<Real> contact_of(std::size_t n) {
  std::vector<Real> contact(n);
  for (std::size_t i = 0; i < n; ++i) {
    contact[i] = i % 3 == 1 ? Real{0} : Real{1};
  }
  return contact;
}

/// Of the approach: from 0.5 to 1.1, none like its neighbours.
std::vector<double> shares_of(std::size_t n) {
  std::vector<double> shares = numbers<double>(n, 0.9);
  std::transform(shares.begin(), shares.end(), shares.begin(),
                 [](double value) { return 0.8 + 0.3 * value; });
  return shares;
}

template <typename Real> class ProjectedCgLoops : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ProjectedCgLoops, Precisions);

template <class Check> void for_lengths(const Check& check) {
  for (const std::size_t n : {1U, 2U, 7U, 16U, 33U, 70U}) {
    check(n);
  }
}

TEST(ProjectedCgLoops, ScalingAveragesTheGapUnderPressure) {
  for_lengths([](std::size_t n) {
    std::vector<double> p = numbers<double>(n, 0.4);
    std::vector<double> u = numbers<double>(n, 1.0);
    const std::vector<double> h = numbers<double>(n, 2.0);
    const std::vector<double> p_before = p;
    const std::vector<double> u_before = u;
    const std::vector<double> s = shares_of(n);
    const ContactMean mean =
        scale_and_average(p.data(), u.data(), h.data(), s.data(), 1.25, 0.3, n);
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_DOUBLE_EQ(p[i], 1.25 * p_before[i]);
      EXPECT_DOUBLE_EQ(u[i], 1.25 * u_before[i]);
      if (p[i] > 0.0) {
        sum += s[i] * (h[i] + u[i] - s[i] * 0.3);
        squares += s[i] * s[i];
      }
    }
    EXPECT_NEAR(mean.sum, sum, rounding<double>);
    EXPECT_NEAR(mean.squares, squares, rounding<double>);
  });
}

TYPED_TEST(ProjectedCgLoops, ResidualIsThereOnContactOnly) {
  using Real = TypeParam;
  for_lengths([](std::size_t n) {
    std::vector<double> p = numbers<double>(n, 0.4);
    std::transform(p.begin(), p.end(), p.begin(), [](double v) { return std::max(v, 0.0); });
    const std::vector<double> u = numbers<double>(n, 1.0);
    const std::vector<double> h = numbers<double>(n, 2.0);
    const std::vector<double> s = shares_of(n);
    std::vector<Real> r(n);
    std::vector<Real> contact(n);
    form_residual(p.data(), u.data(), h.data(), s.data(), 0.2, r.data(), contact.data(), n);
    for (std::size_t i = 0; i < n; ++i) {
      const double residual = s[i] * 0.2 - h[i] - u[i];
      const bool touches = p[i] > 0.0 || residual > 0.0;
      EXPECT_EQ(contact[i], touches ? Real{1} : Real{0});
      EXPECT_NEAR(r[i], touches ? residual : 0.0, rounding<Real>);
    }
  });
}

TYPED_TEST(ProjectedCgLoops, CorrectionIsSummedOverContact) {
  using Real = TypeParam;
  for_lengths([](std::size_t n) {
    std::vector<Real> z = numbers<Real>(n, 0.4);
    const std::vector<Real> all_z = z;
    const std::vector<Real> contact = contact_of<Real>(n);
    std::vector<Real> r = numbers<Real>(n, 1.0);
    std::vector<Real> old_r = numbers<Real>(n, 2.0);
    std::vector<Real> v = numbers<Real>(n, 3.0);
    for (std::size_t i = 0; i < n; ++i) { // as the iteration keeps them
      r[i] *= contact[i];
      old_r[i] *= contact[i];
      v[i] *= contact[i];
    }
    const std::vector<double> s = shares_of(n);
    const CorrectionSums sums =
        sum_correction(z.data(), r.data(), old_r.data(), v.data(), contact.data(), s.data(), n);
    CorrectionSums expected;
    expected.least_z = std::numeric_limits<Real>::max();
    expected.largest_z = -expected.least_z;
    for (std::size_t i = 0; i < n; ++i) {
      const double here = contact[i] * all_z[i];
      EXPECT_EQ(z[i], contact[i] * all_z[i]);
      expected.s_s += contact[i] * s[i] * s[i];
      expected.s_z += s[i] * here;
      expected.s_r += s[i] * r[i];
      expected.s_old_r += s[i] * old_r[i];
      expected.z_r += here * r[i];
      expected.z_old_r += here * old_r[i];
      expected.s_v += s[i] * v[i];
      if (contact[i] > Real{0}) {
        expected.least_z = std::min(expected.least_z, here);
        expected.largest_z = std::max(expected.largest_z, here);
      }
    }
    EXPECT_NEAR(sums.s_s, expected.s_s, rounding<Real>);
    EXPECT_NEAR(sums.s_z, expected.s_z, rounding<Real>);
    EXPECT_NEAR(sums.s_r, expected.s_r, rounding<Real>);
    EXPECT_NEAR(sums.s_old_r, expected.s_old_r, rounding<Real>);
    EXPECT_NEAR(sums.z_r, expected.z_r, rounding<Real>);
    EXPECT_NEAR(sums.z_old_r, expected.z_old_r, rounding<Real>);
    EXPECT_NEAR(sums.s_v, expected.s_v, rounding<Real>);
    EXPECT_EQ(sums.least_z, expected.least_z);
    EXPECT_EQ(sums.largest_z, expected.largest_z);
  });
}

TYPED_TEST(ProjectedCgLoops, DirectionStaysWithinContact) {
  using Real = TypeParam;
  for_lengths([](std::size_t n) {
    const std::vector<Real> contact = contact_of<Real>(n);
    std::vector<Real> z = numbers<Real>(n, 0.4);
    std::vector<Real> v = numbers<Real>(n, 3.0);
    for (std::size_t i = 0; i < n; ++i) {
      z[i] *= contact[i];
    }
    const std::vector<Real> before = v;
    const std::vector<double> s = shares_of(n);
    form_direction(z.data(), v.data(), contact.data(), s.data(), 0.6, 0.1, n);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(v[i], contact[i] * (z[i] + 0.6 * before[i] - 0.1 * s[i]), rounding<Real>) << i;
    }
  });
}

TYPED_TEST(ProjectedCgLoops, EnergiesAreProducts) {
  using Real = TypeParam;
  for_lengths([](std::size_t n) {
    const std::vector<double> p = numbers<double>(n, 0.1);
    const std::vector<double> u = numbers<double>(n, 0.2);
    const std::vector<Real> r = numbers<Real>(n, 0.3);
    const std::vector<Real> v = numbers<Real>(n, 0.4);
    const std::vector<Real> q = numbers<Real>(n, 0.5);
    const auto product = [n](const auto& a, const auto& b) {
      double sum = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
      }
      return sum;
    };
    const std::vector<double> one(n, 1.0);
    const StepSums step = sum_step(r.data(), v.data(), q.data(), n);
    EXPECT_NEAR(step.r_v, product(r, v), rounding<Real>);
    EXPECT_NEAR(step.v_q, product(v, q), rounding<Real>);
    const std::vector<double> s = shares_of(n);
    const JointStepSums joint =
        sum_joint_step(p.data(), u.data(), r.data(), v.data(), q.data(), s.data(), n);
    EXPECT_NEAR(joint.v_q, product(v, q), rounding<Real>);
    EXPECT_NEAR(joint.p_q, product(p, q), rounding<Real>);
    EXPECT_NEAR(joint.p_u, product(p, u), rounding<Real>);
    EXPECT_NEAR(joint.r_v, product(r, v), rounding<Real>);
    EXPECT_NEAR(joint.r_p, product(r, p), rounding<Real>);
    EXPECT_NEAR(joint.v, product(v, one), rounding<Real>);
    EXPECT_NEAR(joint.p, product(p, one), rounding<Real>);
    EXPECT_NEAR(joint.s_v, product(s, v), rounding<Real>);
    EXPECT_NEAR(joint.s_p, product(s, p), rounding<Real>);
  });
}

TYPED_TEST(ProjectedCgLoops, MoveAndItsCutKeepPressureAndChangeTogether) {
  using Real = TypeParam;
  for_lengths([](std::size_t n) {
    std::vector<double> p = numbers<double>(n, 0.1);
    std::transform(p.begin(), p.end(), p.begin(), [](double value) { return std::abs(value); });
    std::vector<double> u = numbers<double>(n, 0.2);
    const std::vector<double> p_before = p;
    const std::vector<double> u_before = u;
    const std::vector<Real> v = numbers<Real>(n, 0.4);
    const std::vector<Real> q = numbers<Real>(n, 0.5);
    const std::vector<double> s = shares_of(n);
    const MoveSums sums = move(p.data(), u.data(), v.data(), q.data(), s.data(), 0.7, n);
    MoveSums expected;
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(p[i], p_before[i] + 0.7 * static_cast<double>(v[i]), rounding<Real>);
      EXPECT_NEAR(u[i], u_before[i] + 0.7 * static_cast<double>(q[i]), rounding<Real>);
      expected.load += s[i] * std::max(p[i], 0.0);
      expected.largest = std::max(expected.largest, p[i]);
      expected.largest_change =
          std::max(expected.largest_change, std::abs(0.7 * static_cast<double>(v[i])));
      expected.negative_count += p[i] < 0.0 ? 1.0 : 0.0;
    }
    EXPECT_NEAR(sums.load, expected.load, rounding<Real>);
    EXPECT_EQ(sums.largest, expected.largest);
    EXPECT_NEAR(sums.largest_change, expected.largest_change, rounding<Real>);
    EXPECT_EQ(sums.negative_count, expected.negative_count);
    std::vector<Real> change(n);
    form_change(p.data(), v.data(), 0.7, change.data(), n);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(change[i], std::max(p[i], 0.0) - p_before[i], rounding<Real>) << i;
    }
  });
}

TYPED_TEST(ProjectedCgLoops, TakesOutWhatCutPressuresDisplaced) {
  using Real = TypeParam;
  for_lengths([](std::size_t n) {
    for (const std::size_t cuts : {0U, 1U, 3U, 8U, 11U}) {
      std::vector<std::vector<Real>> kernels;
      std::vector<const Real*> first;
      for (std::size_t c = 0; c < cuts; ++c) {
        kernels.push_back(numbers<Real>(n, 0.3 * static_cast<double>(c)));
      }
      for (const std::vector<Real>& kernel : kernels) {
        first.push_back(kernel.data());
      }
      const std::vector<Real> pressures = numbers<Real>(cuts, 1.0);
      std::vector<double> u = numbers<double>(n, 0.2);
      const std::vector<double> before = u;
      std::vector<Real> scratch(n);
      take_out(u.data(), scratch.data(), first.data(), pressures.data(), cuts, n);
      for (std::size_t i = 0; i < n; ++i) {
        double displaced = 0.0;
        for (std::size_t c = 0; c < cuts; ++c) {
          displaced += static_cast<double>(pressures[c]) * static_cast<double>(kernels[c][i]);
        }
        EXPECT_NEAR(u[i], before[i] - displaced, rounding<Real>) << i << ' ' << cuts;
      }
    }
  });
}

} // namespace
} // namespace wrc::test::projected_cg_loops_test
