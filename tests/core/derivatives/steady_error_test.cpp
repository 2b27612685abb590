/// The law for the error of steady creep forces, against converged transient rolling.
#include "derivatives/steady_error.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wrc {
namespace {

TEST(SteadyError, GrowsWithTheChangeOverAContactUpToALimit) {
  EXPECT_EQ(steady_error(10.0, 0.0, 0.0, 24e3), 0.0);
  EXPECT_DOUBLE_EQ(steady_error(10.0, 24.0, 0.0, 24e3), 7e-3);
  EXPECT_DOUBLE_EQ(steady_error(20.0, 24.0, 0.0, 24e3), 14e-3);
  EXPECT_DOUBLE_EQ(steady_error(10.0, 2400.0, 0.0, 24e3), 0.12);
  EXPECT_DOUBLE_EQ(steady_error(10.0, 2400.0, 2400.0, 24e3), 0.7) << "creepages may change it more";
  EXPECT_EQ(steady_error(10.0, 2.4e9, 2.4e9, 24e3), 2.0) << "forces are between -mu N and mu N";
  EXPECT_EQ(steady_error(10.0, 24.0, 24.0, 0.0), 0.0) << "without friction no force remembers";
}

/// The load varies by 30 % over waves of two to eight contact lengths.
TEST(SteadyError, CoversTheDifferenceToConvergedTransientRolling) {
  std::ifstream file(WRCONTACT_REFERENCE_DIR "/transient_converged.json");
  const auto cases = nlohmann::json::parse(file).at("cases");
  ASSERT_EQ(cases.size(), 5U);
  constexpr double contact_length = 10.0;
  for (const auto& one : cases) {
    SCOPED_TRACE(one.at("id"));
    const auto column = [&one](const char* name) {
      return one.at(name).get<std::vector<double>>();
    };
    const auto position = column("position_mm");
    const auto x = column("Fx_over_muN0");
    const auto y = column("Fy_over_muN0");
    const auto steady_x = column("steady_Fx");
    const auto steady_y = column("steady_Fy");
    double error = 0.0;
    double told = 0.0;
    for (std::size_t i = 1; i < position.size(); ++i) {
      error = std::max(error, std::hypot(steady_x[i] - x[i], steady_y[i] - y[i]));
      const double change =
          std::hypot(steady_x[i] - steady_x[i - 1], steady_y[i] - steady_y[i - 1]);
      told = std::max(
          told, steady_error(contact_length, change / (position[i] - position[i - 1]), 0.0, 1.0));
    }
    EXPECT_GE(told, error);
    EXPECT_LE(told, 4.0 * error);
    EXPECT_GT(error, 0.02) << "so the cases are some that need it";
  }
}

} // namespace
} // namespace wrc
