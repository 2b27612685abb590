/// The table of equivalent conicities that wrc_sweep writes for wheels of simple shapes.
#include <cmath>

#include "run_driver.hpp"
#include "support/csv_table.hpp"

namespace conicity_table_test {
namespace {

class ConicityTable : public Driver {
protected:
  ConicityTable() : Driver(WRC_SWEEP_PROGRAM) {}
  /// Of a wheel in wheel.dat.
  [[nodiscard]] driver::CsvTable table_of(const std::string& rail, const std::string& lateral) {
    write("s.toml", rail +
                        "[wheelset]\nwheel = \"wheel.dat; origin = tape\"\n[pose]\n"
                        "roll = \"en15302\"\nlateral = " +
                        lateral +
                        "\n[load]\nboth = 0\n[study]\nresults = "
                        "[\"rolling_radius_difference\", \"left.rigid_contact.angle\", "
                        "\"right.rigid_contact.angle\"]\n[[picture]]\nkind = \"conicity\"\n"
                        "file = \"c.png\"\n");
    const Outcome outcome = run("s.toml --out o");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_TRUE(is_png("o/c.png"));
    return driver::CsvTable(folder() / "o/c_by_amplitude.csv");
  }
};

constexpr std::size_t amplitudes = 47; // 0.5 to 12 mm

TEST_F(ConicityTable, OfAConeHasItsSlope) {
  NEEDS_GNUPLOT();
  std::string wheel;
  for (int s = -60; s <= 60; ++s) { // heights towards larger radius: 1 in 20
    wheel += std::to_string(s) + ' ' + std::to_string(-0.05 * s) + '\n';
  }
  write("wheel.dat", wheel);
  const auto table = table_of("", "{from = -6, to = 6, step = 0.5}");
  ASSERT_EQ(table.row_count(), amplitudes);
  const auto amplitude = table.numbers("amplitude");
  const auto conicity = table.numbers("equivalent_conicity");
  const auto message = table.texts("message");
  constexpr double search = 1e-5; // of contact points
  for (std::size_t i = 0; i < amplitudes; ++i) {
    if (amplitude[i] <= 6.0) {
      EXPECT_NEAR(conicity[i], 0.05, search) << amplitude[i];
      EXPECT_EQ(message[i], "");
    } else {
      EXPECT_TRUE(std::isnan(conicity[i]));
      EXPECT_EQ(message[i], "the rolling radius difference is not known beyond y = 6 mm");
    }
  }
}

TEST_F(ConicityTable, IsWrittenWithoutItsPicture) {
  write("s.toml", "[pose]\nroll = \"en15302\"\nlateral = {from = -4, to = 4, step = 1}\n"
                  "[solve]\nuntil = \"geometry\"\n[study]\nresults = "
                  "[\"rolling_radius_difference\", \"left.rigid_contact.angle\", "
                  "\"right.rigid_contact.angle\"]\n[[picture]]\nkind = \"conicity\"\n"
                  "file = \"c.png\"\n[[picture]]\nkind = \"lines\"\nfile = \"l.png\"\n"
                  "x = \"pose.lateral\"\n"
                  "panels = [{lines = [{result = \"rolling_radius_difference\"}]}]\n");
  const Outcome outcome = run("s.toml --out o --no-pictures");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("conicity"), std::string::npos) << outcome.out;
  EXPECT_EQ(driver::CsvTable(folder() / "o/c_by_amplitude.csv").row_count(), amplitudes);
  EXPECT_FALSE(std::filesystem::exists(folder() / "o/c.png"));
  EXPECT_FALSE(std::filesystem::exists(folder() / "o/l.png"));
}

TEST_F(ConicityTable, DoesNotDependOnTheOrderOfPositions) {
  NEEDS_GNUPLOT();
  std::string wheel;
  for (int s = -60; s <= 60; ++s) {
    wheel += std::to_string(s) + ' ' + std::to_string(-0.05 * s) + '\n';
  }
  write("wheel.dat", wheel);
  constexpr double search = 1e-5; // of contact points
  EXPECT_NEAR(table_of("", "[4, 2, -6, 6, 0, 2, -2]").at("amplitude", 3.0, "equivalent_conicity"),
              0.05, search);
}

/// Where both wheels touch with their cylinders the rolling radius difference is 0 up to rounding.
TEST_F(ConicityTable, OfACylinderIsZeroAndHasAllAmplitudes) {
  NEEDS_GNUPLOT();
  std::string wheel; // a cylinder, towards the flange a cone
  for (int i = -240; i <= 240; ++i) {
    const double s = 0.25 * i;
    const double flange = s < -38.0 ? 28.0 * std::min(1.0, (-38.0 - s) / 14.0) : 0.0;
    wheel +=
        std::to_string(s) + ' ' + std::to_string(0.1 * std::max(-3.0 - s, 0.0) + flange) + '\n';
  }
  std::string rail; // a circle of 60 mm
  for (int i = -470; i <= 470; ++i) {
    const double y = 0.1 * i;
    rail += std::to_string(y) + ' ' + std::to_string(std::sqrt(3600.0 - y * y) - 60.0) + '\n';
  }
  write("wheel.dat", wheel);
  write("rail.dat", rail);
  const auto table = table_of("[track]\nrail = \"rail.dat\"\ninclination = 0.0\n",
                              "{from = -12.0, to = 12.0, step = 0.05}");
  ASSERT_EQ(table.row_count(), amplitudes);
  const auto amplitude = table.numbers("amplitude");
  const auto conicity = table.numbers("equivalent_conicity");
  // The tops of the rails are 756.02 mm from the track's axis (14 mm below them the circle is 38.52
  // mm wide), the taping lines 750 mm. A cone of 1 in 10 that begins 3 mm from the taping line
  // touches the circle where that is 0.298 mm deep, once its wheel is displaced by 6.03 mm.
  for (std::size_t i = 0; i < amplitudes; ++i) {
    if (amplitude[i] <= 6.0) {
      EXPECT_EQ(conicity[i], 0.0) << amplitude[i];
    } else {
      EXPECT_GT(conicity[i], 0.0) << amplitude[i];
      EXPECT_LT(conicity[i], 2.0) << amplitude[i];
    }
    if (amplitude[i] > 6.0 && amplitude[i] <= 10.0) {
      EXPECT_GT(conicity[i], conicity[i - 1]) << amplitude[i];
    }
  }
}

} // namespace
} // namespace conicity_table_test
