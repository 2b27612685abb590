#include "damage/subsurface_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/vector_clones.hpp"
#include "damage/constants.hpp"

namespace wrc {
namespace {

/// Values of a line at every second point, such that its moments up to the third stay: each element
/// is distributed to the larger ones on its side, next and next but one.
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

std::size_t whole_vectors_of(std::size_t places) {
  return (places + vector_places - 1) / vector_places * vector_places;
}

std::size_t halved(std::size_t count) {
  return (count + 1) / 2 + 4;
}

/// Stresses at a row of points due to a row of elements.
template <class Real> struct RowSums {
  const Real* loads; ///< p, q_x, q_y, this number of each
  std::size_t load_count;
  std::size_t kinds;   ///< of loads: 1 or 3
  const Real* kernels; ///< of stress_kernels, pitch apart
  Real* sums;          ///< of six components, pitch apart
  std::size_t pitch;
  std::size_t places; ///< whole vectors of them, unless there is one or the stride is not 1
  std::size_t stride; ///< between points, in elements
};

/// For `block` points, whose sums stay in registers: sums[t] += loads[c] kernel[t + c].
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
WRC_VECTOR_BODY void add_below_one_place(const RowSums<Real>& row, std::size_t component,
                                         std::size_t place) {
  Real sum = 0;
  for (std::size_t kind = 0; kind < row.kinds; ++kind) {
    const Real* kernel = row.kernels + kernel_of[kind][component] * row.pitch + place * row.stride;
    const Real* loads = row.loads + kind * row.load_count;
#pragma omp simd reduction(+ : sum)
    for (std::size_t c = 0; c < row.load_count; ++c) {
      sum += loads[c] * kernel[c];
    }
  }
  row.sums[component * row.pitch + place] += sum;
}

template <class Real> WRC_VECTOR_BODY void add_row_body(const RowSums<Real>& row) {
  for (std::size_t component = 0; component < 6; ++component) {
    if (row.places == 1 || row.stride > 1) {
      for (std::size_t t = 0; t < row.places; ++t) {
        add_below_one_place(row, component, t);
      }
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
  // Rows are kept backwards: their first value is the last point.
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
  const bool in_vectors = places.x_count > 1 && places.x_stride == 1;
  const std::size_t x_count = in_vectors ? whole_vectors_of(places.x_count) : places.x_count;
  const std::size_t offsets = (x_count - 1) * places.x_stride + columns;
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
  const auto rows_at = [last = rows - 1, &places](std::size_t t, std::size_t offset) {
    return t * places.y_stride + last - offset;
  };
  const auto loaded_at = [&](std::size_t i) { // i has wrapped where there is no such row
    return i < rows ? level.last[i] - level.first[i] : 0;
  };
  bool far_is_there = false;
  for (std::size_t offset = 0; offset < rows + (places.y_count - 1) * places.y_stride; ++offset) {
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
                            x_count, places.x_stride});
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

template std::vector<Stress> SubsurfaceStress::sums<float>(const Level&, const Places&,
                                                           double) const;

} // namespace wrc
