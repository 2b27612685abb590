// Tables of the built-in profiles: segments join, have their radii, and curves are drawn by them.
#include "profile/standard_table.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace wrc::test::standard_table_test {
namespace {

/// Gap that profiles of standards state in their files, mm.
constexpr double stated_gap = 0.05;

double polynomial(const TableSegment& segment, double lateral) {
  double value = 0.0;
  for (std::size_t i = segment.coefficient_count; i-- > 0;) {
    value = value * (lateral - segment.expansion_point) + segment.coefficients[i];
  }
  return value;
}

std::array<double, 2> end_of(const TableSegment& segment, bool last) {
  const std::array<double, 2>& end = last ? segment.end : segment.start;
  return segment.type == TableSegment::Type::polynomial
             ? std::array{end[0], polynomial(segment, end[0])}
             : end;
}

TEST(StandardTable, SegmentsJoin) {
  for (const TableProfile& profile : standard_table()) {
    ASSERT_FALSE(profile.segments.empty()) << profile.name;
    for (std::size_t i = 0; i + 1 < profile.segments.size(); ++i) {
      const auto end = end_of(profile.segments[i], true);
      const auto begin = end_of(profile.segments[i + 1], false);
      EXPECT_LT(std::hypot(begin[0] - end[0], begin[1] - end[1]), stated_gap)
          << profile.name << ' ' << profile.segments[i].label;
    }
  }
}

TEST(StandardTable, ArcsHaveTheirRadii) {
  std::size_t arcs = 0;
  for (const TableProfile& profile : standard_table()) {
    for (const TableSegment& segment : profile.segments) {
      if (segment.type != TableSegment::Type::arc) {
        continue;
      }
      ++arcs;
      for (const auto& end : {segment.start, segment.end}) {
        EXPECT_NEAR(std::hypot(end[0] - segment.centre[0], end[1] - segment.centre[1]),
                    std::abs(segment.radius), stated_gap)
            << profile.name << ' ' << segment.label;
      }
    }
  }
  EXPECT_GT(arcs, 50U);
}

TEST(StandardTable, NamesAreDistinctAndSourcesAreGiven) {
  std::set<std::string_view> names;
  for (const TableProfile& profile : standard_table()) {
    EXPECT_TRUE(names.insert(profile.name).second) << profile.name;
    EXPECT_FALSE(profile.source.empty()) << profile.name;
    EXPECT_FALSE(profile.confidence.empty()) << profile.name;
  }
}

} // namespace
} // namespace wrc::test::standard_table_test
