/// Steady rolling, steps and shifts against closed forms, identities and published values.
#include "rolling/rolling_contact.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/rolling_ellipse.hpp"

namespace wrc::test::rolling_contact_test {
namespace {

// The values printed by CONTACT (Vollebregt, open source, 2024) for elliptic pressures on the same
// elements, with its stopping tolerance of 1e-6.
TEST(RollingContact, FirstOrderDifferenceGivesWhatContactGives) {
  struct Case {
    std::size_t count;
    Creepages creepages;
    double x, y, moment;
  };
  const Creepages along{-0.001385074967904795, 0.0, 0.0};
  const Creepages all{-0.001385074967904795, -0.0015799647930828113, -0.0007867372780147649};
  for (const Case& c :
       {Case{16, along, 0.45138128940672206, 0.0, 0.0},
        Case{16, all, 0.29739637979244127, 0.7588811245250848, 0.19729224539254067},
        Case{32, along, 0.4369216927532865, 0.0, 0.0},
        Case{32, all, 0.2948559360816609, 0.7495508852344775, 0.1874978896278011}}) {
    Ellipse ellipse;
    ellipse.along = ellipse.across = c.count;
    ellipse.scaled = false;
    RollingProblem problem = ellipse.problem(c.creepages, 1e-6);
    problem.difference = SlipDifference::first_order;
    const RollingSolution solution = RollingSolver().solve(problem);
    EXPECT_NEAR(relative(solution.longitudinal_force), c.x, 3e-6);
    EXPECT_NEAR(relative(solution.lateral_force), c.y, 3e-6);
    EXPECT_NEAR(relative(solution.spin_moment) / ellipse.a, c.moment, 3e-6);
  }
}

// CONTACT's values extrapolated to elements of no size; their own error is 2e-4 to 5e-4.
TEST(RollingContact, ForcesOnEllipsesAreAccurateToAThousandth) {
  struct Case {
    double a, b;
    Creepages creepages;
    double x, y, moment;
  };
  for (const Case& c :
       {Case{5.0,
             5.0,
             {-0.001385074967904795, -0.0015799647930828113, -0.0007867372780147649},
             0.2937,
             0.7436,
             0.1801},
        Case{5.0, 5.0, {-0.001385074967904795, 0.0, 0.0}, 0.4271, 0.0, 0.0}}) {
    Ellipse ellipse;
    ellipse.a = c.a;
    ellipse.b = c.b;
    ellipse.along = 64;
    const RollingSolution solution = RollingSolver().solve(ellipse.problem(c.creepages, 1e-3));
    EXPECT_TRUE(solution.converged);
    EXPECT_NEAR(relative(solution.longitudinal_force), c.x, 2e-3);
    EXPECT_NEAR(relative(solution.lateral_force), c.y, 2e-3);
    EXPECT_NEAR(relative(solution.spin_moment) / std::sqrt(c.a * c.b), c.moment, 2e-3);
  }
}

// Carter (1926): F/(mu Q) = 1 - (a'/a)^2 with xi = mu p0 (1 - nu)... of a line contact. One row of
// elements a thousand times as long as the contact is nearly one; the grid ends at the edges.
TEST(RollingContact, CartersLineContact) {
  for (const double share : {0.3, 0.6, 0.9}) {
    double errors[2] = {};
    for (const std::size_t count : {std::size_t{16}, std::size_t{64}}) {
      const double a = 1.0;
      const double width = 2000.0;
      RollingProblem problem;
      problem.grid = {1,     count,
                      width, 2.0 * a / static_cast<double>(count),
                      0.0,   -a + a / static_cast<double>(count)};
      std::vector<double> pressure(count);
      double sum = 0.0;
      const double largest = 1000.0;
      for (std::size_t i = 0; i < count; ++i) {
        const double x = problem.grid.longitudinal(i) / a;
        pressure[i] = largest * std::sqrt(1.0 - x * x);
        sum += pressure[i] * problem.grid.longitudinal_step;
      }
      for (double& p : pressure) {
        p *= 0.5 * std::numbers::pi * largest * a / sum;
      }
      problem.pressure = pressure;
      problem.friction = friction;
      problem.shear_modulus = shear_modulus;
      problem.poisson = 0.28;
      problem.tolerance = 1e-6;
      // Full slip begins at 2 mu p0 (1 - nu)/G (Johnson 1985, eq. 8.41, both bodies).
      const double saturation = 2.0 * friction * largest * (1.0 - 0.28) / shear_modulus;
      problem.creepages.longitudinal = -share * saturation;
      const double stick = 1.0 - share;
      const RollingSolution solution = RollingSolver().solve(problem);
      const double whole = friction * 0.5 * std::numbers::pi * largest * a * width;
      errors[count == 16 ? 0 : 1] =
          std::abs(solution.longitudinal_force / whole - (1.0 - stick * stick));
    }
    EXPECT_LE(errors[0], 2e-3) << share;
    EXPECT_LE(errors[1], 4e-4) << share;
  }
}

TEST(RollingContact, FullSlidingTransmitsAllOfTheFriction) {
  Ellipse ellipse;
  const RollingSolution solution = RollingSolver().solve(ellipse.problem({3.0, -4.0, 0.0}));
  EXPECT_NEAR(relative(solution.longitudinal_force), -0.6, 1e-4);
  EXPECT_NEAR(relative(solution.lateral_force), 0.8, 1e-4);
  EXPECT_EQ(solution.adhesion_area, 0.0);
}

/// Slips are up to 1e50 times what tractions displace, more than single precision holds.
TEST(RollingContact, TheSmallestFrictionSlidesLikeAnyOther) {
  Ellipse ellipse;
  RollingProblem problem = ellipse.problem({1e-3, 0.0, -6e-4});
  problem.derivatives = true;
  problem.friction = 1e-9;
  const RollingSolution little = RollingSolver().solve(problem);
  for (const double share : {1e-15, 1e-41}) {
    RollingProblem less = problem;
    less.friction *= share;
    const RollingSolution found = RollingSolver().solve(less);
    const double size = std::abs(little.longitudinal_force);
    EXPECT_NEAR(found.longitudinal_force / share, little.longitudinal_force, 1e-5 * size);
    EXPECT_NEAR(found.lateral_force / share, little.lateral_force, 1e-5 * size);
    EXPECT_NEAR(found.by_creepage[0] / share, little.by_creepage[0],
                1e-2 * std::abs(little.by_creepage[0]));
    EXPECT_NEAR(found.slip_x[0], little.slip_x[0], 1e-6);
  }
}

/// Pressures so small that their ratio to the largest is no number of full precision.
TEST(RollingContact, SubnormalPressuresDoNotAffectTheForce) {
  const std::vector<double> pressure{1e3, 1e-320, 1e3, 1e-320, 1e3, 1e3, 1e3, 1e-320, 0.0};
  RollingProblem problem;
  problem.grid = {3, 3, 0.3, 0.3, 0.0, 0.0};
  problem.pressure = pressure;
  problem.friction = 1e-9;
  problem.shear_modulus = 82000.0;
  problem.poisson = 0.28;
  problem.creepages = {1e-3, 0.0, 0.0};
  problem.tolerance = 1e-6;
  const RollingSolution solution = RollingSolver().solve(problem);
  EXPECT_NEAR(solution.longitudinal_force, -5e-6 * 0.09, 1e-3 * 5e-6 * 0.09);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    EXPECT_LE(std::abs(solution.traction_x[i]), 1.001e-9 * pressure[i]);
  }
}

// The moment of friction that turns everywhere, of Hertz's pressures on a circle.
TEST(RollingContact, LargeSpinOnACircle) {
  Ellipse ellipse;
  ellipse.along = ellipse.across = 64;
  const RollingSolution solution = RollingSolver().solve(ellipse.problem({0.0, 0.0, 1e3}));
  EXPECT_NEAR(relative(solution.spin_moment) / ellipse.a, -3.0 * std::numbers::pi / 16.0, 1e-3);
}

TEST(RollingContact, NothingWithoutCreepageFrictionOrPressure) {
  Ellipse ellipse;
  RollingProblem problem = ellipse.problem({});
  for (int kind = 0; kind < 3; ++kind) {
    if (kind == 1) {
      problem.creepages = {1e-3, 1e-3, 1e-4};
      problem.friction = 0.0;
    } else if (kind == 2) {
      problem.friction = friction;
      ellipse.pressure.assign(ellipse.pressure.size(), 0.0);
    }
    const RollingSolution solution = RollingSolver().solve(problem);
    EXPECT_EQ(solution.longitudinal_force, 0.0);
    EXPECT_EQ(solution.lateral_force, 0.0);
    EXPECT_EQ(solution.spin_moment, 0.0);
    EXPECT_TRUE(solution.converged);
  }
}

// Signs follow from the mirror images of the problem.
TEST(RollingContact, MirroredCreepagesGiveMirroredForces) {
  Ellipse ellipse;
  RollingSolver solver;
  const auto solve = [&](const Creepages& creepages) {
    return solver.solve(ellipse.problem(creepages, 1e-5));
  };
  const RollingSolution one = solve({1e-3, 8e-4, 3e-4});
  const RollingSolution mirrored = solve({1e-3, -8e-4, -3e-4});
  const RollingSolution opposite = solve({-1e-3, -8e-4, -3e-4});
  const double whole = friction * load;
  EXPECT_NEAR(mirrored.longitudinal_force, one.longitudinal_force, 1e-4 * whole);
  EXPECT_NEAR(mirrored.lateral_force, -one.lateral_force, 1e-4 * whole);
  EXPECT_NEAR(mirrored.spin_moment, -one.spin_moment, 1e-4 * whole * ellipse.a);
  EXPECT_NEAR(opposite.longitudinal_force, -one.longitudinal_force, 1e-4 * whole);
  EXPECT_NEAR(opposite.lateral_force, -one.lateral_force, 1e-4 * whole);
}

// Where nothing slips forces are linear in the creepages, and the influence of spin on the lateral
// force is that of lateral creepage on the moment (C23 = -C32). For nu = 0 C11 = C22 on a circle.
TEST(RollingContact, WithoutSlipReciprocityHolds) {
  Ellipse ellipse;
  ellipse.a = 3.0;
  RollingSolver solver;
  const auto solve = [&](const Creepages& creepages) {
    RollingProblem problem = ellipse.problem(creepages, 1e-6);
    problem.friction = 1e4;
    return solver.solve(problem);
  };
  for (const std::size_t count : {std::size_t{32}, std::size_t{64}}) {
    ellipse.along = count;
    ellipse.across = count;
    const RollingSolution spin = solve({0.0, 0.0, 1e-4});
    const RollingSolution lateral = solve({0.0, 1e-3, 0.0});
    EXPECT_EQ(spin.slip_area, 0.0);
    const double one = spin.lateral_force / 1e-4;
    const double other = -lateral.spin_moment / 1e-3;
    EXPECT_NEAR(one / other, 1.0, 1e-6); // the tolerance of the iteration
  }

  ellipse.a = 5.0;
  ellipse.poisson = 0.0;
  const RollingSolution along = solve({1e-3, 0.0, 0.0});
  const RollingSolution across = solve({0.0, 1e-3, 0.0});
  EXPECT_NEAR(along.longitudinal_force, across.lateral_force,
              1e-4 * std::abs(across.lateral_force));
}

// Frictional power is -F.w in steady rolling; what slip times traction shows of it on the grid
// tends to that.
TEST(RollingContact, NumericalLossShrinksWithTheElements) {
  double before = 1.0;
  for (const std::size_t count : {std::size_t{16}, std::size_t{32}, std::size_t{64}}) {
    Ellipse ellipse;
    ellipse.along = count;
    ellipse.across = count / 2;
    const RollingSolution solution =
        RollingSolver().solve(ellipse.problem({-1.4e-3, -1.6e-3, 0.0}, 1e-5));
    EXPECT_GT(solution.friction_power, 0.0);
    EXPECT_GT(solution.numerical_loss, 0.0);
    EXPECT_LT(solution.numerical_loss, 0.7 * before);
    before = solution.numerical_loss;
  }
}

// Cattaneo (1938), Mindlin (1949): a sphere shifted from rest; Vollebregt's CONTACT agrees to 4e-4.
TEST(RollingContact, CattaneosShift) {
  Ellipse ellipse;
  ellipse.poisson = 0.0; // exact for no coupling between the directions
  ellipse.along = ellipse.across = 64;
  for (const double share : {0.2, 0.5, 0.8}) {
    const double shift = 3.0 * friction * load / (16.0 * ellipse.a) * (2.0 / shear_modulus) * 2.0 *
                         (1.0 - std::cbrt((1.0 - share) * (1.0 - share)));
    RollingProblem problem = ellipse.problem({shift, 0.0, 0.0}, 1e-5);
    problem.motion = TangentialMotion::shift;
    const RollingSolution solution = RollingSolver().solve(problem);
    EXPECT_NEAR(relative(solution.longitudinal_force), -share, 1e-3);
  }
}

// CONTACT's values for rolling from rest on the same elements: the first two steps and the last of
// forty, which is steady to 0.3 %.
TEST(RollingContact, RollingFromRestBecomesSteady) {
  Ellipse ellipse;
  RollingProblem problem = ellipse.problem({-0.00277014993580959, 0.0, 0.0}, 1e-4);
  problem.motion = TangentialMotion::transient;
  RollingSolver solver;
  std::vector<double> x;
  std::vector<double> y;
  double force = 0.0;
  for (int step = 1; step <= 40; ++step) {
    problem.previous_x = x;
    problem.previous_y = y;
    RollingSolution solution = solver.solve(problem);
    ASSERT_TRUE(solution.converged) << step;
    x = std::move(solution.traction_x);
    y = std::move(solution.traction_y);
    force = relative(solution.longitudinal_force);
    if (step == 1) {
      EXPECT_NEAR(force, 0.03427, 3e-4);
    } else if (step == 2) {
      EXPECT_NEAR(force, 0.06769, 3e-4);
    }
  }
  EXPECT_NEAR(force, 0.68047, 2e-3);
}

TEST(RollingContact, ShiftsFollowEachOther) {
  Ellipse ellipse;
  RollingProblem problem = ellipse.problem({0.010888633596740242, 0.0, 0.0}, 1e-4);
  problem.motion = TangentialMotion::shift;
  RollingSolver solver;
  const RollingSolution first = solver.solve(problem);
  problem.previous_x = first.traction_x;
  problem.previous_y = first.traction_y;
  problem.creepages.longitudinal = 0.00993441960302537;
  const RollingSolution second = solver.solve(problem);
  EXPECT_NEAR(relative(first.longitudinal_force), -0.4, 2e-3);
  EXPECT_NEAR(relative(second.longitudinal_force), -0.7, 2e-3);
}

TEST(RollingContact, BitsDoNotDependOnEarlierSolutions) {
  Ellipse ellipse;
  RollingSolver used;
  (void)used.solve(ellipse.problem({5e-3, 0.0, -1e-4}));
  Ellipse other;
  other.along = 20;
  (void)used.solve(other.problem({1e-3, 0.0, 0.0}));
  const RollingProblem problem = ellipse.problem({1e-3, 8e-4, 3e-4});
  const RollingSolution again = used.solve(problem);
  const RollingSolution fresh = RollingSolver().solve(problem);
  EXPECT_EQ(again.traction_x, fresh.traction_x);
  EXPECT_EQ(again.traction_y, fresh.traction_y);
  EXPECT_EQ(again.spin_moment, fresh.spin_moment);
}

TEST(RollingContact, RefusesArgumentsOutsideTheirRanges) {
  Ellipse ellipse;
  const RollingProblem good = ellipse.problem({1e-3, 0.0, 0.0});
  const auto refused = [&](auto change, const std::string& name) {
    RollingProblem problem = good;
    change(problem);
    try {
      (void)RollingSolver().solve(problem);
      ADD_FAILURE() << name << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name, 0), 0U) << error.what();
    }
  };
  const std::vector<double> few(3, 1.0);
  const std::vector<double> shares(good.pressure.size(), 1.5);
  const std::vector<double> negative(good.pressure.size(), -1.0);
  const std::vector<double> infinite(good.pressure.size(), INFINITY);
  refused([](RollingProblem& p) { p.friction = -0.1; }, "friction");
  refused([](RollingProblem& p) { p.shear_modulus = 0.0; }, "shear_modulus");
  refused([](RollingProblem& p) { p.poisson = 0.6; }, "poisson");
  refused([](RollingProblem& p) { p.tolerance = 0.0; }, "tolerance");
  refused([](RollingProblem& p) { p.maximum_iterations = 0; }, "maximum_iterations");
  refused([](RollingProblem& p) { p.creepages.spin = NAN; }, "spin_creepage");
  refused([&](RollingProblem& p) { p.pressure = few; }, "pressure.size");
  refused([&](RollingProblem& p) { p.previous_x = few; }, "previous_x.size");
  refused([&](RollingProblem& p) { p.pressure = negative; }, "pressure[0] = -1");
  refused([&](RollingProblem& p) { p.covered = few; }, "covered.size");
  refused([&](RollingProblem& p) { p.covered = shares; }, "covered[0] = 1.5");
  refused([&](RollingProblem& p) { p.previous_x = p.previous_y = infinite; }, "previous_x");
}

} // namespace
} // namespace wrc::test::rolling_contact_test
