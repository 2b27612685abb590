/// Tangential contact of pressures given by the caller: arguments through the C interface, results
/// through that for C++.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include "owned_handles.hpp"
#include "wrcontact.hpp"

namespace rolling_test {
namespace {

using wrcontact::RollingContact;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Sums over a few thousand elements.
constexpr double rounding = 1e-10;

/// A circle of radius 5 mm under 80 kN.
constexpr double radius = 5.0;
constexpr double load = 80000.0;
constexpr double friction = 0.3;

/// Hertz's pressures on n x n elements around the circle.
std::vector<double> circle_pressure(int n) {
  std::vector<double> pressure;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double x = (2 * i + 1.0) / n - 1.0;
      const double y = (2 * j + 1.0) / n - 1.0;
      pressure.push_back(1.5 * load / (std::numbers::pi * radius * radius) *
                         std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
    }
  }
  return pressure;
}

template <class Contact> void prepare(Contact& contact, int n) {
  contact.set_grid(n, n, 2.0 * radius / n, 2.0 * radius / n);
  contact.set_pressure(circle_pressure(n));
  contact.set("longitudinal_creepage", -0.001);
  contact.set("lateral_creepage", -0.0008);
  contact.set("spin_creepage", -0.0004);
}

RollingContact make_circle(int n) {
  RollingContact contact;
  prepare(contact, n);
  return contact;
}

TEST(RollingHandle, EveryFunctionRefusesANullHandle) {
  double value = 0.0;
  std::int64_t count = 0;
  EXPECT_EQ(wrc_rolling_create(nullptr), WRC_INVALID_ARGUMENT);
  wrc_rolling_destroy(nullptr);
  EXPECT_EQ(wrc_rolling_set_grid(nullptr, 2, 2, 1.0, 1.0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_set_pressure(nullptr, &value, 1), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_set_slip(nullptr, &value, &value, 1), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_set_previous(nullptr, &value, &value, 1), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_set_number(nullptr, "tolerance", 1e-3), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_set_text(nullptr, "model", "full"), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_solve(nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_advance(nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_number(nullptr, "residual", &value), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_field(nullptr, "slip_x", &value, 1, &count), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_rolling_error(nullptr), "rolling = NULL"));
}

TEST(RollingHandle, NullArgumentsAreNamed) {
  const RollingContact contact = make_circle(8);
  wrc_rolling* r = contact.handle();
  double value = 0.0;
  std::int64_t count = 0;
  expect_null_told(r, wrc_rolling_set_pressure(r, nullptr, 4), "values");
  expect_null_told(r, wrc_rolling_set_slip(r, nullptr, &value, 1), "slip_x");
  expect_null_told(r, wrc_rolling_set_slip(r, &value, nullptr, 1), "slip_y");
  expect_null_told(r, wrc_rolling_set_previous(r, nullptr, &value, 1), "traction_x");
  expect_null_told(r, wrc_rolling_set_previous(r, &value, nullptr, 1), "traction_y");
  expect_null_told(r, wrc_rolling_set_number(r, nullptr, 1.0), "key");
  expect_null_told(r, wrc_rolling_set_text(r, nullptr, "full"), "key");
  expect_null_told(r, wrc_rolling_set_text(r, "model", nullptr), "value");
  ASSERT_EQ(wrc_rolling_solve(r), WRC_OK);
  expect_null_told(r, wrc_rolling_number(r, nullptr, &value), "name");
  expect_null_told(r, wrc_rolling_number(r, "residual", nullptr), "value");
  expect_null_told(r, wrc_rolling_field(r, nullptr, &value, 1, &count), "name");
  expect_null_told(r, wrc_rolling_field(r, "slip_x", nullptr, 64, &count), "values");
  expect_null_told(r, wrc_rolling_field(r, "slip_x", &value, 1, nullptr), "count");
}

TEST(RollingHandle, ThereAreNoResultsBeforeSolving) {
  const RollingContact contact = make_circle(8);
  wrc_rolling* r = contact.handle();
  double value = 7.0;
  std::int64_t count = 5;
  expect_error(r, wrc_rolling_number(r, "slip_area", &value), WRC_NO_RESULT, "not been solved");
  EXPECT_EQ(wrc_rolling_field(r, "slip_x", nullptr, 0, &count), WRC_NO_RESULT);
  EXPECT_EQ(wrc_rolling_advance(r), WRC_NO_RESULT);
  EXPECT_EQ(value, 7.0);
  EXPECT_EQ(count, 5);
}

TEST(RollingProblem, MissingInputIsNamed) {
  const RollingContact contact;
  wrc_rolling* r = contact.handle();
  const std::vector<double> values(6, 1.0);
  expect_error(r, wrc_rolling_solve(r), WRC_INVALID_ARGUMENT, "wrc_rolling_set_grid");
  ASSERT_EQ(wrc_rolling_set_grid(r, 2, 4, 1.0, 1.0), WRC_OK);
  expect_error(r, wrc_rolling_solve(r), WRC_INVALID_ARGUMENT, "wrc_rolling_set_pressure");
  ASSERT_EQ(wrc_rolling_set_pressure(r, values.data(), 6), WRC_OK);
  expect_error(r, wrc_rolling_solve(r), WRC_INVALID_ARGUMENT, "8 elements");
  ASSERT_EQ(wrc_rolling_set_grid(r, 2, 3, 1.0, 1.0), WRC_OK);
  EXPECT_EQ(wrc_rolling_solve(r), WRC_OK);
  EXPECT_STREQ(wrc_rolling_error(r), "");
  ASSERT_EQ(wrc_rolling_set_slip(r, values.data(), values.data(), 4), WRC_OK);
  expect_error(r, wrc_rolling_solve(r), WRC_INVALID_ARGUMENT, "slip_x.size = 4");
  ASSERT_EQ(wrc_rolling_set_slip(r, nullptr, nullptr, 0), WRC_OK);
  EXPECT_EQ(wrc_rolling_solve(r), WRC_OK);
  // Previous tractions count in steps and shifts only.
  ASSERT_EQ(wrc_rolling_set_previous(r, values.data(), values.data(), 4), WRC_OK);
  EXPECT_EQ(wrc_rolling_solve(r), WRC_OK);
  for (const char* step : {"transient", "shift"}) {
    ASSERT_EQ(wrc_rolling_set_text(r, "contact", step), WRC_OK);
    expect_error(r, wrc_rolling_solve(r), WRC_INVALID_ARGUMENT, "previous_x.size = 4");
  }
  ASSERT_EQ(wrc_rolling_set_previous(r, nullptr, nullptr, 0), WRC_OK);
  EXPECT_EQ(wrc_rolling_solve(r), WRC_OK);
}

TEST(RollingProblem, ValuesOutOfRangeAreRefusedAndChangeNothing) {
  RollingContact plain = make_circle(12);
  RollingContact contact = make_circle(12);
  wrc_rolling* r = contact.handle();
  EXPECT_EQ(wrc_rolling_set_grid(r, 0, 4, 1.0, 1.0), WRC_INVALID_ARGUMENT);
  expect_error(r, wrc_rolling_set_grid(r, 4, -1, 1.0, 1.0), WRC_INVALID_ARGUMENT,
               "longitudinal_count");
  expect_error(r, wrc_rolling_set_grid(r, 4, 4, nan, 1.0), WRC_INVALID_ARGUMENT, "lateral_step");
  for (const double wrong : {-1.0, 1.1e30, nan, infinity}) {
    const std::vector<double> values{1.0, wrong, 2.0};
    expect_error(r, wrc_rolling_set_pressure(r, values.data(), 3), WRC_INVALID_ARGUMENT,
                 "values[1]", "between 0 and 1e30 MPa");
  }
  const std::vector<double> values{1.0, 2.0, infinity};
  EXPECT_EQ(wrc_rolling_set_pressure(r, values.data(), 0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_set_pressure(r, values.data(), -3), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_rolling_set_slip(r, values.data(), values.data(), -3), WRC_INVALID_ARGUMENT);
  expect_error(r, wrc_rolling_set_slip(r, values.data() + 1, values.data(), 2),
               WRC_INVALID_ARGUMENT, "slip_x[1]", "between -1e30 and 1e30");
  expect_error(r, wrc_rolling_set_slip(r, values.data(), values.data() + 1, 2),
               WRC_INVALID_ARGUMENT, "slip_y[1]");
  EXPECT_EQ(wrc_rolling_set_previous(r, values.data(), values.data(), -3), WRC_INVALID_ARGUMENT);
  expect_error(r, wrc_rolling_set_previous(r, values.data() + 1, values.data(), 2),
               WRC_INVALID_ARGUMENT, "traction_x[1]");
  expect_error(r, wrc_rolling_set_previous(r, values.data(), values.data() + 1, 2),
               WRC_INVALID_ARGUMENT, "traction_y[1]");
  const std::map<std::string, std::vector<double>> wrong{
      {"shear_modulus", {0.0, -1.0, 1.1e30}},
      {"poisson", {-0.01, 0.51}},
      {"friction", {-0.1, 1001.0}},
      {"longitudinal_creepage", {1.1e30}},
      {"lateral_creepage", {-1.1e30}},
      {"spin_creepage", {1.1e30}},
      {"tolerance", {0.0, 0.9e-10, 0.11}},
      {"maximum_iterations", {0.0, -3.0, 2.5, 1.1e9}},
      {"difference_parameter", {-0.51, 0.51}},
      {"derivatives", {-1.0, 0.5, 2.0}}};
  for (auto [key, numbers] : wrong) {
    numbers.insert(numbers.end(), {nan, infinity, -infinity});
    for (const double value : numbers) {
      expect_error(r, wrc_rolling_set_number(r, key.c_str(), value), WRC_INVALID_ARGUMENT, key,
                   "must be");
    }
  }
  for (const char* key : {"model", "contact", "difference"}) {
    expect_error(r, wrc_rolling_set_text(r, key, "fast"), WRC_INVALID_ARGUMENT, key,
                 " = \"fast\": must be \"");
  }
  EXPECT_TRUE(contains(wrc_rolling_error(r), "must be \"biased\" or \"first-order\""));
  ASSERT_TRUE(contact.solve());
  ASSERT_TRUE(plain.solve());
  EXPECT_EQ(contact.field("traction_x"), plain.field("traction_x"));
}

TEST(RollingProblem, AnUnknownNameIsReportedWithTheKnownOnes) {
  RollingContact contact = make_circle(8);
  wrc_rolling* r = contact.handle();
  double value = 7.0;
  std::int64_t count = 5;
  expect_error(r, wrc_rolling_set_number(r, "creepage", 1.0), WRC_UNKNOWN_NAME, "\"creepage\"",
               "spin_creepage, tolerance");
  expect_error(r, wrc_rolling_set_text(r, "method", "full"), WRC_UNKNOWN_NAME,
               "model, contact, difference");
  ASSERT_TRUE(contact.solve());
  expect_error(r, wrc_rolling_number(r, "force", &value), WRC_UNKNOWN_NAME,
               "creep_force.longitudinal");
  expect_error(r, wrc_rolling_field(r, "pressure", nullptr, 0, &count), WRC_UNKNOWN_NAME,
               "traction_x, traction_y, slip_x, slip_y, normal_displacement");
  EXPECT_EQ(value, 7.0);
  EXPECT_EQ(count, 5);
}

TEST(RollingProblem, DefaultsAreThoseOfSteelAndTheHeader) {
  RollingContact plain = make_circle(12);
  RollingContact contact = make_circle(12);
  const std::map<std::string, double> numbers{{"shear_modulus", 210000.0 / (2.0 * 1.28)},
                                              {"poisson", 0.28},
                                              {"friction", friction},
                                              {"tolerance", 1e-3},
                                              {"difference_parameter", 0.0},
                                              {"derivatives", 0.0},
                                              {"maximum_iterations", 30.0}};
  for (const auto& [key, value] : numbers) {
    contact.set(key, value);
  }
  contact.set("model", "full");
  contact.set("contact", "rolling");
  contact.set("difference", "biased");
  ASSERT_TRUE(plain.solve());
  ASSERT_TRUE(contact.solve());
  EXPECT_EQ(contact.field("traction_x"), plain.field("traction_x"));
  EXPECT_EQ(contact.field("slip_y"), plain.field("slip_y"));
}

// The values printed by CONTACT (Vollebregt, open source, 2024) on the same elements; those of
// tests/core/rolling.
TEST(RollingResults, MatchContactWithItsFirstOrderDifference) {
  constexpr double printed = 3e-6;
  RollingContact contact = make_circle(32);
  contact.set("difference", "first-order");
  contact.set("shear_modulus", 82000.0);
  contact.set("tolerance", 1e-6);
  contact.set("longitudinal_creepage", -0.001385074967904795);
  contact.set("lateral_creepage", -0.0015799647930828113);
  contact.set("spin_creepage", -0.0007867372780147649);
  ASSERT_TRUE(contact.solve());
  const auto relative = [&](const char* name) { return contact.number(name) / (friction * load); };
  EXPECT_NEAR(relative("creep_force.longitudinal"), 0.2948559360816609, printed);
  EXPECT_NEAR(relative("creep_force.lateral"), 0.7495508852344775, printed);
  EXPECT_NEAR(relative("spin_moment") / radius, 0.1874978896278011, printed);
}

TEST(RollingResults, NumbersAreThoseOfTheFields) {
  constexpr int n = 24;
  constexpr double area = 4.0 * radius * radius / (n * n);
  constexpr double on_bound = 1.0 - 1e-6;
  RollingContact contact = make_circle(n);
  ASSERT_TRUE(contact.solve());
  const auto pressure = circle_pressure(n);
  const auto traction_x = contact.field("traction_x");
  const auto traction_y = contact.field("traction_y");
  const auto slip_x = contact.field("slip_x");
  const auto slip_y = contact.field("slip_y");
  double force_x = 0.0;
  double force_y = 0.0;
  double moment = 0.0;
  double dissipation = 0.0;
  double slip_area = 0.0;
  double adhesion_area = 0.0;
  for (int element = 0; element < n * n; ++element) {
    const double x = ((2 * (element % n) + 1.0) / n - 1.0) * radius;
    const double y = ((2 * (element / n) + 1.0) / n - 1.0) * radius;
    const auto at = static_cast<std::size_t>(element);
    force_x += area * traction_x[at];
    force_y += area * traction_y[at];
    moment += area * (x * traction_y[at] - y * traction_x[at]);
    dissipation -= area * (traction_x[at] * slip_x[at] + traction_y[at] * slip_y[at]);
    const double bound = friction * pressure[at];
    const double traction = std::hypot(traction_x[at], traction_y[at]);
    EXPECT_LE(traction, bound * (1.0 + 1e-6));
    if (pressure[at] > 0.0) {
      (traction >= on_bound * bound ? slip_area : adhesion_area) += area;
    } else {
      EXPECT_EQ(std::hypot(slip_x[at], slip_y[at]), 0.0);
    }
  }
  const double scale = friction * load;
  EXPECT_NEAR(contact.number("creep_force.longitudinal"), force_x, scale * rounding);
  EXPECT_NEAR(contact.number("creep_force.lateral"), force_y, scale * rounding);
  EXPECT_NEAR(contact.number("spin_moment"), moment, scale * radius * rounding);
  EXPECT_NEAR(contact.number("slip_area"), slip_area, rounding * slip_area);
  EXPECT_NEAR(contact.number("adhesion_area"), adhesion_area, rounding * adhesion_area);
  const double power = 0.001 * force_x + 0.0008 * force_y + 0.0004 * moment;
  EXPECT_NEAR(contact.number("friction_power"), power, power * rounding);
  EXPECT_NEAR(contact.number("numerical_loss"), 1.0 - dissipation / power, 1e-8);
  EXPECT_EQ(contact.number("converged"), 1.0);
  EXPECT_GT(contact.number("iterations"), 0.0);
  EXPECT_GT(contact.number("convolutions"), contact.number("iterations"));
  EXPECT_GT(contact.number("residual"), 0.0);
  EXPECT_LE(contact.number("residual"), 1e-3);
}

TEST(RollingResults, DerivativesComeOnRequest) {
  RollingContact contact = make_circle(16);
  ASSERT_TRUE(contact.solve());
  EXPECT_EQ(contact.field("creepage_derivatives"), std::vector<double>(9, 0.0));
  contact.set("derivatives", 1.0);
  ASSERT_TRUE(contact.solve());
  const std::vector<double> rates = contact.field("creepage_derivatives");
  ASSERT_EQ(rates.size(), 9U);
  const double force = contact.number("creep_force.lateral");
  contact.set("lateral_creepage", -0.0008 * 1.01);
  ASSERT_TRUE(contact.solve());
  EXPECT_NEAR(contact.number("creep_force.lateral") - force, -0.0008 * 0.01 * rates[4],
              2e-3 * 0.01 * friction * load + 1e-4 * friction * load);
}

// A soft wheel that rolls freely is braked, and the tractions open and close the gap.
TEST(RollingResults, UnlikeBodiesDisplaceAcross) {
  RollingContact contact = make_circle(16);
  contact.set("longitudinal_creepage", 0.0);
  contact.set("lateral_creepage", 0.0);
  contact.set("spin_creepage", 0.0);
  ASSERT_TRUE(contact.solve());
  EXPECT_EQ(contact.number("creep_force.longitudinal"), 0.0);
  EXPECT_EQ(contact.field("normal_displacement"), std::vector<double>(256, 0.0));
  contact.set("difference_parameter", 0.07);
  ASSERT_TRUE(contact.solve());
  EXPECT_LT(contact.number("creep_force.longitudinal"), -0.1 * friction * load);
  EXPECT_NE(contact.field("normal_displacement")[0], 0.0);
  contact.set("contact", "shift");
  expect_error(contact.handle(), wrc_rolling_solve(contact.handle()), WRC_INVALID_ARGUMENT,
               "difference_parameter", "rolls steadily");
  contact.set("difference_parameter", 1e-17); // no effect
  EXPECT_TRUE(contact.solve());
}

// On an ellipse FASTSIM by strips is within some per cent of the full theory.
TEST(RollingModels, FastsimIsNearTheFullTheory) {
  RollingContact contact = make_circle(32);
  ASSERT_TRUE(contact.solve());
  const double force = contact.number("creep_force.longitudinal");
  contact.set("model", "fastsim");
  ASSERT_TRUE(contact.solve());
  EXPECT_NE(contact.number("creep_force.longitudinal"), force);
  EXPECT_NEAR(contact.number("creep_force.longitudinal"), force, 0.1 * friction * load);
  EXPECT_EQ(contact.number("convolutions"), 0.0);
  contact.set_pressure(std::vector<double>(1024, 0.0));
  ASSERT_TRUE(contact.solve());
  EXPECT_EQ(contact.number("creep_force.longitudinal"), 0.0);
  contact.set("contact", "transient");
  expect_error(contact.handle(), wrc_rolling_solve(contact.handle()), WRC_INVALID_ARGUMENT,
               "steady rolling for FASTSIM");
}

TEST(RollingResults, AFieldIsOnlyCopiedWhole) {
  RollingContact contact = make_circle(8);
  ASSERT_TRUE(contact.solve());
  std::vector<double> values(65, 7.0);
  std::int64_t count = 0;
  for (const char* name : {"traction_x", "traction_y", "slip_x", "slip_y"}) {
    EXPECT_EQ(wrc_rolling_field(contact.handle(), name, values.data(), 63, &count), WRC_TOO_SMALL);
    EXPECT_EQ(count, 64);
    EXPECT_EQ(values[0], 7.0);
    EXPECT_TRUE(contains(wrc_rolling_error(contact.handle()), "64"));
    EXPECT_EQ(wrc_rolling_field(contact.handle(), name, values.data(), 65, &count), WRC_OK);
    EXPECT_EQ(values[64], 7.0);
    EXPECT_NE(values[0], 7.0);
    values.assign(65, 7.0);
  }
}

// A step of rolling by one element is the first-order difference, so that steps end where steady
// rolling is: a tenth of the rest is left after each twenty or so. Without spin, whose place on an
// element differs.
TEST(RollingSteps, EndInSteadyRolling) {
  constexpr int n = 16;
  RollingContact steady = make_circle(n);
  steady.set("difference", "first-order");
  RollingContact contact = make_circle(n);
  contact.set("contact", "transient");
  for (RollingContact* each : {&steady, &contact}) {
    each->set("spin_creepage", 0.0);
    each->set("tolerance", 1e-8);
  }
  ASSERT_TRUE(steady.solve());
  double before = 0.0;
  for (int step = 0; step < 10 * n; ++step) {
    ASSERT_TRUE(contact.solve());
    const double force = contact.number("creep_force.longitudinal");
    EXPECT_GT(force, before * (1.0 - 1e-6)) << step;
    before = force;
    contact.advance();
  }
  EXPECT_NEAR(before, steady.number("creep_force.longitudinal"), 1e-6 * before);
  EXPECT_NEAR(contact.number("creep_force.lateral"), steady.number("creep_force.lateral"),
              1e-6 * before);
}

TEST(RollingSteps, HistoryIsGivenByTheCaller) {
  for (const char* step : {"transient", "shift"}) {
    RollingContact contact = make_circle(12);
    contact.set("contact", step);
    ASSERT_TRUE(contact.solve());
    const auto first = contact.field("traction_x");
    const auto first_y = contact.field("traction_y");
    ASSERT_TRUE(contact.solve());
    EXPECT_EQ(contact.field("traction_x"), first) << "solving again is no step";
    contact.advance();
    EXPECT_EQ(contact.field("traction_x"), first) << "results stay";
    ASSERT_TRUE(contact.solve());
    const auto second = contact.field("traction_x");
    EXPECT_NE(second, first);
    ASSERT_TRUE(contact.solve());
    EXPECT_EQ(contact.field("traction_x"), second) << "nor is it after a step";

    RollingContact other = make_circle(12);
    other.set("contact", step);
    other.set_previous(first, first_y);
    ASSERT_TRUE(other.solve());
    EXPECT_EQ(other.field("traction_x"), second);
    EXPECT_THROW(other.set_previous(first, {}), wrcontact::Error);
    other.set_previous({}, {});
    ASSERT_TRUE(other.solve());
    EXPECT_EQ(other.field("traction_x"), first);

    // Steady rolling has no history.
    RollingContact steady = make_circle(12);
    ASSERT_TRUE(steady.solve());
    contact.set("contact", "rolling");
    ASSERT_TRUE(contact.solve());
    EXPECT_EQ(contact.field("traction_x"), steady.field("traction_x"));
  }
}

TEST(RollingResults, StayThoseOfTheLastSolve) {
  RollingContact contact = make_circle(16);
  ASSERT_TRUE(contact.solve());
  const double force = contact.number("creep_force.lateral");
  const auto slip = contact.field("slip_x");
  contact.set_pressure({1.0, 2.0, 3.0, 4.0});
  contact.set("friction", 0.1);
  EXPECT_THROW(contact.solve(), wrcontact::Error); // 4 values on 256 elements
  EXPECT_EQ(contact.number("creep_force.lateral"), force);
  EXPECT_EQ(contact.field("slip_x"), slip);
  contact.set_grid(2, 2, 1.0, 1.0);
  EXPECT_EQ(contact.field("slip_x"), slip);
  ASSERT_TRUE(contact.solve());
  EXPECT_EQ(contact.field("slip_x").size(), 4U);
}

TEST(RollingResults, DoNotDependOnEarlierCalls) {
  RollingContact fresh = make_circle(20);
  ASSERT_TRUE(fresh.solve());
  RollingContact used = make_circle(33);
  used.set("tolerance", 1e-6);
  ASSERT_TRUE(used.solve());
  used.set("contact", "shift");
  ASSERT_TRUE(used.solve());
  used.set("contact", "rolling");
  used.set("tolerance", 1e-3);
  prepare(used, 20);
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(used.solve());
    EXPECT_EQ(used.field("traction_x"), fresh.field("traction_x"));
    EXPECT_EQ(used.field("slip_y"), fresh.field("slip_y"));
  }
}

TEST(RollingResults, AreZeroWithoutFriction) {
  RollingContact contact = make_circle(16);
  contact.set("friction", 0.0);
  ASSERT_TRUE(contact.solve());
  for (const char* name :
       {"creep_force.longitudinal", "creep_force.lateral", "spin_moment", "friction_power",
        "numerical_loss", "iterations", "slip_area", "adhesion_area"}) {
    EXPECT_EQ(contact.number(name), 0.0) << name;
  }
}

TEST(RollingResults, NotConvergedComesWithUsableResults) {
  RollingContact contact = make_circle(48);
  contact.set("tolerance", 1e-9);
  contact.set("maximum_iterations", 2.0);
  EXPECT_EQ(wrc_rolling_solve(contact.handle()), WRC_NOT_CONVERGED);
  EXPECT_TRUE(contains(wrc_rolling_error(contact.handle()), "residual = "));
  EXPECT_EQ(contact.number("converged"), 0.0);
  EXPECT_GT(contact.number("residual"), 1e-9);
  EXPECT_GT(contact.number("creep_force.longitudinal"), 0.0);
  EXPECT_EQ(contact.field("traction_x").size(), 48U * 48U);
}

} // namespace
} // namespace rolling_test
