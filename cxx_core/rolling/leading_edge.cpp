#include "rolling/leading_edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "rolling/constants.hpp"

namespace wrc {

namespace {

/// Elements from the leading end of the grid to where contact begins, strip by strip; infinite
/// without contact.
template <typename Real>
std::vector<double> edge_places(const Real* bound, const Real* covered, const TractionShape& shape,
                                std::size_t pitch) {
  std::vector<double> places(shape.columns, std::numeric_limits<double>::infinity());
  for (std::size_t row = shape.rows; row-- > 0;) {
    for (std::size_t column = 0; column < shape.columns; ++column) {
      const std::size_t at = row * pitch + column;
      if (bound[at] > Real{0}) {
        places[column] = static_cast<double>(row) + 1.0 - static_cast<double>(covered[at]);
      }
    }
  }
  return places;
}

/// What an edge advances from strip to strip, in the mean of both sides or on one.
double advance_at(const std::vector<double>& places, std::size_t column) {
  double sum = 0.0;
  int sides = 0;
  for (const std::size_t other : {column - 1, column + 1}) {
    if (other < places.size() && std::isfinite(places[other])) {
      sum += (other < column ? 1.0 : -1.0) * (places[column] - places[other]);
      ++sides;
    }
  }
  return sides > 0 ? std::abs(sum) / sides : 0.0;
}

} // namespace

double edge_compliance(double covered) {
  const double within = std::clamp(covered, min_edge_share, 1.0);
  return 2.0 / std::numbers::pi * edge_stiffening * (1.0 - within) / within;
}

double edge_traction_ratio(double covered) {
  return edge_traction / std::sqrt(std::clamp(covered, min_edge_share, 1.0));
}

double edge_compliance_rate(double compliance) {
  const double unit = 2.0 / std::numbers::pi * edge_stiffening;
  const double inverse = 1.0 + compliance / unit; // of the share
  return compliance > 0.0 ? -unit * inverse * inverse : 0.0;
}

template <typename Real>
void make_edges(Real* bound, Real* edge, const TractionShape& shape, std::size_t pitch,
                double aspect) {
  const std::vector<double> places = edge_places(bound, edge, shape, pitch);
  for (std::size_t row = shape.rows; row-- > 0;) {
    for (std::size_t column = 0; column < shape.columns; ++column) {
      const std::size_t at = row * pitch + column;
      if (!(bound[at] > Real{0}) || (row > 0 && bound[at - pitch] > Real{0})) {
        edge[at] = Real{0};
        continue;
      }
      const auto covered = static_cast<double>(edge[at]);
      const double slope =
          places[column] >= static_cast<double>(row) ? advance_at(places, column) / aspect : 0.0;
      bound[at] *= static_cast<Real>(edge_traction_ratio(covered));
      edge[at] = static_cast<Real>(edge_compliance(covered + edge_advance * slope));
    }
  }
}

template void make_edges<float>(float*, float*, const TractionShape&, std::size_t, double);
template void make_edges<double>(double*, double*, const TractionShape&, std::size_t, double);

} // namespace wrc
