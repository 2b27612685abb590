/// The table of certified ranges (docs/evidence/limits.md) for gaps given directly: each boundary
/// from both sides; other units change nothing beyond 1e-12, and a second run not a bit.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "owned_handles.hpp"

namespace certified_gaps_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double steel = 210000.0 / (2.0 * (1.0 - 0.3 * 0.3));

struct Gap {
  std::int64_t rows = 32;
  std::int64_t columns = 16;
  double lateral_step = 0.625;
  double longitudinal_step = 1.25;
  double modulus = steel;
  double load = 80000.0;
  double tolerance = 1e-12;
  std::vector<double> distance;
};

/// Radii of 460 mm along and 300 mm across, on the gap's grid.
Gap hertz(Gap gap = {}) {
  for (std::int64_t i = 0; i < gap.rows; ++i) {
    for (std::int64_t j = 0; j < gap.columns; ++j) {
      const double y = (static_cast<double>(i) - 0.5 * static_cast<double>(gap.rows - 1)) * 0.625;
      const double x = (static_cast<double>(j) - 0.5 * static_cast<double>(gap.columns - 1)) * 1.25;
      gap.distance.push_back(x * x / 920.0 + y * y / 600.0);
    }
  }
  return gap;
}

/// The first status that is not WRC_OK.
wrc_status solve(wrc_normal* normal, const Gap& gap) {
  wrc_status status =
      wrc_normal_set_grid(normal, gap.rows, gap.columns, gap.lateral_step, gap.longitudinal_step);
  if (status == WRC_OK) {
    status = wrc_normal_set_distance(normal, gap.distance.data(),
                                     static_cast<std::int64_t>(gap.distance.size()));
  }
  for (const auto& [key, value] :
       {std::pair{"combined_modulus", gap.modulus}, std::pair{"normal_load", gap.load},
        std::pair{"tolerance", gap.tolerance}}) {
    if (status == WRC_OK) {
      status = wrc_normal_set_number(normal, key, value);
    }
  }
  return status == WRC_OK ? wrc_normal_solve(normal) : status;
}

double number_of(wrc_normal* normal, const char* name) {
  double value = nan;
  EXPECT_EQ(wrc_normal_number(normal, name, &value), WRC_OK) << name;
  return value;
}

std::vector<double> pressure_of(wrc_normal* normal) {
  std::int64_t count = 0;
  EXPECT_EQ(wrc_normal_field(normal, "pressure", nullptr, 0, &count), WRC_OK);
  std::vector<double> values(static_cast<std::size_t>(count));
  EXPECT_EQ(wrc_normal_field(normal, "pressure", values.data(), count, &count), WRC_OK);
  return values;
}

struct Named {
  const char* name;
  Gap gap;
};

template <class Change> Named with(const char* name, const Change& change) {
  Named named{name, hertz()};
  change(named.gap);
  return named;
}

/// A grid of elements of this shape, and a gap that rises by what the load presses it in.
Gap shaped(double aspect) {
  Gap gap;
  gap.lateral_step = 0.8 * std::sqrt(aspect);
  gap.longitudinal_step = 0.8 / std::sqrt(aspect);
  gap.distance.assign(static_cast<std::size_t>(gap.rows * gap.columns), 0.0);
  const NormalPointer punch = make_normal();
  EXPECT_EQ(solve(punch.get(), gap), WRC_OK) << wrc_normal_error(punch.get());
  const double rise = 3.0 * number_of(punch.get(), "approach");
  for (std::size_t i = 0; i < gap.distance.size(); ++i) {
    const double y = static_cast<double>(i / 16) / 15.5 - 1.0;
    const double x = static_cast<double>(i % 16) / 7.5 - 1.0;
    gap.distance[i] = rise * (x * x + y * y);
  }
  return gap;
}

TEST(CertifiedGaps, AreSolvedWithinTheirRanges) {
  const Named all[] = {
      with("as it is", [](Gap&) {}),
      with("least load", [](Gap& gap) { gap.load = 1e-60; }),
      with("largest load", [](Gap& gap) { gap.load = 1e60; }),
      with("least modulus", [](Gap& gap) { gap.modulus = 1e-30; }),
      with("largest modulus", [](Gap& gap) { gap.modulus = 1e30; }),
      with("least steps", [](Gap& gap) { gap.lateral_step = gap.longitudinal_step = 1e-30; }),
      with("largest steps", [](Gap& gap) { gap.lateral_step = gap.longitudinal_step = 1e30; }),
      with("flattest elements", [](Gap& gap) { gap = shaped(1e-9); }),
      with("steepest elements", [](Gap& gap) { gap = shaped(1e9); }),
      with("elements of 1:1000", [](Gap& gap) { gap = shaped(1e-3); }),
      with("elements of 1000:1", [](Gap& gap) { gap = shaped(1e3); }),
      with("one element",
           [](Gap& gap) {
             gap.rows = gap.columns = 1;
             gap.distance = {0.1};
           }),
      with("finest tolerance", [](Gap& gap) { gap.tolerance = 1e-13; }),
      with("coarsest tolerance", [](Gap& gap) { gap.tolerance = 0.1; }),
      with("absent bodies", [](Gap& gap) { std::fill_n(gap.distance.begin(), 100, 1e300); }),
  };
  for (const auto& [name, gap] : all) {
    SCOPED_TRACE(name);
    const NormalPointer normal = make_normal();
    ASSERT_EQ(solve(normal.get(), gap), WRC_OK) << wrc_normal_error(normal.get());
    const std::vector<double> pressure = pressure_of(normal.get());
    const double largest = *std::max_element(pressure.begin(), pressure.end());
    EXPECT_TRUE(std::isfinite(largest));
    EXPECT_GT(largest, 0.0);
    EXPECT_GE(*std::min_element(pressure.begin(), pressure.end()), 0.0);
    constexpr double summation = 1e-12;
    EXPECT_LE(number_of(normal.get(), "residuals.load_balance"), summation);
    // Gaps are told to the rounding of the approach, whatever displaces the bodies.
    std::int64_t count = static_cast<std::int64_t>(pressure.size());
    std::vector<double> displacement(pressure.size());
    ASSERT_EQ(wrc_normal_field(normal.get(), "displacement", displacement.data(), count, &count),
              WRC_OK);
    const double rounding = 1e-15 * std::abs(number_of(normal.get(), "approach")) /
                            *std::max_element(displacement.begin(), displacement.end());
    const double permitted = std::max(gap.tolerance, summation) + rounding;
    EXPECT_LE(number_of(normal.get(), "residuals.complementarity"), permitted);
    EXPECT_GE(number_of(normal.get(), "residuals.least_gap"), -permitted);
  }
}

TEST(CertifiedGaps, AreRefusedOutsideWithArgumentValueAndAllowedRange) {
  struct Refusal {
    Named named;
    std::vector<std::string> said;
  };
  const Refusal all[] = {
      {with("load", [](Gap& gap) { gap.load = 9e-61; }),
       {"normal_load = 9e-61", "must be 0, or 1e-60 to 1e60 N"}},
      {with("load", [](Gap& gap) { gap.load = 1.1e60; }), {"normal_load = 1.1e+60", "1e60 N"}},
      {with("load", [](Gap& gap) { gap.load = -1.0; }), {"normal_load = -1", "1e60 N"}},
      {with("load", [](Gap& gap) { gap.load = nan; }), {"normal_load = nan", "1e60 N"}},
      {with("modulus", [](Gap& gap) { gap.modulus = 9e-31; }),
       {"combined_modulus = 9e-31", "between 1e-30 and 1e30 MPa"}},
      {with("modulus", [](Gap& gap) { gap.modulus = 1.1e30; }),
       {"combined_modulus = 1.1e+30", "between 1e-30 and 1e30 MPa"}},
      {with("step", [](Gap& gap) { gap.lateral_step = gap.longitudinal_step = 9e-31; }),
       {"grid.lateral_step = 9e-31", "between 1e-30 and 1e30"}},
      {with("step", [](Gap& gap) { gap.longitudinal_step = 1.1e30; }),
       {"grid.longitudinal_step = 1.1e+30", "between 1e-30 and 1e30"}},
      {with("step", [](Gap& gap) { gap.lateral_step = 0.0; }),
       {"grid.lateral_step = 0", "between 1e-30 and 1e30"}},
      {with("aspect",
            [](Gap& gap) {
              gap.lateral_step = 1.1e5;
              gap.longitudinal_step = 1e-4;
            }),
       {"grid.lateral_step/longitudinal_step = 1.1e+09", "between 1e-9 and 1e9"}},
      {with("aspect",
            [](Gap& gap) {
              gap.lateral_step = 1e-4;
              gap.longitudinal_step = 1.25e5;
            }),
       {"grid.lateral_step/longitudinal_step = 8e-10", "between 1e-9 and 1e9"}},
      {with("rows", [](Gap& gap) { gap.rows = 0; }),
       {"grid.lateral_count = 0", "between 1 and 2^26"}},
      {with("elements",
            [](Gap& gap) {
              gap.rows = 8193;
              gap.columns = 8192;
            }),
       {"grid.longitudinal_count = 8192", "2^26 elements"}},
      {with("tolerance", [](Gap& gap) { gap.tolerance = 9e-14; }),
       {"tolerance = 9e-14", "must be between 1e-13 and 0.1"}},
      {with("tolerance", [](Gap& gap) { gap.tolerance = 0.11; }),
       {"tolerance = 0.11", "must be between 1e-13 and 0.1"}},
      {with("hole", [](Gap& gap) { gap.distance[7] = nan; }), {"values[7] = nan", "finite"}},
      {with("hole", [](Gap& gap) { gap.distance[0] = -infinity; }), {"values[0] = -inf", "finite"}},
  };
  for (const auto& [named, said] : all) {
    SCOPED_TRACE(named.name);
    const NormalPointer normal = make_normal();
    EXPECT_EQ(solve(normal.get(), named.gap), WRC_INVALID_ARGUMENT);
    for (const std::string& part : said) {
      EXPECT_TRUE(contains(wrc_normal_error(normal.get()), part))
          << '"' << part << "\" is not in: " << wrc_normal_error(normal.get());
    }
  }
  // An approach has the load's limits.
  const NormalPointer normal = make_normal();
  EXPECT_EQ(wrc_normal_set_number(normal.get(), "approach", 1e60), WRC_OK);
  expect_error(normal.get(), wrc_normal_set_number(normal.get(), "approach", -1.1e60),
               WRC_INVALID_ARGUMENT, "approach = -1.1e+60: must be between -1e60");
}

TEST(CertifiedGaps, WithoutLoadOrTouchThereIsNoPressure) {
  const NormalPointer normal = make_normal();
  Gap gap = hertz();
  gap.load = 0.0;
  ASSERT_EQ(solve(normal.get(), gap), WRC_OK);
  EXPECT_EQ(number_of(normal.get(), "pmax"), 0.0);
  const double least = *std::min_element(gap.distance.begin(), gap.distance.end());
  EXPECT_EQ(number_of(normal.get(), "approach"), least);
  for (const double approach : {-1.0, least}) {
    ASSERT_EQ(wrc_normal_set_number(normal.get(), "approach", approach), WRC_OK);
    ASSERT_EQ(wrc_normal_solve(normal.get()), WRC_OK);
    EXPECT_EQ(number_of(normal.get(), "normal_force"), 0.0);
    EXPECT_EQ(number_of(normal.get(), "fill"), 0.0);
  }
}

TEST(CertifiedGaps, TheWholeGridMayBeInContact) {
  const NormalPointer normal = make_normal();
  Gap gap = hertz();
  gap.load = 1e7;
  ASSERT_EQ(solve(normal.get(), gap), WRC_OK);
  EXPECT_EQ(number_of(normal.get(), "fill"), 1.0);
  EXPECT_LE(number_of(normal.get(), "residuals.complementarity"), gap.tolerance);
}

/// Directions of the iteration are in single precision, and other units may round their last bit
/// otherwise; so may the steps that are left when the tolerance is met.
TEST(CertifiedGaps, OtherUnitsChangeNothingBeyondRounding) {
  for (const double tolerance : {1e-3, 1e-6, 1e-13}) {
    const double permitted =
        1e-12 + static_cast<double>(std::numeric_limits<float>::epsilon()) * tolerance;
    Gap plain = hertz();
    plain.tolerance = tolerance;
    const NormalPointer normal = make_normal();
    ASSERT_EQ(solve(normal.get(), plain), WRC_OK);
    const std::vector<double> expected = pressure_of(normal.get());
    const double approach = number_of(normal.get(), "approach");
    const double largest = *std::max_element(expected.begin(), expected.end());
    for (const double length : {1e-12, 1e-3, 1.0, 1e3, 1e12}) {
      for (const double modulus : {1e-12, 1e-6, 1.0, 1e12}) {
        Gap scaled = plain;
        scaled.lateral_step *= length;
        scaled.longitudinal_step *= length;
        scaled.modulus *= modulus;
        scaled.load *= length * length * modulus;
        for (double& value : scaled.distance) {
          value *= length;
        }
        ASSERT_EQ(solve(normal.get(), scaled), WRC_OK) << wrc_normal_error(normal.get());
        const std::vector<double> found = pressure_of(normal.get());
        double difference = std::abs(number_of(normal.get(), "approach") / length / approach - 1.0);
        for (std::size_t i = 0; i < found.size(); ++i) {
          difference = std::max(difference, std::abs(found[i] / modulus - expected[i]) / largest);
        }
        EXPECT_LE(difference, permitted)
            << "tolerance " << tolerance << ", lengths x " << length << ", moduli x " << modulus;
      }
    }
  }
}

TEST(CertifiedGaps, ASecondRunChangesNoBit) {
  const Gap gap = hertz();
  const NormalPointer one = make_normal();
  ASSERT_EQ(solve(one.get(), gap), WRC_OK);
  const std::vector<double> expected = pressure_of(one.get());
  // By another handle, and by one that has solved something else in between.
  const NormalPointer other = make_normal();
  ASSERT_EQ(solve(other.get(), gap), WRC_OK);
  EXPECT_EQ(pressure_of(other.get()), expected);
  ASSERT_EQ(solve(one.get(), shaped(3.0)), WRC_OK);
  ASSERT_EQ(solve(one.get(), gap), WRC_OK);
  EXPECT_EQ(pressure_of(one.get()), expected);
}

} // namespace
} // namespace certified_gaps_test
