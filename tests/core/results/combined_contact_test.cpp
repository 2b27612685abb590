#include "results/combined_contact.hpp"

#include <cmath>
#include <memory>
#include <numeric>

#include <gtest/gtest.h>

#include "support/simple_profiles.hpp"

namespace wrc::test::combined_contact_test {
namespace {

constexpr double rounding = 1e-12;
constexpr double axis = 717.5 + 35.0; // of the rail

/// Uniform pressure on 8 x 6 elements of half a millimetre, `lateral` beside the rail's axis.
PatchResult part_at(double lateral, double pressure) {
  PatchResult part;
  part.frame.origin = {0.0, axis + lateral, 0.0};
  part.penetration.mean_y = axis + lateral;
  part.penetration.weight = 0.5;
  part.grid = {8, 6, 0.5, 0.5, -1.75, -1.25};
  part.pressure.assign(48, pressure);
  part.normal_force = 48.0 * 0.25 * pressure;
  part.contact.normal_force = part.normal_force;
  part.contact.peak_pressure = pressure;
  part.contact.semi_axis_lateral = 2.0;
  part.contact.semi_axis_longitudinal = 1.5;
  part.approach = 1e-4 * pressure;
  return part;
}

class CombinedContact : public testing::Test {
protected:
  const RailSurface rail{circular_rail(300.0), {1435.0, 14.0, 0.0}};
  [[nodiscard]] PatchResult whole_of(std::vector<PatchResult> parts) const {
    const std::vector<Patch> patches(parts.begin(), parts.end());
    PatchResult whole;
    static_cast<Patch&>(whole) = combined(patches, rail);
    whole.parts = std::move(parts);
    return whole;
  }
};

TEST_F(CombinedContact, AddsForcesAndTheirMoments) {
  const PatchResult whole = whole_of({part_at(-3.0, 300.0), part_at(3.0, 100.0)});
  EXPECT_NEAR(whole.normal_force, 12.0 * 400.0, rounding * whole.normal_force);
  EXPECT_EQ(whole.contact.peak_pressure, 300.0);
  EXPECT_DOUBLE_EQ(whole.approach, 0.03);
  EXPECT_NEAR(whole.frame.origin.y, axis, rounding * axis); // weights, not forces
  EXPECT_NEAR(whole.frame.origin.z, 0.0, rounding * axis);
  EXPECT_NEAR(whole.contact.centroid_lateral, -1.5, 1e-9);
  EXPECT_NEAR(whole.contact.semi_axis_longitudinal, 1.5, 1e-9);
  // <y^2> = a^2/5 + 3/4 x 1.5^2 + 1/4 x 4.5^2 about the centre of pressure.
  EXPECT_NEAR(whole.contact.semi_axis_lateral, std::sqrt(4.0 + 5.0 * 6.75), 1e-9);
}

TEST_F(CombinedContact, TheGridSpansAllPartsAndKeepsTheForce) {
  // A tenth of an element off the grid of the first.
  const PatchResult whole = whole_of({part_at(-3.0, 300.0), part_at(3.05, 100.0)});
  const Grid& grid = whole.grid;
  EXPECT_EQ(grid.lateral_step, 0.5);
  EXPECT_EQ(grid.lateral_count, 21u); // -5 to 5.05 about the axis
  EXPECT_EQ(grid.longitudinal_count, 6u);
  const auto pressure = combined_pressure(whole);
  EXPECT_NEAR(std::accumulate(pressure.begin(), pressure.end(), 0.0) * grid.element_area(),
              whole.normal_force, 1e-9 * whole.normal_force);
  EXPECT_NEAR(pressure[0], 300.0, 1e-9);
  EXPECT_NEAR(pressure[20 * 6], 10.0, 1e-6); // a tenth of the last row is under pressure
}

/// 16 times as many elements as all parts have, and what rounding up to whole ones adds.
TEST_F(CombinedContact, TheGridIsCoarserForDistantParts) {
  const PatchResult whole = whole_of({part_at(-30.0, 300.0), part_at(30.0, 100.0)});
  const double finest = 64.0 * 3.0 / 0.25;
  EXPECT_LT(finest, 16.0 * 96.0);
  PatchResult tiny = part_at(30.0, 100.0);
  tiny.grid = {2, 2, 0.01, 0.01, -0.005, -0.005};
  tiny.pressure.assign(4, 1e4);
  tiny.contact.peak_pressure = 1e4;
  const Grid grid = whole_of({tiny, part_at(-30.0, 300.0)}).grid;
  EXPECT_EQ(whole.grid.lateral_step, 0.5);
  EXPECT_GT(grid.lateral_step, 0.02);
  EXPECT_LT(static_cast<double>(grid.element_count()), 1.4 * 16.0 * 52.0);
  EXPECT_GT(static_cast<double>(grid.element_count()), 0.8 * 16.0 * 52.0);
}

/// What a part displaces beside another counts by the weight of their interaction.
TEST_F(CombinedContact, DisplacementsEqualThoseOfTheParts) {
  PatchResult whole = whole_of({part_at(-3.0, 300.0), part_at(3.0, 100.0)});
  WheelDetails details;
  details.request.combined_modulus = 1e5;
  const auto displaced = [&](double weight) {
    whole.parts[0].coupling_weight = whole.parts[1].coupling_weight = weight;
    return combined_displacement(whole, details);
  };
  const auto alone = displaced(0.0);
  const auto half = displaced(0.5);
  const auto full = displaced(1.0);
  // Near the middle of the second part: the first, 3600 N, is 6 mm away.
  const std::size_t middle = 16 * 6 + 3;
  const double other = 3600.0 / (std::acos(-1.0) * 1e5 * 6.0);
  EXPECT_NEAR(full[middle] - alone[middle], other, 0.1 * other);
  EXPECT_NEAR(half[middle] - alone[middle], 0.5 * (full[middle] - alone[middle]), rounding);
}

} // namespace
} // namespace wrc::test::combined_contact_test
