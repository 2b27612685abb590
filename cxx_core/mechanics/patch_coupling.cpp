#include "mechanics/patch_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wrc {

namespace {

/// Nodes of a box in either direction.
constexpr std::size_t most_nodes = 12;

} // namespace

PatchCoupling::Axis PatchCoupling::make_axis(std::size_t elements, double step) {
  const std::size_t count = std::min(most_nodes, elements);
  Axis axis;
  const double length = static_cast<double>(elements - 1);
  const double spacing = count > 1 ? length / static_cast<double>(count - 1) : 1.0;
  for (std::size_t k = 0; k < count; ++k) {
    axis.position.push_back(static_cast<double>(k) * spacing * step);
  }
  for (std::size_t i = 0; i < elements; ++i) {
    const double place = static_cast<double>(i) / spacing;
    const std::size_t before =
        count > 1 ? std::min(static_cast<std::size_t>(place), count - 2) : std::size_t{0};
    axis.node.push_back(before);
    axis.share.push_back(count > 1 ? place - static_cast<double>(before) : 0.0);
  }
  return axis;
}

PatchCoupling::PatchCoupling(std::vector<CoupledBox> boxes, std::vector<double> closeness)
    : boxes_(std::move(boxes)), closeness_(std::move(closeness)) {
  for (const CoupledBox& box : boxes_) {
    Nodes nodes;
    nodes.rows = make_axis(box.rows, box.lateral_step);
    nodes.columns = make_axis(box.columns, box.longitudinal_step);
    nodes.load.resize(nodes.count());
    nodes.displacement.resize(nodes.count());
    nodes_.push_back(std::move(nodes));
  }
}

template <typename Real> void PatchCoupling::gather(std::size_t box, const Real* pressure) {
  Nodes& nodes = nodes_[box];
  const std::size_t columns = boxes_[box].columns;
  const std::size_t node_columns = nodes.columns.nodes();
  const double area = boxes_[box].lateral_step * boxes_[box].longitudinal_step;
  std::fill(nodes.load.begin(), nodes.load.end(), 0.0);
  for (std::size_t i = 0; i < boxes_[box].rows; ++i) {
    const Real* row = pressure + i * columns;
    double* before = nodes.load.data() + nodes.rows.node[i] * node_columns;
    const double share = nodes.rows.share[i];
    for (std::size_t j = 0; j < columns; ++j) {
      const double load = area * static_cast<double>(row[j]);
      const std::size_t node = nodes.columns.node[j];
      const double second = nodes.columns.share[j] * load;
      const double first = load - second;
      before[node] += (1.0 - share) * first;
      if (second != 0.0) {
        before[node + 1] += (1.0 - share) * second;
      }
      if (share != 0.0) {
        before[node_columns + node] += share * first;
        if (second != 0.0) {
          before[node_columns + node + 1] += share * second;
        }
      }
    }
  }
}

void PatchCoupling::transfer() {
  for (Nodes& nodes : nodes_) {
    std::fill(nodes.displacement.begin(), nodes.displacement.end(), 0.0);
  }
  for (std::size_t to = 0; to < boxes_.size(); ++to) {
    for (std::size_t from = 0; from < boxes_.size(); ++from) {
      const double closeness = closeness_[to * boxes_.size() + from];
      if (to == from || closeness == 0.0) {
        continue;
      }
      const Nodes& source = nodes_[from];
      Nodes& target = nodes_[to];
      const auto half_spacing = [](const Axis& axis) {
        return axis.nodes() > 1 ? 0.5 * axis.position[1] : 0.0;
      };
      // The same for both ways, so that the operator stays symmetric.
      const double least = std::max({half_spacing(source.rows), half_spacing(source.columns),
                                     half_spacing(target.rows), half_spacing(target.columns)});
      const double lateral = boxes_[to].lateral_first - boxes_[from].lateral_first;
      const double longitudinal = boxes_[to].longitudinal_first - boxes_[from].longitudinal_first;
      for (std::size_t i = 0; i < target.rows.nodes(); ++i) {
        for (std::size_t j = 0; j < target.columns.nodes(); ++j) {
          double sum = 0.0;
          for (std::size_t k = 0; k < source.rows.nodes(); ++k) {
            const double across = lateral + target.rows.position[i] - source.rows.position[k];
            const double* load = source.load.data() + k * source.columns.nodes();
            for (std::size_t l = 0; l < source.columns.nodes(); ++l) {
              const double along =
                  longitudinal + target.columns.position[j] - source.columns.position[l];
              sum += load[l] / std::sqrt(std::max(across * across + along * along, least * least));
            }
          }
          target.displacement[i * target.columns.nodes() + j] += closeness * sum;
        }
      }
    }
  }
}

template <typename Real> void PatchCoupling::add(std::size_t box, Real* displacement) {
  Nodes& nodes = nodes_[box];
  const std::size_t columns = boxes_[box].columns;
  const std::size_t node_columns = nodes.columns.nodes();
  const double unit = 1.0 / boxes_[box].longitudinal_step;
  const auto after = [](std::size_t node, std::size_t count) {
    return std::min(node + 1, count - 1);
  };
  for (std::size_t i = 0; i < boxes_[box].rows; ++i) {
    const double share = nodes.rows.share[i];
    const double* first = nodes.displacement.data() + nodes.rows.node[i] * node_columns;
    const double* second =
        nodes.displacement.data() + after(nodes.rows.node[i], nodes.rows.nodes()) * node_columns;
    Real* row = displacement + i * columns;
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t before = nodes.columns.node[j];
      const std::size_t next = after(before, node_columns);
      const double along = nodes.columns.share[j];
      const double upper = first[before] + along * (first[next] - first[before]);
      const double lower = second[before] + along * (second[next] - second[before]);
      row[j] += static_cast<Real>(unit * (upper + share * (lower - upper)));
    }
  }
}

template void PatchCoupling::gather(std::size_t box, const float* pressure);
template void PatchCoupling::gather(std::size_t box, const double* pressure);
template void PatchCoupling::add(std::size_t box, float* displacement);
template void PatchCoupling::add(std::size_t box, double* displacement);

} // namespace wrc
