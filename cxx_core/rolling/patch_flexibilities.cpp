// Flexibilities of a patch of any shape, from the full theory without slip.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mechanics/cascade.hpp"
#include "rolling/constants.hpp"
#include "rolling/fastsim.hpp"

namespace wrc {

namespace {

/// A rectangle of elements, each in contact or not; x runs fastest, as in Grid.
struct ContactElements {
  Grid grid;
  std::vector<double> contact; ///< 1 or 0
};

/// The elements in contact, joined until no more than the constants' numbers span the contact. An
/// element that was joined is in contact where half of it is.
ContactElements coarsened(const RollingProblem& problem) {
  const Grid& grid = problem.grid;
  ContactElements coarse;
  ElementBox box;
  if (!find_pressure_box({grid.lateral_count, grid.longitudinal_count}, problem.pressure, 0, box)) {
    return coarse;
  }
  const std::size_t first_x = box.first_column;
  const std::size_t end_x = box.last_column + 1;
  const std::size_t first_y = box.first_row;
  const std::size_t end_y = box.last_row + 1;
  const auto inside = [&](std::size_t i, std::size_t j) {
    return i < end_x && j < end_y && problem.pressure[j * grid.longitudinal_count + i] > 0.0;
  };
  std::size_t along =
      (end_x - first_x + flexibility_elements_along - 1) / flexibility_elements_along;
  std::size_t across =
      (end_y - first_y + flexibility_elements_across - 1) / flexibility_elements_across;
  while (true) {
    const auto mean_of = [](double first, double step, std::size_t from, std::size_t joined) {
      return first + step * (static_cast<double>(from) + 0.5 * static_cast<double>(joined - 1));
    };
    coarse.grid = {(end_y - first_y + across - 1) / across,
                   (end_x - first_x + along - 1) / along,
                   static_cast<double>(across) * grid.lateral_step,
                   static_cast<double>(along) * grid.longitudinal_step,
                   mean_of(grid.lateral_first, grid.lateral_step, first_y, across),
                   mean_of(grid.longitudinal_first, grid.longitudinal_step, first_x, along)};
    coarse.contact.assign(coarse.grid.element_count(), 0.0);
    double contacts = 0.0;
    for (std::size_t element = 0; element < coarse.contact.size(); ++element) {
      const std::size_t i = first_x + element % coarse.grid.longitudinal_count * along;
      const std::size_t j = first_y + element / coarse.grid.longitudinal_count * across;
      std::size_t found = 0;
      for (std::size_t k = 0; k < along * across; ++k) {
        found += inside(i + k % along, j + k / along) ? 1 : 0;
      }
      coarse.contact[element] = 2 * found >= along * across ? 1.0 : 0.0;
      contacts += coarse.contact[element];
    }
    if (contacts > 0.0 || along * across == 1) {
      return coarse;
    }
    along = across = 1; // scattered contact
  }
}

/// Forces of the springs without slip, of flexibility 1 for a creepage of 1.
struct SpringSums {
  double force = 0.0;        ///< of one creepage, against it
  double longitudinal = 0.0; ///< where it acts
  double lateral = 0.0;
  double spin = 0.0; ///< lateral force of spin about that point, against it
};

SpringSums spring_sums(const ContactElements& elements) {
  const Grid& grid = elements.grid;
  const double area = grid.element_area();
  const double step = grid.longitudinal_step;
  SpringSums sums;
  for (std::size_t j = 0; j < grid.lateral_count; ++j) {
    const double* contact = elements.contact.data() + j * grid.longitudinal_count;
    for (std::size_t end = grid.longitudinal_count; end > 0; --end) {
      std::size_t first = end;
      while (first > 0 && contact[first - 1] > 0.0) {
        --first;
      }
      if (first == end) {
        continue;
      }
      // A stretch of n elements: from its leading edge their middles are at 1/2, 3/2, ... of one.
      const auto n = static_cast<double>(end - first);
      const double force = area * step * n * n / 2.0;
      const double middle = grid.longitudinal(first) + 0.5 * (n - 1.0) * step;
      sums.force += force;
      sums.longitudinal += force * middle;
      sums.lateral += force * grid.lateral(j);
      // Sum over the elements of (h^2 - x^2)/2, x from the stretch's middle, 2h its length.
      sums.spin += area * step * step * n * (2.0 * n * n + 1.0) / 24.0;
      end = first + 1;
    }
  }
  sums.longitudinal /= sums.force;
  sums.lateral /= sums.force;
  return sums;
}

} // namespace

Flexibilities flexibilities_of(const RollingProblem& problem, RollingSolver& solver) {
  check_problem(problem);
  constexpr double none = std::numeric_limits<double>::infinity();
  const ContactElements elements = coarsened(problem);
  if (elements.contact.empty()) {
    return {none, none, none, 0.0};
  }
  const SpringSums springs = spring_sums(elements);
  RollingProblem without_slip;
  without_slip.grid = elements.grid;
  // From the springs' centre: the spin is then that of the patch.
  without_slip.grid.longitudinal_first -= springs.longitudinal;
  without_slip.grid.lateral_first -= springs.lateral;
  without_slip.pressure = elements.contact;
  without_slip.friction = no_slip_friction;
  without_slip.shear_modulus = 1.0;
  without_slip.poisson = problem.poisson;
  without_slip.tolerance = flexibility_tolerance;
  const double size =
      std::sqrt(elements.grid.element_area() * static_cast<double>(elements.contact.size()));
  without_slip.creepages = {1.0, 0.0, 0.0};
  const double c11 = -solver.solve(without_slip).longitudinal_force;
  without_slip.creepages = {0.0, 1.0, 0.0};
  const RollingSolution lateral = solver.solve(without_slip);
  const double c22 = -lateral.lateral_force;
  without_slip.creepages = {0.0, 0.0, 1.0 / size};
  const double of_spin = -solver.solve(without_slip).lateral_force * size;
  const double c23 = 0.5 * (of_spin + lateral.spin_moment);

  const double g = problem.shear_modulus;
  Flexibilities flexibilities{springs.force / (g * c11), springs.force / (g * c22), 0.0,
                              0.5 * (of_spin - lateral.spin_moment) / c22};
  // Where neighbours outweigh a strip's own part, spin has no stiffness of its own to speak of.
  flexibilities.spin = c23 > 0.0 ? springs.spin / (g * c23)
                                 : std::sqrt(flexibilities.longitudinal * flexibilities.lateral);
  return flexibilities;
}

} // namespace wrc
