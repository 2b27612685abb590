#include "mechanics/yielding.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>

#include "base/reductions.hpp"
#include "half_space/constants.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/coupled_influence.hpp"

namespace wrc {
namespace {

using Fields = std::vector<std::vector<double>>; // one of each patch

/// One value at each element of a product of fields.
template <class... Other, class Function>
void for_each_value(Function function, std::vector<double>& first, Other&... other) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    function(first[i], other[i]...);
  }
}

/// The displacements of all patches by their pressures, on whole grids.
class Displacer {
public:
  Displacer(const NormalProblem& problem, InfluenceCache& cache) {
    std::vector<SolvedPatch> whole;
    Fields ones;
    for (const PatchGap& gap : problem.patches) {
      const Grid& grid = gap.grid;
      const std::size_t rows = grid.lateral_count;
      const std::size_t columns = grid.longitudinal_count;
      const InfluenceKernel kernel{shared_aspect(grid.lateral_step / grid.longitudinal_step),
                                   problem.elements};
      Patch& patch = patches_.emplace_back();
      patch.unit = grid.longitudinal_step / (std::numbers::pi * problem.combined_modulus);
      patch.area = grid.element_area();
      patch.self = patch.unit * cache.table(kernel, 1, 1)->values[0];
      patch.convolution = BoxConvolution<double>::linear({rows, columns, rows, columns, 0, 0},
                                                         kernel, cache, {gap.angles, gap.angles});
      patch.inverse = BoxConvolution<double>::inverse_periodic(rows, columns, kernel, cache);
      ones.emplace_back(grid.element_count(), 1.0);
    }
    for (std::size_t k = 0; problem.interaction != nullptr && k < patches_.size(); ++k) {
      whole.push_back({problem.patches[k].grid, ones[k]});
    }
    if (problem.interaction != nullptr) {
      others_ =
          std::make_unique<CoupledInfluence>(whole, *problem.interaction, problem.combined_modulus);
    }
  }

  void displace(const Fields& pressure, Fields& displacement) {
    displacement.resize(patches_.size());
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      displacement[k].resize(pressure[k].size());
      patches_[k].convolution.apply(pressure[k].data(), displacement[k].data(), workspace_);
      for (double& value : displacement[k]) {
        value *= patches_[k].unit;
      }
    }
    if (others_) {
      others_->add(pressure, displacement);
    }
    ++applications_;
  }
  /// M, of each patch by itself; the fields may be the same.
  void precondition(std::size_t k, const std::vector<double>& residual,
                    std::vector<double>& correction) {
    patches_[k].inverse.apply(residual.data(), correction.data(), workspace_);
    for (double& value : correction) {
      value /= patches_[k].unit;
    }
  }
  /// What an element displaces at itself, mm/MPa.
  [[nodiscard]] double self(std::size_t k) const { return patches_[k].self; }
  /// sum a b dA over all patches.
  [[nodiscard]] double product(const Fields& one, const Fields& other) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      sum += patches_[k].area * dot(one[k].data(), other[k].data(), one[k].size());
    }
    return sum;
  }
  [[nodiscard]] int applications() const { return applications_; }

private:
  struct Patch {
    double unit = 1.0; ///< mm/MPa, of the kernel's units
    double area = 1.0;
    double self = 1.0;
    BoxConvolution<double> convolution;
    BoxConvolution<double> inverse;
  };
  std::vector<Patch> patches_;
  std::unique_ptr<CoupledInfluence> others_;
  ConvolutionWorkspace<double> workspace_;
  int applications_ = 0;
};

class YieldSolver {
public:
  YieldSolver(const NormalProblem& problem, InfluenceCache& cache)
      : problem_(problem), displacer_(problem, cache) {
    for (const PatchGap& gap : problem.patches) {
      std::vector<double>& shares = shares_.emplace_back(gap.grid.element_count());
      for (std::size_t i = 0; i < shares.size(); ++i) {
        shares[i] = gap.share(i);
      }
      distance_.emplace_back(gap.undeformed_distance.begin(), gap.undeformed_distance.end());
    }
  }

  NormalSolution solve();

private:
  /// Pressures, and what follows from them.
  struct State {
    Fields pressure;
    Fields gap; ///< h + A p + w
    std::vector<YieldTerms> terms;
    std::vector<Fields> excess_displacement; ///< A P_b, by body
    double energy = 0.0;
    double elastic_energy = 0.0; ///< 1/2 p.A p
    double largest = 0.0;
  };

  void scale_to_load(Fields& pressure) const;
  State at(Fields pressure);
  double approach_of(const State& state) const;
  void find_contact(const State& state, double approach);
  void linearise(const State& state);
  void apply_stiffness(const State& state, const Fields& direction, Fields& response);
  void precondition(const Fields& residual, Fields& correction);
  int find_step(const State& state, int limit);
  bool leave_out_leaving(const State& state);
  std::optional<State> moved(const State& state, double& change);

  [[nodiscard]] std::size_t count() const { return shares_.size(); }

  const NormalProblem& problem_;
  Displacer displacer_;
  Fields shares_;
  Fields distance_;
  Fields contact_;            ///< 1 on C, else 0
  Fields residual_;           ///< s delta - gap, on C
  Fields diagonal_;           ///< sum_b P_b'' A P_b
  Fields elastic_;            ///< E
  Fields jacobi_;             ///< (1 - E^2)/diag(H)
  Fields loaded_;             ///< M s, on C
  double loaded_share_ = 0.0; ///< sum s M s
  Fields step_;
  Fields product_;
  Fields by_body_;
};

void YieldSolver::scale_to_load(Fields& pressure) const {
  const double load = displacer_.product(pressure, shares_);
  if (problem_.load && load > 0.0) {
    for (std::vector<double>& field : pressure) {
      for (double& value : field) {
        value *= *problem_.load / load;
      }
    }
  }
}

YieldSolver::State YieldSolver::at(Fields pressure) {
  State state;
  state.pressure = std::move(pressure);
  displacer_.displace(state.pressure, state.gap);
  state.elastic_energy = 0.5 * displacer_.product(state.pressure, state.gap);
  state.energy = state.elastic_energy + displacer_.product(state.pressure, distance_);
  if (problem_.approach) {
    state.energy -= *problem_.approach * displacer_.product(state.pressure, shares_);
  }
  for (std::size_t k = 0; k < count(); ++k) {
    add_scaled(state.gap[k].data(), 1.0, distance_[k].data(), distance_[k].size());
    state.largest = std::max(state.largest,
                             *std::max_element(state.pressure[k].begin(), state.pressure[k].end()));
    state.terms.emplace_back(problem_.patches[k].grid, state.pressure[k],
                             problem_.patches[k].row_scales, problem_.yielding,
                             problem_.patches[k].carried);
  }
  state.excess_displacement.resize(problem_.yielding.size());
  Fields excess(count());
  for (std::size_t b = 0; b < problem_.yielding.size(); ++b) {
    for (std::size_t k = 0; k < count(); ++k) {
      excess[k] = state.terms[k].excess[b];
    }
    Fields& displaced = state.excess_displacement[b];
    displacer_.displace(excess, displaced);
    state.energy += 0.5 * displacer_.product(excess, displaced);
    for (std::size_t k = 0; k < count(); ++k) {
      state.terms[k].add_indentation(b, displaced[k], state.gap[k]);
    }
  }
  return state;
}

/// Given, or by least squares of the gaps under pressure.
double YieldSolver::approach_of(const State& state) const {
  if (problem_.approach) {
    return *problem_.approach;
  }
  double gaps = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < count(); ++k) {
    double sum = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < shares_[k].size(); ++i) {
      if (state.pressure[k][i] > 0.0) {
        sum += shares_[k][i] * state.gap[k][i];
        square += shares_[k][i] * shares_[k][i];
      }
    }
    gaps += problem_.patches[k].grid.element_area() * sum;
    squares += problem_.patches[k].grid.element_area() * square;
  }
  return gaps / squares;
}

void YieldSolver::find_contact(const State& state, double approach) {
  contact_ = residual_ = shares_;
  for (std::size_t k = 0; k < count(); ++k) {
    for (std::size_t i = 0; i < shares_[k].size(); ++i) {
      const double residual = approach * shares_[k][i] - state.gap[k][i];
      contact_[k][i] = state.pressure[k][i] > 0.0 || residual > 0.0 ? 1.0 : 0.0;
      residual_[k][i] = contact_[k][i] * residual;
    }
  }
}

void YieldSolver::linearise(const State& state) {
  diagonal_.assign(count(), {});
  elastic_ = jacobi_ = shares_;
  for (std::size_t k = 0; k < count(); ++k) {
    const YieldTerms& terms = state.terms[k];
    diagonal_[k].assign(shares_[k].size(), 0.0);
    const double self = displacer_.self(k);
    for (std::size_t i = 0; i < shares_[k].size(); ++i) {
      double squares = 1.0;
      for (std::size_t b = 0; b < terms.slope.size(); ++b) {
        diagonal_[k][i] += terms.curvature[b][i] * state.excess_displacement[b][k][i];
        squares += terms.slope[b][i] * terms.slope[b][i];
      }
      const double whole = self * squares + diagonal_[k][i];
      elastic_[k][i] = std::sqrt(self / whole);
      jacobi_[k][i] = (1.0 - self / whole) / whole;
    }
  }
  precondition(shares_, loaded_);
  loaded_share_ = displacer_.product(loaded_, shares_);
}

void YieldSolver::apply_stiffness(const State& state, const Fields& direction, Fields& response) {
  displacer_.displace(direction, response);
  product_.resize(count());
  for (std::size_t b = 0; b < problem_.yielding.size(); ++b) {
    for (std::size_t k = 0; k < count(); ++k) {
      product_[k] = direction[k];
      for_each_value([](double& value, double slope) { value *= slope; }, product_[k],
                     state.terms[k].slope[b]);
    }
    displacer_.displace(product_, by_body_);
    for (std::size_t k = 0; k < count(); ++k) {
      state.terms[k].add_indentation(b, by_body_[k], response[k]);
    }
  }
  for (std::size_t k = 0; k < count(); ++k) {
    for_each_value([](double& sum, double diagonal, double value,
                      double contact) { sum = contact * (sum + diagonal * value); },
                   response[k], diagonal_[k], direction[k], contact_[k]);
  }
}

/// On C.
void YieldSolver::precondition(const Fields& residual, Fields& correction) {
  correction.resize(count());
  for (std::size_t k = 0; k < count(); ++k) {
    std::vector<double>& values = correction[k];
    values = residual[k];
    for_each_value(
        [](double& value, double elastic, double contact) { value *= elastic * contact; }, values,
        elastic_[k], contact_[k]);
    displacer_.precondition(k, values, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = contact_[k][i] * (elastic_[k][i] * values[i] + jacobi_[k][i] * residual[k][i]);
    }
  }
}

/// v with H v = residual_ on C, to `yield_step_tolerance`; without load if that is given. Returns
/// the iterations.
int YieldSolver::find_step(const State& state, int limit) {
  Fields residual = residual_;
  Fields correction;
  Fields response;
  Fields direction(count());
  step_.assign(count(), {});
  for (std::size_t k = 0; k < count(); ++k) {
    direction[k].assign(shares_[k].size(), 0.0);
    step_[k].assign(shares_[k].size(), 0.0);
  }
  double first = 0.0;
  double last = 0.0;
  for (int iteration = 0;; ++iteration) {
    precondition(residual, correction);
    if (problem_.load) {
      const double share = displacer_.product(correction, shares_) / loaded_share_;
      for (std::size_t k = 0; k < count(); ++k) {
        add_scaled(correction[k].data(), -share, loaded_[k].data(), loaded_[k].size());
      }
    }
    const double now = displacer_.product(residual, correction);
    first = iteration == 0 ? now : first;
    if (!(now > yield_step_tolerance * yield_step_tolerance * first) || iteration >= limit) {
      return iteration;
    }
    const double growth = iteration == 0 ? 0.0 : now / last;
    last = now;
    for (std::size_t k = 0; k < count(); ++k) {
      for_each_value([growth](double& value, double by) { value = by + growth * value; },
                     direction[k], correction[k]);
    }
    apply_stiffness(state, direction, response);
    const double energy = displacer_.product(direction, response);
    if (!(energy > 0.0)) {
      return iteration;
    }
    for (std::size_t k = 0; k < count(); ++k) {
      add_scaled(step_[k].data(), now / energy, direction[k].data(), direction[k].size());
      add_scaled(residual[k].data(), -now / energy, response[k].data(), response[k].size());
    }
  }
}

/// Elements without pressure that the step would give less: without them it leads to less energy.
/// False if there are none.
bool YieldSolver::leave_out_leaving(const State& state) {
  bool any = false;
  for (std::size_t k = 0; k < count(); ++k) {
    for (std::size_t i = 0; i < step_[k].size(); ++i) {
      if (contact_[k][i] > 0.0 && !(state.pressure[k][i] > 0.0) && step_[k][i] < 0.0) {
        contact_[k][i] = residual_[k][i] = 0.0;
        any = true;
      }
    }
  }
  return any;
}

/// The step, or a part of it that leads to less energy; none if no part does.
std::optional<YieldSolver::State> YieldSolver::moved(const State& state, double& change) {
  const double permitted =
      state.energy + yield_energy_rounding * (std::abs(state.energy) + state.elastic_energy);
  double part = 1.0;
  for (int halving = 0; halving < yield_halvings; ++halving, part *= 0.5) {
    Fields pressure = state.pressure;
    for (std::size_t k = 0; k < count(); ++k) {
      for_each_value([part](double& value, double by) { value = std::max(0.0, value + part * by); },
                     pressure[k], step_[k]);
    }
    scale_to_load(pressure);
    State next = at(std::move(pressure));
    if (next.energy <= permitted) {
      change = 0.0;
      for (std::size_t k = 0; k < count(); ++k) {
        for (std::size_t i = 0; i < step_[k].size(); ++i) {
          change = std::max(change, std::abs(next.pressure[k][i] - state.pressure[k][i]));
        }
      }
      change = next.largest > 0.0 ? change / (part * next.largest) : 0.0;
      return next;
    }
  }
  return std::nullopt;
}

NormalSolution YieldSolver::solve() {
  Fields pressure;
  for (const PatchGap& gap : problem_.patches) {
    pressure.emplace_back(gap.start.begin(), gap.start.end());
  }
  scale_to_load(pressure);
  State state = at(std::move(pressure));
  NormalSolution solution;
  double change = 1.0;
  solution.stop_reason = StopReason::iteration_limit;
  for (int round = 0; round < yield_rounds && solution.iterations < problem_.maximum_iterations;
       ++round) {
    find_contact(state, approach_of(state));
    linearise(state);
    std::optional<State> next;
    do {
      solution.iterations += find_step(state, problem_.maximum_iterations - solution.iterations);
      next = moved(state, change);
    } while (!next && leave_out_leaving(state));
    if (!next) {
      solution.stop_reason = StopReason::stagnation;
      break;
    }
    state = std::move(*next);
    if (change <= problem_.tolerance) {
      solution.stop_reason = StopReason::tolerance_met;
      break;
    }
  }
  solution.pressure_error = change;
  solution.approach = approach_of(state);
  solution.convolutions = displacer_.applications();
  for (std::size_t k = 0; k < count(); ++k) {
    NormalSolution::Patch& patch = solution.patches.emplace_back();
    patch.pressure = std::move(state.pressure[k]);
    patch.normal_force = std::accumulate(patch.pressure.begin(), patch.pressure.end(), 0.0) *
                         problem_.patches[k].grid.element_area();
    for (std::size_t b = 0; b < problem_.yielding.size(); ++b) {
      state.terms[k].add_indentation(b, state.excess_displacement[b][k],
                                     patch.indentation.emplace_back(patch.pressure.size(), 0.0));
    }
  }
  return solution;
}

} // namespace

YieldTerms::YieldTerms(const Grid& grid, std::span<const double> pressure,
                       std::span<const double> scales, std::span<const YieldingBody> bodies,
                       std::span<const double> carried)
    : excess(bodies.size()), slope(bodies.size()), curvature(bodies.size()) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double root = std::sqrt(yield_stiffness * bodies[b].share);
    for (std::vector<double>* field : {&excess[b], &slope[b], &curvature[b]}) {
      field->resize(pressure.size());
    }
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      const std::size_t row = i / grid.longitudinal_count;
      const double scale = scales.empty() ? 1.0 : scales[row];
      const double before = carried.empty()                        ? 0.0
                            : carried.size() == grid.lateral_count ? carried[row]
                                                                   : carried[i];
      const Excess beyond = excess_of(scale * pressure[i], bodies[b].stress, before);
      excess[b][i] = root * beyond.value / scale;
      slope[b][i] = root * beyond.slope;
      curvature[b][i] = root * beyond.curvature * scale;
    }
  }
}

void YieldTerms::add_indentation(std::size_t b, std::span<const double> by_excess,
                                 std::span<double> displacement) const {
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    displacement[i] += slope[b][i] * by_excess[i];
  }
}

NormalSolution solve_yielding(const NormalProblem& problem, InfluenceCache& cache) {
  check_problem(problem);
  return YieldSolver(problem, cache).solve();
}

} // namespace wrc
