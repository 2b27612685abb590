/// Points of a curve with noise along its normals, the same in each run.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "profile/curve.hpp"

namespace wrc::test {

struct Noise {
  double deviation = 0.02;  ///< mm
  double spacing = 0.25;    ///< of the points, mm
  double correlation = 0.0; ///< its length, mm
  std::uint64_t seed = 1;
};

/// Normal numbers by Box and Muller, the same with every standard library.
class NormalSource {
public:
  explicit NormalSource(std::uint64_t seed) : engine_(seed * 7919) {}
  double operator()() {
    return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * std::numbers::pi * uniform());
  }

private:
  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 engine_;
};

inline std::vector<Position> noisy_points(const Curve& curve, const Noise& noise) {
  NormalSource normal(noise.seed);
  const auto count = static_cast<int>(std::ceil(curve.length() / noise.spacing));
  const double tie = noise.correlation > 0.0 ? std::exp(-noise.spacing / noise.correlation) : 0.0;
  double value = normal();
  std::vector<Position> points;
  for (int i = 0; i <= count; ++i) {
    const CurvePoint at = curve.at(curve.length() * i / count);
    value = tie * value + std::sqrt(1.0 - tie * tie) * normal();
    const double offset = noise.deviation * value;
    points.push_back(
        {at.lateral - offset * at.tangent_height, at.height + offset * at.tangent_lateral});
  }
  return points;
}

} // namespace wrc::test
