#include "models/kik_piotrowski.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "models/elliptic_integrals.hpp"
#include "models/hertz.hpp"

namespace wrc {
namespace {

/// Half of the nodes along a yawed strip, the same number to each side as across the strips: the
/// rule includes the roots at both ends.
constexpr std::size_t half_nodes = penetration_nodes;

/// The upper half of the nodes of the Gauss-Chebyshev rule of the second kind; the lower half
/// mirrors it.
struct ChebyshevRule {
  std::array<double, half_nodes> place;
  std::array<double, half_nodes> weight; ///< over sqrt(1 - x^2)
};

const ChebyshevRule& chebyshev_rule() {
  static const ChebyshevRule rule = [] {
    ChebyshevRule made{};
    const double step = std::numbers::pi / static_cast<double>(2 * half_nodes + 1);
    for (std::size_t i = 0; i < half_nodes; ++i) {
      const double angle = step * static_cast<double>(i + 1);
      made.place[i] = std::cos(angle);
      made.weight[i] = step * std::sin(angle);
    }
    return made;
  }();
  return rule;
}

/// int sqrt(l^2 - (x - centre)^2) / sqrt(x^2 + y^2) dx.
double displacing_strip(double half_length_square, double lateral, double centre) {
  const double y = std::abs(lateral);
  if (centre == 0.0) {
    const double reach = std::sqrt(half_length_square + y * y);
    return 2.0 * half_length_square / reach * elliptic_integrals(y / reach).d;
  }
  const double half_length = std::sqrt(half_length_square);
  const double first = std::asinh((centre - half_length) / y);
  const double last = std::asinh((centre + half_length) / y);
  const double half = 0.5 * (last - first);
  const double grown = 0.5 * y * std::exp(0.5 * (first + last));
  const double shrunk = 0.25 * y * y / grown;
  const auto height = [&](double x) {
    const double off = x - centre;
    return std::sqrt(std::max(0.0, half_length_square - off * off));
  };
  const ChebyshevRule& rule = chebyshev_rule();
  double sum = 0.0;
  for (std::size_t i = 0; i < half_nodes; ++i) {
    const double factor = std::exp(half * rule.place[i]);
    sum += rule.weight[i] *
           (height(grown * factor - shrunk / factor) + height(grown / factor - shrunk * factor));
  }
  return half * sum;
}

/// Semi-axis along the rail over that across it, of Hertz's ellipse for bodies whose penetration
/// has this ratio.
double hertz_ratio(double penetration_ratio) {
  const double square = penetration_ratio * penetration_ratio;
  return square >= 1.0 ? 1.0 / hertz_axis_ratio(square) : hertz_axis_ratio(1.0 / square);
}

} // namespace

KikPiotrowskiContact solve_virtual_penetration(std::span<const KikPiotrowskiStrip> strips,
                                               double greatest_half_length, double combined_modulus,
                                               double approach) {
  KikPiotrowskiContact contact;
  for (const KikPiotrowskiStrip& strip : strips) {
    contact.area += 2.0 * strip.weight * std::sqrt(strip.half_length_square);
  }
  if (!(contact.area > 0.0)) {
    throw Error(ErrorCode::no_contact,
                "solve.model = \"kik-piotrowski\": the contact is narrower than a row of the "
                "profiles, or at their end; solve.model must be \"half-space\" here");
  }
  const double ratio =
      std::numbers::pi * greatest_half_length * greatest_half_length / contact.area;
  const double stretch_square = hertz_ratio(ratio) / ratio;
  contact.stretch = std::sqrt(stretch_square);
  double volume = 0.0; // I1 over pi/2
  double displaced = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  double sum_xx = 0.0;
  double sum_yy = 0.0;
  for (const KikPiotrowskiStrip& strip : strips) {
    const double square = stretch_square * strip.half_length_square;
    const double y = strip.lateral / contact.stretch;
    const double weight = strip.weight / contact.stretch;
    displaced += weight * displacing_strip(square, y, strip.centre);
    const double moment = weight * square;
    volume += moment;
    sum_x += moment * strip.centre;
    sum_y += moment * y;
    sum_xx += moment * (0.25 * square + strip.centre * strip.centre);
    sum_yy += moment * y * y;
  }
  contact.pressure_factor = std::numbers::pi * combined_modulus * approach / displaced;
  contact.normal_force = 0.5 * std::numbers::pi * volume * contact.pressure_factor;
  contact.peak_pressure = contact.pressure_factor * contact.stretch * greatest_half_length;
  contact.centroid_longitudinal = sum_x / volume;
  contact.centroid_lateral = sum_y / volume;
  const auto semi_axis = [volume](double squares, double mean) {
    return std::sqrt(5.0 * std::max(0.0, squares / volume - mean * mean));
  };
  contact.semi_axis_longitudinal = semi_axis(sum_xx, contact.centroid_longitudinal);
  contact.semi_axis_lateral = semi_axis(sum_yy, contact.centroid_lateral);
  return contact;
}

} // namespace wrc
