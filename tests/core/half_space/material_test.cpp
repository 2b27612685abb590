/// Combined modulus: printed formula and refused constants.
#include "half_space/material.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/errors.hpp"

namespace wrc::test::material_test {
namespace {

TEST(Material, CombinesBothBodies) {
  // Like bodies: E/(2 (1 - nu^2)).
  EXPECT_DOUBLE_EQ(combined_modulus({210000.0, 0.3}, {210000.0, 0.3}), 210000.0 / 1.82);
  const double expected = 1.0 / ((1.0 - 0.0625) / 100.0 + (1.0 - 0.25) / 300.0);
  EXPECT_DOUBLE_EQ(combined_modulus({100.0, 0.25}, {300.0, 0.5}), expected);
  EXPECT_DOUBLE_EQ(combined_modulus({300.0, 0.5}, {100.0, 0.25}), expected);
}

TEST(Material, RefusesConstantsOutsideTheirRange) {
  const Material steel{210000.0, 0.3};
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double modulus : {0.0, -1.0, infinity, std::nan("")}) {
    EXPECT_THROW(combined_modulus({modulus, 0.3}, steel), Error);
    EXPECT_THROW(combined_modulus(steel, {modulus, 0.3}), Error);
  }
  for (const double poisson : {-0.01, 0.51, std::nan("")}) {
    EXPECT_THROW(combined_modulus({210000.0, poisson}, steel), Error);
    EXPECT_THROW(combined_modulus(steel, {210000.0, poisson}), Error);
  }
  test::expect_error(
      ErrorCode::invalid_argument,
      [&] {
        combined_modulus(steel, {210000.0, 0.6});
      },
      "rail.poisson = 0.6: must be between 0 and 0.5");
}

TEST(Material, ADifferenceWithoutEffectCountsAsNone) {
  for (const double sign : {1.0, -1.0}) {
    const auto counts = [sign](double difference, double friction, double accuracy) {
      const double effective = effective_difference(sign * difference, friction, accuracy);
      EXPECT_TRUE(effective == 0.0 || effective == sign * difference);
      return effective != 0.0;
    };
    // A thousandth of the accuracy, times friction.
    EXPECT_FALSE(counts(2.9e-6, 0.3, 1e-2));
    EXPECT_TRUE(counts(3.1e-6, 0.3, 1e-2));
    EXPECT_FALSE(counts(2.9e-7, 0.3, 1e-3));
    EXPECT_TRUE(counts(3.1e-7, 0.3, 1e-3));
    // Above a friction of 1 that of pressures is larger.
    EXPECT_FALSE(counts(1.9e-6, 5.0, 1e-2));
    EXPECT_TRUE(counts(2.1e-6, 5.0, 1e-2));
    // Rounding of the constants, whatever the friction.
    for (const double friction : {0.0, 1e-12, 0.3}) {
      EXPECT_FALSE(counts(5e-16, friction, 1e-6)) << friction;
      EXPECT_TRUE(counts(1e-2, friction, 1e-6)) << friction;
    }
  }
  const ShearConstants rounded = shear_constants({210000.0, 0.1 + 0.2}, {210000.0, 0.3});
  EXPECT_NE(rounded.difference_parameter, 0.0);
  EXPECT_EQ(effective_difference(rounded.difference_parameter, 1e-9, 1e-9), 0.0);
}

} // namespace
} // namespace wrc::test::material_test
