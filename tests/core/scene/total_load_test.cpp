/// The search for loads on the pressures, with totals in closed form.
#include "scene/total_load.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace wrc {
namespace {

constexpr double target = 80e3;
constexpr double tolerance = 1e-6; ///< as scene/total_load.hpp states

/// Solutions that it takes until a total is met; the load is left in `search`.
template <class Total> int solutions(LoadSearch& search, double accuracy, const Total& total) {
  for (int count = 1;; ++count) {
    if (search.is_met_by(total(search.load()), accuracy, "load.left")) {
      return count;
    }
  }
}

TEST(LoadSearch, TakesOneSolutionWithoutCreepForcesAndTwoWithSliding) {
  LoadSearch nothing(target);
  EXPECT_EQ(solutions(nothing, 1e-3, [](double load) { return load; }), 1);
  EXPECT_EQ(nothing.load(), target);
  LoadSearch sliding(target);
  EXPECT_EQ(solutions(sliding, 1e-3, [](double load) { return 0.86 * load; }), 2);
  EXPECT_NEAR(sliding.load(), target / 0.86, tolerance * target);
}

/// Without slip tangential forces grow as the load to the power 2/3.
TEST(LoadSearch, TakesFewSolutionsInAdhesion) {
  for (const double share : {-0.5, -0.15, -0.02, 0.02, 0.15, 1.0}) {
    const auto total = [share](double load) {
      return load + share * target * std::cbrt(load * load / (target * target));
    };
    LoadSearch search(target);
    EXPECT_LE(solutions(search, 1e-3, total), std::abs(share) < 0.2 ? 4 : 6) << share;
    EXPECT_NEAR(total(search.load()), target, tolerance * target);
  }
}

TEST(LoadSearch, FindsALoadFarAboveTheTotal) {
  LoadSearch search(target);
  EXPECT_LE(solutions(search, 1e-3, [](double load) { return 0.07 * load; }), 5);
  EXPECT_NEAR(0.07 * search.load(), target, tolerance * target);
}

/// No load is better than the jump leaves it; that stays below the accuracy.
TEST(LoadSearch, EndsAtAJump) {
  constexpr double accuracy = 1e-2;
  for (const double jump : {0.5e-4, 0.5e-2}) {
    const auto total = [jump](double load) {
      return load + (load < 1.01 * target ? -1.0 - jump : -1.0 + jump) * 0.01 * target;
    };
    LoadSearch search(target);
    EXPECT_LE(solutions(search, accuracy, total), 40);
    EXPECT_NEAR(total(search.load()), target, accuracy * target);
  }
}

TEST(LoadSearch, RefusesATotalThatNoLoadGives) {
  const auto expect_refused = [](auto&& total) {
    LoadSearch search(target);
    try {
      solutions(search, 1e-3, total);
      ADD_FAILURE() << "a load was found: " << search.load();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
      EXPECT_NE(std::string(error.what()).find("load.left = 80000"), std::string::npos);
    }
  };
  expect_refused([](double load) { return -0.5 * load; });
  expect_refused([](double load) { return 0.02 * load; });
  expect_refused([](double load) { return load < 0.9 * target ? 0.5 * load : 1.5 * load; });
  expect_refused([](double /*load*/) { return std::nan(""); });
}

TEST(JointLoadSearch, FindsLoadsThatDependOnEachOther) {
  const WheelNumbers totals{80e3, 60e3};
  const auto carried = [](const WheelNumbers& loads) {
    const double mean = std::sqrt(loads[0] * loads[1]);
    return WheelNumbers{0.8 * loads[0] + 0.1 * mean, 1.15 * loads[1] - 0.08 * mean};
  };
  JointLoadSearch search(totals);
  int count = 1;
  while (!search.are_met_by(carried(search.loads()), 1e-3)) {
    ++count;
  }
  EXPECT_LE(count, 7);
  const WheelNumbers found = carried(search.loads());
  EXPECT_NEAR(found[0], totals[0], tolerance * totals[0]);
  EXPECT_NEAR(found[1], totals[1], tolerance * totals[1]);
}

TEST(JointLoadSearch, RefusesTotalsThatNoLoadsGive) {
  for (const double slope : {-0.4, std::nan("")}) {
    JointLoadSearch search({80e3, 60e3});
    const auto seek = [&] {
      while (!search.are_met_by({slope * search.loads()[0], search.loads()[1]}, 1e-3)) {
      }
    };
    EXPECT_THROW(seek(), Error) << slope;
  }
}

TEST(WheelLoads, AreThoseOfTheSceneIfNoTotalIsGiven) {
  Scene scene;
  scene.left.load = 5e4;
  WheelLoads loads(scene, true, true);
  EXPECT_EQ(loads.load(0), 5e4);
  EXPECT_TRUE(loads.any_open());
  EXPECT_FALSE(loads.are_sought());
  loads.take({4e4, 8e4});
  EXPECT_FALSE(loads.any_open());
}

TEST(WheelLoads, AreFoundForTheSolvedWheels) {
  Scene scene;
  scene.load_of = LoadOf::total;
  scene.left.load = 5e4;
  scene.right.load = 6e4;
  WheelLoads loads(scene, true, false);
  EXPECT_TRUE(loads.are_sought());
  EXPECT_FALSE(loads.is_open(1));
  loads.take({4e4, 0.0});
  EXPECT_TRUE(loads.is_open(0));
  EXPECT_NEAR(loads.load(0), 62.5e3, 1.0);
  loads.take({5e4, 0.0});
  EXPECT_FALSE(loads.any_open());
}

} // namespace
} // namespace wrc
