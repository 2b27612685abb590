/// FASTSIM on ellipses and strip by strip: closed forms, published values, the limit without slip.
#include "rolling/fastsim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace wrc::test::fastsim_test {
namespace {

constexpr double load = 80000.0;
constexpr double friction = 0.3;
constexpr double shear_modulus = 82000.0;
constexpr double poisson = 0.28;
constexpr double whole = friction * load;

RollingEllipse ellipse_of(double a, double b) {
  return {a, b, load, friction, shear_modulus, poisson};
}

/// Pure longitudinal creepage over mu N, closed form. `k`: gradient of the traction in adhesion,
/// over mu times the largest pressure over a.
double pure_longitudinal_force(double k) {
  // A strip of half length l (in a) sticks from its leading edge to where k (l - x) = l^2 - x^2.
  const auto strip = [&](double l) {
    const double edge = std::clamp(k - l, -l, l);
    const double stick = k * (l - edge) * (l - edge) / 2.0;
    const double slip = l * l * (edge + l) - (edge * edge * edge + l * l * l) / 3.0;
    return stick + slip;
  };
  double sum = 0.0;
  constexpr int count = 20000;
  for (int j = 0; j < count; ++j) {
    const double y = (j + 0.5) / count;
    sum += strip(std::sqrt(1.0 - y * y)) / count;
  }
  return 2.0 * sum / (0.5 * std::numbers::pi); // the bound's volume over the ellipse
}

TEST(Fastsim, PureLongitudinalCreepageMeetsTheClosedForm) {
  const RollingEllipse ellipse = ellipse_of(5.0, 8.0);
  const Flexibilities flexibilities{1e-4, 1e-4, 1e-4};
  const double largest = friction * 2.0 * load / (std::numbers::pi * 40.0);
  for (const double k : {0.05, 0.3, 0.8, 1.5, 3.0}) {
    const double xi = -k * largest * 1e-4 / 5.0;
    const FastsimForces coarse = fastsim_forces(ellipse, flexibilities, {xi, 0.0, 0.0});
    const FastsimForces fine = fastsim_forces(ellipse, flexibilities, {xi, 0.0, 0.0}, {256, 256});
    EXPECT_NEAR(coarse.forces.longitudinal / whole, pure_longitudinal_force(k), 4e-3) << k;
    EXPECT_NEAR(fine.forces.longitudinal / whole, pure_longitudinal_force(k), 1e-4) << k;
    EXPECT_NEAR(fine.friction_power, -fine.forces.longitudinal * xi, 1e-9 * whole);
    EXPECT_NEAR(fine.slip_area + fine.adhesion_area, std::numbers::pi * 40.0, 0.02);
  }
}

// Without slip the flexibilities give back the coefficients they were made of.
TEST(Fastsim, SmallCreepagesAreLinear) {
  const RollingEllipse ellipse = ellipse_of(6.0, 4.0);
  const KalkerCoefficients kalker{4.3, 4.0, 1.7, 1.0};
  const Flexibilities flexibilities = flexibilities_of(ellipse, kalker);
  constexpr double small = 1e-9;
  for (const Creepages& w :
       {Creepages{small, 0.0, 0.0}, Creepages{0.0, small, 0.0}, Creepages{0.0, 0.0, small}}) {
    const CreepForces linear = linear_forces(ellipse, kalker, w);
    const CreepForces forces = fastsim_forces(ellipse, flexibilities, w, {128, 128}).forces;
    const double size = std::hypot(linear.longitudinal, linear.lateral);
    EXPECT_NEAR(forces.longitudinal, linear.longitudinal, 1e-3 * size);
    EXPECT_NEAR(forces.lateral, linear.lateral, 1e-3 * size);
  }
}

TEST(Fastsim, FullSlidingTransmitsAllOfTheFriction) {
  const RollingEllipse ellipse = ellipse_of(5.0, 5.0);
  const Flexibilities flexibilities{1e-4, 1e-4, 1e-4};
  for (const FastsimGrid& grid : {FastsimGrid{10, 10}, FastsimGrid{16, 16}, FastsimGrid{33, 7}}) {
    const FastsimForces sliding = fastsim_forces(ellipse, flexibilities, {30.0, -40.0, 0.0}, grid);
    EXPECT_NEAR(sliding.forces.longitudinal / whole, -0.6, 1e-9);
    EXPECT_NEAR(sliding.forces.lateral / whole, 0.8, 1e-9);
    EXPECT_NEAR(sliding.adhesion_area, 0.0, 1e-9);
  }
  // Friction that turns everywhere, of parabolic pressure: 8/15 mu N a.
  const FastsimForces spinning =
      fastsim_forces(ellipse, flexibilities, {0.0, 0.0, 1e3}, {200, 200});
  EXPECT_NEAR(spinning.forces.spin_moment / (whole * 5.0), -8.0 / 15.0, 1e-3);
}

// CONTACT (Vollebregt, open source, 2024), its FASTSIM with parabolic bound and the flexibilities
// it used, from 64 x 64 and 128 x 128 elements extrapolated to none: it marches over a regular grid
// with a first-order step, which is what is left of the difference.
TEST(Fastsim, FineGridsGiveWhatContactTendsTo) {
  struct Case {
    double a, b;
    Flexibilities flexibilities;
    Creepages creepages;
    double x, y, moment;
  };
  for (const Case& c : {Case{2.2360679775,
                             11.1803398875,
                             {2.10742534e-05, 2.67451517e-05, 1.65768145e-05},
                             {-0.00167442563, -0.00222222113, -0.00188282421},
                             0.09799,
                             0.42049,
                             0.70614},
                        Case{3.53553390593,
                             7.07106781187,
                             {3.10371777e-05, 3.70413475e-05, 2.65230688e-05},
                             {-0.00156787266, -0.00193468956, -0.00124084148},
                             0.19479,
                             0.62564,
                             0.35399},
                        Case{11.1803398875,
                             2.2360679775,
                             {4.60726871e-05, 4.37611288e-05, 3.54252776e-05},
                             {0, 0, -0.000207844029},
                             0.00000,
                             0.59617,
                             0.03869},
                        Case{11.1803398875,
                             2.2360679775,
                             {4.5436212e-05, 4.35099135e-05, 3.65633713e-05},
                             {-0.000741755955, -0.000704541068, -0.000173203358},
                             0.36266,
                             0.78173,
                             -0.02192}}) {
    const CreepForces forces =
        fastsim_forces(ellipse_of(c.a, c.b), c.flexibilities, c.creepages, {256, 256}).forces;
    EXPECT_NEAR(forces.longitudinal / whole, c.x, 1.5e-3);
    EXPECT_NEAR(forces.lateral / whole, c.y, 1.5e-3);
    EXPECT_NEAR(forces.spin_moment / (whole * std::sqrt(c.a * c.b)), c.moment, 1.5e-3);
  }
}

TEST(Fastsim, MirroredCreepagesGiveMirroredForces) {
  const RollingEllipse ellipse = ellipse_of(6.0, 3.0);
  const Flexibilities flexibilities{1e-4, 1.2e-4, 0.8e-4};
  const FastsimForces one = fastsim_forces(ellipse, flexibilities, {1e-3, 8e-4, 2e-4});
  const FastsimForces mirrored = fastsim_forces(ellipse, flexibilities, {1e-3, -8e-4, -2e-4});
  const FastsimForces opposite = fastsim_forces(ellipse, flexibilities, {-1e-3, -8e-4, -2e-4});
  EXPECT_NEAR(mirrored.forces.longitudinal, one.forces.longitudinal, 1e-9 * whole);
  EXPECT_NEAR(mirrored.forces.lateral, -one.forces.lateral, 1e-9 * whole);
  EXPECT_NEAR(mirrored.forces.spin_moment, -one.forces.spin_moment, 1e-8 * whole);
  EXPECT_NEAR(opposite.forces.longitudinal, -one.forces.longitudinal, 1e-9 * whole);
  EXPECT_NEAR(opposite.forces.spin_moment, -one.forces.spin_moment, 1e-8 * whole);
}

TEST(Fastsim, NothingWithoutFrictionOrLoad) {
  RollingEllipse ellipse = ellipse_of(5.0, 5.0);
  ellipse.friction = 0.0;
  EXPECT_EQ(fastsim_forces(ellipse, {1e-4, 1e-4, 1e-4}, {1e-3, 0.0, 0.0}).forces.longitudinal, 0.0);
}

/// A patch whose square of pressure is given over the unit square; pressures carry the load.
struct Patch {
  std::vector<double> pressure;
  RollingProblem problem;

  template <typename Square>
  Patch(std::size_t along, std::size_t across, double a, double b, Square square,
        double centre_x = 0.0, double centre_y = 0.0) {
    const auto columns = static_cast<double>(along);
    const auto rows = static_cast<double>(across);
    problem.grid = {across,
                    along,
                    2.0 * b / rows,
                    2.0 * a / columns,
                    centre_y - b + b / rows,
                    centre_x - a + a / columns};
    double sum = 0.0;
    for (std::size_t j = 0; j < across; ++j) {
      for (std::size_t i = 0; i < along; ++i) {
        const double value = square((problem.grid.longitudinal(i) - centre_x) / a,
                                    (problem.grid.lateral(j) - centre_y) / b);
        pressure.push_back(std::sqrt(std::max(value, 0.0)));
        sum += pressure.back() * problem.grid.element_area();
      }
    }
    for (double& p : pressure) {
      p *= load / sum;
    }
    problem.pressure = pressure;
    problem.friction = friction;
    problem.shear_modulus = shear_modulus;
    problem.poisson = poisson;
  }
  Patch(const Patch&) = delete;
  Patch& operator=(const Patch&) = delete;
  ~Patch() = default;
};

constexpr auto hertz = [](double x, double y) { return 1.0 - x * x - y * y; };
constexpr auto lobes = [](double x, double y) {
  const double u = std::abs(y) - 0.5;
  return 0.16 - u * u - (y > 0.0 ? 0.16 : 0.3) * x * x;
};
constexpr auto banana = [](double x, double y) {
  const double bent = x - 0.6 * y * y + 0.2;
  return 0.5 - bent * bent - 0.5 * y * y;
};

// The aim of the flexibilities of a patch: without slip FASTSIM has the full theory's forces.
TEST(FastsimStrips, WithoutSlipForcesAreThoseOfTheFullTheory) {
  RollingSolver solver;
  const auto check = [&](Patch& patch) {
    const Flexibilities flexibilities = flexibilities_of(patch.problem, solver);
    patch.problem.friction = 1e6;
    patch.problem.tolerance = 1e-4;
    for (const Creepages& w :
         {Creepages{1.0, 0.0, 0.0}, Creepages{0.0, 1.0, 0.0}, Creepages{0.0, 0.0, 0.1}}) {
      patch.problem.creepages = w;
      const RollingSolution full = solver.solve(patch.problem);
      const RollingSolution strips = solve_with_fastsim(patch.problem, flexibilities);
      ASSERT_TRUE(full.converged);
      if (w.longitudinal != 0.0) {
        EXPECT_NEAR(strips.longitudinal_force / full.longitudinal_force, 1.0, 2e-3);
      } else {
        EXPECT_NEAR(strips.lateral_force / full.lateral_force, 1.0, 2e-3);
      }
    }
  };
  Patch ellipse(32, 16, 5.0, 3.0, hertz);
  Patch two(24, 16, 4.0, 8.0, lobes, 1.0, -2.0); // the origin is not the patch's centre
  Patch bent(32, 16, 5.0, 5.0, banana);
  check(ellipse);
  check(two);
  check(bent);
}

// On a finer grid than the flexibilities' own.
TEST(FastsimStrips, FlexibilitiesOfAnEllipseAreNearlyKalkers) {
  RollingSolver solver;
  Patch patch(96, 48, 6.0, 4.0, hertz);
  const Flexibilities own = flexibilities_of(patch.problem, solver);
  const RollingEllipse ellipse = ellipse_of(6.0, 4.0);
  const Flexibilities kalkers = flexibilities_of(ellipse, kalker_coefficients(ellipse));
  // Errors of 32 x 16 elements.
  EXPECT_NEAR(own.longitudinal / kalkers.longitudinal, 1.0, 0.02);
  EXPECT_NEAR(own.lateral / kalkers.lateral, 1.0, 0.02);
  EXPECT_NEAR(own.spin / kalkers.spin, 1.0, 0.03);
}

TEST(FastsimStrips, FlexibilitiesDependOnTheAreaOnly) {
  RollingSolver solver;
  Patch patch(24, 12, 5.0, 5.0, hertz);
  const Flexibilities one = flexibilities_of(patch.problem, solver);
  for (double& p : patch.pressure) {
    p = p > 0.0 ? 3.0 : 0.0;
  }
  patch.problem.friction = 0.1;
  patch.problem.creepages = {1e-3, 0.0, 0.0};
  const Flexibilities other = flexibilities_of(patch.problem, solver);
  EXPECT_EQ(one.longitudinal, other.longitudinal);
  EXPECT_EQ(one.spin, other.spin);
}

// The bound is the elliptic pressure here, of equal friction: with no limit reached, and with all
// of it, strips and ellipse agree.
TEST(FastsimStrips, AgreeWithTheEllipse) {
  const RollingEllipse ellipse = ellipse_of(6.0, 4.0);
  const Flexibilities flexibilities = flexibilities_of(ellipse, {4.3, 4.0, 1.7, 1.0});
  Patch patch(128, 128, 6.0, 4.0, hertz);
  for (const Creepages& w : {Creepages{1e-9, 2e-9, 1e-10}, Creepages{3.0, -4.0, 0.0}}) {
    patch.problem.creepages = w;
    const RollingSolution strips = solve_with_fastsim(patch.problem, flexibilities);
    const CreepForces forces = fastsim_forces(ellipse, flexibilities, w, {128, 128}).forces;
    const double size = std::hypot(forces.longitudinal, forces.lateral);
    EXPECT_NEAR(strips.longitudinal_force, forces.longitudinal, 0.01 * size);
    EXPECT_NEAR(strips.lateral_force, forces.lateral, 0.01 * size);
  }
}

TEST(FastsimStrips, TractionsStayWithinTheBoundAndOpposeTheSlip) {
  Patch patch(40, 30, 5.0, 6.0, lobes);
  patch.problem.creepages = {1e-3, -1e-3, 4e-4};
  const Flexibilities flexibilities{1e-4, 1e-4, 1e-4};
  const RollingSolution solution = solve_with_fastsim(patch.problem, flexibilities);
  double x = 0.0;
  double slipping = 0.0;
  for (std::size_t i = 0; i < patch.pressure.size(); ++i) {
    const double bound = friction * patch.pressure[i];
    const double size = std::hypot(solution.traction_x[i], solution.traction_y[i]);
    const double slip = std::hypot(solution.slip_x[i], solution.slip_y[i]);
    EXPECT_LE(size, bound * (1.0 + 1e-12));
    if (slip > 0.0) {
      EXPECT_NEAR(size, bound, 1e-12 * bound);
      EXPECT_NEAR(solution.traction_x[i] * solution.slip_x[i] +
                      solution.traction_y[i] * solution.slip_y[i],
                  -size * slip, 1e-9 * size * slip);
      slipping += patch.problem.grid.element_area();
    }
    x += solution.traction_x[i] * patch.problem.grid.element_area();
  }
  EXPECT_NEAR(x, solution.longitudinal_force, 1e-9 * whole);
  EXPECT_NEAR(slipping, solution.slip_area, 1e-9 * slipping);
  EXPECT_GT(solution.adhesion_area, 0.0);
  EXPECT_TRUE(solution.converged);
  EXPECT_NEAR(solution.friction_power,
              -(solution.longitudinal_force * 1e-3 - solution.lateral_force * 1e-3 +
                solution.spin_moment * 4e-4),
              1e-9 * whole);
}

// A strip with a gap: the rear part knows nothing of the front one.
TEST(FastsimStrips, EachPartOfAStripHasALeadingEdge) {
  Patch patch(16, 1, 8.0, 1.0, [](double, double) { return 1.0; });
  patch.pressure[8] = 0.0;
  patch.problem.creepages = {-1e-5, 0.0, 0.0};
  const RollingSolution solution = solve_with_fastsim(patch.problem, {1e-4, 1e-4, 1e-4});
  // 1 mm elements, 0.1 MPa/mm; the leading edge is at large x.
  EXPECT_NEAR(solution.traction_x[15], 0.05, 1e-12);
  EXPECT_NEAR(solution.traction_x[9], 0.65, 1e-12);
  EXPECT_EQ(solution.traction_x[8], 0.0);
  EXPECT_NEAR(solution.traction_x[7], 0.05, 1e-12);
  EXPECT_NEAR(solution.traction_x[0], 0.75, 1e-12);
}

TEST(FastsimStrips, NoContactHasNoFlexibility) {
  Patch patch(8, 8, 1.0, 1.0, hertz);
  std::fill(patch.pressure.begin(), patch.pressure.end(), 0.0);
  patch.problem.creepages = {1e-3, 0.0, 1e-4};
  RollingSolver solver;
  const Flexibilities flexibilities = flexibilities_of(patch.problem, solver);
  EXPECT_TRUE(std::isinf(flexibilities.longitudinal));
  EXPECT_EQ(solve_with_fastsim(patch.problem, flexibilities).longitudinal_force, 0.0);
}

TEST(FastsimStrips, RefusesArgumentsOutsideTheirRanges) {
  Patch patch(8, 8, 1.0, 1.0, hertz);
  const auto refused = [](auto call, const std::string& name) {
    try {
      call();
      ADD_FAILURE() << name << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name, 0), 0U) << error.what();
    }
  };
  const Flexibilities good{1e-4, 1e-4, 1e-4};
  const auto solve = [&](const Flexibilities& flexibilities) {
    (void)solve_with_fastsim(patch.problem, flexibilities);
  };
  refused([&] { solve({0.0, 1e-4, 1e-4}); }, "longitudinal_flexibility");
  refused([&] { solve({1e-4, -1.0, 1e-4}); }, "lateral_flexibility");
  refused([&] { solve({1e-4, 1e-4, NAN}); }, "spin_flexibility");
  refused([&] { solve({1e-4, 1e-4, 1e-4, INFINITY}); }, "spin_lead");
  patch.problem.motion = TangentialMotion::shift;
  refused([&] { solve(good); }, "motion");
  patch.problem.motion = TangentialMotion::rolling;
  patch.problem.shear_modulus = -1.0;
  refused([&] { solve(good); }, "shear_modulus");
  const RollingEllipse ellipse = ellipse_of(1.0, 1.0);
  refused([&] { (void)fastsim_forces(ellipse, good, {}, {0, 16}); }, "strips");
  refused([&] { (void)fastsim_forces(ellipse, good, {}, {257, 16}); }, "strips");
  refused([&] { (void)fastsim_forces(ellipse, good, {}, {16, 0}); }, "slices");
}

} // namespace
} // namespace wrc::test::fastsim_test
