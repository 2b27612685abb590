#include "damage/subsurface_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "base/vector_clones.hpp"
#include "damage/constants.hpp"

namespace wrc {
namespace {

/// Values of a line at every second place, such that its moments up to the third stay: what an
/// element gives to the larger ones on its side, next and next but one.
void halve(const double* fine, std::size_t count, std::size_t stride, double* coarse,
           std::size_t coarse_stride) {
  constexpr std::array weights{22.0 / 128.0, -3.0 / 128.0};
  for (std::size_t i = 0; i < count; ++i) {
    const double value = 0.5 * fine[i * stride];
    double* at = coarse + (i / 2 + weights.size()) * coarse_stride;
    const std::ptrdiff_t outwards = i % 2 == 0 ? -static_cast<std::ptrdiff_t>(coarse_stride)
                                               : static_cast<std::ptrdiff_t>(coarse_stride);
    at[0] += value;
    for (std::size_t j = 0; j < weights.size(); ++j) {
      const std::ptrdiff_t away = static_cast<std::ptrdiff_t>(j + 1) * outwards;
      at[away] += weights[j] * value;
      at[-away] -= weights[j] * value;
    }
  }
}

std::size_t halved(std::size_t count) {
  return (count + 1) / 2 + 4;
}

/// What a row of elements gives to a row of places.
template <class Real> struct RowSums {
  const Real* loads; ///< p, q_x, q_y, so many each
  std::size_t load_count;
  std::size_t kinds;   ///< of loads: 1 or 3
  const Real* kernels; ///< of stress_kernels, pitch apart
  Real* sums;          ///< of six components, pitch apart
  std::size_t pitch;
  std::size_t places; ///< one or whole vectors of them
};

/// For so many places, whose sums stay in registers: sums[t] += loads[c] kernel[t + c].
template <std::size_t block, class Real>
WRC_VECTOR_BODY void add_block(const RowSums<Real>& row, std::size_t component, std::size_t place) {
  std::array<Real, block> sums{};
  for (std::size_t kind = 0; kind < row.kinds; ++kind) {
    const Real* kernel = row.kernels + kernel_of[kind][component] * row.pitch + place;
    const Real* loads = row.loads + kind * row.load_count;
    for (std::size_t c = 0; c < row.load_count; ++c) {
#pragma omp simd
      for (std::size_t t = 0; t < block; ++t) {
        sums[t] += loads[c] * kernel[c + t];
      }
    }
  }
  Real* to = row.sums + component * row.pitch + place;
  for (std::size_t t = 0; t < block; ++t) {
    to[t] += sums[t];
  }
}

template <class Real>
WRC_VECTOR_BODY void add_below_one_place(const RowSums<Real>& row, std::size_t component) {
  Real sum = 0;
  for (std::size_t kind = 0; kind < row.kinds; ++kind) {
    const Real* kernel = row.kernels + kernel_of[kind][component] * row.pitch;
    const Real* loads = row.loads + kind * row.load_count;
#pragma omp simd reduction(+ : sum)
    for (std::size_t c = 0; c < row.load_count; ++c) {
      sum += loads[c] * kernel[c];
    }
  }
  row.sums[component * row.pitch] += sum;
}

template <class Real> WRC_VECTOR_BODY void add_row_body(const RowSums<Real>& row) {
  for (std::size_t component = 0; component < 6; ++component) {
    if (row.places == 1) {
      add_below_one_place(row, component);
      continue;
    }
    std::size_t t = 0;
    for (; t + 2 * vector_places <= row.places; t += 2 * vector_places) {
      add_block<2 * vector_places>(row, component, t);
    }
    for (; t < row.places; t += vector_places) {
      add_block<vector_places>(row, component, t);
    }
  }
}

/// Kernels of a row of elements from the corners on both of its sides.
template <class Real>
WRC_VECTOR_BODY void difference_body(const Real* far, const Real* near, std::size_t count,
                                     Real* kernel) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    kernel[i] = (near[i + 1] - near[i]) - (far[i + 1] - far[i]);
  }
}

WRC_VECTOR_CLONES void add_row(const RowSums<double>& row) {
  add_row_body(row);
}
WRC_VECTOR_CLONES void add_row(const RowSums<float>& row) {
  add_row_body(row);
}
WRC_VECTOR_CLONES void difference(const double* far, const double* near, std::size_t count,
                                  double* kernel) {
  difference_body(far, near, count, kernel);
}
WRC_VECTOR_CLONES void difference(const float* far, const float* near, std::size_t count,
                                  float* kernel) {
  difference_body(far, near, count, kernel);
}

/// Weights of the cubic through values at four places.
std::array<double, 4> cubic(const std::array<double, 4>& places, double place) {
  std::array<double, 4> weights{1.0, 1.0, 1.0, 1.0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      weights[i] *= j == i ? 1.0 : (place - places[j]) / (places[i] - places[j]);
    }
  }
  return weights;
}

/// Adds the cubic through four places of a row, which are 1 apart.
void add_interpolated(const std::vector<Stress>& row, double place, Stress& stress) {
  const double whole = std::clamp(std::floor(place), 1.0, static_cast<double>(row.size()) - 3.0);
  const std::array weights = cubic({-1.0, 0.0, 1.0, 2.0}, place - whole);
  const Stress* from = row.data() + static_cast<std::size_t>(whole) - 1;
  for (std::size_t c = 0; c < stress.size(); ++c) {
    stress[c] += weights[0] * from[0][c] + weights[1] * from[1][c] + weights[2] * from[2][c] +
                 weights[3] * from[3][c];
  }
}

/// Which of some rising depths are a share of themselves apart, with the first and the last; all
/// where these are too few for cubics between them.
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

SubsurfaceStress::SubsurfaceStress(const SurfaceLoads& loads, double poisson) : poisson_(poisson) {
  const Grid& grid = loads.grid;
  const std::array given{loads.pressure, loads.traction_x, loads.traction_y};
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (given[k].size() != grid.element_count() && (k == 0 || !given[k].empty())) {
      throw_invalid_argument(k == 0 ? "pressure" : "traction", static_cast<double>(given[k].size()),
                             "must have one value per element of the grid");
    }
    tractions_ = tractions_ || (k > 0 && !given[k].empty());
  }
  // The part that holds loads.
  std::array<std::size_t, 2> rows{grid.lateral_count, 0};
  std::array<std::size_t, 2> columns{grid.longitudinal_count, 0};
  for (const auto& load : given) {
    for (std::size_t i = 0; i < load.size(); ++i) {
      if (load[i] != 0.0) {
        const std::size_t row = i / grid.longitudinal_count;
        const std::size_t column = i % grid.longitudinal_count;
        rows = {std::min(rows[0], row), std::max(rows[1], row + 1)};
        columns = {std::min(columns[0], column), std::max(columns[1], column + 1)};
      }
    }
  }
  if (rows[1] == 0) { // nothing anywhere: one element of it
    rows = columns = {0, 1};
  }
  Level& level = levels_.emplace_back();
  level.grid = {rows[1] - rows[0],      columns[1] - columns[0], grid.lateral_step,
                grid.longitudinal_step, grid.lateral(rows[0]),   grid.longitudinal(columns[0])};
  for (std::size_t k = 0; k < given.size(); ++k) {
    level.loads[k].resize(level.grid.element_count());
    for (std::size_t i = rows[0]; !given[k].empty() && i < rows[1]; ++i) {
      const auto row = given[k].begin() + static_cast<std::ptrdiff_t>(i * grid.longitudinal_count);
      std::reverse_copy(
          row + static_cast<std::ptrdiff_t>(columns[0]),
          row + static_cast<std::ptrdiff_t>(columns[1]),
          level.loads[k].begin() +
              static_cast<std::ptrdiff_t>((i - rows[0]) * level.grid.longitudinal_count));
    }
  }
  make_levels();
}

void SubsurfaceStress::make_levels() {
  find_extents(levels_.front());
  const Grid& finest = levels_.front().grid;
  for (std::size_t across = std::min(finest.lateral_count, finest.longitudinal_count);
       across >= 2 * coarsest_elements; across /= 2) {
    levels_.push_back(coarsened(levels_.back()));
    find_extents(levels_.back());
  }
}

SubsurfaceStress::Level SubsurfaceStress::coarsened(const Level& fine) {
  Level level;
  const std::size_t rows = fine.grid.lateral_count;
  const std::size_t columns = fine.grid.longitudinal_count;
  Grid& grid = level.grid;
  grid.lateral_count = halved(rows);
  grid.longitudinal_count = halved(columns);
  grid.lateral_step = 2.0 * fine.grid.lateral_step;
  grid.longitudinal_step = 2.0 * fine.grid.longitudinal_step;
  grid.lateral_first = fine.grid.lateral_first - 1.75 * grid.lateral_step;
  // Rows are kept backwards: their first value is the last place.
  const double last = fine.grid.longitudinal(columns - 1) + 1.75 * grid.longitudinal_step;
  grid.longitudinal_first =
      last - static_cast<double>(grid.longitudinal_count - 1) * grid.longitudinal_step;
  std::vector<double> between(rows * grid.longitudinal_count);
  for (std::size_t k = 0; k < 3; ++k) {
    std::fill(between.begin(), between.end(), 0.0);
    for (std::size_t i = 0; i < rows; ++i) {
      halve(fine.loads[k].data() + i * columns, columns, 1,
            between.data() + i * grid.longitudinal_count, 1);
    }
    level.loads[k].assign(grid.element_count(), 0.0);
    for (std::size_t j = 0; j < grid.longitudinal_count; ++j) {
      halve(between.data() + j, rows, grid.longitudinal_count, level.loads[k].data() + j,
            grid.longitudinal_count);
    }
  }
  return level;
}

void SubsurfaceStress::find_extents(Level& level) {
  const std::size_t columns = level.grid.longitudinal_count;
  level.first.assign(level.grid.lateral_count, 0);
  level.last.assign(level.grid.lateral_count, 0);
  for (std::size_t i = 0; i < level.grid.lateral_count; ++i) {
    const auto holds = [&](std::size_t j) {
      return std::any_of(std::begin(level.loads), std::end(level.loads),
                         [&](const auto& load) { return load[i * columns + j] != 0.0; });
    };
    std::size_t last = columns;
    while (last > 0 && !holds(last - 1)) {
      --last;
    }
    std::size_t first = 0;
    while (first < last && !holds(first)) {
      ++first;
    }
    level.first[i] = first;
    level.last[i] = last;
  }
}

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

double SubsurfaceStress::Level::size() const {
  return std::max(grid.longitudinal_step, grid.lateral_step);
}

const SubsurfaceStress::Level& SubsurfaceStress::level_for(double depth, double sizes) const {
  std::size_t i = levels_.size() - 1;
  while (i > 0 && depth < sizes * levels_[i].size()) {
    --i;
  }
  return levels_[i];
}

template <class Real>
std::vector<Stress> SubsurfaceStress::sums(const Level& level, const Places& places,
                                           double depth) const {
  // In units of the longitudinal step.
  const Grid& grid = level.grid;
  const std::size_t columns = grid.longitudinal_count;
  const std::size_t rows = grid.lateral_count;
  const double unit = grid.longitudinal_step;
  const double z = std::max(depth, least_depth * std::min(unit, grid.lateral_step)) / unit;
  const double width = grid.lateral_step / unit;
  // Whole vectors of places, unless there is one only.
  const std::size_t x_count =
      places.x_count == 1 ? 1
                          : (places.x_count + vector_places - 1) / vector_places * vector_places;
  const std::size_t offsets = x_count + columns - 1;
  const std::size_t pitch = offsets + 1;
  const std::size_t kinds = tractions_ ? 3 : 1;
  std::vector<Real> memory((3 * stress_kernels + 6 * places.y_count) * pitch + 3 * columns);
  Real* near = memory.data(); // corners on the side of small y of elements
  Real* far = near + stress_kernels * pitch;
  Real* kernels = far + stress_kernels * pitch;
  Real* sum = kernels + stress_kernels * pitch;
  Real* loads = sum + 6 * places.y_count * pitch;
  const double x_corner = (places.x_first - grid.longitudinal(columns - 1)) / unit - 0.5;
  const double y_least = (places.y_first - grid.lateral(rows - 1)) / unit;
  const auto corners = [&](double y, Real* to) {
    stress_corners(static_cast<Real>(x_corner), Real(1), pitch, static_cast<Real>(y),
                   static_cast<Real>(z), static_cast<Real>(poisson_), tractions_, to, pitch);
  };
  const auto rows_at = [&](std::size_t t, std::size_t offset) { return t + rows - 1 - offset; };
  const auto loaded_at = [&](std::size_t i) { // i has wrapped where there is no such row
    return i < rows ? level.last[i] - level.first[i] : 0;
  };
  bool far_is_there = false;
  for (std::size_t offset = 0; offset < rows + places.y_count - 1; ++offset) {
    bool needed = false;
    for (std::size_t t = 0; t < places.y_count && !needed; ++t) {
      needed = loaded_at(rows_at(t, offset)) > 0;
    }
    if (!needed) {
      far_is_there = false;
      continue;
    }
    if (!far_is_there) {
      corners(y_least + (static_cast<double>(offset) - 0.5) * width, far);
    }
    far_is_there = true;
    corners(y_least + (static_cast<double>(offset) + 0.5) * width, near);
    for (std::size_t k = 0; k < (tractions_ ? stress_kernels : 6); ++k) {
      difference(far + k * pitch, near + k * pitch, offsets, kernels + k * pitch);
    }
    std::swap(near, far);
    for (std::size_t t = 0; t < places.y_count; ++t) {
      const std::size_t i = rows_at(t, offset);
      const std::size_t loaded = loaded_at(i);
      if (loaded == 0) {
        continue;
      }
      const std::size_t first = level.first[i];
      for (std::size_t kind = 0; kind < kinds; ++kind) {
        const auto from =
            level.loads[kind].begin() + static_cast<std::ptrdiff_t>(i * columns + first);
        std::transform(from, from + static_cast<std::ptrdiff_t>(loaded), loads + kind * loaded,
                       [](double value) { return static_cast<Real>(value); });
      }
      add_row(RowSums<Real>{loads, loaded, kinds, kernels + first, sum + 6 * t * pitch, pitch,
                            x_count});
    }
  }
  std::vector<Stress> stresses(places.x_count * places.y_count);
  for (std::size_t t = 0; t < places.y_count; ++t) {
    for (std::size_t j = 0; j < places.x_count; ++j) {
      for (std::size_t c = 0; c < 6; ++c) {
        stresses[t * places.x_count + j][c] = static_cast<double>(sum[(6 * t + c) * pitch + j]);
      }
    }
  }
  return stresses;
}

Stress SubsurfaceStress::point(const Level& level, double x, double y, double depth) const {
  return sums<float>(level, {x, 1, y, 1}, depth).front();
}

Stress SubsurfaceStress::at(double x, double y, double depth) const {
  return sums<double>(levels_.front(), {x, 1, y, 1}, depth).front();
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

template std::vector<Stress> SubsurfaceStress::sums<float>(const Level&, const Places&,
                                                           double) const;

} // namespace wrc
