#include "rolling/leading_edge.hpp"

#include <algorithm>
#include <numbers>

#include "rolling/constants.hpp"

namespace wrc {

double edge_compliance(double covered) {
  const double within = std::clamp(covered, 0.0, 1.0);
  return 2.0 / std::numbers::pi * edge_stiffening * (edge_of_whole_element - within) /
         (within + 1.0 - edge_of_whole_element);
}

double edge_compliance_rate(double covered) {
  const double within = std::clamp(covered, 0.0, 1.0) + 1.0 - edge_of_whole_element;
  return -2.0 / std::numbers::pi * edge_stiffening / (within * within);
}

template <typename Real>
void make_edges(const Real* bound, Real* edge, const TractionShape& shape, std::size_t pitch) {
  for (std::size_t row = shape.rows; row-- > 0;) {
    for (std::size_t at = row * pitch; at < row * pitch + shape.columns; ++at) {
      const bool first = bound[at] > Real{0} && (row == 0 || !(bound[at - pitch] > Real{0}));
      edge[at] = first ? static_cast<Real>(edge_compliance(edge[at])) : Real{0};
    }
  }
}

template void make_edges<float>(const float*, float*, const TractionShape&, std::size_t);
template void make_edges<double>(const double*, double*, const TractionShape&, std::size_t);

} // namespace wrc
