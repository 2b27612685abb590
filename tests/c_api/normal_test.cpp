/// The normal contact of a gap given by the caller, through the C interface.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "owned_handles.hpp"

namespace normal_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Sums over a few thousand elements.
constexpr double rounding = 1e-10;

/// A sphere of this radius on a plane; with E* of steel 1 kN presses a circle of radius 1.0 mm.
constexpr double radius = 120.0;
constexpr double modulus = 210000.0 / (2.0 * 0.91);
constexpr double load = 1000.0;

std::vector<double> sphere_gap(int lateral_count, int longitudinal_count, double step) {
  std::vector<double> gap;
  for (int i = 0; i < lateral_count; ++i) {
    for (int j = 0; j < longitudinal_count; ++j) {
      const double y = (i - 0.5 * (lateral_count - 1)) * step;
      const double x = (j - 0.5 * (longitudinal_count - 1)) * step;
      gap.push_back((x * x + y * y) / (2.0 * radius));
    }
  }
  return gap;
}

/// The sphere on n x n elements of a square of 3 mm.
NormalPointer make_sphere(int n) {
  NormalPointer normal = make_normal();
  const double step = 3.0 / n;
  const auto gap = sphere_gap(n, n, step);
  EXPECT_EQ(wrc_normal_set_grid(normal.get(), n, n, step, step), WRC_OK);
  EXPECT_EQ(wrc_normal_set_distance(normal.get(), gap.data(), n * n), WRC_OK);
  EXPECT_EQ(wrc_normal_set_number(normal.get(), "normal_load", load), WRC_OK);
  return normal;
}

double number_of(wrc_normal* normal, const char* name) {
  double value = nan;
  EXPECT_EQ(wrc_normal_number(normal, name, &value), WRC_OK) << name;
  return value;
}

std::vector<double> field_of(wrc_normal* normal, const char* name) {
  std::int64_t count = -1;
  EXPECT_EQ(wrc_normal_field(normal, name, nullptr, 0, &count), WRC_OK) << name;
  std::vector<double> values(static_cast<std::size_t>(count));
  EXPECT_EQ(wrc_normal_field(normal, name, values.data(), count, &count), WRC_OK);
  return values;
}

TEST(NormalHandle, EveryFunctionRefusesANullHandle) {
  double value = 0.0;
  const char* text = nullptr;
  std::int64_t count = 0;
  EXPECT_EQ(wrc_normal_create(nullptr), WRC_INVALID_ARGUMENT);
  wrc_normal_destroy(nullptr);
  EXPECT_EQ(wrc_normal_set_grid(nullptr, 2, 2, 1.0, 1.0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_set_distance(nullptr, &value, 1), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_set_number(nullptr, "tolerance", 1e-3), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_set_text(nullptr, "solver", "paper"), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_solve(nullptr), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_number(nullptr, "pmax", &value), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_text(nullptr, "stop_reason", &text), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_field(nullptr, "pressure", &value, 1, &count), WRC_INVALID_ARGUMENT);
  EXPECT_TRUE(contains(wrc_normal_error(nullptr), "NULL"));
}

TEST(NormalHandle, NullArgumentsAreNamed) {
  const NormalPointer normal = make_sphere(8);
  wrc_normal* n = normal.get();
  double value = 0.0;
  const char* text = nullptr;
  expect_null_told(n, wrc_normal_set_distance(n, nullptr, 4), "values");
  expect_null_told(n, wrc_normal_set_number(n, nullptr, 1.0), "key");
  expect_null_told(n, wrc_normal_set_text(n, nullptr, "paper"), "key");
  expect_null_told(n, wrc_normal_set_text(n, "solver", nullptr), "value");
  ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
  expect_null_told(n, wrc_normal_number(n, nullptr, &value), "name");
  expect_null_told(n, wrc_normal_number(n, "pmax", nullptr), "value");
  expect_null_told(n, wrc_normal_text(n, nullptr, &text), "name");
  expect_null_told(n, wrc_normal_text(n, "stop_reason", nullptr), "value");
  std::int64_t count = 0;
  expect_null_told(n, wrc_normal_field(n, nullptr, &value, 1, &count), "name");
  expect_null_told(n, wrc_normal_field(n, "pressure", nullptr, 64, &count), "values");
  expect_null_told(n, wrc_normal_field(n, "pressure", &value, 1, nullptr), "count");
}

TEST(NormalHandle, ThereAreNoResultsBeforeSolving) {
  const NormalPointer normal = make_sphere(8);
  double value = 7.0;
  const char* text = "kept";
  std::int64_t count = 5;
  expect_error(normal.get(), wrc_normal_number(normal.get(), "pmax", &value), WRC_NO_RESULT,
               "not been solved");
  EXPECT_EQ(wrc_normal_text(normal.get(), "stop_reason", &text), WRC_NO_RESULT);
  EXPECT_EQ(wrc_normal_field(normal.get(), "pressure", nullptr, 0, &count), WRC_NO_RESULT);
  EXPECT_EQ(value, 7.0);
  EXPECT_STREQ(text, "kept");
  EXPECT_EQ(count, 5);
}

TEST(NormalProblem, MissingInputIsNamed) {
  const NormalPointer normal = make_normal();
  wrc_normal* n = normal.get();
  const std::vector<double> gap(6, 0.0);
  expect_error(n, wrc_normal_solve(n), WRC_INVALID_ARGUMENT, "grid");
  ASSERT_EQ(wrc_normal_set_grid(n, 2, 4, 1.0, 1.0), WRC_OK);
  expect_error(n, wrc_normal_solve(n), WRC_INVALID_ARGUMENT, "undeformed_distance");
  ASSERT_EQ(wrc_normal_set_distance(n, gap.data(), 6), WRC_OK);
  ASSERT_EQ(wrc_normal_set_number(n, "normal_load", 1.0), WRC_OK);
  expect_error(n, wrc_normal_solve(n), WRC_INVALID_ARGUMENT, "8 elements");
  ASSERT_EQ(wrc_normal_set_grid(n, 2, 3, 1.0, 1.0), WRC_OK);
  EXPECT_EQ(wrc_normal_solve(n), WRC_OK);
  EXPECT_STREQ(wrc_normal_error(n), "");

  const NormalPointer unloaded = make_normal();
  ASSERT_EQ(wrc_normal_set_grid(unloaded.get(), 2, 3, 1.0, 1.0), WRC_OK);
  ASSERT_EQ(wrc_normal_set_distance(unloaded.get(), gap.data(), 6), WRC_OK);
  expect_error(unloaded.get(), wrc_normal_solve(unloaded.get()), WRC_INVALID_ARGUMENT,
               "normal_load");
}

TEST(NormalProblem, ValuesOutOfRangeAreRefusedAndChangeNothing) {
  const NormalPointer plain = make_sphere(12);
  const NormalPointer normal = make_sphere(12);
  wrc_normal* n = normal.get();
  constexpr std::int64_t large = std::int64_t{1} << 26;
  const std::array<double, 3> bad_gap{0.0, nan, 0.0};
  EXPECT_EQ(wrc_normal_set_grid(n, 0, 4, 1.0, 1.0), WRC_INVALID_ARGUMENT);
  expect_error(n, wrc_normal_set_grid(n, 4, -1, 1.0, 1.0), WRC_INVALID_ARGUMENT,
               "longitudinal_count");
  EXPECT_EQ(wrc_normal_set_grid(n, large, 2, 1.0, 1.0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_set_grid(n, std::numeric_limits<std::int64_t>::max(), 2, 1.0, 1.0),
            WRC_INVALID_ARGUMENT);
  for (const double step : {0.0, -1.0, nan, infinity}) {
    expect_error(n, wrc_normal_set_grid(n, 4, 4, step, 1.0), WRC_INVALID_ARGUMENT, "lateral_step");
    EXPECT_EQ(wrc_normal_set_grid(n, 4, 4, 1.0, step), WRC_INVALID_ARGUMENT);
  }
  expect_error(n, wrc_normal_set_distance(n, bad_gap.data(), 3), WRC_INVALID_ARGUMENT, "values[1]");
  EXPECT_EQ(wrc_normal_set_distance(n, bad_gap.data(), 0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_set_distance(n, bad_gap.data(), -3), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_set_distance(n, bad_gap.data(), large + 1), WRC_INVALID_ARGUMENT);
  for (const char* key :
       {"combined_modulus", "normal_load", "approach", "tolerance", "maximum_iterations"}) {
    for (const double value : {nan, infinity, -infinity}) {
      EXPECT_EQ(wrc_normal_set_number(n, key, value), WRC_INVALID_ARGUMENT) << key;
      EXPECT_TRUE(contains(wrc_normal_error(n), key));
    }
  }
  EXPECT_EQ(wrc_normal_set_number(n, "combined_modulus", 0.0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_set_number(n, "normal_load", -1.0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_set_number(n, "tolerance", 0.0), WRC_INVALID_ARGUMENT);
  EXPECT_EQ(wrc_normal_set_number(n, "tolerance", 0.11), WRC_INVALID_ARGUMENT);
  for (const double value : {0.0, 1.5, 1e10}) {
    EXPECT_EQ(wrc_normal_set_number(n, "maximum_iterations", value), WRC_INVALID_ARGUMENT);
  }
  for (const char* key : {"solver", "precision", "planner"}) {
    expect_error(n, wrc_normal_set_text(n, key, "fast"), WRC_INVALID_ARGUMENT, key, "fast");
  }
  ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
  ASSERT_EQ(wrc_normal_solve(plain.get()), WRC_OK);
  EXPECT_EQ(field_of(n, "pressure"), field_of(plain.get(), "pressure"));
}

TEST(NormalProblem, AnUnknownNameIsReportedWithTheKnownOnes) {
  const NormalPointer normal = make_sphere(8);
  wrc_normal* n = normal.get();
  double value = 7.0;
  const char* text = "kept";
  std::int64_t count = 5;
  expect_error(n, wrc_normal_set_number(n, "load", 1.0), WRC_UNKNOWN_NAME, "\"load\"",
               "normal_load");
  EXPECT_EQ(wrc_normal_set_text(n, "method", "paper"), WRC_UNKNOWN_NAME);
  ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
  expect_error(n, wrc_normal_number(n, "pmaximum", &value), WRC_UNKNOWN_NAME,
               "residuals.least_gap");
  EXPECT_EQ(wrc_normal_text(n, "reason", &text), WRC_UNKNOWN_NAME);
  EXPECT_EQ(wrc_normal_field(n, "gap", nullptr, 0, &count), WRC_UNKNOWN_NAME);
  EXPECT_EQ(value, 7.0);
  EXPECT_STREQ(text, "kept");
  EXPECT_EQ(count, 5);
}

TEST(NormalResults, AreThoseOfHertz) {
  constexpr int n = 60;
  // Errors of 40 elements across the contact with constant elements (docs/evidence/validation.md):
  // 0.08/n^2, 0.15/n^2, with smooth ones a fifth of it; by counting elements the area is of order
  // one, 0.55/n too large with smooth ones.
  constexpr double error_approach = 2e-4;
  constexpr double error_pmax = 5e-4;
  constexpr double error_area = 5e-3;
  constexpr double error_count = 3e-2;
  const double a = std::cbrt(3.0 * load * radius / (4.0 * modulus));
  const double pmax = 3.0 * load / (2.0 * std::numbers::pi * a * a);
  const double approach = a * a / radius;
  for (const char* solver : {"default", "paper"}) {
    const NormalPointer normal = make_sphere(n);
    ASSERT_EQ(wrc_normal_set_text(normal.get(), "solver", solver), WRC_OK);
    ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK);
    const auto number = [&](const char* name) { return number_of(normal.get(), name); };
    EXPECT_NEAR(number("pmax"), pmax, pmax * error_pmax) << solver;
    EXPECT_NEAR(number("approach"), approach, approach * error_approach) << solver;
    EXPECT_NEAR(number("area"), std::numbers::pi * a * a, error_area * std::numbers::pi * a * a)
        << solver;
    EXPECT_NEAR(number("fill"), number("area") / 9.0, error_count * number("fill")) << solver;
    EXPECT_NEAR(number("normal_force"), load, load * rounding) << solver;
    EXPECT_GE(number("pmax"), number("pmax_element"));
    EXPECT_GT(number("iterations"), 0.0);
    EXPECT_LT(number("residuals.load_balance"), rounding);
    EXPECT_GT(number("residuals.least_gap"), -1e-5); // the tolerance is 1e-6 of the pressure
    EXPECT_LT(number("residuals.complementarity"), 1e-5);
    const char* reason = nullptr;
    ASSERT_EQ(wrc_normal_text(normal.get(), "stop_reason", &reason), WRC_OK);
    EXPECT_STREQ(reason, "tolerance_met");
  }
}

TEST(NormalResults, FieldsSolveTheProblem) {
  constexpr int n = 24;
  const NormalPointer normal = make_sphere(n);
  ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK);
  const auto gap = sphere_gap(n, n, 3.0 / n);
  const auto pressure = field_of(normal.get(), "pressure");
  const auto displacement = field_of(normal.get(), "displacement");
  ASSERT_EQ(pressure.size(), gap.size());
  ASSERT_EQ(displacement.size(), gap.size());
  const double approach = number_of(normal.get(), "approach");
  const double largest = *std::max_element(displacement.begin(), displacement.end());
  double worst = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const double g = gap[i] + displacement[i] - approach;
    worst = std::max(worst, pressure[i] > 0.0 ? std::abs(g) : -g);
  }
  // The same displacements by another sum of the same transforms.
  const double told = std::max(number_of(normal.get(), "residuals.complementarity"),
                               -number_of(normal.get(), "residuals.least_gap"));
  EXPECT_NEAR(worst / largest, told, rounding);
  const double sum = std::accumulate(pressure.begin(), pressure.end(), 0.0);
  EXPECT_NEAR(sum * 9.0 / (n * n), load, load * rounding);
}

TEST(NormalResults, AFieldIsOnlyCopiedWhole) {
  const NormalPointer normal = make_sphere(8);
  ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK);
  std::vector<double> values(65, 7.0);
  std::int64_t count = 0;
  for (const char* name : {"pressure", "displacement"}) {
    EXPECT_EQ(wrc_normal_field(normal.get(), name, values.data(), 63, &count), WRC_TOO_SMALL);
    EXPECT_EQ(count, 64);
    EXPECT_EQ(values[0], 7.0);
    EXPECT_TRUE(contains(wrc_normal_error(normal.get()), "64"));
    EXPECT_EQ(wrc_normal_field(normal.get(), name, values.data(), -1, &count), WRC_OK);
    EXPECT_EQ(values[0], 7.0);
    EXPECT_EQ(wrc_normal_field(normal.get(), name, values.data(), 65, &count), WRC_OK);
    EXPECT_EQ(values[64], 7.0);
    EXPECT_NE(values[0], 7.0);
    values.assign(65, 7.0);
  }
}

TEST(NormalResults, ArePreciseToTheTolerance) {
  constexpr double tolerance = 1e-8;
  const NormalPointer normal = make_sphere(32);
  wrc_normal* n = normal.get();
  ASSERT_EQ(wrc_normal_set_number(n, "tolerance", tolerance), WRC_OK);
  ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
  const auto mixed = field_of(n, "pressure");
  const double limit = 2.0 * tolerance * number_of(n, "pmax_element"); // both may be off by one
  const auto compare = [&] {
    ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
    const auto other = field_of(n, "pressure");
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      ASSERT_NEAR(other[i], mixed[i], limit);
    }
  };
  ASSERT_EQ(wrc_normal_set_text(n, "precision", "double"), WRC_OK);
  compare();
  ASSERT_EQ(wrc_normal_set_text(n, "planner", "measure"), WRC_OK);
  compare();
}

TEST(NormalResults, LoadAndApproachReplaceEachOther) {
  const NormalPointer normal = make_sphere(24);
  wrc_normal* n = normal.get();
  ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
  const double approach = number_of(n, "approach");
  const double pmax = number_of(n, "pmax");
  ASSERT_EQ(wrc_normal_set_number(n, "approach", approach), WRC_OK);
  ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
  EXPECT_NEAR(number_of(n, "normal_force"), load, load * 1e-5); // the tolerance is 1e-6
  EXPECT_NEAR(number_of(n, "pmax"), pmax, pmax * 1e-5);
  EXPECT_EQ(number_of(n, "residuals.load_balance"), 0.0);
  ASSERT_EQ(wrc_normal_set_number(n, "normal_load", 0.0), WRC_OK);
  ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
  EXPECT_EQ(number_of(n, "normal_force"), 0.0);
  EXPECT_EQ(number_of(n, "fill"), 0.0);
  EXPECT_EQ(number_of(n, "pmax"), 0.0);
}

TEST(NormalResults, StayThoseOfTheLastSolve) {
  const NormalPointer normal = make_sphere(16);
  wrc_normal* n = normal.get();
  ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
  const NormalPointer same = make_sphere(16);
  ASSERT_EQ(wrc_normal_solve(same.get()), WRC_OK);
  // The problem changes before displacements and residuals have been asked for.
  const std::vector<double> flat(4, 0.0);
  ASSERT_EQ(wrc_normal_set_distance(n, flat.data(), 4), WRC_OK);
  ASSERT_EQ(wrc_normal_set_number(n, "combined_modulus", 1.0), WRC_OK);
  EXPECT_EQ(wrc_normal_solve(n), WRC_INVALID_ARGUMENT); // 4 values on 256 elements
  EXPECT_EQ(number_of(n, "residuals.complementarity"),
            number_of(same.get(), "residuals.complementarity"));
  EXPECT_EQ(field_of(n, "displacement"), field_of(same.get(), "displacement"));
  ASSERT_EQ(wrc_normal_set_grid(n, 2, 2, 1.0, 1.0), WRC_OK);
  EXPECT_EQ(field_of(n, "pressure"), field_of(same.get(), "pressure"));
  ASSERT_EQ(wrc_normal_solve(n), WRC_OK);
  EXPECT_EQ(field_of(n, "pressure").size(), 4U);
  EXPECT_LT(number_of(n, "residuals.complementarity"), 1e-5);
  EXPECT_EQ(field_of(n, "displacement").size(), 4U);
}

TEST(NormalResults, DoNotDependOnEarlierCalls) {
  const NormalPointer fresh = make_sphere(20);
  ASSERT_EQ(wrc_normal_solve(fresh.get()), WRC_OK);
  const NormalPointer used = make_sphere(33);
  ASSERT_EQ(wrc_normal_solve(used.get()), WRC_OK);
  const auto gap = sphere_gap(20, 20, 3.0 / 20);
  ASSERT_EQ(wrc_normal_set_grid(used.get(), 20, 20, 3.0 / 20, 3.0 / 20), WRC_OK);
  ASSERT_EQ(wrc_normal_set_distance(used.get(), gap.data(), 400), WRC_OK);
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(wrc_normal_solve(used.get()), WRC_OK);
    EXPECT_EQ(field_of(used.get(), "pressure"), field_of(fresh.get(), "pressure"));
  }
}

TEST(NormalResults, NotConvergedComesWithUsableResults) {
  for (const char* solver : {"default", "paper"}) {
    const NormalPointer normal = make_sphere(48);
    wrc_normal* n = normal.get();
    ASSERT_EQ(wrc_normal_set_text(n, "solver", solver), WRC_OK);
    ASSERT_EQ(wrc_normal_set_number(n, "tolerance", 1e-9), WRC_OK);
    ASSERT_EQ(wrc_normal_set_number(n, "maximum_iterations", 3.0), WRC_OK);
    expect_error(n, wrc_normal_solve(n), WRC_NOT_CONVERGED, "stop_reason");
    const char* reason = nullptr;
    ASSERT_EQ(wrc_normal_text(n, "stop_reason", &reason), WRC_OK);
    EXPECT_STREQ(reason, "iteration_limit");
    EXPECT_NEAR(number_of(n, "normal_force"), load, load * rounding);
    EXPECT_EQ(field_of(n, "pressure").size(), 48U * 48U);
  }
}

/// The texts of all warnings of a result, each after its class.
std::vector<std::string> warnings_of(wrc_normal* normal) {
  std::vector<std::string> warnings;
  for (int i = 0; i < number_of(normal, "warning_count"); ++i) {
    const char* kind = nullptr;
    const char* text = nullptr;
    EXPECT_EQ(wrc_normal_text(normal, ("warning_classes." + std::to_string(i)).c_str(), &kind),
              WRC_OK);
    EXPECT_EQ(wrc_normal_text(normal, ("warnings." + std::to_string(i)).c_str(), &text), WRC_OK);
    warnings.push_back(kind + std::string(": ") + text);
    EXPECT_EQ(wrc_normal_text(normal, ("warning_grades." + std::to_string(i)).c_str(), &text),
              WRC_OK);
    EXPECT_STREQ(text, "do not use");
  }
  const char* text = nullptr;
  EXPECT_EQ(wrc_normal_text(normal, ("warnings." + std::to_string(warnings.size())).c_str(), &text),
            WRC_UNKNOWN_NAME);
  EXPECT_EQ(number_of(normal, "grade"), warnings.empty() ? WRC_FINE : WRC_DO_NOT_USE);
  return warnings;
}

TEST(NormalWarnings, TellOfTheGridsEdgeAndOfFewElements) {
  const NormalPointer normal = make_sphere(24);
  ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK);
  EXPECT_TRUE(warnings_of(normal.get()).empty());
  EXPECT_EQ(wrc_normal_set_number(normal.get(), "normal_load", 5.0 * load), WRC_OK);
  ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK); // 1.7 mm, on a square of 3 mm
  std::vector<std::string> warnings = warnings_of(normal.get());
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(contains(warnings[0], "grid_edge: contact reaches the edge of the grid"));
  EXPECT_EQ(wrc_normal_set_number(normal.get(), "normal_load", 1e-4 * load), WRC_OK);
  ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK); // 0.05 mm, on elements of 0.125 mm
  warnings = warnings_of(normal.get());
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(contains(warnings[0], "accuracy: contact covers 2 x 2 elements")) << warnings[0];
  EXPECT_EQ(wrc_normal_set_number(normal.get(), "normal_load", 0.0), WRC_OK);
  ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK);
  EXPECT_TRUE(warnings_of(normal.get()).empty()) << "no contact";
}

} // namespace
} // namespace normal_test
