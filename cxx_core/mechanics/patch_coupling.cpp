#include "mechanics/patch_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "vector_clones.hpp"

namespace wrc {

namespace {

/// Error of the interpolation, and the nodes that it may take in either direction.
constexpr double interpolation_error = 1e-5;
constexpr std::size_t least_nodes = 4;
constexpr std::size_t most_nodes = 20;

double extent(std::size_t elements, double step) {
  return static_cast<double>(elements - 1) * step;
}

/// Between two intervals; 0 if they overlap.
double between(double first, double length, double other_first, double other_length) {
  return std::max({0.0, other_first - (first + length), first - (other_first + other_length)});
}

double distance_of(const CoupledBox& one, const CoupledBox& other) {
  return std::hypot(between(one.lateral_first, extent(one.rows, one.lateral_step),
                            other.lateral_first, extent(other.rows, other.lateral_step)),
                    between(one.longitudinal_first, extent(one.columns, one.longitudinal_step),
                            other.longitudinal_first,
                            extent(other.columns, other.longitudinal_step)));
}

template <typename Real>
WRC_VECTOR_BODY double product_body(const Real* values, const double* weights, std::size_t count) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < count; ++i) {
    sum += static_cast<double>(values[i]) * weights[i];
  }
  return sum;
}

WRC_VECTOR_CLONES double product(const float* values, const double* weights, std::size_t count) {
  return product_body(values, weights, count);
}
WRC_VECTOR_CLONES double product(const double* values, const double* weights, std::size_t count) {
  return product_body(values, weights, count);
}
WRC_VECTOR_CLONES void add_times(double* values, double factor, const double* weights,
                                 std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    values[i] += factor * weights[i];
  }
}

} // namespace

PatchCoupling::Axis PatchCoupling::make_axis(std::size_t elements, double step, double distance) {
  Axis axis;
  axis.elements = elements;
  const double half = 0.5 * extent(elements, step);
  const double ratio = half > 0.0 ? distance / half : std::numeric_limits<double>::infinity();
  const double needed =
      std::isfinite(ratio) ? std::ceil(-std::log(interpolation_error) / std::asinh(ratio)) : 1.0;
  const std::size_t count = std::min(
      elements, static_cast<std::size_t>(std::clamp(needed, static_cast<double>(least_nodes),
                                                    static_cast<double>(most_nodes))));
  // Barycentric formula (Berrut & Trefethen, SIAM Review 46, 2004, eq. 5.4).
  std::vector<double> node;
  std::vector<double> factor;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle =
        std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    node.push_back(-std::cos(angle));
    factor.push_back((k % 2 == 0 ? 1.0 : -1.0) * std::sin(angle));
    axis.position.push_back(half * (1.0 + node.back()));
  }
  axis.half_spacing = half / static_cast<double>(count);
  axis.weight.assign(count * elements, 0.0);
  for (std::size_t i = 0; i < elements; ++i) {
    const double place = half > 0.0 ? static_cast<double>(i) * step / half - 1.0 : 0.0;
    double sum = 0.0;
    std::size_t met = count;
    for (std::size_t k = 0; k < count; ++k) {
      const double apart = place - node[k];
      if (apart == 0.0) {
        met = k;
        break;
      }
      axis.weight[k * elements + i] = factor[k] / apart;
      sum += factor[k] / apart;
    }
    for (std::size_t k = 0; k < count; ++k) {
      double& weight = axis.weight[k * elements + i];
      weight = met < count ? (k == met ? 1.0 : 0.0) : weight / sum;
    }
  }
  return axis;
}

PatchCoupling::Link PatchCoupling::make_link(std::size_t one, std::size_t other,
                                             double closeness) const {
  const Nodes& here = nodes_[one];
  const Nodes& there = nodes_[other];
  Link link{one, other, {}};
  link.values.reserve(here.count() * there.count());
  const double lateral = boxes_[one].lateral_first - boxes_[other].lateral_first;
  const double longitudinal = boxes_[one].longitudinal_first - boxes_[other].longitudinal_first;
  const double least = std::max({here.rows.half_spacing, here.columns.half_spacing,
                                 there.rows.half_spacing, there.columns.half_spacing});
  const double distance = distance_of(boxes_[one], boxes_[other]);
  const double softening = std::max(0.0, least * least - distance * distance);
  for (const double row : here.rows.position) {
    for (const double column : here.columns.position) {
      for (const double other_row : there.rows.position) {
        const double across = lateral + row - other_row;
        for (const double other_column : there.columns.position) {
          const double along = longitudinal + column - other_column;
          link.values.push_back(closeness / std::sqrt(across * across + along * along + softening));
        }
      }
    }
  }
  return link;
}

PatchCoupling::PatchCoupling(std::vector<CoupledBox> boxes, const std::vector<double>& closeness)
    : boxes_(std::move(boxes)) {
  const std::size_t count = boxes_.size();
  for (std::size_t k = 0; k < count; ++k) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t l = 0; l < count; ++l) {
      if (l != k && closeness[k * count + l] != 0.0) {
        nearest = std::min(nearest, distance_of(boxes_[k], boxes_[l]));
      }
    }
    const CoupledBox& box = boxes_[k];
    Nodes nodes;
    nodes.rows = make_axis(box.rows, box.lateral_step, nearest);
    nodes.columns = make_axis(box.columns, box.longitudinal_step, nearest);
    nodes.load.resize(nodes.count());
    nodes.displacement.resize(nodes.count());
    nodes_.push_back(std::move(nodes));
  }
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t l = 0; l < k; ++l) {
      if (closeness[k * count + l] != 0.0) {
        links_.push_back(make_link(k, l, closeness[k * count + l]));
      }
    }
  }
}

template <typename Real> void PatchCoupling::gather(std::size_t box, const Real* pressure) {
  Nodes& nodes = nodes_[box];
  const std::size_t columns = boxes_[box].columns;
  const std::size_t node_columns = nodes.columns.nodes();
  const double area = boxes_[box].lateral_step * boxes_[box].longitudinal_step;
  std::fill(nodes.load.begin(), nodes.load.end(), 0.0);
  line_.resize(node_columns);
  for (std::size_t i = 0; i < boxes_[box].rows; ++i) {
    for (std::size_t l = 0; l < node_columns; ++l) {
      line_[l] = area * product(pressure + i * columns, nodes.columns.of_node(l), columns);
    }
    for (std::size_t k = 0; k < nodes.rows.nodes(); ++k) {
      add_times(nodes.load.data() + k * node_columns, nodes.rows.of_node(k)[i], line_.data(),
                node_columns);
    }
  }
}

void PatchCoupling::transfer() {
  for (Nodes& nodes : nodes_) {
    std::fill(nodes.displacement.begin(), nodes.displacement.end(), 0.0);
  }
  for (const Link& link : links_) {
    Nodes& one = nodes_[link.one];
    Nodes& other = nodes_[link.other];
    for (std::size_t k = 0; k < one.count(); ++k) {
      const double* values = link.values.data() + k * other.count();
      one.displacement[k] += product(other.load.data(), values, other.count());
      add_times(other.displacement.data(), one.load[k], values, other.count());
    }
  }
}

template <typename Real> void PatchCoupling::add(std::size_t box, Real* displacement) {
  const Nodes& nodes = nodes_[box];
  const std::size_t columns = boxes_[box].columns;
  const std::size_t node_columns = nodes.columns.nodes();
  const double unit = 1.0 / boxes_[box].longitudinal_step;
  std::vector<double> at_nodes(node_columns);
  line_.resize(columns);
  for (std::size_t i = 0; i < boxes_[box].rows; ++i) {
    std::fill(at_nodes.begin(), at_nodes.end(), 0.0);
    for (std::size_t k = 0; k < nodes.rows.nodes(); ++k) {
      add_times(at_nodes.data(), unit * nodes.rows.of_node(k)[i],
                nodes.displacement.data() + k * node_columns, node_columns);
    }
    std::fill(line_.begin(), line_.end(), 0.0);
    for (std::size_t l = 0; l < node_columns; ++l) {
      add_times(line_.data(), at_nodes[l], nodes.columns.of_node(l), columns);
    }
    Real* row = displacement + i * columns;
    for (std::size_t j = 0; j < columns; ++j) {
      row[j] += static_cast<Real>(line_[j]);
    }
  }
}

template void PatchCoupling::gather(std::size_t box, const float* pressure);
template void PatchCoupling::gather(std::size_t box, const double* pressure);
template void PatchCoupling::add(std::size_t box, float* displacement);
template void PatchCoupling::add(std::size_t box, double* displacement);

} // namespace wrc
