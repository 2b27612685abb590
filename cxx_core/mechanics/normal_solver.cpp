#include "mechanics/normal_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mechanics/cascade.hpp"
#include "mechanics/projected_cg.hpp"
#include "vector_clones.hpp"

namespace wrc {

namespace {

/// Error of p at which a coarser grid is left: what refining adds is about as much.
constexpr double coarse_tolerance = 1e-2;
/// Elements around the pressures found on the coarser grid.
constexpr std::size_t box_margin = 2;
/// The free step leaves an error of 0.1 to 0.6 of max|z|, in flat punches and very narrow contacts
/// up to 1.9 (at loose tolerances): less than 1 is needed for the tolerance to hold.
constexpr double stop_share = 0.75;
/// Overlap outside the rectangle that counts as contact left out, as a share of the approach: a
/// little above the rounding of single precision. Where the tolerance asks for less, double
/// precision is used.
constexpr double missed_overlap = 5e-7;
/// The same for double precision.
constexpr double double_overlap = 1e-13;
/// A start serves grids whose elements have at least this share of the area of its own.
constexpr double start_coarseness = 0.15;
/// Share of elements below the distance from which the first pressures are drawn.
constexpr double start_quantile = 0.2;
/// Memory for tables and spectra kept between calls.
constexpr std::size_t kept_bytes = std::size_t{256} << 20;

/// One grid of the cascade, in its own unit of length.
struct Level {
  LevelSize size;
  std::vector<double> distance;
  std::vector<double> pressure;
  std::optional<double> pressure_sum;
  double approach = 0.0;
};

double sum_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum;
}

/// Pressures like Hertz's over the elements below a quantile of the distance; even ones where
/// nothing lies below it (a punch).
void start_pressure(Level& level) {
  level.pressure.assign(level.size.count(), 0.0);
  if (!level.pressure_sum) {
    return; // the approach is given: the first residual tells where contact is
  }
  std::vector<double> ordered = level.distance;
  const auto rank =
      static_cast<std::ptrdiff_t>(start_quantile * static_cast<double>(ordered.size() - 1));
  std::nth_element(ordered.begin(), ordered.begin() + rank, ordered.end());
  const double height = ordered[static_cast<std::size_t>(rank)];
  for (std::size_t i = 0; i < level.pressure.size(); ++i) {
    level.pressure[i] = std::sqrt(std::max(0.0, height - level.distance[i]));
  }
  double sum = sum_of(level.pressure);
  if (sum == 0.0) {
    for (std::size_t i = 0; i < level.pressure.size(); ++i) {
      level.pressure[i] = level.distance[i] <= height ? 1.0 : 0.0;
    }
    sum = sum_of(level.pressure);
  }
  for (double& value : level.pressure) {
    value *= *level.pressure_sum / sum;
  }
}

void copy_box(const LevelSize& size, const ElementBox& box, std::span<const double> field,
              std::vector<double>& inside) {
  inside.resize(box.rows() * box.columns());
  for (std::size_t row = 0; row < box.rows(); ++row) {
    std::copy_n(field.data() + (box.first_row + row) * size.columns + box.first_column,
                box.columns(), inside.data() + row * box.columns());
  }
}

void put_box(const LevelSize& size, const ElementBox& box, std::span<const double> inside,
             std::vector<double>& field) {
  for (std::size_t row = 0; row < box.rows(); ++row) {
    std::copy_n(inside.data() + row * box.columns(), box.columns(),
                field.data() + (box.first_row + row) * size.columns + box.first_column);
  }
}

ElementBox whole(const LevelSize& size) {
  return {0, size.rows - 1, 0, size.columns - 1};
}

void include(ElementBox& box, const ElementBox& other) {
  box.first_row = std::min(box.first_row, other.first_row);
  box.last_row = std::max(box.last_row, other.last_row);
  box.first_column = std::min(box.first_column, other.first_column);
  box.last_column = std::max(box.last_column, other.last_column);
}

/// Moves the sides that contact has reached outwards.
ElementBox grown(const ElementBox& box, const BoxOutcome& outcome, const LevelSize& size) {
  constexpr std::size_t least_growth = 4;
  const std::size_t by_rows = std::max(least_growth, box.rows() / 4);
  const std::size_t by_columns = std::max(least_growth, box.columns() / 4);
  ElementBox larger = box;
  if (outcome.reached_first_row) {
    larger.first_row -= std::min(larger.first_row, by_rows);
  }
  if (outcome.reached_last_row) {
    larger.last_row = std::min(larger.last_row + by_rows, size.rows - 1);
  }
  if (outcome.reached_first_column) {
    larger.first_column -= std::min(larger.first_column, by_columns);
  }
  if (outcome.reached_last_column) {
    larger.last_column = std::min(larger.last_column + by_columns, size.columns - 1);
  }
  return larger;
}

/// An aspect ratio without its last bits, so that grids whose steps were multiplied out with
/// different roundings share their influence coefficients.
double rounded_aspect(double aspect) {
  constexpr double bits = 0x1p48;
  int exponent = 0;
  const double fraction = std::frexp(aspect, &exponent);
  return std::ldexp(std::nearbyint(fraction * bits) / bits, exponent);
}

/// Number of entries of a row that are below a limit.
WRC_VECTOR_CLONES double count_below(const double* values, double limit, std::size_t count) {
  double below = 0.0;
#pragma omp simd reduction(+ : below)
  for (std::size_t i = 0; i < count; ++i) {
    below += values[i] < limit ? 1.0 : 0.0;
  }
  return below;
}

} // namespace

struct NormalSolver::State {
  State(PlannerRigor rigor, Precision precision_asked)
      : precision(precision_asked), cache(rigor), single_iteration(cache), double_iteration(cache) {
  }

  BoxOutcome solve_box(const BoxRequest& request, std::span<double> pressure,
                       std::span<const double> distance) {
    return precision == Precision::mixed ? single_iteration.solve(request, pressure, distance)
                                         : double_iteration.solve(request, pressure, distance);
  }
  BoxOutcome solve_level(Level& level, ElementBox& box, double tolerance, int iteration_limit);
  bool find_missed_contact(const Level& level, const ElementBox& box, const BoxOutcome& outcome,
                           double tolerance, ElementBox& larger);
  template <typename Real>
  void displace(const ElementBox& box, const ElementBox& rectangle,
                ConvolutionWorkspace<Real>& workspace);
  bool take_start(const StartPressure& start, const Grid& finest, double pressure_scale);
  NormalSolution solve(const NormalProblem& problem);

  Precision precision;
  double aspect = 1.0;
  InfluenceCache cache;
  BoxIteration<float> single_iteration;
  BoxIteration<double> double_iteration;
  std::vector<Level> levels;
  std::vector<double> box_pressure;
  std::vector<double> box_distance;
  std::vector<double> exterior_out;
};

/// Iterates on the box until contact keeps off its open sides; writes the pressures back.
BoxOutcome NormalSolver::State::solve_level(Level& level, ElementBox& box, double tolerance,
                                            int iteration_limit) {
  int iterations = 0;
  while (true) {
    copy_box(level.size, box, level.pressure, box_pressure);
    copy_box(level.size, box, level.distance, box_distance);
    BoxRequest request;
    request.rows = box.rows();
    request.columns = box.columns();
    request.aspect = aspect;
    request.pressure_sum = level.pressure_sum;
    request.approach = level.approach;
    request.tolerance = tolerance;
    request.maximum_iterations = std::max(0, iteration_limit - iterations);
    request.open_first_row = box.first_row > 0;
    request.open_last_row = box.last_row + 1 < level.size.rows;
    request.open_first_column = box.first_column > 0;
    request.open_last_column = box.last_column + 1 < level.size.columns;
    BoxOutcome outcome = solve_box(request, box_pressure, box_distance);
    put_box(level.size, box, box_pressure, level.pressure);
    iterations += outcome.iterations;
    outcome.iterations = iterations;
    if (!outcome.reached_edge()) {
      return outcome;
    }
    box = grown(box, outcome, level.size);
  }
}

/// Displacements on a rectangle from the pressures of the box.
template <typename Real>
void NormalSolver::State::displace(const ElementBox& box, const ElementBox& rectangle,
                                   ConvolutionWorkspace<Real>& workspace) {
  const BoxConvolution<Real> convolution = BoxConvolution<Real>::linear(
      {box.rows(), box.columns(), rectangle.rows(), rectangle.columns(),
       -static_cast<std::ptrdiff_t>(box.first_row - rectangle.first_row),
       -static_cast<std::ptrdiff_t>(box.first_column - rectangle.first_column)},
      aspect, cache);
  const std::vector<Real> in(box_pressure.begin(), box_pressure.end());
  std::vector<Real> out(rectangle.rows() * rectangle.columns());
  convolution.apply(in.data(), out.data(), workspace);
  exterior_out.assign(out.begin(), out.end());
}

/// Looks for overlap outside the box. Displacements are positive, and at least those of the whole
/// load at the farthest place of the box, so most elements need no displacement of their own.
bool NormalSolver::State::find_missed_contact(const Level& level, const ElementBox& box,
                                              const BoxOutcome& outcome, double tolerance,
                                              ElementBox& larger) {
  const LevelSize& size = level.size;
  double load = 0.0;
  copy_box(size, box, level.pressure, box_pressure);
  load = sum_of(box_pressure) * aspect;
  const auto farthest = [](std::size_t place, std::size_t first, std::size_t last) {
    const double before = static_cast<double>(last) - static_cast<double>(place);
    const double after = static_cast<double>(place) - static_cast<double>(first);
    return std::max(before, after) + 0.5;
  };
  ElementBox candidates{size.rows, 0, size.columns, 0};
  for (std::size_t row = 0; row < size.rows; ++row) {
    const double* distance = level.distance.data() + row * size.columns;
    const double row_reach = aspect * farthest(row, box.first_row, box.last_row);
    const double longest = std::hypot(
        row_reach, std::max(farthest(0, box.first_column, box.last_column),
                            farthest(size.columns - 1, box.first_column, box.last_column)));
    if (count_below(distance, outcome.approach - load / longest, size.columns) == 0.0) {
      continue;
    }
    const bool row_in_box = row >= box.first_row && row <= box.last_row;
    for (std::size_t column = 0; column < size.columns; ++column) {
      if (row_in_box && column == box.first_column) {
        column = box.last_column;
        continue;
      }
      const double reach =
          std::hypot(row_reach, farthest(column, box.first_column, box.last_column));
      if ((outcome.approach - distance[column]) * reach > load) {
        include(candidates, {row, row, column, column});
      }
    }
  }
  if (candidates.first_row > candidates.last_row) {
    return false;
  }

  ElementBox rectangle = box;
  include(rectangle, candidates);
  // An element left out lacks about overlap / K[0, 0] of pressure; u is nowhere above the approach.
  const double permitted =
      0.5 * tolerance * outcome.largest_pressure * cache.table(aspect, 1, 1).row(0)[0];
  double overlap = missed_overlap * outcome.approach;
  if (overlap <= permitted) {
    displace(box, rectangle, single_iteration.workspace());
  } else {
    overlap = std::max(permitted, double_overlap * outcome.approach);
    displace(box, rectangle, double_iteration.workspace());
  }
  const double limit = outcome.approach - overlap;
  bool missed = false;
  larger = box;
  for (std::size_t row = rectangle.first_row; row <= rectangle.last_row; ++row) {
    const double* displacement =
        exterior_out.data() + (row - rectangle.first_row) * rectangle.columns();
    const double* distance = level.distance.data() + row * size.columns + rectangle.first_column;
    for (std::size_t j = 0; j < rectangle.columns(); ++j) {
      const std::size_t column = rectangle.first_column + j;
      if (distance[j] + displacement[j] < limit && !box.holds(row, column)) {
        missed = true;
        include(larger, {row - std::min(row, box_margin), std::min(row + box_margin, size.rows - 1),
                         column - std::min(column, box_margin),
                         std::min(column + box_margin, size.columns - 1)});
      }
    }
  }
  return missed;
}

/// Puts a start on the coarsest grid, with the load asked for. False if nothing of it lies there.
bool NormalSolver::State::take_start(const StartPressure& start, const Grid& finest,
                                     double pressure_scale) {
  Level& level = levels.back();
  Grid grid = finest;
  const auto factor = static_cast<double>(std::size_t{1} << (levels.size() - 1));
  grid.lateral_count = level.size.rows;
  grid.longitudinal_count = level.size.columns;
  grid.lateral_step *= factor;
  grid.longitudinal_step *= factor;
  grid.lateral_first += 0.5 * (grid.lateral_step - finest.lateral_step);
  grid.longitudinal_first += 0.5 * (grid.longitudinal_step - finest.longitudinal_step);
  resample_pressure(start.grid, start.pressure, grid, level.pressure);
  const double sum = sum_of(level.pressure);
  if (!(sum > 0.0) || !std::isfinite(sum)) {
    return false;
  }
  const double scale = level.pressure_sum ? *level.pressure_sum / sum : 1.0 / pressure_scale;
  for (double& value : level.pressure) {
    value *= scale;
  }
  return true;
}

NormalSolution NormalSolver::State::solve(const NormalProblem& problem) {
  check_problem(problem);
  const Grid& grid = problem.grid;
  const double least_distance =
      *std::min_element(problem.undeformed_distance.begin(), problem.undeformed_distance.end());
  NormalSolution solution;
  const bool apart =
      problem.normal_load ? *problem.normal_load == 0.0 : *problem.approach <= least_distance;
  if (apart) {
    solution.pressure.assign(grid.element_count(), 0.0);
    solution.approach = problem.approach ? *problem.approach : least_distance;
    return solution;
  }

  // Without dimensions: lengths in longitudinal steps, u = K p, mean pressure 1 over the grid if
  // the load is given, approach 1 if that is given.
  const double step = grid.longitudinal_step;
  aspect = rounded_aspect(grid.lateral_step / step);
  std::size_t level_count = 1;
  // The cascade begins where elements are about as large as those of the start, if there is one.
  const double largest_element = problem.start
                                     ? start_coarseness * problem.start->grid.element_area()
                                     : std::numeric_limits<double>::infinity();
  double element = grid.element_area();
  for (LevelSize size{grid.lateral_count, grid.longitudinal_count};
       can_coarsen(size) && element < largest_element; size = coarser_size(size)) {
    element *= 4.0;
    ++level_count;
  }
  levels.resize(level_count);
  Level& finest = levels.front();
  finest.size = {grid.lateral_count, grid.longitudinal_count};
  double pressure_scale = 0.0;
  double normal_scale = 0.0;
  const double modulus = std::numbers::pi * problem.combined_modulus;
  if (problem.normal_load) {
    const auto count = static_cast<double>(grid.element_count());
    pressure_scale = *problem.normal_load / step / grid.lateral_step / count;
    normal_scale = pressure_scale / modulus * step;
    finest.pressure_sum = count;
  } else {
    normal_scale = *problem.approach - least_distance;
    pressure_scale = normal_scale / step * modulus;
    finest.pressure_sum.reset();
    finest.approach = 1.0;
  }
  // No element farther away than the approach is in contact, and no approach is larger than that of
  // the whole load on one element. Keeps absent bodies (any finite distance) within range.
  const double farthest =
      4.0 *
      (finest.pressure_sum ? *finest.pressure_sum * cache.table(aspect, 1, 1).row(0)[0] : 1.0);
  finest.distance.resize(grid.element_count());
  std::transform(problem.undeformed_distance.begin(), problem.undeformed_distance.end(),
                 finest.distance.begin(), [=](double distance) {
                   return std::min((distance - least_distance) / normal_scale, farthest);
                 });
  for (std::size_t i = 1; i < level_count; ++i) {
    Level& level = levels[i];
    level.size = coarser_size(levels[i - 1].size);
    coarsen_distance(levels[i - 1].size, levels[i - 1].distance, level.distance);
    level.pressure_sum.reset();
    if (finest.pressure_sum) {
      level.pressure_sum = *levels[i - 1].pressure_sum / 4.0;
    }
    level.approach = levels[i - 1].approach / 2.0;
  }

  if (!problem.start || !take_start(*problem.start, grid, pressure_scale)) {
    start_pressure(levels.back());
  }
  BoxOutcome outcome;
  for (std::size_t i = level_count; i-- > 0;) {
    Level& level = levels[i];
    if (i + 1 < level_count) {
      refine_pressure(levels[i + 1].size, levels[i + 1].pressure, level.size, level.pressure);
    }
    ElementBox box;
    if (i + 1 == level_count && !problem.start) {
      box = whole(level.size);
    } else if (!find_pressure_box(level.size, level.pressure, box_margin, box)) {
      start_pressure(level); // the coarser grid has lost the contact
      box = whole(level.size);
    }
    const double tolerance = i > 0 ? std::max(coarse_tolerance, stop_share * problem.tolerance)
                                   : stop_share * problem.tolerance;
    outcome = solve_level(level, box, tolerance, problem.maximum_iterations);
    solution.iterations += outcome.iterations;
    ElementBox larger;
    while (i == 0 && find_missed_contact(level, box, outcome, problem.tolerance, larger)) {
      box = larger;
      outcome = solve_level(level, box, tolerance, problem.maximum_iterations);
      solution.iterations += outcome.iterations;
    }
  }

  solution.stop_reason = outcome.stop_reason;
  solution.pressure_error = outcome.error / stop_share;
  solution.pressure.resize(grid.element_count());
  std::transform(finest.pressure.begin(), finest.pressure.end(), solution.pressure.begin(),
                 [=](double p) { return p * pressure_scale; });
  solution.approach =
      problem.approach ? *problem.approach : least_distance + outcome.approach * normal_scale;
  solution.normal_force =
      problem.normal_load ? *problem.normal_load : sum_of(solution.pressure) * grid.element_area();
  cache.trim(kept_bytes);
  return solution;
}

NormalSolver::NormalSolver(PlannerRigor rigor, Precision precision)
    : state_(new State(rigor, precision)) {}
NormalSolver::~NormalSolver() = default;
NormalSolver::NormalSolver(NormalSolver&&) noexcept = default;
NormalSolver& NormalSolver::operator=(NormalSolver&&) noexcept = default;

NormalSolution NormalSolver::solve(const NormalProblem& problem) {
  return state_->solve(problem);
}

} // namespace wrc
