#include "geometry/feature_map.hpp"

#include <algorithm>

namespace wrc {

FeatureMap::FeatureMap(std::span<const double> parameters, std::span<const double> arcs)
    : is_identity_(std::equal(parameters.begin(), parameters.end(), arcs.begin(), arcs.end())),
      parameters_(parameters.begin(), parameters.end()) {
  const std::size_t intervals = parameters.size() - 1;
  const auto step = [&](std::size_t k) { return parameters[k + 1] - parameters[k]; };
  const auto chord = [&](std::size_t k) { return (arcs[k + 1] - arcs[k]) / step(k); };
  const auto slope = [&](std::size_t k) {
    const double before = chord(k > 0 ? k - 1 : k);
    const double after = chord(k < intervals ? k : k - 1);
    return 2.0 / (1.0 / before + 1.0 / after);
  };
  for (std::size_t k = 0; k < intervals; ++k) {
    polynomials_.push_back(
        quintic({arcs[k], slope(k), 0.0}, {arcs[k + 1], slope(k + 1), 0.0}, step(k)));
  }
}

} // namespace wrc
