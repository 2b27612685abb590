#include "mechanics/patch_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/vector_clones.hpp"
#include "mechanics/constants.hpp"

namespace wrc {

namespace {

double extent(std::size_t elements, double step) {
  return static_cast<double>(elements - 1) * step;
}

/// Centres of a box's elements along one direction.
struct Interval {
  double first = 0.0;
  double length = 0.0;
  [[nodiscard]] double half() const { return 0.5 * length; }
  [[nodiscard]] double middle() const { return first + half(); }
  [[nodiscard]] double last() const { return first + length; }
};

Interval lateral_of(const Grid& box) {
  return {box.lateral_first, extent(box.lateral_count, box.lateral_step)};
}

Interval longitudinal_of(const Grid& box) {
  return {box.longitudinal_first, extent(box.longitudinal_count, box.longitudinal_step)};
}

/// 0 if they overlap.
double between(const Interval& one, const Interval& other) {
  return std::max({0.0, other.first - one.last(), one.first - other.last()});
}

/// ln rho along one direction of a box: its half length, and how far the other box lies beyond it
/// and beside it.
double convergence(double half, double beyond, double beside) {
  return half > 0.0 ? std::max(std::acosh(1.0 + beyond / half), std::asinh(beside / half))
                    : std::numeric_limits<double>::infinity();
}

double half_diagonal(const Grid& box) {
  return std::hypot(lateral_of(box).half(), longitudinal_of(box).half());
}

/// Between the loads of two boxes: that of their middles, or half of the longer diagonal where long
/// boxes lie close beside each other, or on each other; that of one element is no less than its
/// diagonal.
double typical_distance(const Grid& one, const Grid& other) {
  const double middles =
      std::hypot(lateral_of(one).middle() - lateral_of(other).middle(),
                 longitudinal_of(one).middle() - longitudinal_of(other).middle());
  const double element = std::hypot(one.lateral_step, one.longitudinal_step);
  return std::max({middles, half_diagonal(one), half_diagonal(other), element});
}

/// sums[k] = sum_i values[i] * weights[k * count + i].
template <typename Real>
WRC_VECTOR_BODY void gather_body(const Real* values, const Real* weights, std::size_t count,
                                 std::size_t nodes, double* sums) {
  std::size_t k = 0;
  for (; k + 4 <= nodes; k += 4) {
    const Real* w = weights + k * count;
    Real a = 0, b = 0, c = 0, d = 0;
#pragma omp simd reduction(+ : a, b, c, d)
    for (std::size_t i = 0; i < count; ++i) {
      const Real value = values[i];
      a += value * w[i];
      b += value * w[count + i];
      c += value * w[2 * count + i];
      d += value * w[3 * count + i];
    }
    sums[k] = a;
    sums[k + 1] = b;
    sums[k + 2] = c;
    sums[k + 3] = d;
  }
  for (; k < nodes; ++k) {
    Real sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < count; ++i) {
      sum += values[i] * weights[k * count + i];
    }
    sums[k] = sum;
  }
}

WRC_VECTOR_CLONES void gather_line(const float* values, const float* weights, std::size_t count,
                                   std::size_t nodes, double* sums) {
  gather_body(values, weights, count, nodes, sums);
}
WRC_VECTOR_CLONES void gather_line(const double* values, const double* weights, std::size_t count,
                                   std::size_t nodes, double* sums) {
  gather_body(values, weights, count, nodes, sums);
}

/// to[i] += sum_k factors[k] * weights[k * count + i].
template <typename Real, typename To>
WRC_VECTOR_BODY void spread_body(const Real* factors, const Real* weights, std::size_t nodes,
                                 std::size_t count, To* to) {
  std::size_t k = 0;
  for (; k + 4 <= nodes; k += 4) {
    const Real* w = weights + k * count;
    const Real a = factors[k];
    const Real b = factors[k + 1];
    const Real c = factors[k + 2];
    const Real d = factors[k + 3];
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
      to[i] += (a * w[i] + b * w[count + i]) + (c * w[2 * count + i] + d * w[3 * count + i]);
    }
  }
  for (; k < nodes; ++k) {
    const Real* w = weights + k * count;
    const Real factor = factors[k];
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
      to[i] += factor * w[i];
    }
  }
}

WRC_VECTOR_CLONES void spread_line(const float* factors, const float* weights, std::size_t nodes,
                                   std::size_t count, float* to) {
  spread_body(factors, weights, nodes, count, to);
}
WRC_VECTOR_CLONES void spread_line(const float* factors, const float* weights, std::size_t nodes,
                                   std::size_t count, double* to) {
  spread_body(factors, weights, nodes, count, to);
}
WRC_VECTOR_CLONES void spread_line(const double* factors, const double* weights, std::size_t nodes,
                                   std::size_t count, double* to) {
  spread_body(factors, weights, nodes, count, to);
}

/// Both ways of a link at once: K from, and other_to += K^T other_from.
WRC_VECTOR_CLONES double link_line(const double* values, const double* from, double other_from,
                                   std::size_t count, double* other_to) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < count; ++i) {
    sum += values[i] * from[i];
    other_to[i] += other_from * values[i];
  }
  return sum;
}

/// weight_i = factor / (place_i - node), which is kept away from 0 without a trace.
WRC_VECTOR_CLONES void add_weights(double factor, double node, const double* place,
                                   std::size_t count, double* weight, double* sum) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const double apart = place[i] - node;
    weight[i] = factor / (apart == 0.0 ? 1e-200 : apart);
    sum[i] += weight[i];
  }
}

WRC_VECTOR_CLONES void divide(double* values, const double* by, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    values[i] /= by[i];
  }
}

/// c / sqrt(x_i^2 + across_squared), of nodes that are no nearer than `least`.
WRC_VECTOR_CLONES void fill_link(double coupling_weight, double across_squared, double least,
                                 double along, const double* position, std::size_t count,
                                 double* values) {
  const double least_squared = least * least;
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const double x = along - position[i];
    const double square = x * x + across_squared;
    values[i] = coupling_weight / std::sqrt(square > least_squared ? square : least_squared);
  }
}

} // namespace

PatchCoupling::Axis PatchCoupling::make_axis(std::size_t elements, double step, double convergence,
                                             double error) {
  Axis axis;
  const double half = 0.5 * extent(elements, step);
  const double needed = std::ceil(-std::log(error) / convergence);
  const std::size_t count = std::min(
      elements, static_cast<std::size_t>(std::clamp(needed, static_cast<double>(min_coupling_nodes),
                                                    static_cast<double>(max_coupling_nodes))));
  // Barycentric formula (Berrut & Trefethen, SIAM Review 46, 2004, eq. 5.4).
  std::vector<double> place(elements);
  for (std::size_t i = 0; i < elements; ++i) {
    place[i] = half > 0.0 ? static_cast<double>(i) * step / half - 1.0 : 0.0;
  }
  axis.half_spacing = half / static_cast<double>(count);
  axis.weight.resize(count * elements);
  std::vector<double> sum(elements, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const double angle =
        std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    const double node = -std::cos(angle);
    axis.position.push_back(half * (1.0 + node));
    add_weights((k % 2 == 0 ? 1.0 : -1.0) * std::sin(angle), node, place.data(), elements,
                axis.weight.data() + k * elements, sum.data());
  }
  for (std::size_t k = 0; k < count; ++k) {
    divide(axis.weight.data() + k * elements, sum.data(), elements);
  }
  axis.single_weight.assign(axis.weight.begin(), axis.weight.end());
  return axis;
}

PatchCoupling::Link PatchCoupling::make_link(std::size_t one, std::size_t other,
                                             double coupling_weight) const {
  const Nodes& here = nodes_[one];
  const Nodes& there = nodes_[other];
  Link link{one, other, {}};
  link.values.resize(here.count() * there.count());
  const double lateral = boxes_[one].lateral_first - boxes_[other].lateral_first;
  const double longitudinal = boxes_[one].longitudinal_first - boxes_[other].longitudinal_first;
  const double least = std::max({here.rows.half_spacing, here.columns.half_spacing,
                                 there.rows.half_spacing, there.columns.half_spacing});
  double* values = link.values.data();
  for (const double row : here.rows.position) {
    for (const double column : here.columns.position) {
      for (const double other_row : there.rows.position) {
        const double across = lateral + row - other_row;
        fill_link(coupling_weight, across * across, least, longitudinal + column,
                  there.columns.position.data(), there.columns.nodes(), values);
        values += there.columns.nodes();
      }
    }
  }
  return link;
}

PatchCoupling::PatchCoupling(std::vector<Grid> boxes, const std::vector<double>& coupling_weight,
                             double error)
    : boxes_(std::move(boxes)) {
  const std::size_t count = boxes_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Grid& box = boxes_[k];
    double by_rows = std::numeric_limits<double>::infinity();
    double by_columns = by_rows;
    for (std::size_t l = 0; l < count; ++l) {
      if (l != k && coupling_weight[k * count + l] != 0.0) {
        const double lateral = between(lateral_of(box), lateral_of(boxes_[l]));
        const double longitudinal = between(longitudinal_of(box), longitudinal_of(boxes_[l]));
        by_rows = std::min(by_rows, convergence(lateral_of(box).half(), lateral, longitudinal));
        by_columns =
            std::min(by_columns, convergence(longitudinal_of(box).half(), longitudinal, lateral));
      }
    }
    Nodes nodes;
    nodes.rows = make_axis(box.lateral_count, box.lateral_step, by_rows, error);
    nodes.columns = make_axis(box.longitudinal_count, box.longitudinal_step, by_columns, error);
    nodes_.push_back(std::move(nodes));
  }
  rough_links_.resize(count * count);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t l = 0; l < k; ++l) {
      const double close = coupling_weight[pair(k, l)];
      if (close != 0.0) {
        links_.push_back(make_link(k, l, close));
        rough_links_[pair(k, l)] = rough_links_[pair(l, k)] =
            close / typical_distance(boxes_[k], boxes_[l]);
      }
    }
  }
}

NodeField PatchCoupling::field() const {
  NodeField field;
  for (const Nodes& nodes : nodes_) {
    field.load.emplace_back(nodes.count());
  }
  field.displacement.resize(boxes_.size() * boxes_.size());
  for (const Link& link : links_) {
    field.displacement[pair(link.one, link.other)].resize(nodes_[link.one].count());
    field.displacement[pair(link.other, link.one)].resize(nodes_[link.other].count());
  }
  return field;
}

// Across the rail first, and last when adding: contact is narrower there, so there are fewer nodes.

template <typename Real>
void PatchCoupling::gather(std::size_t box, const Real* pressure, NodeLoads& loads) {
  const Nodes& nodes = nodes_[box];
  const std::size_t rows = boxes_[box].lateral_count;
  const std::size_t columns = boxes_[box].longitudinal_count;
  const std::size_t node_columns = nodes.columns.nodes();
  const double area = boxes_[box].lateral_step * boxes_[box].longitudinal_step;
  std::vector<Real>& line = lines<Real>();
  for (std::size_t k = 0; k < nodes.rows.nodes(); ++k) {
    line.assign(columns, Real{0});
    spread_line(nodes.rows.weights<Real>() + k * rows, pressure, rows, columns, line.data());
    double* load = loads[box].data() + k * node_columns;
    gather_line(line.data(), nodes.columns.weights<Real>(), columns, node_columns, load);
    std::transform(load, load + node_columns, load, [area](double sum) { return area * sum; });
  }
}

void PatchCoupling::transfer(NodeField& field) const {
  for (const Link& link : links_) {
    std::vector<double>& here = field.displacement[pair(link.one, link.other)];
    std::vector<double>& there = field.displacement[pair(link.other, link.one)];
    std::fill(there.begin(), there.end(), 0.0);
    for (std::size_t k = 0; k < here.size(); ++k) {
      here[k] = link_line(link.values.data() + k * there.size(), field.load[link.other].data(),
                          field.load[link.one][k], there.size(), there.data());
    }
  }
}

double PatchCoupling::energy(const NodeField& field, std::size_t box, std::size_t other) const {
  const std::vector<double>& displacement = field.displacement[pair(box, other)];
  return std::inner_product(displacement.begin(), displacement.end(), field.load[box].begin(), 0.0);
}

double PatchCoupling::rough_energy(std::size_t box, double sum, std::size_t other,
                                   double other_sum) const {
  const auto load = [this](std::size_t k, double pressures) {
    return pressures * boxes_[k].lateral_step * boxes_[k].longitudinal_step;
  };
  return rough_links_[pair(box, other)] * load(box, sum) * load(other, other_sum);
}

void PatchCoupling::sum_others(const NodeField& field, std::size_t box,
                               std::vector<double>& nodes) const {
  nodes.assign(nodes_[box].count(), 0.0);
  for (std::size_t other = 0; other < boxes_.size(); ++other) {
    const std::vector<double>& by_other = field.displacement[pair(box, other)];
    std::transform(by_other.begin(), by_other.end(), nodes.begin(), nodes.begin(), std::plus<>());
  }
}

void PatchCoupling::add_others(const NodeField& field, std::size_t box, double* displacement) {
  std::vector<double> nodes;
  sum_others(field, box, nodes);
  add<double>(box, nodes, displacement);
}

template <typename Real>
void PatchCoupling::add(std::size_t box, const std::vector<double>& nodes, double* displacement) {
  const Nodes& here = nodes_[box];
  const std::size_t rows = boxes_[box].lateral_count;
  const std::size_t columns = boxes_[box].longitudinal_count;
  const std::size_t node_rows = here.rows.nodes();
  const std::size_t node_columns = here.columns.nodes();
  const double unit = 1.0 / boxes_[box].longitudinal_step;
  std::vector<Real>& line = lines<Real>(); // one for each row of nodes, then factors
  line.assign(node_rows * columns + std::max(node_rows, node_columns), Real{0});
  Real* factors = line.data() + node_rows * columns;
  for (std::size_t k = 0; k < node_rows; ++k) {
    const double* from = nodes.data() + k * node_columns;
    std::transform(from, from + node_columns, factors,
                   [unit](double value) { return static_cast<Real>(unit * value); });
    spread_line(factors, here.columns.weights<Real>(), node_columns, columns,
                line.data() + k * columns);
  }
  const Real* weights = here.rows.weights<Real>();
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k < node_rows; ++k) {
      factors[k] = weights[k * rows + i];
    }
    spread_line(factors, line.data(), node_rows, columns, displacement + i * columns);
  }
}

template void PatchCoupling::gather(std::size_t box, const float* pressure, NodeLoads& loads);
template void PatchCoupling::gather(std::size_t box, const double* pressure, NodeLoads& loads);
template void PatchCoupling::add<float>(std::size_t box, const std::vector<double>& nodes,
                                        double* displacement);
template void PatchCoupling::add<double>(std::size_t box, const std::vector<double>& nodes,
                                         double* displacement);

} // namespace wrc
