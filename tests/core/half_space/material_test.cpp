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
      "rail.poisson = 0.6: must lie in 0 to 0.5");
}

} // namespace
} // namespace wrc::test::material_test
