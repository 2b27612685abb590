// Stresses in a plane across the contact: shallow depths on the elements, deeper ones on larger
// elements with the same moments, cubics between depths.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "damage/constants.hpp"
#include "damage/subsurface_stress.hpp"

namespace wrc {
namespace {

/// Weights of the cubic through values at four points.
std::array<double, 4> cubic(const std::array<double, 4>& places, double place) {
  std::array<double, 4> weights{1.0, 1.0, 1.0, 1.0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      weights[i] *= j == i ? 1.0 : (place - places[j]) / (places[i] - places[j]);
    }
  }
  return weights;
}

/// Adds the cubic through four points of a row, which are 1 apart.
void add_interpolated(const std::vector<Stress>& row, double place, Stress& stress) {
  const double whole = std::clamp(std::floor(place), 1.0, static_cast<double>(row.size()) - 3.0);
  const std::array weights = cubic({-1.0, 0.0, 1.0, 2.0}, place - whole);
  const Stress* from = row.data() + static_cast<std::size_t>(whole) - 1;
  for (std::size_t c = 0; c < stress.size(); ++c) {
    stress[c] += weights[0] * from[0][c] + weights[1] * from[1][c] + weights[2] * from[2][c] +
                 weights[3] * from[3][c];
  }
}

/// Selects from rising depths those that differ by at least a given ratio, with the first and the
/// last; all where these are too few for cubics between them.
std::vector<std::size_t> depths_to_compute(std::span<const double> depths) {
  std::vector<std::size_t> computed;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (computed.empty() || i + 1 == depths.size() ||
        depths[i + 1] - depths[computed.back()] > depth_spacing * depths[i]) {
      computed.push_back(i);
    }
  }
  if (computed.size() < 4) {
    computed.resize(depths.size());
    std::iota(computed.begin(), computed.end(), std::size_t{0});
  }
  return computed;
}

/// Stresses at the other depths: cubics through the four that are next.
void fill_between(const std::vector<std::size_t>& computed, StressSection& section) {
  const std::size_t count = section.places.size();
  for (std::size_t k = 0; k + 1 < computed.size(); ++k) {
    const std::size_t start =
        std::min(k == 0 ? 0 : k - 1, computed.size() - std::min<std::size_t>(computed.size(), 4));
    for (std::size_t i = computed[k] + 1; i < computed[k + 1]; ++i) {
      std::array<double, 4> places{};
      std::array<const Stress*, 4> from{};
      for (std::size_t m = 0; m < 4; ++m) {
        places[m] = section.depths[computed[start + m]];
        from[m] = section.stresses.data() + computed[start + m] * count;
      }
      const std::array weights = cubic(places, section.depths[i]);
      for (std::size_t j = 0; j < count; ++j) {
        for (std::size_t c = 0; c < 6; ++c) {
          section.stresses[i * count + j][c] =
              weights[0] * from[0][j][c] + weights[1] * from[1][j][c] + weights[2] * from[2][j][c] +
              weights[3] * from[3][j][c];
        }
      }
    }
  }
}

/// With x and y exchanged.
Stress exchanged(const Stress& s) {
  return {s[yy], s[xx], s[zz], s[xy], s[yz], s[xz]};
}

} // namespace

SubsurfaceStress SubsurfaceStress::transposed() const {
  SubsurfaceStress other;
  other.poisson_ = poisson_;
  other.tractions_ = tractions_;
  const Level& from = levels_.front();
  Level& level = other.levels_.emplace_back();
  const std::size_t rows = from.grid.lateral_count;
  const std::size_t columns = from.grid.longitudinal_count;
  level.grid = {columns,
                rows,
                from.grid.longitudinal_step,
                from.grid.lateral_step,
                from.grid.longitudinal_first,
                from.grid.lateral_first};
  constexpr std::array<std::size_t, 3> taken{0, 2, 1};
  for (std::size_t k = 0; k < taken.size(); ++k) {
    level.loads[k].resize(rows * columns);
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        level.loads[k][(columns - 1 - j) * rows + (rows - 1 - i)] =
            from.loads[taken[k]][i * columns + j];
      }
    }
  }
  other.make_levels();
  return other;
}

std::vector<SubsurfaceStress::Level> SubsurfaceStress::seen_from(const Level& level, double y) {
  std::vector<Level> parts;
  Level rest = level;
  for (;;) {
    if (rest.grid.lateral_count < rows_worth_splitting) {
      parts.push_back(std::move(rest));
      return parts;
    }
    const double reach = 2.0 * depth_of_element * rest.size();
    Level near = rest;
    bool more = false;
    for (std::size_t i = 0; i < rest.grid.lateral_count; ++i) {
      const bool is_near = std::abs(rest.grid.lateral(i) - y) < reach;
      more = more || (!is_near && rest.last[i] > rest.first[i]);
      Level& other = is_near ? rest : near;
      for (auto& load : other.loads) {
        const auto row =
            load.begin() + static_cast<std::ptrdiff_t>(i * rest.grid.longitudinal_count);
        std::fill_n(row, rest.grid.longitudinal_count, 0.0);
      }
      other.first[i] = other.last[i] = 0;
    }
    parts.push_back(std::move(near));
    if (!more) {
      return parts;
    }
    rest = coarsened(rest);
    find_extents(rest);
  }
}

StressSection SubsurfaceStress::along(std::span<const double> x, double y,
                                      std::span<const double> depths) const {
  StressSection section{{x.begin(), x.end()}, {depths.begin(), depths.end()}, {}};
  section.stresses.resize(x.size() * depths.size());
  std::vector<std::vector<Level>> parts(levels_.size());
  const std::vector<std::size_t> computed = depths_to_compute(depths);
  for (const std::size_t i : computed) {
    const Level& level = level_for(depths[i], depth_of_element);
    auto& seen = parts[static_cast<std::size_t>(&level - levels_.data())];
    if (seen.empty()) {
      seen = seen_from(level, y);
    }
    for (const Level& part : seen) {
      const double step = part.grid.longitudinal_step;
      // Below the centres of elements, and one more on each side.
      const double first =
          part.grid.longitudinal_first +
          (std::floor((x.front() - part.grid.longitudinal_first) / step) - 1.0) * step;
      const auto count = static_cast<std::size_t>(std::ceil((x.back() - first) / step)) + 3;
      const std::vector<Stress> line = sums<float>(part, {first, count, y, 1}, depths[i]);
      for (std::size_t j = 0; j < x.size(); ++j) {
        add_interpolated(line, (x[j] - first) / step, section.stresses[i * x.size() + j]);
      }
    }
  }
  fill_between(computed, section);
  return section;
}

StressSection SubsurfaceStress::across(std::span<const double> y, double x,
                                       std::span<const double> depths) const {
  StressSection section = transposed().along(y, x, depths);
  for (Stress& stress : section.stresses) {
    stress = exchanged(stress);
  }
  return section;
}

} // namespace wrc
