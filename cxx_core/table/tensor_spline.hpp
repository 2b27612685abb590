/// Cubic splines of several variables on a rectangular grid of equally spaced nodes.
///
/// Tensor products of B-splines with not-a-knot ends (de Boor, A Practical Guide to Splines, 1978,
/// ch. IX and XVII), with one coefficient for each node. They have continuous
/// second derivatives; beyond the nodes they go on along their tangent. Units: those of the values.
/// Thread rule: plain values; `at` and `evaluate` are pure and allocate nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/value_with_rates.hpp"
#include "base/vector_clones.hpp"

namespace wrc {

/// The nodes of one variable, and the basis over them.
struct SplineAxis {
  double first = 0.0;
  double step = 1.0;
  std::size_t count = 4; ///< of nodes, at least 4

  SplineAxis() = default;
  SplineAxis(double from, double to, std::size_t nodes)
      : first(from), step((to - from) / static_cast<double>(nodes - 1)), count(nodes) {}

  [[nodiscard]] double node(std::size_t i) const { return first + step * static_cast<double>(i); }
  [[nodiscard]] double last() const { return node(count - 1); }

  /// The four basis functions that are not 0 somewhere, and their slopes.
  struct Weights {
    std::size_t index = 0; ///< of the first one
    std::array<double, 4> value{};
    std::array<double, 4> slope{};
  };
  [[nodiscard]] Weights at(double x) const {
    // Not-a-number: the first node.
    const double place = x > first ? std::min(x, last()) : first;
    const double cell = (place - first) / step;
    const std::size_t node_before = std::min(static_cast<std::size_t>(cell), count - 2);
    Weights weights;
    weights.index = std::clamp<std::size_t>(node_before, 1, count - 3) - 1;
    std::array<double, 3> left{};
    std::array<double, 3> right{};
    for (std::size_t j = 0; j < 3; ++j) {
      left[j] = cell - knot(weights.index + 3 - j);
      right[j] = knot(weights.index + 4 + j) - cell;
    }
    std::array<double, 4>& value = weights.value;
    value[0] = 1.0;
    std::array<double, 3> quadratic{};
    for (std::size_t degree = 1; degree <= 3; ++degree) {
      if (degree == 3) {
        quadratic = {value[0], value[1], value[2]};
      }
      double saved = 0.0;
      for (std::size_t r = 0; r < degree; ++r) {
        const double share = value[r] / (right[r] + left[degree - 1 - r]);
        value[r] = saved + right[r] * share;
        saved = left[degree - 1 - r] * share;
      }
      value[degree] = saved;
    }
    double before = 0.0;
    for (std::size_t r = 0; r < 3; ++r) {
      const double rate = 3.0 * quadratic[r] / ((right[r] + left[2 - r]) * step);
      weights.slope[r] = before - rate;
      before = rate;
    }
    weights.slope[3] = before;
    for (std::size_t r = 0; r < 4; ++r) {
      value[r] += (x - place) * weights.slope[r];
    }
    return weights;
  }

private:
  /// In steps from the first node.
  [[nodiscard]] double knot(std::size_t i) const {
    return i <= 3 ? 0.0 : i >= count ? static_cast<double>(count - 1) : static_cast<double>(i - 2);
  }
};

/// From values at the nodes of an axis to coefficients, in place: of each of `lines` lines, values
/// `stride` apart.
void interpolate_lines(const SplineAxis& axis, double* values, std::size_t stride,
                       const std::vector<std::size_t>& lines);

/// `parts` splines of the same variables; the last variable runs fastest, then the parts.
template <std::size_t variables, std::size_t parts, class Stored = double> class TensorSpline {
public:
  using Axes = std::array<SplineAxis, variables>;
  using Place = std::array<double, variables>;
  struct Values {
    alignas(64) std::array<double, parts> value{};
    alignas(64) std::array<std::array<double, parts>, variables> slope{};
  };

  TensorSpline() = default;
  /// Through `values`, in the order of the coefficients.
  TensorSpline(const Axes& axes, std::vector<double> values) : axes_(axes) {
    std::size_t stride = parts;
    for (std::size_t variable = variables; variable-- > 0;) {
      std::vector<std::size_t> lines;
      const std::size_t block = stride * axes[variable].count;
      for (std::size_t outer = 0; outer < values.size(); outer += block) {
        for (std::size_t inner = 0; inner < stride; ++inner) {
          lines.push_back(outer + inner);
        }
      }
      interpolate_lines(axes[variable], values.data(), stride, lines);
      stride = block;
    }
    coefficients_.assign(values.begin(), values.end());
  }

  [[nodiscard]] static std::size_t size_of(const Axes& axes) {
    std::size_t size = parts;
    for (const SplineAxis& axis : axes) {
      size *= axis.count;
    }
    return size;
  }
  [[nodiscard]] const Axes& axes() const { return axes_; }
  /// Without coefficients, which then must follow.
  void set_axes(const Axes& axes) { axes_ = axes; }
  [[nodiscard]] std::vector<Stored>& coefficients() { return coefficients_; }
  [[nodiscard]] const std::vector<Stored>& coefficients() const { return coefficients_; }

  WRC_VECTOR_BODY void evaluate(const Place& place, Values& to) const {
    std::array<SplineAxis::Weights, variables> weights;
    for (std::size_t i = 0; i < variables; ++i) {
      weights[i] = axes_[i].at(place[i]);
    }
    contract<0>(weights, 0, to);
  }

  /// Without slopes.
  WRC_VECTOR_BODY std::array<double, parts> values(const Place& place) const {
    std::array<SplineAxis::Weights, variables> weights;
    for (std::size_t i = 0; i < variables; ++i) {
      weights[i] = axes_[i].at(place[i]);
    }
    std::array<double, parts> to{};
    add_values<0>(weights, 0, 1.0, to);
    return to;
  }

private:
  template <std::size_t variable>
  WRC_VECTOR_BODY void add_values(const std::array<SplineAxis::Weights, variables>& weights,
                                  std::size_t before, double weight,
                                  std::array<double, parts>& to) const {
    const SplineAxis::Weights& own = weights[variable];
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t at = before * axes_[variable].count + own.index + k;
      const double value = weight * own.value[k];
      if constexpr (variable + 1 == variables) {
        const Stored* const from = coefficients_.data() + at * parts;
        for (std::size_t i = 0; i < parts; ++i) {
          to[i] += value * from[i];
        }
      } else {
        add_values<variable + 1>(weights, at, value, to);
      }
    }
  }

  template <std::size_t variable>
  WRC_VECTOR_BODY void contract(const std::array<SplineAxis::Weights, variables>& weights,
                                std::size_t before, Values& to) const {
    to.value.fill(0.0);
    for (std::size_t j = variable; j < variables; ++j) {
      to.slope[j].fill(0.0);
    }
    const SplineAxis::Weights& own = weights[variable];
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t at = before * axes_[variable].count + own.index + k;
      const double value = own.value[k];
      const double slope = own.slope[k];
      if constexpr (variable + 1 == variables) {
        const Stored* const from = coefficients_.data() + at * parts;
        for (std::size_t i = 0; i < parts; ++i) {
          to.value[i] += value * from[i];
          to.slope[variable][i] += slope * from[i];
        }
      } else {
        Values inner;
        contract<variable + 1>(weights, at, inner);
        for (std::size_t i = 0; i < parts; ++i) {
          to.value[i] += value * inner.value[i];
          to.slope[variable][i] += slope * inner.value[i];
        }
        for (std::size_t j = variable + 1; j < variables; ++j) {
          for (std::size_t i = 0; i < parts; ++i) {
            to.slope[j][i] += value * inner.slope[j][i];
          }
        }
      }
    }
  }

  Axes axes_{};
  std::vector<Stored> coefficients_;
};

/// A part of the values at a place that `evaluate` found, with the rates of the place, if any.
template <class Values, std::size_t variables>
double part_of(const Values& found, std::size_t part, const std::array<double, variables>&) {
  return found.value[part];
}
template <class Values, std::size_t variables, std::size_t count>
WRC_VECTOR_BODY WithRates<count> part_of(const Values& found, std::size_t part,
                                         const std::array<WithRates<count>, variables>& place) {
  WithRates<count> result(found.value[part]);
  for (std::size_t variable = 0; variable < variables; ++variable) {
    for (std::size_t i = 0; i < count; ++i) {
      result.rates[i] += found.slope[variable][part] * place[variable].rates[i];
    }
  }
  return result;
}

} // namespace wrc
