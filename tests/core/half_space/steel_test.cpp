/// Yield stresses by number and grade, and the law of pressures beyond them.
#include "half_space/steel.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "half_space/constants.hpp"

namespace wrc::test::steel_test {
namespace {

TEST(Steel, AGradeSaysItsYieldStressAndItsSource) {
  const std::optional<Steel> rail = steel_of_grade("R260");
  ASSERT_TRUE(rail);
  EXPECT_EQ(rail->yield_stress, 480.0);
  EXPECT_EQ(text_of(*rail), "R260, 480 MPa (estimate: 0.55 of the tensile strength)");
  EXPECT_EQ(text_of(*steel_of_grade("ER8")), "ER8, 540 MPa (EN 13262, the least that it requires)");
  EXPECT_EQ(text_of(Steel{512.5, {}}), "512.5 MPa");
  EXPECT_EQ(text_of(Steel{}), "elastic");
  EXPECT_EQ(steel_of_grade("r260")->yield_stress, 480.0);
  EXPECT_FALSE(steel_of_grade("R261"));
}

TEST(Steel, ShearYieldFollowsFromIt) {
  EXPECT_DOUBLE_EQ(shear_yield_of(Steel{520.0, {}}), 520.0 / std::sqrt(3.0));
  EXPECT_EQ(shear_yield_of(Steel{}), 300.0);
}

TEST(Steel, BodiesCountByTheirPartOfTheCompliance) {
  const Material steel{210e3, 0.3};
  const Material soft{70e3, 0.3};
  EXPECT_TRUE(yielding_bodies(steel, {}, steel, {}).empty());
  const auto alike = yielding_bodies(steel, {{500.0}, {}}, soft, {{500.0}, {}});
  ASSERT_EQ(alike.size(), 1u);
  EXPECT_EQ(alike[0].share, 1.0);
  EXPECT_NEAR(alike[0].of_wheel, 0.25, 1e-15); // the softer rail takes more of the groove
  const auto rail = yielding_bodies(steel, {}, soft, {{300.0}, {}});
  ASSERT_EQ(rail.size(), 1u);
  EXPECT_NEAR(rail[0].share, 0.75, 1e-15);
  const auto both = yielding_bodies(steel, {{400.0}, {}}, steel, {{500.0}, {}});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].share + both[1].share, 1.0);
  EXPECT_EQ(both[0].of_wheel, 1.0);
  EXPECT_EQ(both[1].of_wheel, 0.0);
  EXPECT_EQ(onset_of_yield(both), 1.44 * 400.0);
  EXPECT_TRUE(std::isinf(onset_of_yield({})));
}

TEST(Steel, TheExcessIsSmoothAndZeroBelowItsOnset) {
  constexpr double stress = 500.0;
  EXPECT_EQ(excess_of(yield_onset * stress, stress).value, 0.0);
  EXPECT_EQ(excess_of(yield_onset * stress, stress).slope, 0.0);
  for (const double pressure : {730.0, 900.0, 1500.0, 5000.0}) {
    const double step = 1e-4 * pressure;
    const Excess before = excess_of(pressure - step, stress);
    const Excess here = excess_of(pressure, stress);
    const Excess after = excess_of(pressure + step, stress);
    EXPECT_NEAR(here.slope, (after.value - before.value) / (2.0 * step), 1e-4 * here.slope);
    EXPECT_NEAR(here.curvature, (after.slope - before.slope) / (2.0 * step), 1e-4 * here.curvature);
  }
  EXPECT_NEAR(excess_of(3.44 * stress, stress).value, stress * std::pow(2.0, yield_exponent), 1e-9);
}

TEST(Steel, PressedAgainTakesOnlyWhatIsMore) {
  constexpr double stress = 500.0;
  constexpr double carried = 1100.0;
  for (const double pressure : {500.0, 900.0, 1300.0}) { // carried below the onset: the same bits
    EXPECT_EQ(excess_of(pressure, stress, 700.0).value, excess_of(pressure, stress).value);
    EXPECT_EQ(excess_of(pressure, stress, 700.0).slope, excess_of(pressure, stress).slope);
  }
  EXPECT_EQ(excess_of(carried, stress, carried).value, 0.0);
  EXPECT_EQ(excess_of(carried, stress, carried).slope, 0.0);
  const double before = excess_of(carried, stress).value;
  for (const double pressure : {1101.0, 1102.0, 1110.0, 1200.0, 2000.0}) {
    constexpr double step = 0.01;
    const Excess under = excess_of(pressure - step, stress, carried);
    const Excess here = excess_of(pressure, stress, carried);
    const Excess over = excess_of(pressure + step, stress, carried);
    EXPECT_NEAR(here.slope, (over.value - under.value) / (2.0 * step), 1e-3 * here.slope);
    EXPECT_NEAR(here.curvature, (over.slope - under.slope) / (2.0 * step), 1e-3 * here.curvature);
    const double more = excess_of(pressure, stress).value - before;
    EXPECT_LE(here.value, more);
    EXPECT_GE(here.value, more - 0.5 * yield_again_range * before);
  }
}

TEST(Steel, TheEstimateGrowsFromTheOnsetAndSaturates) {
  EXPECT_EQ(yielded_estimate(700.0, 500.0), 700.0);
  EXPECT_LT(yielded_estimate(1000.0, 500.0), 1000.0);
  EXPECT_NEAR(yielded_estimate(1e5, 500.0), (1.44 + 1.22) * 500.0, 1e-6);
}

} // namespace
} // namespace wrc::test::steel_test
