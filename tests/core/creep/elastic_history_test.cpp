// Where the displacements of an earlier step are found again.
#include "creep/elastic_history.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/rail_surface.hpp"
#include "profile/standard_profiles.hpp"
#include "records/wheel_result.hpp"

namespace wrc::test::elastic_history_test {
namespace {

constexpr double length = 2.0; // of the step, mm

Grid grid_at(double x, double y) {
  return {5, 7, 0.5, 0.4, y, x};
}

ContactFrame frame_at(const RailSurface& rail, double along, double across, double angle = 0.0) {
  return tangent_frame({along, rail.origin_y() + across * std::cos(angle),
                        rail.origin_z() + across * std::sin(angle)},
                       angle);
}

class ElasticHistory : public testing::Test {
protected:
  ElasticHistory() {
    PatchHistory patch{frame_at(rail_, 0.0, 1.0), grid_at(-1.2, -1.0), {}, {}};
    patch.frame.origin = patch.frame.origin - Vector3{0.0, rail_.origin_y(), rail_.origin_z()};
    for (std::size_t at = 0; at < patch.grid.element_count(); ++at) { // linear in x and y
      patch.x.push_back(x_at(patch.grid.longitudinal(at % 7), patch.grid.lateral(at / 7)));
      patch.y.push_back(2.0 * patch.x.back());
    }
    history_.push_back(patch);
  }
  static double x_at(double x, double y) { return 3.0 + 0.5 * x - 2.0 * y; }

  RailSurface rail_{standard_profile("60E1"), {}};
  WheelHistory history_;
};

TEST_F(ElasticHistory, StaysWithTheRailAndUnderTheWheelset) {
  const RailSurface moved = rail_.displaced({7.0, -3.0, 0.0});
  for (const RailSurface* rail : std::array<const RailSurface*, 2>{&rail_, &moved}) {
    // The plane's origin 0.3 mm ahead and 0.2 mm beside, another grid.
    const ContactFrame frame = frame_at(*rail, 0.3, 1.2);
    const Grid grid{3, 4, 0.3, 0.35, -0.5, -0.9};
    SlipField slip;
    slip.x.assign(grid.element_count(), 10.0);
    add_history(history_, *rail, frame, grid, length, slip);
    ASSERT_EQ(slip.y.size(), grid.element_count());
    for (std::size_t at = 0; at < grid.element_count(); ++at) {
      const double value =
          x_at(grid.longitudinal(at % 4) + 0.3, grid.lateral(at / 4) + 0.2) / length;
      EXPECT_NEAR(slip.x[at], 10.0 - value, 1e-9);
      EXPECT_NEAR(slip.y[at], -2.0 * value, 1e-9);
    }
  }
}

TEST_F(ElasticHistory, OnTheSameGridKeepsItsValues) {
  SlipField slip;
  const Grid grid = history_[0].grid;
  add_history(history_, rail_, frame_at(rail_, 0.0, 1.0), grid, length, slip);
  for (std::size_t at = 0; at < grid.element_count(); ++at) {
    EXPECT_NEAR(slip.x[at], -history_[0].x[at] / length, 1e-9);
  }
}

/// Positions on a curve are arcs, not their projections on the plane.
TEST_F(ElasticHistory, AlongACurveKeepsItsValuesOnTheSameGrid) {
  std::vector<ContactCurve::Node> nodes; // the curvature is 0.2 per mm
  for (int i = -32; i <= 32; ++i) {
    const double y = 0.1 * i;
    nodes.push_back({y, 0.1 * y * y, 0.2 * y});
  }
  const auto curve = std::make_shared<const ContactCurve>(nodes);
  history_[0].frame.curve = curve;
  ContactFrame frame = frame_at(rail_, 0.0, 1.0);
  frame.curve = curve;
  SlipField slip;
  add_history(history_, rail_, frame, history_[0].grid, length, slip);
  for (std::size_t at = 0; at < slip.x.size(); ++at) {
    EXPECT_NEAR(slip.x[at], -history_[0].x[at] / length, 1e-6);
  }
}

TEST_F(ElasticHistory, BeyondItsElementsIsThatOfTheNearest) {
  SlipField slip;
  const Grid grid = grid_at(-2.2, -1.0); // begins 1 mm further behind
  add_history(history_, rail_, frame_at(rail_, 0.0, 1.0), grid, length, slip);
  EXPECT_NEAR(slip.x[0], -x_at(-1.2, -1.0) / length, 1e-9);
}

TEST_F(ElasticHistory, APatchElsewhereHasNone) {
  SlipField slip;
  for (const double across : {4.0, -40.0}) {
    add_history(history_, rail_, frame_at(rail_, 0.0, across), grid_at(-1.2, -1.0), length, slip);
    for (const double value : slip.x) {
      EXPECT_EQ(value, 0.0);
    }
  }
  // Of two, the nearer one's.
  PatchHistory other = history_[0];
  other.frame.origin.y += 1.5;
  other.x.assign(other.x.size(), 1.0);
  history_.push_back(other);
  add_history(history_, rail_, frame_at(rail_, 0.0, 2.4), grid_at(-1.2, -1.0), length, slip);
  EXPECT_NEAR(slip.x[0], -1.0 / length, 1e-12);
}

TEST_F(ElasticHistory, IsKeptOfPatchesWithDisplacements) {
  WheelResult wheel;
  wheel.details.rail = std::make_shared<const RailSurface>(rail_);
  wheel.patches.resize(2);
  for (PatchResult& patch : wheel.patches) {
    patch.frame = frame_at(rail_, 0.0, 1.0);
    patch.creep.emplace().grid = history_[0].grid;
  }
  wheel.patches[1].creep->displacement_x = history_[0].x;
  wheel.patches[1].creep->displacement_y = history_[0].y;
  const WheelHistory kept = history_of(wheel);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].x, history_[0].x);
  EXPECT_NEAR(kept[0].frame.origin.y, history_[0].frame.origin.y, 1e-12);
}

} // namespace
} // namespace wrc::test::elastic_history_test
