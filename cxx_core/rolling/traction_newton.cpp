#include "rolling/traction_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/reductions.hpp"
#include "rolling/constants.hpp"

namespace wrc {

namespace {

/// The least-squares problem of GMRES: a Hessenberg matrix reduced column by column by rotations.
class KrylovReduction {
public:
  explicit KrylovReduction(double norm) { rest_[0] = norm; }

  [[nodiscard]] double rest() const { return std::abs(rest_[size_]); }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Products of the new vector with the ones before, and its own norm after these are taken away.
  void add(const std::array<double, krylov_limit>& products, double norm) {
    auto& column = columns_[size_];
    column = products;
    for (std::size_t i = 0; i < size_; ++i) {
      const double above = column[i];
      const double below = column[i + 1];
      column[i] = cosines_[i] * above + sines_[i] * below;
      column[i + 1] = cosines_[i] * below - sines_[i] * above;
    }
    const double length = std::hypot(column[size_], norm);
    cosines_[size_] = length > 0.0 ? column[size_] / length : 1.0;
    sines_[size_] = length > 0.0 ? norm / length : 0.0;
    column[size_] = length;
    rest_[size_ + 1] = -sines_[size_] * rest_[size_];
    rest_[size_] *= cosines_[size_];
    ++size_;
  }

  [[nodiscard]] std::array<double, krylov_limit> solution() const {
    std::array<double, krylov_limit> y{};
    for (std::size_t i = size_; i-- > 0;) {
      double sum = rest_[i];
      for (std::size_t j = i + 1; j < size_; ++j) {
        sum -= columns_[j][i] * y[j];
      }
      y[i] = columns_[i][i] != 0.0 ? sum / columns_[i][i] : 0.0;
    }
    return y;
  }

private:
  std::size_t size_ = 0;
  std::array<std::array<double, krylov_limit>, krylov_limit> columns_{};
  std::array<double, krylov_limit> cosines_{};
  std::array<double, krylov_limit> sines_{};
  std::array<double, krylov_limit + 1> rest_{};
};

} // namespace

template <typename Real>
TractionNewton<Real>::TractionNewton(const TractionGrid& grid, double poisson,
                                     const SlipDifferenceWeights& difference,
                                     const TractionTable& table, LinePlans& plans)
    : shape_(grid.shape), upstream_(difference.upstream),
      pitch_(aligned_pitch<Real>(grid.shape.columns)), count_(grid.shape.rows * pitch_),
      convolution_(grid.shape, pitch_, poisson, difference.weights, table, plans, grid.angles),
      march_(grid.shape.rows, pitch_, grid.step_over_width, difference.upstream),
      fields_((3 + 2 * vector_count + element_fields) * count_), elements_{} {
  std::fill_n(fields_.data(), fields_.size(), Real{0});
  const auto self = convolution_.self_influence();
  self_influence_ = std::sqrt(self[0] * self[1]);
  scales_ = {natural_step_of(shape_, self, difference.upstream), march_.diagonal() * self[0],
             march_.diagonal() * self[1], 0.0};
  Real* scalars = vector(vector_count);
  elements_ = {scalars,
               scalars + count_,
               scalars + 2 * count_,
               scalars + 3 * count_,
               scalars + 4 * count_,
               scalars + 5 * count_,
               scalars + 6 * count_};
}

template <typename Real> void TractionNewton<Real>::convolve(const Real* in, Real* out) {
  convolution_.apply(in, in + count_, out, out + count_, workspace_);
  add_edges(edge(), in, out, count_);
  ++convolutions_;
}

template <typename Real>
double TractionNewton<Real>::residual_of(const Real* q, const Real* s) const {
  return natural_residual(q, s, fields_.data(), fields_.data() + count_, scales_.step, count_)
      .ratio();
}

template <typename Real>
void TractionNewton<Real>::solve_linear(double relative_tolerance, Real* step, Real* step_slip) {
  const std::size_t size = 2 * count_;
  const auto provided = [&](std::vector<AlignedArray<Real>>& arrays, std::size_t index,
                            std::size_t length) {
    if (arrays.size() <= index) {
      arrays.emplace_back(length);
      std::fill_n(arrays.back().data(), length, Real{0});
    }
    return arrays[index].data();
  };
  const Real* right = vector(right_side);
  const double norm = std::sqrt(dot(right, right, size));
  if (!(norm > 0.0)) {
    std::fill_n(step, size, Real{0});
    std::fill_n(step_slip, size, Real{0});
    return;
  }
  scale_to(provided(krylov_, 0, size), 1.0 / norm, right, size);
  KrylovReduction reduction(norm);
  while (reduction.size() < krylov_limit && reduction.rest() > relative_tolerance * norm) {
    const std::size_t j = reduction.size();
    Real* z = provided(directions_, j, 2 * size);
    Real* displaced = z + size;
    Real* next = provided(krylov_, j + 1, size);
    march_.apply(elements_, scales_, krylov_[j].data(), z);
    convolve(z, displaced);
    project(elements_, displaced, z, next, count_);
    std::array<double, krylov_limit> products{};
    for (std::size_t i = 0; i <= j; ++i) {
      products[i] = dot(next, krylov_[i].data(), size);
      add_scaled(next, -products[i], krylov_[i].data(), size);
    }
    const double rest = std::sqrt(dot(next, next, size));
    reduction.add(products, rest);
    if (!(rest > std::numeric_limits<Real>::epsilon() * norm)) {
      break;
    }
    scale_to(next, 1.0 / rest, next, size);
  }
  const auto weights = reduction.solution();
  scale_to(step, weights[0], directions_[0].data(), size);
  scale_to(step_slip, weights[0], directions_[0].data() + size, size);
  for (std::size_t j = 1; j < reduction.size(); ++j) {
    add_scaled(step, weights[j], directions_[j].data(), size);
    add_scaled(step_slip, weights[j], directions_[j].data() + size, size);
  }
}

/// q and s after the whole step, or after a half or a quarter of it where the whole one leads away.
template <typename Real>
void TractionNewton<Real>::take_step(double residual, const Real* step, const Real* step_slip) {
  const std::size_t size = 2 * count_;
  Real* q = vector(tractions);
  Real* s = vector(slips);
  add_scaled(q, 1.0, step, size);
  add_scaled(s, 1.0, step_slip, size);
  double best = residual_of(q, s);
  if (best <= allowed_growth * residual) {
    return;
  }
  double taken = 1.0;
  double best_share = 1.0;
  for (const double share : {0.5, 0.25}) {
    add_scaled(q, share - taken, step, size);
    add_scaled(s, share - taken, step_slip, size);
    taken = share;
    const double reached = residual_of(q, s);
    if (reached < best) {
      best = reached;
      best_share = share;
    }
  }
  add_scaled(q, best_share - taken, step, size);
  add_scaled(s, best_share - taken, step_slip, size);
}

template <typename Real> NewtonOutcome TractionNewton<Real>::solve(const NewtonLimits& limits) {
  const std::size_t size = 2 * count_;
  const Real* g = bound();
  Real* q = vector(tractions);
  Real* s = vector(slips);
  Real* change = vector(changes);
  Real* right = vector(right_side);
  Real* step = vector(steps);
  Real* step_slip = vector(step_slips);
  Real* best_q = vector(best_tractions);
  Real* best_s = vector(best_slips);
  const auto keep_best = [&] {
    std::copy_n(q, size, best_q);
    std::copy_n(s, size, best_s);
  };

  convolutions_ = 0;
  NewtonOutcome outcome;
  outcome.residual = std::numeric_limits<double>::infinity();
  scales_.damping = 0.0;
  convolve(q, s);
  add_scaled(s, 1.0, rigid_slip(), size);
  int without_progress = 0;
  while (true) {
    const double residual = residual_of(q, s);
    if (residual < outcome.residual) {
      outcome.residual = residual;
      keep_best();
      without_progress = 0;
      scales_.damping *= damping_decay;
    } else if (++without_progress % patience == 0) {
      scales_.damping = std::max(first_damping * self_influence_, damping_growth * scales_.damping);
    }
    if (outcome.residual <= limits.tolerance || outcome.iterations >= limits.iterations) {
      break;
    }
    ++outcome.iterations;
    linearise(q, s, g, edge(), scales_, elements_, change, count_);
    add_scaled(q, 1.0, change, size);
    convolve(change, right);
    add_scaled(s, 1.0, right, size);
    std::fill_n(step, size, Real{0});
    project(elements_, s, step, right, count_);
    scale_to(right, -1.0, right, size);
    const double wanted = std::max(forcing, forcing_of_rest * limits.tolerance / residual);
    solve_linear(wanted, step, step_slip);
    take_step(residual, step, step_slip);
  }
  std::copy_n(best_q, size, q);
  std::copy_n(best_s, size, s);
  cut_to_bound(q, s, g, edge(), scales_.step, count_);
  outcome.converged = outcome.residual <= limits.tolerance;
  outcome.convolutions = convolutions_;
  return outcome;
}

template <typename Real>
const Real* TractionNewton<Real>::solve_rate(const Real* slip_rate, double relative_tolerance) {
  const std::size_t size = 2 * count_;
  Real* rate = vector(best_tractions);
  Real* slips_of_rate = vector(best_slips);
  Real* right = vector(right_side);
  scales_.damping = 0.0;
  linearise(vector(tractions), vector(slips), bound(), edge(), scales_, elements_, vector(changes),
            count_);
  std::fill_n(rate, size, Real{0});
  std::copy_n(slip_rate, size, slips_of_rate);
  double first = 0.0;
  for (int restart = 0; restart < rate_restarts; ++restart) {
    project(elements_, slips_of_rate, rate, right, count_);
    scale_to(right, -1.0, right, size);
    const double norm = std::sqrt(dot(right, right, size));
    first = std::max(first, norm);
    if (!(norm > relative_tolerance * first)) {
      break;
    }
    solve_linear(relative_tolerance * first / norm, vector(steps), vector(step_slips));
    add_scaled(rate, 1.0, vector(steps), size);
    add_scaled(slips_of_rate, 1.0, vector(step_slips), size);
  }
  return rate;
}

template class TractionNewton<float>;
template class TractionNewton<double>;

} // namespace wrc
