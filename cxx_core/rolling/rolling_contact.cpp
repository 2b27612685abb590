#include "rolling/rolling_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "half_space/traction_convolution.hpp"
#include "mechanics/cascade.hpp"
#include "rolling/constants.hpp"
#include "rolling/leading_edge.hpp"
#include "rolling/normal_displacement.hpp"
#include "rolling/problem_rates.hpp"
#include "rolling/scaled_tractions.hpp"
#include "rolling/traction_newton.hpp"

namespace wrc {

namespace {

/// Bound and covered fractions on the coarser grid: means of two by two elements.
template <typename Real> void coarsen(TractionNewton<Real>& fine, TractionNewton<Real>& coarse) {
  const auto average = [&](const Real* from, Real* to) {
    std::fill_n(to, coarse.size(), Real{0});
    for (std::size_t i = 0; i < fine.shape().rows; ++i) {
      for (std::size_t j = 0; j < fine.shape().columns; ++j) {
        to[i / 2 * coarse.pitch() + j / 2] += Real(0.25) * from[i * fine.pitch() + j];
      }
    }
  };
  average(fine.bound(), coarse.bound());
  average(fine.edge(), coarse.edge());
}

/// Tractions of the coarser grid over their bound, by bilinear interpolation between elements in
/// contact, times the finer grid's bound.
template <typename Real>
void prolong_traction(TractionNewton<Real>& coarse, TractionNewton<Real>& fine) {
  const Real* coarse_bound = coarse.bound();
  const Real* from_x = coarse.traction();
  const Real* from_y = from_x + coarse.size();
  const Real* bound = fine.bound();
  Real* to_x = fine.traction();
  Real* to_y = to_x + fine.size();
  const auto neighbour = [](std::size_t index, std::size_t count) -> std::optional<std::size_t> {
    const std::size_t own = index / 2;
    if (index % 2 == 1) {
      return own + 1 < count ? std::optional(own + 1) : std::nullopt;
    }
    return own > 0 ? std::optional(own - 1) : std::nullopt;
  };
  for (std::size_t i = 0; i < fine.shape().rows; ++i) {
    const std::array<std::optional<std::size_t>, 2> rows{i / 2, neighbour(i, coarse.shape().rows)};
    for (std::size_t j = 0; j < fine.shape().columns; ++j) {
      const std::size_t place = i * fine.pitch() + j;
      const std::array<std::optional<std::size_t>, 2> columns{j / 2,
                                                              neighbour(j, coarse.shape().columns)};
      Real x = 0;
      Real y = 0;
      Real weights = 0;
      for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t b = 0; b < 2; ++b) {
          if (rows[a] && columns[b]) {
            const std::size_t at = *rows[a] * coarse.pitch() + *columns[b];
            if (coarse_bound[at] > Real{0}) {
              const Real weight =
                  (a == 0 ? Real(0.75) : Real(0.25)) * (b == 0 ? Real(0.75) : Real(0.25));
              weights += weight;
              x += weight * from_x[at] / coarse_bound[at];
              y += weight * from_y[at] / coarse_bound[at];
            }
          }
        }
      }
      const Real share = weights > Real{0} ? bound[place] / weights : Real{0};
      to_x[place] = share * x;
      to_y[place] = share * y;
    }
  }
}

/// The grids of a cascade, finest first, for one shape of elements; kept while they serve.
template <typename Real> class Cascade {
public:
  Cascade(const ScaledTractions& scaled, const RollingProblem& problem, LinePlans& plans) {
    const TractionShape& finest = scaled.box().shape;
    TractionGrid grid{finest,
                      2.0 / (scaled.aspect() * static_cast<double>(finest.columns)),
                      {scaled.angles().begin(), scaled.angles().end()}};
    const TractionTable table = scaled.table();
    double times = 1.0;
    while (true) {
      levels_.push_back(std::make_unique<TractionNewton<Real>>(
          grid, problem.poisson, difference_of(problem, times), table, plans));
      if (std::min(grid.shape.rows, grid.shape.columns) < 2 * min_cascade_side) {
        break;
      }
      grid.shape = {(grid.shape.rows + 1) / 2, (grid.shape.columns + 1) / 2};
      grid.step_over_width *= 2.0;
      std::vector<double> angles;
      coarsen_angles(grid.angles, angles);
      grid.angles = std::move(angles);
      times *= 2.0;
    }
  }

  NewtonOutcome solve(const ScaledTractions& scaled, const RollingProblem& problem) {
    scaled.fill_bound(finest().bound(), finest().pitch());
    std::fill_n(finest().edge(), 2 * finest().size(), Real{0});
    if (scaled.has_edges()) {
      scaled.fill_covered(finest().edge(), finest().pitch());
    }
    for (std::size_t level = 1; level < levels_.size(); ++level) {
      coarsen(*levels_[level - 1], *levels_[level]);
    }
    for (auto& level : levels_) {
      if (scaled.has_edges()) {
        make_edges(level->bound(), level->edge(), level->shape(), level->pitch(), scaled.aspect(),
                   problem.poisson, level->upstream());
      }
    }
    NewtonOutcome all;
    for (std::size_t level = levels_.size(); level-- > 0;) {
      TractionNewton<Real>& at = *levels_[level];
      if (level + 1 < levels_.size()) {
        prolong_traction(*levels_[level + 1], at);
      } else {
        std::fill_n(at.traction(), 2 * at.size(), Real{0});
      }
      scaled.fill_rigid_slip(at.rigid_slip(), at.shape(), at.pitch(), level);
      const double tolerance =
          level == 0 ? problem.tolerance : std::max(cascade_tolerance, problem.tolerance);
      const NewtonOutcome outcome = at.solve({tolerance, problem.maximum_iterations});
      all.iterations += outcome.iterations;
      all.convolutions += outcome.convolutions;
      all.residual = outcome.residual;
      all.converged = outcome.converged;
    }
    return all;
  }

  TractionNewton<Real>& finest() { return *levels_.front(); }

private:
  std::vector<std::unique_ptr<TractionNewton<Real>>> levels_;
};

/// Of a step of time, without the columns beyond the contact.
template <typename Real>
void take_displacement(TractionNewton<Real>& level, const ScaledTractions& scaled, LinePlans& plans,
                       RollingSolution& solution) {
  const TractionShape& shape = level.shape();
  const auto packed = [&](const Real* field, std::size_t rows) {
    std::vector<double> values;
    for (std::size_t row = 0; row < rows; ++row) {
      const Real* from = field + row * level.pitch();
      values.insert(values.end(), from, from + shape.columns);
    }
    return values;
  };
  scaled.displace(packed(level.traction(), 2 * shape.rows), packed(level.bound(), shape.rows),
                  packed(level.edge(), 2 * shape.rows), plans, solution);
}

/// What a cascade was made for.
using CascadeKey = std::tuple<std::size_t, std::size_t, double, double, TangentialMotion,
                              SlipDifference, double, std::vector<double>>;

} // namespace

struct RollingSolver::State {
  std::shared_ptr<LinePlans> plans;
  CascadeKey key{};
  std::optional<Cascade<float>> coarse;
  std::optional<Cascade<double>> accurate;

  template <typename Real>
  NewtonOutcome solve(std::optional<Cascade<Real>>& cascade, const ScaledTractions& scaled,
                      const RollingProblem& problem, RollingSolution& solution) {
    if (!cascade) {
      cascade.emplace(scaled, problem, *plans);
    }
    const NewtonOutcome outcome = cascade->solve(scaled, problem);
    TractionNewton<Real>& level = cascade->finest();
    scaled.read_back(level.traction(), level.slip(), level.bound(), level.pitch(), solution);
    if (problem.step_length > 0.0) {
      take_displacement(level, scaled, *plans, solution);
    }
    for (std::size_t creepage = 0; problem.derivatives && creepage < 3; ++creepage) {
      scaled.fill_slip_rate(creepage, level.rigid_slip(), level.pitch());
      const std::array<double, 4> rates =
          scaled.force_rates(creepage, level.solve_rate(level.rigid_slip(), rate_tolerance),
                             level.bound(), level.pitch());
      for (std::size_t force = 0; force < 3; ++force) {
        solution.by_creepage[3 * force + creepage] = rates[force];
      }
      solution.weighted_by_creepage[creepage] = rates[3];
    }
    solution.by_rate = rates_of_forces(problem, scaled, level, *plans);
    return outcome;
  }
};

RollingSolver::RollingSolver(std::shared_ptr<LinePlans> plans) : state_(new State) {
  state_->plans = std::move(plans);
}
RollingSolver::~RollingSolver() = default;
RollingSolver::RollingSolver(RollingSolver&&) noexcept = default;
RollingSolver& RollingSolver::operator=(RollingSolver&&) noexcept = default;

LinePlans& RollingSolver::plans() {
  return *state_->plans;
}

RollingSolution RollingSolver::solve(const RollingProblem& problem) {
  check_problem(problem);
  RollingSolution solution;
  solution.traction_x.resize(problem.grid.element_count());
  solution.traction_y.resize(problem.grid.element_count());
  solution.slip_x.resize(problem.grid.element_count());
  solution.slip_y.resize(problem.grid.element_count());
  const ScaledTractions scaled(problem, *state_->plans);
  if (scaled.empty()) {
    solution.by_rate.resize(problem.rates.size());
    return solution;
  }
  const CascadeKey key{scaled.box().shape.rows,
                       scaled.box().shape.columns,
                       scaled.aspect(),
                       problem.poisson,
                       problem.motion,
                       problem.difference,
                       scaled.difference().upstream,
                       {scaled.angles().begin(), scaled.angles().end()}};
  if (key != state_->key) {
    state_->coarse.reset();
    state_->accurate.reset();
    state_->key = key;
  }
  const NewtonOutcome outcome = problem.tolerance >= single_precision_tolerance
                                    ? state_->solve(state_->coarse, scaled, problem, solution)
                                    : state_->solve(state_->accurate, scaled, problem, solution);
  solution.iterations = outcome.iterations;
  solution.convolutions = outcome.convolutions;
  solution.residual = outcome.residual;
  solution.converged = outcome.converged;
  if (problem.difference_parameter != 0.0) {
    solution.normal_displacement =
        normal_displacement(problem, solution.traction_x, solution.traction_y, *state_->plans);
  }
  sum_up(problem, scaled.power_by_pressure(solution), solution);
  return solution;
}

} // namespace wrc
