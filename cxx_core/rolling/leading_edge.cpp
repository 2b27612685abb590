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
/// without contact. A first element counts as far as it is covered.
template <typename Real>
std::vector<double> edge_places(const Real* bound, const Real* covered, const TractionShape& shape,
                                std::size_t pitch) {
  std::vector<double> places(shape.columns, std::numeric_limits<double>::infinity());
  for (std::size_t row = shape.rows; row-- > 0;) {
    for (std::size_t column = 0; column < shape.columns; ++column) {
      const std::size_t at = row * pitch + column;
      if (bound[at] > Real{0}) {
        const double open = 1.0 - static_cast<double>(covered[at]);
        const double next = row + 1 < shape.rows ? static_cast<double>(covered[at + pitch]) : 0.0;
        places[column] = static_cast<double>(row) + open + open * (1.0 - next);
      }
    }
  }
  return places;
}

/// Distance that an edge advances from strip to strip, on average of both sides or on one.
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

/// The effective covered fraction: more for an oblique edge, on average by `advance`, and nothing
/// for an uncovered or a whole element, so that nothing steps as edges move on.
double advanced_share(double covered, double advance) {
  constexpr double most = 1.0 / 6.0; // with which 1 is reached with slope 0
  return covered + std::min(advance, most) * 6.0 * covered * (1.0 - covered);
}

} // namespace

double edge_compliance(double covered) {
  const double within = std::clamp(covered, min_edge_share, 1.0);
  return 2.0 / std::numbers::pi * edge_stiffening * (1.0 - within) / within;
}

double edge_traction_ratio(double covered) {
  return edge_traction / std::sqrt(std::clamp(covered, min_edge_share, 1.0));
}

double edge_compliance_rate(double compliance, double covered) {
  const double unit = 2.0 / std::numbers::pi * edge_stiffening;
  const double inverse = 1.0 + compliance / unit; // of the fraction as the edge is found
  const double c = std::clamp(covered, min_edge_share, 1.0);
  if (!(compliance > 0.0)) {
    return 0.0;
  }
  const double advanced = 1.0 / inverse - c; // in fractions of c (1 - c)
  return -unit * inverse * inverse * (1.0 + advanced * (1.0 - 2.0 * c) / (c * (1.0 - c)));
}

template <typename Real>
void make_edges(Real* bound, Real* edge, const TractionShape& shape, std::size_t pitch,
                double aspect, double poisson, double upstream) {
  const std::size_t count = shape.rows * pitch;
  const double apart = 2.0 * edge_advance * poisson;
  const std::vector<double> places = edge_places(bound, edge, shape, pitch);
  for (std::size_t row = shape.rows; row-- > 0;) {
    for (std::size_t column = 0; column < shape.columns; ++column) {
      const std::size_t at = row * pitch + column;
      const double open = row > 0 ? 1.0 - static_cast<double>(edge[at - pitch]) : 1.0;
      if (!(bound[at] > Real{0}) || !(open > 0.0)) {
        edge[at] = edge[count + at] = Real{0};
        continue;
      }
      const auto covered = static_cast<double>(edge[at]);
      const bool first =
          places[column] + 1.0 >= static_cast<double>(row); // of strips behind others
      const double slope = first ? advance_at(places, column) / aspect : 0.0;
      bound[at] *= static_cast<Real>(1.0 + upstream * open * (edge_traction_ratio(covered) - 1.0));
      const auto compliance = [&](double advance) {
        return upstream * open * edge_compliance(advanced_share(covered, advance * slope));
      };
      edge[at] = static_cast<Real>((1.0 - poisson) * compliance(edge_advance - apart));
      edge[count + at] = static_cast<Real>(compliance(edge_advance + apart));
    }
  }
}

template void make_edges<float>(float*, float*, const TractionShape&, std::size_t, double, double,
                                double);
template void make_edges<double>(double*, double*, const TractionShape&, std::size_t, double,
                                 double, double);

} // namespace wrc
