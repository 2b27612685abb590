#include "support/dense_reference.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "half_space/influence_coefficients.hpp"

extern "C" void dposv_(const char* triangle, const int* order, const int* right_sides,
                       double* matrix, const int* matrix_rows, double* values,
                       const int* value_rows, int* status);

namespace wrc::test {

namespace {

std::vector<double> influence_matrix(const PatchGap& patch, double combined_modulus,
                                     Elements elements) {
  const Grid& grid = patch.grid;
  const std::size_t count = grid.element_count();
  const std::size_t columns = grid.longitudinal_count;
  std::vector<double> matrix(count * count);
  for (std::size_t to = 0; to < count; ++to) {
    for (std::size_t from = 0; from < count; ++from) {
      matrix[to * count + from] = influence_coefficient(
          grid.longitudinal(to % columns) - grid.longitudinal(from % columns),
          grid.lateral(to / columns) - grid.lateral(from / columns), grid.longitudinal_step,
          grid.lateral_step, combined_modulus, elements);
      if (!patch.angles.empty()) {
        matrix[to * count + from] *=
            std::cos(patch.angles[to / columns] - patch.angles[from / columns]);
      }
    }
  }
  return matrix;
}

/// Pressures on the active elements, and the approach, for a given contact set.
DenseSolution solve_on(const std::vector<std::size_t>& active, const PatchProblem& problem,
                       const std::vector<double>& matrix) {
  const std::size_t count = problem.patch.grid.element_count();
  const std::size_t size = active.size();
  std::vector<double> reduced(size * size);
  // First column: answer to one unit of approach; second: to the undeformed distance.
  std::vector<double> values(2 * size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      reduced[i * size + j] = matrix[active[i] * count + active[j]];
    }
    values[i] = 1.0;
    values[size + i] = problem.patch.undeformed_distance[active[i]];
  }
  const int order = static_cast<int>(size);
  const int right_sides = 2;
  int status = 0;
  dposv_("L", &order, &right_sides, reduced.data(), &order, values.data(), &order, &status);
  if (status != 0) {
    throw std::runtime_error("dposv failed");
  }
  double unit_sum = 0.0;
  double distance_sum = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    unit_sum += values[i];
    distance_sum += values[size + i];
  }
  DenseSolution solution{std::vector<double>(count, 0.0), 0.0};
  solution.approach =
      problem.approach
          ? *problem.approach
          : (*problem.load / problem.patch.grid.element_area() + distance_sum) / unit_sum;
  for (std::size_t i = 0; i < size; ++i) {
    solution.pressure[active[i]] = solution.approach * values[i] - values[size + i];
  }
  return solution;
}

} // namespace

DenseSolution solve_densely(const PatchProblem& problem) {
  const std::size_t count = problem.patch.grid.element_count();
  const std::vector<double> matrix =
      influence_matrix(problem.patch, problem.combined_modulus, problem.elements);
  const std::span<const double> distance = problem.patch.undeformed_distance;
  const double least = *std::min_element(distance.begin(), distance.end());
  std::vector<bool> active(count);
  for (std::size_t index = 0; index < count; ++index) {
    // Anything near the least distance may start in contact; 1 mm is far beyond every deflection.
    active[index] =
        problem.approach ? distance[index] < *problem.approach : distance[index] < least + 1.0;
  }
  // Kim & Park's settings: three block exchanges without progress before single ones.
  int patience = 3;
  std::size_t fewest_wrong = count + 1;
  for (int exchange = 0; exchange < 2000; ++exchange) {
    std::vector<std::size_t> chosen;
    for (std::size_t index = 0; index < count; ++index) {
      if (active[index]) {
        chosen.push_back(index);
      }
    }
    DenseSolution solution = solve_on(chosen, problem, matrix);
    const double largest = *std::max_element(solution.pressure.begin(), solution.pressure.end());
    std::vector<std::size_t> wrong;
    for (std::size_t index = 0; index < count; ++index) {
      double gap = distance[index] - solution.approach;
      for (const std::size_t other : chosen) {
        gap += matrix[index * count + other] * solution.pressure[other];
      }
      // Signs below rounding are no reason to exchange.
      const double smallest_gap = -1e-13 * matrix[0] * largest;
      if (active[index] ? solution.pressure[index] < 0.0 : gap < smallest_gap) {
        wrong.push_back(index);
      }
    }
    if (wrong.empty()) {
      return solution;
    }
    if (wrong.size() < fewest_wrong) {
      fewest_wrong = wrong.size();
      patience = 3;
    } else {
      --patience;
    }
    if (patience < 0) {
      wrong = {wrong.back()};
    }
    for (const std::size_t index : wrong) {
      active[index] = !active[index];
    }
    if (std::none_of(active.begin(), active.end(), [](bool value) { return value; })) {
      active[static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) -
                                      distance.begin())] = true;
    }
  }
  throw std::runtime_error("the exchange of contact elements did not end");
}

} // namespace wrc::test
