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
  double deviation = 0.02;  ///< mm, of filtered noise before the filter
  double spacing = 0.25;    ///< of the points, mm
  double correlation = 0.0; ///< its length, mm
  std::uint64_t seed = 1;
  double cutoff = 0.0; ///< of the Gaussian filter that it went through (ISO 16610-21), mm
  double width = 0.0;  ///< of Gaussian weights that correlate it and keep its deviation, mm
  double digit = 0.0;  ///< that the points are rounded to, mm; 0: not
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

/// Values of noise at points of this distance.
inline std::vector<double> noise_values(const Noise& noise, double spacing, int count) {
  NormalSource normal(noise.seed);
  std::vector<double> values;
  // The filter of ISO 16610-21 as a normal density: alpha / sqrt(2 pi) cut-offs wide.
  const double alpha = std::sqrt(std::numbers::ln2 / std::numbers::pi);
  const double width =
      noise.cutoff > 0.0 ? noise.cutoff * alpha / std::sqrt(2.0 * std::numbers::pi) : noise.width;
  if (width > 0.0) {
    const int reach = static_cast<int>(std::ceil(4.0 * width / spacing));
    std::vector<double> weights;
    double sum = 0.0;
    double square = 0.0;
    for (int i = -reach; i <= reach; ++i) {
      weights.push_back(std::exp(-0.5 * std::pow(i * spacing / width, 2)));
      sum += weights.back();
      square += weights.back() * weights.back();
    }
    std::vector<double> white;
    for (int i = 0; i < count + 2 * reach; ++i)
      white.push_back(noise.deviation * normal());
    for (int i = 0; i < count; ++i) {
      double value = 0.0;
      for (int k = 0; k <= 2 * reach; ++k)
        value += weights[static_cast<std::size_t>(k)] * white[static_cast<std::size_t>(i + k)];
      values.push_back(value / (noise.cutoff > 0.0 ? sum : std::sqrt(square)));
    }
    return values;
  }
  const double tie = noise.correlation > 0.0 ? std::exp(-spacing / noise.correlation) : 0.0;
  double value = normal();
  for (int i = 0; i < count; ++i) {
    value = tie * value + std::sqrt(1.0 - tie * tie) * normal();
    values.push_back(noise.deviation * value);
  }
  return values;
}

inline std::vector<Position> noisy_points(const Curve& curve, const Noise& noise) {
  const auto count = static_cast<int>(std::ceil(curve.length() / noise.spacing));
  const std::vector<double> values = noise_values(noise, noise.spacing, count + 1);
  const auto rounded = [&](double value) {
    return noise.digit > 0.0 ? std::round(value / noise.digit) * noise.digit : value;
  };
  std::vector<Position> points;
  for (int i = 0; i <= count; ++i) {
    const CurvePoint at = curve.at(curve.length() * i / count);
    const double offset = values[static_cast<std::size_t>(i)];
    points.push_back({rounded(at.lateral - offset * at.tangent_height),
                      rounded(at.height + offset * at.tangent_lateral)});
  }
  return points;
}

} // namespace wrc::test
