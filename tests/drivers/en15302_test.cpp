/// Equivalent conicity of the reference profiles of EN 15302: its wheels A, B, C, H and I on its
/// rail A, as wrc_sweep computes them from profiles in files, against the results the standard
/// gives.
///
/// Profiles: the equations by zones of annex D of EN 15302:2008+A1:2010 (annex I of EN 15302:2021),
/// z downwards, in mm, as published in github.com/rohrbecka/EN15302 (commit 05de831). Results:
/// annex E of EN 15302:2008+A1:2010, as published in
/// github.com/criogenox/B_ECC-Equivalent-Conicity- Calculation (MIT licence, commits 851670d and
/// f3deb14, data/ben_E1.dat to ben_E9.dat), of wheel C annex K.4 of EN 15302:2021, from the first
/// one. Rows here are a few of those tables.
#include <cmath>
#include <functional>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <vector>

#include "run_driver.hpp"
#include "support/csv_table.hpp"

namespace en15302_test {
namespace {

/// From one lateral position up to that of the next zone: z over y.
struct Zone {
  double begin;
  std::function<double(double)> height;
};

/// A line through z at y = 0.
std::function<double(double)> line(double z, double slope) {
  return [=](double y) { return z + slope * y; };
}
/// An arc about a centre: the side of greater z (1) or smaller (-1).
std::function<double(double)> arc(int side, double centre_y, double centre_z, double radius) {
  return [=](double y) {
    return centre_z + side * std::sqrt(radius * radius - std::pow(y - centre_y, 2));
  };
}

struct ReferenceProfile {
  std::vector<Zone> zones;
  double end;
};

std::map<char, ReferenceProfile> wheels() {
  const double root = std::sqrt(14375.0); // of wheel I
  return {{'A',
           {{{-70.0, arc(1, -49.5, 9.51926, 20.5)},
             {-62.7647, arc(1, -55.0, 16.00065, 12.0)},
             {-49.6625, arc(1, -58.5583, 8.83556, 20.0)},
             {-39.7645, line(-93.57685, -2.7475)},
             {-38.7372, arc(-1, -25.5816, 17.64215, 14.0)},
             {-29.4591, arc(-1, -2.6594, 97.16493, 96.76055)},
             {-10.8749, arc(-1, 18.4173, 344.50806, 345.0)},
             {18.4173, line(-0.49194, 0.0)},
             {30.0, line(1.50804, -0.066666)},
             {60.0, line(57.50808, -1.0)}},
            65.0}},
          {'B',
           {{{-70.0, arc(1, -49.5, 9.5193, 20.5)},
             {-62.7647, arc(1, -55.0, 16.0, 12.0)},
             {-49.6625, arc(1, -58.5583, 8.8349, 20.0)},
             {-39.764, line(-93.5767, -2.7475)},
             {-38.7879, arc(-1, -25.6322, 17.7814, 14.0)},
             {-29.3505, arc(-1, 2.5204, 119.9745, 120.0)},
             {-0.4787, line(0.0, -0.025)},
             {30.0, line(0.75, -0.05)},
             {60.0, line(57.75, -1.0)}},
            65.0}},
          {'C',
           {{{-70.0, line(515.19747, 7.11537)},
             {-69.4027, arc(1, -59.5, 20.00006, 10.0)},
             {-59.5, arc(1, -60.4941, 12.02753, 18.0)},
             {-43.8048, line(-89.65019, -2.47508685)},
             {-41.0534, arc(-1, -29.0, 16.830365, 13.0)},
             {-32.3621, arc(-1, -6.5, 100.870534, 100.0)},
             {-17.587, arc(-1, 19.0, 329.45258, 330.0)},
             {19.0, line(-0.54742374, 0.0)},
             {29.0, line(2.35257626, -0.1)},
             {59.0, line(55.45257626, -1.0)}}, // as the publisher corrected it
            65.0}},
          {'H',
           {{{-70.0, arc(1, -49.5, 9.5193, 20.5)},
             {-62.7647, arc(1, -55.0, 16.0, 12.0)},
             {-49.6625, arc(1, -58.5583, 8.8349, 20.0)},
             {-39.7645, line(-93.5767, -2.7475)},
             {-38.722, arc(-1, -25.5663, 17.6003, 14.0)},
             {-28.3119, line(-1.7902, -0.2)},
             {-10.2297, line(0.0, -0.025)},
             {30.0, line(1.251, -0.0667)},
             {60.0, line(57.249, -1.0)}},
            65.0}},
          {'I',
           {{{-70.0, arc(1, -49.5, 9.51929, 20.5)},
             {-62.7647, arc(1, -55.0, 16.00054, 12.0)},
             {-49.6625, arc(1, -58.5583, 8.83545, 20.0)},
             {-39.764, line(-93.5767, -2.7475)},
             {-39.0486, arc(-1, -25.8929, 18.49733, 14.0)},
             {-29.9231, arc(-1, 5.0, root, 120.0)},
             {5.0, line(root - 120.0, 0.0)}, // a cylinder
             {30.0, line(1.89679, -0.0667)},
             {60.0, line(57.89479, -1.0)}},
            65.0}}};
}

/// Inclined as it lies; the gauge side has negative y.
ReferenceProfile rail() {
  return {{{-32.634, arc(-1, -19.63949, 15.899044, 13.0)},
           {-23.2401, arc(-1, -1.0825, 80.277908, 80.0)},
           {-7.8749, arc(-1, 17.5966, 299.48349, 300.0)},
           {13.0989, arc(-1, 14.29829, 79.508225, 80.0)},
           {28.6709, arc(-1, 26.33535, 13.598369, 13.0)}},
          39.2705};
}

/// Two columns, every 0.1 mm or closer and at the ends of all zones; heights times a sign.
std::string points_of(const ReferenceProfile& profile, double sign) {
  std::ostringstream out;
  out << "y z\n" << std::fixed << std::setprecision(7);
  for (std::size_t i = 0; i < profile.zones.size(); ++i) {
    const Zone& zone = profile.zones[i];
    const bool last = i + 1 == profile.zones.size();
    const double length = (last ? profile.end : profile.zones[i + 1].begin) - zone.begin;
    constexpr double spacing = 0.1;
    const int count = static_cast<int>(std::ceil(length / spacing));
    for (int k = 0; k < (last ? count + 1 : count); ++k) {
      const double y = zone.begin + length * k / count;
      out << y << ' ' << sign * zone.height(y) << '\n';
    }
  }
  return out.str();
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> amplitudes{1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5, 7, 7.5};

struct Case {
  const char* name;
  char right;
  char left;
  double left_radius; ///< that of the right wheel is 460 mm
  std::vector<double> conicity;
};

const std::vector<Case> cases{{"E.1",
                               'A',
                               'A',
                               460.0,
                               {0.125, 0.139, 0.155, 0.171, 0.188, 0.202, 0.216, 0.234, 0.254,
                                0.277, 0.303, 0.348, 0.505, 0.640}},
                              {"E.2",
                               'B',
                               'B',
                               460.0,
                               {0.025, 0.025, 0.025, 0.025, 0.058, 0.189, 0.241, 0.267, 0.283,
                                0.293, 0.302, 0.336, 0.485, 0.627}},
                              {"E.3",
                               'H',
                               'H',
                               460.0,
                               {0.025, 0.025, 0.025, 0.025, 0.245, 0.308, 0.319, 0.315, 0.306,
                                0.295, 0.284, 0.274, 0.437, 0.597}},
                              {"E.4",
                               'I',
                               'I',
                               460.0,
                               {0.000, 0.000, 0.293, 0.458, 0.489, 0.490, 0.485, 0.479, 0.475,
                                0.463, 0.447, 0.431, 0.486, 0.643}},
                              {"E.5",
                               'A',
                               'A',
                               459.0,
                               {0.280, 0.276, 0.272, 0.266, 0.261, 0.262, 0.269, 0.280, 0.307,
                                0.347, 0.395, 0.440, 0.492, 0.623}},
                              {"E.6",
                               'B',
                               'B',
                               459.0,
                               {0.660, 0.472, 0.376, 0.317, 0.278, 0.249, 0.227, 0.213, 0.295,
                                0.357, 0.409, 0.443, 0.478, 0.607}},
                              {"E.7",
                               'H',
                               'H',
                               459.0,
                               {0.712, 0.491, 0.381, 0.314, 0.270, 0.238, 0.217, 0.271, 0.275,
                                0.384, 0.421, 0.437, 0.443, 0.571}},
                              {"E.8",
                               'I',
                               'I',
                               459.0,
                               {0.780, 0.540, 0.418, 0.343, 0.449, 0.475, 0.479, 0.470, 0.458,
                                0.449, 0.497, 0.547, 0.564, 0.608}},
                              {"E.9",
                               'A',
                               'B',
                               460.0,
                               {0.137, 0.117, 0.104, 0.094, 0.132, 0.191, 0.225, 0.250, 0.271,
                                0.290, 0.307, 0.344, 0.493, 0.634}},
                              {"K.4 of 2021",
                               'C',
                               'C',
                               460.0,
                               {0.515, unknown, 0.365, unknown, 0.271, unknown, 0.221, unknown,
                                0.191, unknown, 0.170, unknown, 0.156, unknown}}};

class En15302 : public Driver {
protected:
  En15302() : Driver(WRC_SWEEP_PROGRAM) {}
};

TEST_F(En15302, ReferenceProfilesHaveTheStandardsConicity) {
  NEEDS_GNUPLOT();
  write("rail.dat", points_of(rail(), -1.0));
  for (const auto& [name, profile] : wheels()) {
    write(std::string(1, name) + ".dat", points_of(profile, 1.0));
  }
  for (const Case& reference : cases) {
    SCOPED_TRACE(reference.name);
    std::ostringstream study;
    // 1435.16 in the standard, whose rail profiles are as far apart as the taping lines, 1500 mm:
    // 1435.16452, 14 mm below the top. Wheel H leaves its cone at 2.5007 mm, so that this counts.
    study << "[track]\nrail = \"rail.dat\"\ninclination = 0.0\ngauge = 1435.16452\n[wheelset]\n"
          << "left.wheel = {file = \"" << reference.left
          << ".dat\", origin = \"tape\"}\nright.wheel = \"" << reference.right
          << ".dat; origin = tape\"\nleft.radius = " << std::showpoint << reference.left_radius
          << "\nright.radius = 460.0\n[pose]\nroll = \"en15302\"\n"
          << "lateral = {from = -10.0, to = 10.0, step = 0.1}\n[load]\nboth = 0.0\n[study]\n"
          << "results = [\"rolling_radius_difference\", \"left.rigid_contact.angle\", "
          << "\"right.rigid_contact.angle\"]\n[[picture]]\nkind = \"conicity\"\nfile = \"c.png\"\n";
    write("s.toml", study.str());
    const Outcome outcome = run("s.toml --out o");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const driver::CsvTable table(folder() / "o/c_by_amplitude.csv");
    const std::string parameter = "nonlinearity parameter ";
    const std::size_t at = outcome.out.find(parameter);
    ASSERT_NE(at, std::string::npos) << outcome.out;
    // From the standard's conicities at 4 and 2 mm, each to half of its last digit.
    EXPECT_NEAR(std::stod(outcome.out.substr(at + parameter.size())),
                0.5 * (reference.conicity[6] - reference.conicity[2]), 0.005);
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
      const double expected = reference.conicity[i];
      if (std::isnan(expected)) {
        continue;
      }
      const double conicity = table.at("amplitude", amplitudes[i], "equivalent_conicity");
      // Annex F: 0.05, half of small values, and 0.01 where the conicity is 0.
      const double band = expected > 0.0 ? std::min(0.05, 0.5 * expected) : 0.01;
      EXPECT_NEAR(conicity, expected, band) << amplitudes[i];
      // Three digits, from samples 0.1 mm apart in the standard as here: a tenth of the band and
      // more off would be an error that the band hides.
      constexpr double digits = 0.005;
      EXPECT_NEAR(conicity, expected, digits) << amplitudes[i];
    }
  }
}

} // namespace
} // namespace en15302_test
