// Stresses below the surface against closed forms of Hertz contact, against quadrature of point
// forces and against an independent program.
#include "damage/subsurface_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "support/reference_data.hpp"

namespace subsurface_stress_test {
namespace {

using namespace wrc;

struct Loads {
  Grid grid;
  std::vector<double> pressure, traction_x, traction_y;
  [[nodiscard]] SurfaceLoads surface() const { return {grid, pressure, traction_x, traction_y}; }
};

/// p = sqrt(1 - (x/a)^2 - (y/b)^2) at the centres, q = shares of it.
Loads hertz(double a, double b, std::size_t columns, std::size_t rows, double share_x = 0.0,
            double share_y = 0.0) {
  Loads loads;
  loads.grid = {rows,
                columns,
                2.0 * b / static_cast<double>(rows),
                2.0 * a / static_cast<double>(columns),
                -b + b / static_cast<double>(rows),
                -a + a / static_cast<double>(columns)};
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const double x = loads.grid.longitudinal(j) / a;
      const double y = loads.grid.lateral(i) / b;
      const double p = std::sqrt(std::max(1.0 - x * x - y * y, 0.0));
      loads.pressure.push_back(p);
      if (share_x != 0.0 || share_y != 0.0) {
        loads.traction_x.push_back(share_x * p);
        loads.traction_y.push_back(share_y * p);
      }
    }
  }
  return loads;
}

/// Stresses of point forces on the surface (Johnson, Contact Mechanics, 1985, eqs. 3.21 and 3.76).
Stress boussinesq(double x, double y, double z, double nu) {
  const double r2 = x * x + y * y;
  const double rho = std::sqrt(r2 + z * z);
  const double rho3 = rho * rho * rho;
  const double rho5 = rho3 * rho * rho;
  const double c = (1.0 - 2.0 * nu) / r2;
  const double turn = (1.0 - z / rho) / r2;
  const double scale = 0.5 / std::numbers::pi;
  return {scale * (c * (turn * (x * x - y * y) + z * y * y / rho3) - 3.0 * z * x * x / rho5),
          scale * (c * (turn * (y * y - x * x) + z * x * x / rho3) - 3.0 * z * y * y / rho5),
          -scale * 3.0 * z * z * z / rho5,
          scale * (c * (turn * x * y - x * y * z / rho3) - 3.0 * x * y * z / rho5) +
              scale * c * turn * x * y,
          -scale * 3.0 * x * z * z / rho5,
          -scale * 3.0 * y * z * z / rho5};
}

Stress cerruti(double x, double y, double z, double nu) {
  const double rho = std::sqrt(x * x + y * y + z * z);
  const double rho3 = rho * rho * rho;
  const double rho5 = rho3 * rho * rho;
  const double s = rho + z;
  const double c = 1.0 - 2.0 * nu;
  const double scale = 0.5 / std::numbers::pi;
  const auto bracket = [&](double first, double second, double product) {
    return c * (first + second / (rho * s * s) + product / (rho3 * s * s) +
                2.0 * product / (rho * rho * s * s * s));
  };
  return {scale * (-3.0 * x * x * x / rho5 + bracket(x / rho3, -3.0 * x, x * x * x)),
          scale * (-3.0 * x * y * y / rho5 + bracket(x / rho3, -x, x * y * y)),
          -scale * 3.0 * x * z * z / rho5,
          scale * (-3.0 * x * x * y / rho5 + bracket(0.0, -y, x * x * y)),
          -scale * 3.0 * x * x * z / rho5,
          -scale * 3.0 * x * y * z / rho5};
}

Stress exchanged(const Stress& s) {
  return {s[yy], s[xx], s[zz], s[xy], s[yz], s[xz]};
}

/// Under p = sqrt(1 - r^2) on an ellipse by midpoints in polar coordinates, r = sin t, which take
/// the edge well.
Stress by_quadrature(double a, double b, double share_x, double share_y, double x, double y,
                     double z, double nu) {
  constexpr int rings = 160;
  constexpr int angles = 240;
  Stress sum{};
  for (int i = 0; i < rings; ++i) {
    const double t = 0.5 * std::numbers::pi * (i + 0.5) / rings;
    for (int j = 0; j < angles; ++j) {
      const double angle = 2.0 * std::numbers::pi * (j + 0.5) / angles;
      const double weight = a * b * std::cos(t) * std::sin(t) * std::cos(t) *
                            (0.5 * std::numbers::pi / rings) * (2.0 * std::numbers::pi / angles);
      const double dx = x - a * std::sin(t) * std::cos(angle);
      const double dy = y - b * std::sin(t) * std::sin(angle);
      const Stress p = boussinesq(dx, dy, z, nu);
      const Stress qx = cerruti(dx, dy, z, nu);
      const Stress qy = exchanged(cerruti(dy, dx, z, nu));
      for (std::size_t c = 0; c < 6; ++c) {
        sum[c] += weight * (p[c] + share_x * qx[c] + share_y * qy[c]);
      }
    }
  }
  return sum;
}

constexpr double axis_tolerance = 1e-3;       // of p0: the end condition of the module
constexpr double quadrature_tolerance = 2e-3; // of p0: likewise
constexpr double program_tolerance = 1e-6;    // of p0: values with nine digits
constexpr double search_tolerance = 5e-3;     // of p0: the end condition of the module

TEST(SubsurfaceStress, OnTheAxisOfACircle) {
  for (const double nu : {0.28, 0.3}) {
    const Loads loads = hertz(1.0, 1.0, 96, 96);
    const SubsurfaceStress stress(loads.surface(), nu);
    double greatest = 0.0;
    double shear = 0.0;
    double shear_depth = 0.0;
    for (double z = 0.02; z < 3.0; z += 0.02) {
      const Stress s = stress.at(0.0, 0.0, z);
      const double zz_exact = -1.0 / (1.0 + z * z);
      const double rr_exact = -(1.0 + nu) * (1.0 - z * std::atan(1.0 / z)) + 0.5 / (1.0 + z * z);
      EXPECT_NEAR(s[zz], zz_exact, axis_tolerance);
      EXPECT_NEAR(s[xx], rr_exact, axis_tolerance);
      EXPECT_NEAR(s[yy], rr_exact, axis_tolerance);
      EXPECT_NEAR(von_mises(s), std::abs(rr_exact - zz_exact), axis_tolerance);
      greatest = std::max(greatest, von_mises(s));
      if (greatest_shear(s) > shear) {
        shear = greatest_shear(s);
        shear_depth = z;
      }
    }
    if (nu == 0.28) {
      EXPECT_NEAR(greatest, 0.6293, axis_tolerance);
    } else {
      EXPECT_NEAR(shear, 0.310, 2.0 * axis_tolerance); // Johnson 1985, 3.4: 0.31 p0 at 0.48 a
      EXPECT_NEAR(shear_depth, 0.48, 0.02);
    }
  }
}

TEST(SubsurfaceStress, OnTheAxisOfALineContact) {
  // Elements 40 times as long as the contact is wide stand for infinite ones.
  const double nu = 0.3;
  Loads loads = hertz(1.0, 1.0, 96, 1);
  loads.grid.lateral_step = 2000.0;
  const SubsurfaceStress stress(loads.surface(), nu);
  double shear = 0.0;
  double shear_depth = 0.0;
  for (double z = 0.02; z < 3.0; z += 0.02) {
    const Stress s = stress.at(0.0, 0.0, z);
    const double root = std::sqrt(1.0 + z * z);
    const double xx_exact = -((1.0 + 2.0 * z * z) / root - 2.0 * z);
    EXPECT_NEAR(s[xx], xx_exact, axis_tolerance);
    EXPECT_NEAR(s[zz], -1.0 / root, axis_tolerance);
    EXPECT_NEAR(s[yy], nu * (xx_exact - 1.0 / root), axis_tolerance);
    if (greatest_shear(s) > shear) {
      shear = greatest_shear(s);
      shear_depth = z;
    }
  }
  EXPECT_NEAR(shear, 0.300, axis_tolerance); // Johnson 1985, 4.2: 0.30 p0 at 0.78 a
  EXPECT_NEAR(shear_depth, 0.78, 0.02);
}

TEST(SubsurfaceStress, OffTheAxisAgreesWithQuadratureOfPointForces) {
  const double nu = 0.28;
  for (const auto& [a, b] : {std::pair(1.0, 1.0), std::pair(1.0, 2.5)}) {
    const Loads loads = hertz(a, b, 80, 80, 0.3, -0.2);
    const SubsurfaceStress stress(loads.surface(), nu);
    for (const double z : {0.15, 0.5, 1.1}) {
      for (const auto& [x, y] : {std::pair(0.31, 0.23), std::pair(-0.72, 0.4), std::pair(1.2, -0.9),
                                 std::pair(0.05, 1.7)}) {
        const Stress found = stress.at(x, y, z);
        const Stress expected = by_quadrature(a, b, 0.3, -0.2, x, y, z, nu);
        for (std::size_t c = 0; c < 6; ++c) {
          EXPECT_NEAR(found[c], expected[c], quadrature_tolerance)
              << "component " << c << " at " << x << ' ' << y << ' ' << z << " b " << b;
        }
      }
    }
  }
}

TEST(SubsurfaceStress, AgreesWithContact) {
  const nlohmann::json reference = test::reference_data("subsurface_stress.json");
  // x, y, z, xx, yy, zz, xy, yz, zx, von Mises, principal stresses: there yz before zx.
  constexpr std::array<std::size_t, 6> columns{3, 4, 5, 6, 8, 7};
  int count = 0;
  for (const auto& each : reference.at("cases")) {
    ++count;
    const auto& g = each["grid"];
    Loads loads;
    loads.grid = {g["my"], g["mx"], g["dy_mm"], g["dx_mm"], g["y1_mm"], g["x1_mm"]};
    loads.pressure = each["pn"].get<std::vector<double>>();
    loads.traction_x = each["px"].get<std::vector<double>>();
    loads.traction_y = each["py"].get<std::vector<double>>();
    const double p0 = *std::max_element(loads.pressure.begin(), loads.pressure.end());
    const SubsurfaceStress stress(loads.surface(), each["nu"]);
    double worst = 0.0;
    for (const auto& row : each["points"]) {
      const Stress found = stress.at(row[0], row[1], row[2]);
      for (std::size_t c = 0; c < 6; ++c) {
        worst = std::max(worst, std::abs(found[c] - row[columns[c]].get<double>()) / p0);
      }
      worst = std::max(worst, std::abs(von_mises(found) - row[9].get<double>()) / p0);
      const auto principal = principal_stresses(found);
      for (std::size_t k = 0; k < 3; ++k) {
        worst = std::max(worst, std::abs(principal[k] - row[10 + k].get<double>()) / p0);
      }
    }
    EXPECT_LT(worst, program_tolerance) << each["id"];
    RecordProperty(each["id"].get<std::string>(), std::to_string(worst));
    const double listed = each["greatest_von_mises_in_plane_xz_MPa"];
    EXPECT_GT(stress.greatest().von_mises, listed - search_tolerance * p0) << each["id"];
  }
  EXPECT_GE(count, 2);
}

/// Depths of which fewer than four are far enough apart for cubics between them.
TEST(SubsurfaceStress, FewDepthsCloseTogetherAreAllComputed) {
  const Loads loads = hertz(1.0, 0.6, 24, 16);
  const SubsurfaceStress stress(loads.surface(), 0.28);
  const double y = loads.grid.lateral(7);
  const std::vector<double> x{-0.5, 0.0, 0.5};
  const std::vector<double> depths{0.0, 1.0, 1.01, 1.02};
  const StressSection section = stress.along(x, y, depths);
  for (std::size_t i = 1; i < depths.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      const Stress exact = stress.at(x[j], y, depths[i]);
      for (std::size_t c = 0; c < 6; ++c) {
        EXPECT_NEAR(section.stresses[i * x.size() + j][c], exact[c], 2e-3) << depths[i];
      }
    }
  }
}

TEST(SubsurfaceStress, CoarserElementsSufficeAtDepth) {
  const Loads loads = hertz(1.0, 0.6, 64, 32, 0.25, 0.1);
  const SubsurfaceStress stress(loads.surface(), 0.28);
  std::vector<double> x;
  std::vector<double> depths;
  for (int i = 0; i < 100; ++i) {
    x.push_back(-1.5 + 0.03 * i);
  }
  for (int i = 0; i < 60; ++i) {
    depths.push_back(0.02 + 0.04 * i);
  }
  const double y = loads.grid.lateral(12);
  const StressSection section = stress.along(x, y, depths);
  ASSERT_EQ(section.stresses.size(), x.size() * depths.size());
  double worst = 0.0;
  double worst_near = 0.0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    double& here = depths[i] > 0.09 ? worst : worst_near; // 1.5 times the larger element
    for (std::size_t j = 0; j < x.size(); ++j) {
      const Stress exact = stress.at(x[j], y, depths[i]);
      for (std::size_t c = 0; c < 6; ++c) {
        here = std::max(here, std::abs(section.stresses[i * x.size() + j][c] - exact[c]));
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("worst_near", std::to_string(worst_near));
  EXPECT_LT(worst, 1e-3);     // depth_of_element
  EXPECT_LT(worst_near, 0.1); // between the centres of elements at the contact's edge
}

TEST(SubsurfaceStress, SectionsAcrossAreSectionsAlongWithAxesExchanged) {
  const Loads loads = hertz(1.0, 0.6, 24, 20, 0.25, 0.1);
  const SubsurfaceStress stress(loads.surface(), 0.28);
  const std::vector<double> y{-0.5, -0.3, -0.1, 0.1, 0.3, 0.5};
  const std::vector<double> depths{0.3, 0.8};
  const StressSection section = stress.across(y, 0.13, depths);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      const Stress exact = stress.at(0.13, y[j], depths[i]);
      for (std::size_t c = 0; c < 6; ++c) {
        EXPECT_NEAR(section.stresses[i * y.size() + j][c], exact[c], 1e-3);
      }
    }
  }
}

TEST(SubsurfaceStress, FindsTheGreatestVonMisesStress) {
  // Circle without friction, on the axis; line of lobes; high friction, on the surface.
  const Loads circle = hertz(1.0, 1.0, 64, 64);
  const GreatestStress found = SubsurfaceStress(circle.surface(), 0.28).greatest();
  EXPECT_NEAR(found.von_mises, 0.6293, 1e-3);
  EXPECT_NEAR(found.depth, 0.48, 0.03);
  EXPECT_NEAR(found.x, 0.0, 0.05);
  EXPECT_NEAR(found.y, 0.0, 0.05);
  const Loads ellipse = hertz(1.0, 3.0, 64, 32, 0.2, -0.1);
  const Loads rough = hertz(1.0, 3.0, 64, 32, 0.6, 0.0);
  for (const Loads* loads : {&ellipse, &rough}) {
    const SubsurfaceStress stress(loads->surface(), 0.28);
    const GreatestStress here = stress.greatest();
    double greatest = 0.0;
    for (const double depth : {0.0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}) {
      for (std::size_t i = 0; i < 32; i += 2) {
        for (std::size_t j = 0; j < 64; ++j) {
          greatest = std::max(greatest, von_mises(stress.at(loads->grid.longitudinal(j),
                                                            loads->grid.lateral(i), depth)));
        }
      }
    }
    // On the surface two tops of nearly the same height compete, one of them at the edge.
    EXPECT_GT(here.von_mises, (here.depth > 0.0 ? 0.998 : 0.985) * greatest);
    EXPECT_LT(here.von_mises, 1.02 * greatest);
    EXPECT_NEAR(here.von_mises, von_mises(stress.at(here.x, here.y, here.depth)), 2e-3);
  }
}

TEST(SubsurfaceStress, FindsTheStressBelowANarrowStrip) {
  // A wide contact, and on it a strip that coarse elements do not show.
  Loads loads = hertz(1.0, 1.0, 64, 128);
  for (std::size_t i = 0; i < loads.pressure.size(); ++i) {
    const double y = (loads.grid.lateral(i / 64) - 0.41) / 0.05;
    loads.pressure[i] =
        0.3 * loads.pressure[i] + loads.pressure[i] * std::sqrt(std::max(1.0 - y * y, 0.0));
  }
  const SubsurfaceStress stress(loads.surface(), 0.3);
  double greatest = 0.0;
  for (double z = 0.01; z < 0.6; z += 0.01) {
    greatest = std::max(greatest, von_mises(stress.at(loads.grid.longitudinal(32), 0.41, z)));
  }
  EXPECT_GT(stress.greatest().von_mises, 0.99 * greatest);
}

// Depths of the search are those of the contact's width, however long the elements.
TEST(SubsurfaceStress, FindsTheStressBelowElementsFarLongerThanWide) {
  const Loads loads = hertz(12.0, 1.0, 6, 12);
  const SubsurfaceStress stress(loads.surface(), 0.3);
  const double found = stress.greatest().von_mises;
  double greatest = 0.0;
  for (double z = 0.1; z < 1.5; z += 0.05) {
    greatest = std::max(greatest, von_mises(stress.at(loads.grid.longitudinal(2), 0.0, z)));
  }
  EXPECT_NEAR(found, greatest, 0.01 * greatest);
}

// The search looks at some places only along so slender a contact; on either axis it finds the
// middle.
TEST(SubsurfaceStress, FindsTheStressBelowAVerySlenderContact) {
  for (const bool is_along : {true, false}) {
    const Loads loads = is_along ? hertz(200.0, 1.0, 3001, 10) : hertz(1.0, 200.0, 10, 3001);
    const SubsurfaceStress stress(loads.surface(), 0.3);
    double greatest = 0.0;
    for (double z = 0.5; z < 0.9; z += 0.02) {
      greatest = std::max(greatest, von_mises(stress.at(0.0, 0.0, z)));
    }
    const GreatestStress found = stress.greatest();
    EXPECT_NEAR(found.von_mises, greatest, 5e-3 * greatest) << is_along;
    EXPECT_LT(std::abs(is_along ? found.x : found.y), 5.0) << is_along;
    EXPECT_LT(std::abs(is_along ? found.y : found.x), 0.2) << is_along;
  }
}

TEST(SubsurfaceStress, PrincipalStressesAreRootsOfTheCharacteristicPolynomial) {
  const Stress s{-300.0, 120.0, -800.0, 90.0, -60.0, 210.0};
  const auto principal = principal_stresses(s);
  EXPECT_GE(principal[0], principal[1]);
  EXPECT_GE(principal[1], principal[2]);
  EXPECT_NEAR(principal[0] + principal[1] + principal[2], s[xx] + s[yy] + s[zz], 1e-9);
  for (const double root : principal) {
    const double a = s[xx] - root;
    const double b = s[yy] - root;
    const double c = s[zz] - root;
    EXPECT_NEAR(a * (b * c - s[yz] * s[yz]) - s[xy] * (s[xy] * c - s[yz] * s[xz]) +
                    s[xz] * (s[xy] * s[yz] - b * s[xz]),
                0.0, 1e-3);
  }
  EXPECT_DOUBLE_EQ(greatest_shear(s), 0.5 * (principal[0] - principal[2]));
  EXPECT_DOUBLE_EQ(von_mises({-5.0, -5.0, -5.0, 0.0, 0.0, 0.0}), 0.0);
}

} // namespace
} // namespace subsurface_stress_test
