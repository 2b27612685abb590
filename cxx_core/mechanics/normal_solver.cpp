#include "mechanics/normal_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "base/reductions.hpp"
#include "mechanics/cascade.hpp"
#include "mechanics/coupled_influence.hpp"
#include "mechanics/projected_cg.hpp"

namespace wrc {

namespace {

/// Error of p at which a coarser grid is left: what refining adds is about as much.
constexpr double coarse_tolerance = 1e-2;
/// Longest side of the coarsest grid: of one patch, and of each of several, which together would
/// have more elements there than one.
constexpr std::size_t coarsest_of_one = 32;
constexpr std::size_t coarsest_of_several = 24;
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
/// Error that interpolation may have in what patches displace at each other: a share of the
/// tolerance, but no less than this.
constexpr double coupling_share = 0.03;
constexpr double min_coupling_error = 1e-5;
/// Share of elements below the distance from which the first pressures are drawn.
constexpr double start_quantile = 0.3;
/// One grid of a patch's cascade, in its own unit of length.
struct Level {
  LevelSize size;
  Grid grid; ///< in mm, from the finest level's first element
  std::vector<double> distance;
  std::vector<double> pressure;
  double share = 1.0;  ///< of the approach, in this level's unit
  double weight = 1.0; ///< element area times unit of length, relative to the first patch's grid
  [[nodiscard]] double load_weight() const { return share * weight; }
};

/// Grids of one patch, finest first, and the box worked on.
struct Cascade {
  InfluenceKernel kernel;
  PatchInteraction::Place place; ///< of the finest level's first element in the mean plane
  std::vector<Level> levels;
  std::size_t level_count = 0; ///< of the levels, those of this problem
  ElementBox box;
  std::vector<double> box_pressure;
  std::vector<double> box_distance;

  /// The grid of this patch that goes with a grid of the longest cascade.
  [[nodiscard]] Level& at(std::size_t index) { return levels[std::min(index, level_count - 1)]; }
  [[nodiscard]] Level& finest() { return levels.front(); }
};

double sum_of(const std::vector<double>& values) {
  return wrc::sum_of(values.data(), values.size());
}

/// The approach below which a share of the elements lies.
double start_height(const Level& level) {
  std::vector<double> ordered = level.distance;
  const auto rank =
      static_cast<std::ptrdiff_t>(start_quantile * static_cast<double>(ordered.size() - 1));
  std::nth_element(ordered.begin(), ordered.begin() + rank, ordered.end());
  return ordered[static_cast<std::size_t>(rank)] / level.share;
}

/// Pressures like Hertz's over the elements below a height; even ones where nothing lies below it
/// (a punch). Between patches they go like E* sqrt(height * curvature).
void draw_pressure(Level& level, double height) {
  const double limit = height * level.share;
  double inside = 0.0;
  double deepest = 0.0;
  for (std::size_t i = 0; i < level.pressure.size(); ++i) {
    const double depth = std::max(0.0, limit - level.distance[i]);
    level.pressure[i] = std::sqrt(depth);
    inside += depth > 0.0 ? 1.0 : 0.0;
    deepest = std::max(deepest, depth);
  }
  const double curvature = std::sqrt(deepest / std::max(1.0, inside));
  for (double& value : level.pressure) {
    value *= curvature;
  }
  if (deepest == 0.0) {
    for (std::size_t i = 0; i < level.pressure.size(); ++i) {
      level.pressure[i] = level.distance[i] <= limit ? 1.0 : 0.0;
    }
  }
}

/// The box around all that overlaps at an approach: contact cannot lie outside. False if nothing
/// does.
bool find_penetration_box(const Level& level, double approach, std::size_t margin,
                          ElementBox& box) {
  std::vector<double> depth(level.distance.size());
  const double reach = level.share * approach;
  std::transform(level.distance.begin(), level.distance.end(), depth.begin(),
                 [reach](double distance) { return reach - distance; });
  return find_pressure_box(level.size, depth, margin, box);
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
ElementBox grown(const ElementBox& box, const ReachedSides& reached, const LevelSize& size) {
  constexpr std::size_t min_growth = 4;
  const std::size_t by_rows = std::max(min_growth, box.rows() / 4);
  const std::size_t by_columns = std::max(min_growth, box.columns() / 4);
  ElementBox larger = box;
  if (reached.first_row) {
    larger.first_row -= std::min(larger.first_row, by_rows);
  }
  if (reached.last_row) {
    larger.last_row = std::min(larger.last_row + by_rows, size.rows - 1);
  }
  if (reached.first_column) {
    larger.first_column -= std::min(larger.first_column, by_columns);
  }
  if (reached.last_column) {
    larger.last_column = std::min(larger.last_column + by_columns, size.columns - 1);
  }
  return larger;
}

} // namespace

struct NormalSolver::State {
  State(std::shared_ptr<LinePlans> plans, Precision precision_asked)
      : precision(precision_asked), cache(std::move(plans)), single_iteration(cache),
        double_iteration(cache) {}

  void make_levels(const JointProblem& problem);
  void draw_initial_pressure(std::size_t index);
  bool take_start(const JointProblem& problem);
  void choose_box(Cascade& cascade, Level& level) const;
  IterationOutcome solve_level(std::size_t index, double tolerance, JointSolution& solution);
  void displace_by_others(std::size_t k, const ElementBox& rectangle);
  std::optional<ElementBox> box_with_missed_contact(std::size_t k, double tolerance);
  template <typename Real>
  void displace(const Cascade& cascade, const ElementBox& rectangle,
                ConvolutionWorkspace<Real>& workspace);
  JointSolution solve(const JointProblem& problem);

  Precision precision;
  InfluenceCache cache;
  ProjectedCg<float> single_iteration;
  ProjectedCg<double> double_iteration;
  std::vector<Cascade> cascades; ///< at least as many as patches
  std::size_t count = 0;         ///< of patches
  const PatchInteraction* interaction = nullptr;
  std::optional<double> load; ///< sum of load_weight p
  double approach = 0.0;
  double largest_pressure = 0.0;
  int iteration_limit = 0;
  double rounding_share = 0.0;
  double pressure_scale = 0.0; ///< MPa
  double least_approach = 0.0; ///< mm: at which the first element touches
  double approach_scale = 0.0; ///< mm
  std::vector<IterationBox> boxes;
  std::vector<double> exterior_out;
};

/// Without dimensions: lengths in longitudinal steps of each grid, u = K p, approach in that of the
/// first patch's; mean pressure 1 over the grids if the load is given, approach 1 if that is given.
void NormalSolver::State::make_levels(const JointProblem& problem) {
  const double step = problem.patches[0].grid.longitudinal_step;
  const double area = problem.patches[0].grid.element_area();
  const double modulus = std::numbers::pi * problem.combined_modulus;
  cascades.resize(std::max(cascades.size(), count));
  double elements = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const PatchGap& patch = problem.patches[k];
    std::vector<Level>& levels = cascades[k].levels;
    levels.resize(std::max<std::size_t>(levels.size(), 1));
    Level& finest = levels.front();
    cascades[k].kernel = {shared_aspect(patch.grid.lateral_step / patch.grid.longitudinal_step),
                          problem.elements};
    finest.grid = patch.grid;
    finest.grid.lateral_first = 0.0;
    finest.grid.longitudinal_first = 0.0;
    if (interaction != nullptr) {
      cascades[k].place = {interaction->places[k].lateral + patch.grid.lateral_first,
                           interaction->places[k].longitudinal + patch.grid.longitudinal_first};
    }
    finest.share = patch.approach_cosine * (step / patch.grid.longitudinal_step);
    finest.weight = (patch.grid.element_area() / area) * (patch.grid.longitudinal_step / step);
    elements += finest.load_weight() * static_cast<double>(patch.grid.element_count());
  }
  if (problem.load) {
    pressure_scale = *problem.load / step / problem.patches[0].grid.lateral_step / elements;
    approach_scale = pressure_scale / modulus * step;
    load = elements;
  } else {
    approach_scale = *problem.approach - least_approach;
    pressure_scale = approach_scale / step * modulus;
    load.reset();
    approach = 1.0;
  }
  // No element farther away than the approach is in contact, and no approach is larger than that of
  // the whole load on one element. Keeps absent bodies (any finite distance) within range.
  double farthest = 1.0;
  if (load) {
    farthest = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const Level& finest = cascades[k].finest();
      farthest =
          std::max(farthest, *load / finest.load_weight() *
                                 cache.table(cascades[k].kernel, 1, 1)->row(0)[0] / finest.share);
    }
  }
  const std::size_t coarsest = count > 1 ? coarsest_of_several : coarsest_of_one;
  for (std::size_t k = 0; k < count; ++k) {
    const PatchGap& patch = problem.patches[k];
    Cascade& cascade = cascades[k];
    cascade.level_count = 1;
    for (LevelSize size{patch.grid.lateral_count, patch.grid.longitudinal_count};
         can_coarsen(size, coarsest); size = coarser_size(size)) {
      ++cascade.level_count;
    }
    cascade.levels.resize(std::max(cascade.levels.size(), cascade.level_count));
    Level& finest = cascade.finest();
    finest.size = {patch.grid.lateral_count, patch.grid.longitudinal_count};
    finest.distance.resize(patch.grid.element_count());
    const double unit = approach_scale * (patch.grid.longitudinal_step / step);
    const double least = least_approach * patch.approach_cosine;
    const double limit = 4.0 * farthest * finest.share;
    std::transform(patch.undeformed_distance.begin(), patch.undeformed_distance.end(),
                   finest.distance.begin(),
                   [=](double distance) { return std::min((distance - least) / unit, limit); });
    for (std::size_t i = 1; i < cascade.level_count; ++i) {
      const Level& finer = cascade.levels[i - 1];
      Level& level = cascade.levels[i];
      level.size = coarser_size(finer.size);
      level.grid = finer.grid;
      level.grid.lateral_count = level.size.rows;
      level.grid.longitudinal_count = level.size.columns;
      level.grid.lateral_step *= 2.0;
      level.grid.longitudinal_step *= 2.0;
      level.grid.lateral_first += 0.5 * finer.grid.lateral_step;
      level.grid.longitudinal_first += 0.5 * finer.grid.longitudinal_step;
      level.share = finer.share / 2.0;
      level.weight = finer.weight * 8.0;
      coarsen_distance(finer.size, finer.distance, level.distance);
    }
  }
}

/// First pressures on grid `index` of all patches. With the approach given the first residual tells
/// where contact is.
void NormalSolver::State::draw_initial_pressure(std::size_t index) {
  double height = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < count && load; ++k) {
    height = std::min(height, start_height(cascades[k].at(index)));
  }
  double drawn = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    Level& level = cascades[k].at(index);
    level.pressure.assign(level.size.count(), 0.0);
    if (load) {
      draw_pressure(level, height);
      drawn += level.load_weight() * sum_of(level.pressure);
    }
    cascades[k].box = whole(level.size);
  }
  for (std::size_t k = 0; k < count && load; ++k) {
    for (double& value : cascades[k].at(index).pressure) {
      value *= *load / drawn;
    }
  }
  approach = load ? height : approach;
}

/// Pressures given to start from, if there are some for all patches.
bool NormalSolver::State::take_start(const JointProblem& problem) {
  const bool given =
      std::all_of(problem.patches.begin(), problem.patches.end(), [](const PatchGap& patch) {
        return patch.start.size() == patch.undeformed_distance.size();
      });
  for (std::size_t k = 0; k < count && given; ++k) {
    const std::span<const double> start = problem.patches[k].start;
    std::vector<double>& pressure = cascades[k].finest().pressure;
    pressure.resize(start.size());
    std::transform(start.begin(), start.end(), pressure.begin(),
                   [this](double p) { return p / pressure_scale; });
  }
  return given;
}

/// The box around a patch's pressures; without any, around its penetration at the last approach, or
/// its nearest element.
void NormalSolver::State::choose_box(Cascade& cascade, Level& level) const {
  if (find_pressure_box(level.size, level.pressure, box_margin, cascade.box)) {
    return;
  }
  if (!find_penetration_box(level, approach, box_margin, cascade.box)) {
    const double nearest = std::max(0.0, least_of(level.distance.data(), level.distance.size()));
    const double just_touching = (nearest * (1.0 + 1e-12) + 1e-300) / level.share;
    find_penetration_box(level, just_touching, box_margin, cascade.box);
  }
}

/// Iterates on the boxes until contact keeps off their open sides; writes the pressures back.
IterationOutcome NormalSolver::State::solve_level(std::size_t index, double tolerance,
                                                  JointSolution& solution) {
  while (true) {
    boxes.resize(count);
    std::vector<Grid> coupled;
    for (std::size_t k = 0; k < count; ++k) {
      Cascade& cascade = cascades[k];
      const Level& level = cascade.at(index);
      const ElementBox& box = cascade.box;
      copy_box(level.size, box, level.pressure, cascade.box_pressure);
      copy_box(level.size, box, level.distance, cascade.box_distance);
      IterationBox& request = boxes[k];
      request.rows = box.rows();
      request.columns = box.columns();
      request.kernel = cascade.kernel;
      request.share = level.share;
      request.weight = level.weight;
      request.open_first_row = box.first_row > 0;
      request.open_last_row = box.last_row + 1 < level.size.rows;
      request.open_first_column = box.first_column > 0;
      request.open_last_column = box.last_column + 1 < level.size.columns;
      request.pressure = cascade.box_pressure;
      request.distance = cascade.box_distance;
      if (interaction != nullptr) {
        coupled.push_back(grid_in_mean_plane(level.grid, cascade.place, box));
      }
    }
    std::optional<PatchCoupling> coupling;
    if (interaction != nullptr) {
      coupling.emplace(std::move(coupled), interaction->coupling_weight,
                       std::clamp(coupling_share * tolerance, min_coupling_error, 1.0));
    }
    IterationRequest request;
    request.boxes = boxes;
    request.load = load;
    request.approach = approach;
    request.tolerance = tolerance;
    request.rounding_share = rounding_share;
    request.maximum_iterations = std::max(0, iteration_limit);
    request.coupling = coupling ? &*coupling : nullptr;
    IterationOutcome outcome = precision == Precision::mixed ? single_iteration.solve(request)
                                                             : double_iteration.solve(request);
    iteration_limit -= outcome.iterations;
    solution.iterations += outcome.iterations;
    solution.convolutions += outcome.convolutions;
    for (std::size_t k = 0; k < count; ++k) {
      Cascade& cascade = cascades[k];
      Level& level = cascade.at(index);
      put_box(level.size, cascade.box, cascade.box_pressure, level.pressure);
      cascade.box = grown(cascade.box, outcome.reached[k], level.size);
    }
    approach = outcome.approach;
    largest_pressure = outcome.largest_pressure;
    if (!outcome.reached_any) {
      return outcome;
    }
  }
}

/// Displacements on a rectangle from the pressures of the box.
template <typename Real>
void NormalSolver::State::displace(const Cascade& cascade, const ElementBox& rectangle,
                                   ConvolutionWorkspace<Real>& workspace) {
  const ElementBox& box = cascade.box;
  const BoxConvolution<Real> convolution = BoxConvolution<Real>::linear(
      {box.rows(), box.columns(), rectangle.rows(), rectangle.columns(),
       -static_cast<std::ptrdiff_t>(box.first_row - rectangle.first_row),
       -static_cast<std::ptrdiff_t>(box.first_column - rectangle.first_column)},
      cascade.kernel, cache);
  const std::vector<Real> in(cascade.box_pressure.begin(), cascade.box_pressure.end());
  std::vector<Real> out(rectangle.rows() * rectangle.columns());
  convolution.apply(in.data(), out.data(), workspace);
  exterior_out.assign(out.begin(), out.end());
}

/// Adds what the other patches displace to the displacements on a rectangle of a patch's finest
/// grid.
void NormalSolver::State::displace_by_others(std::size_t k, const ElementBox& rectangle) {
  std::vector<Grid> coupled;
  std::vector<double> coupling_weight(count * count);
  for (std::size_t l = 0; l < count; ++l) {
    coupled.push_back(grid_in_mean_plane(cascades[l].finest().grid, cascades[l].place,
                                         l == k ? rectangle : cascades[l].box));
    coupling_weight[k * count + l] = coupling_weight[l * count + k] =
        interaction->coupling_weight[k * count + l];
  }
  PatchCoupling coupling(std::move(coupled), coupling_weight);
  NodeField field = coupling.field();
  for (std::size_t l = 0; l < count; ++l) {
    if (l != k) {
      coupling.gather(l, cascades[l].box_pressure.data(), field.load);
    }
  }
  coupling.transfer(field);
  coupling.add_others(field, k, exterior_out.data());
}

/// Looks for overlap outside the box, within the penetration: the box enlarged by it, or none.
std::optional<ElementBox> NormalSolver::State::box_with_missed_contact(std::size_t k,
                                                                       double tolerance) {
  Cascade& cascade = cascades[k];
  const Level& level = cascade.finest();
  const LevelSize& size = level.size;
  const ElementBox& box = cascade.box;
  const double approach_here = level.share * approach;
  ElementBox rectangle = box;
  find_penetration_box(level, approach, 0, rectangle);
  include(rectangle, box);
  if (rectangle.rows() * rectangle.columns() == box.rows() * box.columns()) {
    return std::nullopt;
  }
  // An element left out lacks about overlap / K[0, 0] of pressure; u is nowhere above the approach.
  const double permitted =
      0.5 * tolerance * largest_pressure * cache.table(cascade.kernel, 1, 1)->row(0)[0];
  double overlap = missed_overlap * approach_here;
  if (overlap <= permitted) {
    displace(cascade, rectangle, single_iteration.workspace());
  } else {
    overlap = std::max(permitted, double_overlap * approach_here);
    displace(cascade, rectangle, double_iteration.workspace());
  }
  const auto box_with_overlap = [&](double limit) {
    std::optional<ElementBox> larger;
    for (std::size_t row = rectangle.first_row; row <= rectangle.last_row; ++row) {
      const double* displacement =
          exterior_out.data() + (row - rectangle.first_row) * rectangle.columns();
      const double* distance = level.distance.data() + row * size.columns + rectangle.first_column;
      for (std::size_t j = 0; j < rectangle.columns(); ++j) {
        const std::size_t column = rectangle.first_column + j;
        if (box.holds(row, column)) {
          j = box.last_column - rectangle.first_column;
          continue;
        }
        if (distance[j] + displacement[j] < limit) {
          larger = larger.value_or(box);
          include(*larger,
                  {row - std::min(row, box_margin), std::min(row + box_margin, size.rows - 1),
                   column - std::min(column, box_margin),
                   std::min(column + box_margin, size.columns - 1)});
        }
      }
    }
    return larger;
  };
  std::optional<ElementBox> larger = box_with_overlap(approach_here - overlap);
  if (larger && interaction != nullptr) {
    displace_by_others(k, rectangle);
    larger = box_with_overlap(approach_here - overlap);
  }
  return larger;
}

JointSolution NormalSolver::State::solve(const JointProblem& problem) {
  count = problem.patches.size();
  approach = 0.0;
  interaction = problem.interaction;
  least_approach = std::numeric_limits<double>::infinity();
  for (const PatchGap& patch : problem.patches) {
    const double least =
        least_of(patch.undeformed_distance.data(), patch.undeformed_distance.size());
    least_approach = std::min(least_approach, least / patch.approach_cosine);
  }
  JointSolution solution;
  solution.patches.resize(count);
  const bool apart = problem.load ? *problem.load == 0.0 : *problem.approach <= least_approach;
  if (apart) {
    for (std::size_t k = 0; k < count; ++k) {
      solution.patches[k].pressure.assign(problem.patches[k].grid.element_count(), 0.0);
    }
    solution.approach = problem.approach ? *problem.approach : least_approach;
    return solution;
  }

  make_levels(problem);
  iteration_limit = problem.maximum_iterations;
  rounding_share = problem.rounding_share;
  std::size_t level_count = 1;
  for (std::size_t k = 0; k < count; ++k) {
    level_count = std::max(level_count, cascades[k].level_count);
  }
  const bool started = take_start(problem);
  if (!started) {
    draw_initial_pressure(level_count - 1);
  }
  IterationOutcome outcome;
  for (std::size_t i = started ? 1 : level_count; i-- > 0;) {
    bool any_pressure = false;
    for (std::size_t k = 0; k < count; ++k) {
      Cascade& cascade = cascades[k];
      if (i + 1 < cascade.level_count && !started) {
        const Level& coarser = cascade.levels[i + 1];
        Level& level = cascade.levels[i];
        refine_pressure(coarser.grid, coarser.pressure, level.grid, level.pressure);
      }
      const Level& level = cascade.at(i);
      any_pressure = any_pressure || std::any_of(level.pressure.begin(), level.pressure.end(),
                                                 [](double p) { return p > 0.0; });
    }
    if (started || i + 1 < level_count) {
      for (std::size_t k = 0; k < count && any_pressure; ++k) {
        choose_box(cascades[k], cascades[k].at(i));
      }
      if (!any_pressure) {
        draw_initial_pressure(i); // the coarser grid has lost the contact
      }
    }
    const double tolerance = i > 0 ? std::max(coarse_tolerance, stop_share * problem.tolerance)
                                   : stop_share * problem.tolerance;
    outcome = solve_level(i, tolerance, solution);
    while (i == 0) {
      // All are looked through before any box changes, which goes with the pressures on it.
      std::vector<std::optional<ElementBox>> larger(count);
      for (std::size_t k = 0; k < count; ++k) {
        larger[k] = box_with_missed_contact(k, problem.tolerance);
      }
      bool missed = false;
      for (std::size_t k = 0; k < count; ++k) {
        missed = missed || larger[k].has_value();
        cascades[k].box = larger[k].value_or(cascades[k].box);
      }
      if (!missed) {
        break;
      }
      outcome = solve_level(i, tolerance, solution);
    }
  }

  solution.stop_reason = outcome.stop_reason;
  solution.pressure_error = outcome.error / stop_share;
  for (std::size_t k = 0; k < count; ++k) {
    const Grid& grid = problem.patches[k].grid;
    JointSolution::Patch& patch = solution.patches[k];
    patch.pressure.resize(grid.element_count());
    const std::vector<double>& pressure = cascades[k].finest().pressure;
    std::transform(pressure.begin(), pressure.end(), patch.pressure.begin(),
                   [this](double p) { return p * pressure_scale; });
    patch.normal_force = sum_of(patch.pressure) * grid.element_area();
  }
  solution.approach =
      problem.approach ? *problem.approach : least_approach + approach * approach_scale;
  cache.drop_unused();
  return solution;
}

NormalSolver::NormalSolver(PlannerRigor rigor, Precision precision)
    : NormalSolver(std::make_shared<LinePlans>(rigor), precision) {}
NormalSolver::NormalSolver(std::shared_ptr<LinePlans> plans, Precision precision)
    : state_(new State(std::move(plans), precision)) {}
NormalSolver::~NormalSolver() = default;
NormalSolver::NormalSolver(NormalSolver&&) noexcept = default;
NormalSolver& NormalSolver::operator=(NormalSolver&&) noexcept = default;

JointSolution NormalSolver::solve(const JointProblem& problem) {
  check_problem(problem);
  return state_->solve(problem);
}

NormalSolution NormalSolver::solve(const NormalProblem& problem) {
  check_problem(problem);
  const PatchGap patch{problem.grid, problem.undeformed_distance, 1.0};
  JointProblem joint;
  joint.patches = {&patch, 1};
  joint.combined_modulus = problem.combined_modulus;
  joint.load = problem.normal_load;
  joint.approach = problem.approach;
  joint.tolerance = problem.tolerance;
  joint.maximum_iterations = problem.maximum_iterations;
  joint.elements = problem.elements;
  JointSolution solved = state_->solve(joint);
  NormalSolution solution;
  solution.pressure = std::move(solved.patches.front().pressure);
  solution.approach = solved.approach;
  solution.normal_force = problem.normal_load.value_or(solved.patches.front().normal_force);
  solution.iterations = solved.iterations;
  solution.stop_reason = solved.stop_reason;
  solution.pressure_error = solved.pressure_error;
  return solution;
}

} // namespace wrc
