/// Wheels drawn at random, and quantiles of what comes out.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "scene/solve_scene.hpp"

namespace wrc::test {

class Draw {
public:
  explicit Draw(unsigned seed = 1) : random_(seed) {}
  /// A left wheel, S1002 and LMA in turn on four rails, up to flange contact, under 20 to 130 kN.
  Scene wheel(int index) {
    constexpr std::array<const char*, 4> rails{"60E1", "CHN60", "54E1", "60E2"};
    Scene scene;
    const bool lma = index % 2 != 0;
    scene.left.wheel.name = scene.right.wheel.name = lma ? "LMA" : "S1002";
    scene.left.rail.name = scene.right.rail.name = rails[static_cast<std::size_t>(index / 2) % 4];
    scene.back_to_back = lma ? 1353.0 : 1360.0;
    scene.lateral = between(-7.0, 7.0);
    scene.yaw = between(-0.01, 0.01);
    scene.left.load = scene.right.load = std::pow(10.0, between(4.3, 5.1));
    scene.side = SideChoice::left;
    return scene;
  }
  double between(double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(random_);
  }

private:
  std::mt19937_64 random_;
};

inline double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

} // namespace wrc::test
