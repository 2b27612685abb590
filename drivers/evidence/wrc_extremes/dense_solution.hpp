/// The normal contact problem solved by elimination, in any precision: what the library's solver is
/// measured against. Nothing here is shared with it.
///
///   g = h + u - approach >= 0,  p >= 0,  p g = 0,  u_i = sum_j K_ij p_j,  sum p a b = load
/// with K_ij of the library's default elements, of smooth pressure: those of constant ones less a
/// 24th of their second differences. Those are 1/(pi E*) times the integral of 1/distance over
/// element j seen from the centre of element i (Love, Phil. Trans. A 228, 1929): near ones in
/// closed form, far ones by Gauss's rule, since the closed form cancels there.
/// The contact set is found by exchanges (Kim & Park, SIAM J. Sci. Comput. 33, 2011: blocks of
/// them, single ones when blocks make no progress); on each set Cholesky's factors solve for unit
/// approach and for the distance.
/// Units mm, N, MPa. Costs the cube of the number of elements in contact.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <vector>

#include "wrc_extremes/gap_problem.hpp"

namespace extremes {

/// Nodes and weights of Gauss's rule on -1 to 1, by Newton's method on Legendre's polynomial.
template <class Real, std::size_t order> struct GaussRule {
  std::array<Real, order> node{};
  std::array<Real, order> weight{};

  GaussRule() {
    for (std::size_t i = 0; i < order; ++i) {
      Real x = std::cos(std::numbers::pi_v<Real> * (static_cast<Real>(i) + Real(0.75)) /
                        (static_cast<Real>(order) + Real(0.5)));
      Real slope = 1;
      for (int step = 0; step < 100; ++step) {
        Real value = 1;
        Real before = 0;
        for (std::size_t n = 1; n <= order; ++n) {
          const Real degree = static_cast<Real>(n);
          const Real next = ((2 * degree - 1) * x * value - (degree - 1) * before) / degree;
          before = value;
          value = next;
        }
        slope = static_cast<Real>(order) * (x * value - before) / (x * x - 1);
        const Real change = value / slope;
        x -= change;
        if (std::abs(change) <= 2 * std::numeric_limits<Real>::epsilon()) {
          break;
        }
      }
      node[i] = x;
      weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

/// Integral of 1/distance over a rectangle of 1 x `aspect` (along, across), seen from x along and y
/// across from its centre, by Gauss's rule: for points some sides away.
template <class Real, std::size_t order> Real integral_by_rule(Real x, Real y, Real aspect) {
  static const GaussRule<Real, order> rule;
  Real sum = 0;
  for (std::size_t i = 0; i < order; ++i) {
    const Real dx = x - rule.node[i] / 2;
    for (std::size_t k = 0; k < order; ++k) {
      const Real dy = y - aspect * rule.node[k] / 2;
      sum += rule.weight[i] * rule.weight[k] / std::sqrt(dx * dx + dy * dy);
    }
  }
  return sum * aspect / 4;
}

/// Coefficients of smooth elements (the library's default) from those of constant ones, `constant`
/// by offset in rows and columns: less a 24th of the second differences.
template <class Real, class Constant>
Real smooth_influence(const Constant& constant, std::size_t rows, std::size_t columns) {
  const auto before = [](std::size_t index) { return index > 0 ? index - 1 : 1; };
  const Real here = constant(rows, columns);
  const Real others = (constant(before(rows), columns) + constant(rows + 1, columns)) +
                      (constant(rows, before(columns)) + constant(rows, columns + 1));
  return here - (others - 4 * here) / 24;
}

/// Integrals of 1/distance over a rectangle of 1 x `aspect` (along, across), by the offset of its
/// centre in elements.
template <class Real> class LoveIntegral {
public:
  explicit LoveIntegral(Real aspect) : aspect_(aspect) {}

  /// Coefficient of a smooth element.
  [[nodiscard]] Real at(std::size_t rows, std::size_t columns) const {
    return smooth_influence<Real>([this](std::size_t i, std::size_t j) { return constant(i, j); },
                                  rows, columns);
  }
  [[nodiscard]] Real constant(std::size_t rows, std::size_t columns) const {
    const Real x = static_cast<Real>(columns);
    const Real y = static_cast<Real>(rows) * aspect_;
    const Real far = closed_form_reach * std::max(Real(1), aspect_);
    return x * x + y * y >= far * far ? integral_by_rule<Real, order>(x, y, aspect_)
                                      : closed_form(x, y);
  }

private:
  /// In elements' longer sides. Beyond, the rule of this order is exact to 1e-21.
  static constexpr Real closed_form_reach = 8;
  static constexpr std::size_t order = 8;

  static Real antiderivative(Real x, Real y) {
    const Real first = x == 0 ? Real(0) : x * std::asinh(y / std::abs(x));
    const Real second = y == 0 ? Real(0) : y * std::asinh(x / std::abs(y));
    return first + second;
  }
  [[nodiscard]] Real closed_form(Real x, Real y) const {
    const Real a = Real(0.5);
    const Real b = aspect_ / 2;
    return (antiderivative(x + a, y + b) - antiderivative(x + a, y - b)) -
           (antiderivative(x - a, y + b) - antiderivative(x - a, y - b));
  }

  Real aspect_;
};

template <class Real> struct DenseSolution {
  std::vector<Real> pressure; ///< MPa
  Real approach = 0;          ///< mm
  int exchanges = 0;
  bool settled = false; ///< whether all signs are right in the end
};

/// Solves densely. Elements with pressure in `start` are the first contact set: a good one saves
/// exchanges, and none changes the answer.
template <class Real> class DenseSolver {
public:
  explicit DenseSolver(const GapProblem& problem) : problem_(problem) {
    const Real step = static_cast<Real>(problem.longitudinal_step);
    const LoveIntegral<Real> love(static_cast<Real>(problem.lateral_step) / step);
    const Real scale =
        step / (std::numbers::pi_v<Real> * static_cast<Real>(problem.combined_modulus));
    table_.reserve(problem.count());
    for (std::size_t row = 0; row < problem.rows; ++row) {
      for (std::size_t column = 0; column < problem.columns; ++column) {
        table_.push_back(love.at(row, column) * scale);
      }
    }
  }

  DenseSolution<Real> solve(const std::vector<double>& start) {
    constexpr int most_exchanges = 400;
    constexpr int patience_at_first = 3;
    active_.assign(problem_.count(), false);
    bool any = false;
    for (std::size_t i = 0; i < problem_.count(); ++i) {
      active_[i] = start[i] > 0.0;
      any = any || active_[i];
    }
    if (!any) {
      const auto& h = problem_.distance;
      active_[static_cast<std::size_t>(std::min_element(h.begin(), h.end()) - h.begin())] = true;
    }
    int patience = patience_at_first;
    std::size_t fewest = problem_.count() + 1;
    DenseSolution<Real> solution;
    for (; solution.exchanges < most_exchanges; ++solution.exchanges) {
      solve_on_active(solution);
      const std::vector<std::size_t> wrong = wrong_signs(solution);
      if (wrong.empty()) {
        solution.settled = true;
        return solution;
      }
      if (wrong.size() < fewest) {
        fewest = wrong.size();
        patience = patience_at_first;
      } else {
        --patience;
      }
      if (patience >= 0) {
        for (const std::size_t i : wrong) {
          active_[i] = !active_[i];
        }
      } else {
        active_[wrong.back()] = !active_[wrong.back()];
      }
    }
    return solution;
  }

private:
  [[nodiscard]] Real influence(std::size_t one, std::size_t other) const {
    const std::size_t columns = problem_.columns;
    const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
    return table_[apart(one / columns, other / columns) * columns +
                  apart(one % columns, other % columns)];
  }

  /// Cholesky's factors of the active elements' matrix, then pressures for the load or approach.
  void solve_on_active(DenseSolution<Real>& solution) {
    chosen_.clear();
    for (std::size_t i = 0; i < active_.size(); ++i) {
      if (active_[i]) {
        chosen_.push_back(i);
      }
    }
    const std::size_t size = chosen_.size();
    std::vector<Real> factor(size * size);
    std::vector<Real> unit(size, Real(1));
    std::vector<Real> shape(size);
    // Distances from the least one: the rest is a shift of the approach.
    const double least = *std::min_element(problem_.distance.begin(), problem_.distance.end());
    for (std::size_t i = 0; i < size; ++i) {
      shape[i] = static_cast<Real>(problem_.distance[chosen_[i]]) - static_cast<Real>(least);
      for (std::size_t k = 0; k <= i; ++k) {
        Real sum = influence(chosen_[i], chosen_[k]);
        for (std::size_t n = 0; n < k; ++n) {
          sum -= factor[i * size + n] * factor[k * size + n];
        }
        factor[i * size + k] = i == k ? std::sqrt(sum) : sum / factor[k * size + k];
      }
    }
    for (std::vector<Real>* values : {&unit, &shape}) {
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t n = 0; n < i; ++n) {
          (*values)[i] -= factor[i * size + n] * (*values)[n];
        }
        (*values)[i] /= factor[i * size + i];
      }
      for (std::size_t i = size; i-- > 0;) {
        for (std::size_t n = i + 1; n < size; ++n) {
          (*values)[i] -= factor[n * size + i] * (*values)[n];
        }
        (*values)[i] /= factor[i * size + i];
      }
    }
    Real unit_sum = 0;
    Real shape_sum = 0;
    for (std::size_t i = 0; i < size; ++i) {
      unit_sum += unit[i];
      shape_sum += shape[i];
    }
    const Real area =
        static_cast<Real>(problem_.lateral_step) * static_cast<Real>(problem_.longitudinal_step);
    height_ = problem_.approach
                  ? static_cast<Real>(*problem_.approach) - static_cast<Real>(least)
                  : (static_cast<Real>(problem_.normal_load) / area + shape_sum) / unit_sum;
    solution.approach = height_ + static_cast<Real>(least);
    solution.pressure.assign(problem_.count(), Real(0));
    for (std::size_t i = 0; i < size; ++i) {
      solution.pressure[chosen_[i]] = height_ * unit[i] - shape[i];
    }
    least_ = static_cast<Real>(least);
  }

  /// Elements that pull, and elements without pressure that overlap by more than rounding.
  std::vector<std::size_t> wrong_signs(const DenseSolution<Real>& solution) const {
    const Real largest = *std::max_element(solution.pressure.begin(), solution.pressure.end());
    const Real permitted =
        -1000 * std::numeric_limits<Real>::epsilon() * table_.front() * std::abs(largest);
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      if (active_[i]) {
        if (solution.pressure[i] < 0) {
          wrong.push_back(i);
        }
        continue;
      }
      Real gap = (static_cast<Real>(problem_.distance[i]) - least_) - height_;
      for (std::size_t k = 0; k < chosen_.size() && gap < permitted; ++k) {
        gap += influence(i, chosen_[k]) * solution.pressure[chosen_[k]];
      }
      if (gap < permitted) {
        wrong.push_back(i);
      }
    }
    return wrong;
  }

  const GapProblem& problem_;
  std::vector<Real> table_; ///< by offset, mm/MPa
  std::vector<bool> active_;
  std::vector<std::size_t> chosen_;
  Real height_ = 0; ///< approach above the least distance
  Real least_ = 0;
};

} // namespace extremes
