#include "rolling/problem_rates.hpp"

#include <algorithm>

#include "base/reductions.hpp"
#include "rolling/constants.hpp"
#include "rolling/leading_edge.hpp"

namespace wrc {
namespace {

/// Derivative of the coefficients by the logarithm of the ratio of lateral to longitudinal steps.
TractionTable table_by_aspect(double aspect, const TractionShape& shape) {
  const auto table = [&](double factor) {
    return traction_table(factor * aspect, shape.table_rows(), shape.table_columns());
  };
  TractionTable ahead = table(1.0 + aspect_step);
  const TractionTable behind = table(1.0 - aspect_step);
  for (std::size_t i = 0; i < ahead.values.size(); ++i) {
    ahead.values[i] = (ahead.values[i] - behind.values[i]) / (2.0 * aspect_step);
  }
  return ahead;
}

/// Where an element is, and how it moves.
struct MovingElement {
  std::size_t index;
  double x, by_x, by_y;
  double lever, by_lever; ///< of longitudinal tractions
};

template <typename Real> class Rates {
public:
  Rates(const RollingProblem& problem, const ScaledTractions& scaled, TractionNewton<Real>& solved,
        LinePlans& plans)
      : problem_(problem), scaled_(scaled), solved_(solved), kept_share_(2 * solved.size()),
        slip_(2 * solved.size()), by_aspect_(2 * solved.size()) {
    for (AlignedArray<Real>* field : {&kept_share_, &slip_}) {
      std::fill_n(field->data(), field->size(), Real{0}); // also beyond the columns
    }
    fill(by_aspect_, scaled.difference().weights, table_by_aspect(scaled.aspect(), solved.shape()),
         plans);
    if (problem.step_length > 0.0) {
      const double upstream = scaled.difference().upstream;
      by_length_ = AlignedArray<Real>(2 * solved.size());
      fill(by_length_, {0.0, 1.0 - upstream, 0.0, 0.0}, scaled.table(), plans);
      RollingProblem steady = problem;
      steady.step_length = 0.0;
      by_share_ = AlignedArray<Real>(2 * solved.size());
      fill(by_share_, difference_of(steady).weights, scaled.table(), plans);
      for (std::size_t i = 0; upstream > 0.0 && i < by_share_.size(); ++i) {
        by_share_.data()[i] +=
            static_cast<Real>(solved.edge()[i] / upstream) * solved.traction()[i];
      }
    }
  }

  std::array<double, 4> forces_by(const ProblemRate& rate) {
    const Grid& grid = problem_.grid;
    const std::size_t size = solved_.size();
    const Real* q = solved_.traction();
    const Real* bound = solved_.bound();
    Real* kept_share = kept_share_.data();
    Real* slip = slip_.data();
    for_each_element(rate, [&](std::size_t at, const MovingElement& element) {
      const double share = rate.pressure[element.index] / problem_.pressure[element.index] +
                           ratio_growth(rate, at, element.index);
      kept_share[at] = static_cast<Real>(share * static_cast<double>(q[at]));
      kept_share[size + at] = static_cast<Real>(share * static_cast<double>(q[size + at]));
    });
    solved_.convolve(kept_share, slip);
    const double longitudinal = rate.longitudinal_step / grid.longitudinal_step;
    const double lateral = rate.lateral_step / grid.lateral_step;
    add_scaled(slip, lateral - longitudinal, by_aspect_.data(), 2 * size);
    if (problem_.step_length > 0.0) {
      add_scaled(slip, longitudinal, by_length_.data(), 2 * size);
      add_scaled(slip, rate.rolling_share * problem_unit() / scaled_.slip_scale(), by_share_.data(),
                 2 * size);
    }
    const double spin = problem_.creepages.spin / scaled_.slip_scale();
    const double ahead = difference_of(problem_).place * rate.longitudinal_step;
    for_each_element(rate, [&](std::size_t at, const MovingElement& element) {
      slip[at] += static_cast<Real>(-spin * element.by_y);
      slip[size + at] += static_cast<Real>(spin * (element.by_x + ahead));
      if (!rate.slip_x.empty()) {
        slip[at] += static_cast<Real>(rate.slip_x[element.index] / scaled_.slip_scale());
        slip[size + at] += static_cast<Real>(rate.slip_y[element.index] / scaled_.slip_scale());
      }
    });
    add_moving_edges(rate, slip);
    const Real* turning = solved_.solve_rate(slip, rate_tolerance);
    std::array<double, 4> forces{};
    for_each_element(rate, [&](std::size_t at, const MovingElement& element) {
      const double growth = longitudinal + lateral - ratio_growth(rate, at, element.index);
      const double mean = scaled_.mean_share(element.index, static_cast<double>(bound[at]));
      const auto sum = [&](std::size_t i) {
        return mean * (static_cast<double>(kept_share[i]) + static_cast<double>(turning[i]) +
                       growth * static_cast<double>(q[i]));
      };
      const double x = sum(at);
      const double y = sum(size + at);
      forces[0] += x;
      forces[1] += y;
      forces[2] += element.x * y + mean * element.by_x * static_cast<double>(q[size + at]) -
                   element.lever * x - mean * element.by_lever * static_cast<double>(q[at]);
      if (!rate.weight_x.empty()) {
        forces[3] += mean * (rate.weight_x[element.index] * static_cast<double>(q[at]) +
                             rate.weight_y[element.index] * static_cast<double>(q[size + at]));
      }
      if (!problem_.weight_x.empty()) {
        forces[3] += problem_.weight_x[element.index] * x + problem_.weight_y[element.index] * y;
      }
    });
    for (double& force : forces) {
      force *= scaled_.bound() * grid.element_area();
    }
    return forces;
  }

private:
  /// What the tractions displace with these weights and coefficients.
  void fill(AlignedArray<Real>& field, const DifferenceWeights& weights, const TractionTable& table,
            LinePlans& plans) {
    const std::size_t size = solved_.size();
    const Real* q = solved_.traction();
    const TractionConvolution<Real> convolution(solved_.shape(), solved_.pitch(), problem_.poisson,
                                                weights, table, plans, scaled_.angles());
    ConvolutionWorkspace<Real> workspace;
    std::fill_n(field.data(), 2 * size, Real{0});
    convolution.apply(q, q + size, field.data(), field.data() + size, workspace);
  }

  /// Unit of the slips that tractions without units cause.
  [[nodiscard]] double problem_unit() const { return scaled_.bound() / problem_.shear_modulus; }

  /// Whether a strip begins with an element and its edge moves.
  [[nodiscard]] bool has_moving_edge(const ProblemRate& rate, std::size_t at) const {
    return !rate.covered.empty() && scaled_.has_edges() &&
           (at < solved_.pitch() || !(solved_.bound()[at - solved_.pitch()] > Real{0}));
  }

  /// Growth of edge_traction_ratio, which is c^(-1/2) except for a factor.
  [[nodiscard]] double ratio_growth(const ProblemRate& rate, std::size_t at,
                                    std::size_t index) const {
    const bool moves = has_moving_edge(rate, at) && problem_.covered[index] > min_edge_share;
    return moves ? -0.5 * scaled_.difference().upstream * rate.covered[index] /
                       problem_.covered[index]
                 : 0.0;
  }

  /// What leading edges that move within their elements add to slips.
  void add_moving_edges(const ProblemRate& rate, Real* slip) const {
    const std::size_t size = solved_.size();
    const Real* q = solved_.traction();
    const double upstream = scaled_.difference().upstream;
    for_each_element(rate, [&](std::size_t at, const MovingElement& element) {
      if (has_moving_edge(rate, at) && upstream > 0.0) {
        const auto add = [&](std::size_t i, double unit) {
          const double compliance = static_cast<double>(solved_.edge()[i]) / unit;
          const double by = edge_compliance_rate(compliance, problem_.covered[element.index]);
          slip[i] += static_cast<Real>(unit * by * rate.covered[element.index]) * q[i];
        };
        add(at, upstream * (1.0 - problem_.poisson));
        add(size + at, upstream);
      }
    });
  }

  /// Visits elements under pressure; the first argument is their index in the fields.
  template <class Visit> void for_each_element(const ProblemRate& rate, const Visit& visit) const {
    const Grid& grid = problem_.grid;
    for (std::size_t row = 0; row < solved_.shape().rows; ++row) {
      for (std::size_t column = 0; column < solved_.shape().columns; ++column) {
        const std::size_t index = scaled_.element(row, column);
        if (problem_.pressure[index] > 0.0) {
          const std::size_t i = index % grid.longitudinal_count;
          const std::size_t j = index / grid.longitudinal_count;
          visit(row * solved_.pitch() + column,
                MovingElement{index, grid.longitudinal(i),
                              rate.longitudinal_first +
                                  static_cast<double>(i) * rate.longitudinal_step,
                              rate.lateral_first + static_cast<double>(j) * rate.lateral_step,
                              lever_of(problem_, j, grid.lateral_first, grid.lateral_step),
                              lever_of(problem_, j, rate.lateral_first, rate.lateral_step)});
        }
      }
    }
  }

  const RollingProblem& problem_;
  const ScaledTractions& scaled_;
  TractionNewton<Real>& solved_;
  AlignedArray<Real> kept_share_; ///< q'
  AlignedArray<Real> slip_;
  AlignedArray<Real> by_aspect_; ///< what q displaces, by the ratio of the steps
  /// Likewise in a step of time, by the logarithm of their length and by the share of rolling.
  AlignedArray<Real> by_length_;
  AlignedArray<Real> by_share_;
};

} // namespace

template <typename Real>
std::vector<std::array<double, 4>> rates_of_forces(const RollingProblem& problem,
                                                   const ScaledTractions& scaled,
                                                   TractionNewton<Real>& solved, LinePlans& plans) {
  std::vector<std::array<double, 4>> forces;
  if (!problem.rates.empty()) {
    Rates<Real> rates(problem, scaled, solved, plans);
    for (const ProblemRate& rate : problem.rates) {
      forces.push_back(rates.forces_by(rate));
    }
  }
  return forces;
}

template std::vector<std::array<double, 4>>
rates_of_forces(const RollingProblem&, const ScaledTractions&, TractionNewton<float>&, LinePlans&);
template std::vector<std::array<double, 4>>
rates_of_forces(const RollingProblem&, const ScaledTractions&, TractionNewton<double>&, LinePlans&);

} // namespace wrc
