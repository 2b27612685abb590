#include "models/elliptic_integrals.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace wrc::test::elliptic_integrals_test {
namespace {

/// A mean of 1 and 0, or of no number, once had no end.
TEST(EllipticIntegrals, EndForContactsWithoutWidth) {
  for (const double modulus : {0.0, 5e-324, std::numeric_limits<double>::quiet_NaN()}) {
    const EllipticIntegrals found = elliptic_integrals(modulus);
    EXPECT_TRUE(std::isfinite(found.k));
    // K(e) = ln(4/k) for slender ellipses (Abramowitz & Stegun, 17.3.26).
    EXPECT_NEAR(found.k, std::log(4.0) - std::log(std::numeric_limits<double>::min()), 1e-9);
  }
}

} // namespace
} // namespace wrc::test::elliptic_integrals_test
