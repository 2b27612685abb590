#include "multigrid/nested_grids.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/reductions.hpp"
#include "base/vector_clones.hpp"
#include "mechanics/cascade.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/projected_cg_loops.hpp"

namespace multigrid {

namespace {

WRC_VECTOR_CLONES double product_sum(const double* one, const double* other, std::size_t n) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) {
    sum += one[i] * other[i];
  }
  return sum;
}

/// Takes the mean over contact off. Returns the largest change left.
WRC_VECTOR_CLONES double take_mean(double* values, const double* contact, std::size_t n) {
  double sum = 0.0;
  double count = 0.0;
#pragma omp simd reduction(+ : sum, count)
  for (std::size_t i = 0; i < n; ++i) {
    sum += contact[i] * values[i];
    count += contact[i];
  }
  const double mean = count > 0.0 ? sum / count : 0.0;
  double largest = 0.0;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = contact[i] * (values[i] - mean);
    largest = std::max(largest, std::abs(values[i]));
  }
  return largest;
}

WRC_VECTOR_CLONES void residual_on_contact(const double* q, const double* u, const double* h,
                                           double* r, double* contact, std::size_t n) {
  double sum = 0.0;
  double count = 0.0;
#pragma omp simd reduction(+ : sum, count)
  for (std::size_t i = 0; i < n; ++i) {
    const double pressed = q[i] > 0.0 ? 1.0 : 0.0;
    sum += pressed * (h[i] + u[i]);
    count += pressed;
  }
  const double approach = sum / count;
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    const double overlap = approach - h[i] - u[i];
    contact[i] = (q[i] > 0.0) | (overlap > 0.0) ? 1.0 : 0.0;
    r[i] = contact[i] * overlap;
  }
}

WRC_VECTOR_CLONES void step_along(double* q, double* u, const double* v, const double* response,
                                  double step, std::size_t n) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    q[i] += step * v[i];
    u[i] += step * response[i];
  }
}

WRC_VECTOR_CLONES void scale(double* q, double* u, double sum_wanted, std::size_t n) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) {
    sum += q[i];
  }
  const double factor = sum_wanted / sum;
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    q[i] *= factor;
    u[i] *= factor;
  }
}

/// K at all distances along a row, from the farthest on one side to that on the other.
std::vector<double> mirrored(const wrc::InfluenceTable& table, std::size_t rows,
                             std::size_t columns) {
  std::vector<double> values;
  values.reserve(rows * (2 * columns - 1));
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = columns - 1; j > 0; --j) {
      values.push_back(table.row(i)[j]);
    }
    values.insert(values.end(), table.row(i), table.row(i) + columns);
  }
  return values;
}

} // namespace

double dot(const std::vector<double>& one, const std::vector<double>& other) {
  return product_sum(one.data(), other.data(), one.size());
}

double keep_load(std::vector<double>& values, const std::vector<double>& contact) {
  return take_mean(values.data(), contact.data(), values.size());
}

std::vector<GridTools> make_tools(const Problem& finest, MakeProduct make_product,
                                  wrc::InfluenceCache& cache) {
  std::vector<GridTools> tools;
  const wrc::InfluenceKernel kernel = finest.kernel();
  for (wrc::LevelSize size{finest.rows(), finest.columns()};; size = wrc::coarser_size(size)) {
    tools.push_back({make_product(size.rows, size.columns, kernel, cache),
                     std::make_unique<FftProduct>(size.rows, size.columns, kernel, cache,
                                                  FftProduct::Kind::periodic_inverse),
                     cache.table(kernel, size.rows, size.columns),
                     {}});
    tools.back().mirrored = mirrored(*tools.back().table, size.rows, size.columns);
    if (std::max(size.rows, size.columns) <= coarsest_side) {
      return tools;
    }
  }
}

std::vector<Problem> coarsened(const Problem& finest) {
  std::vector<Problem> problems{finest};
  while (std::max(problems.back().rows(), problems.back().columns()) > coarsest_side) {
    problems.push_back(coarser(problems.back()));
  }
  return problems;
}

std::vector<double> refined(const Problem& coarse, const std::vector<double>& q,
                            const Problem& fine) {
  std::vector<double> values;
  wrc::refine_pressure(coarse.grid, q, fine.grid, values);
  const double factor = fine.sum / std::accumulate(values.begin(), values.end(), 0.0);
  for (double& value : values) {
    value *= factor;
  }
  return values;
}

ContactState::ContactState(const Problem& problem, GridTools& tools, std::vector<double> start,
                           Answer& tally)
    : q(std::move(start)), u(q.size()), r(q.size()), z(q.size()), contact(q.size()),
      problem_(problem), tools_(tools), tally_(tally) {
  apply(q, u);
}

void ContactState::apply(const std::vector<double>& from, std::vector<double>& to) {
  tools_.product->apply(from.data(), to.data());
  ++tally_.products;
  tally_.operations += tools_.product->operations();
}

void ContactState::form_residual() {
  residual_on_contact(q.data(), u.data(), problem_.distance.data(), r.data(), contact.data(),
                      q.size());
  // With z, directions and the step: some twenty operations an element and iteration.
  tally_.operations += 20.0 * static_cast<double>(q.size());
}

double ContactState::estimate() {
  tools_.preconditioner->apply(r.data(), z.data());
  tally_.operations += tools_.preconditioner->operations();
  return keep_load(z, contact) / *std::max_element(q.begin(), q.end());
}

void ContactState::move(const std::vector<double>& v, const std::vector<double>& response,
                        double step) {
  step_along(q.data(), u.data(), v.data(), response.data(), step, q.size());
  cut();
  scale(q.data(), u.data(), problem_.sum, q.size());
}

/// As the library does it (mechanics/iteration_box.hpp).
void ContactState::cut() {
  std::vector<std::size_t> negative;
  const std::size_t columns = problem_.columns();
  for (std::size_t row = 0; row < problem_.rows(); ++row) {
    const double* line = q.data() + row * columns;
    if (wrc::least_of(line, columns) < 0.0) {
      for (std::size_t j = 0; j < columns; ++j) {
        if (line[j] < 0.0) {
          negative.push_back(row * columns + j);
        }
      }
    }
  }
  const double most = std::min(static_cast<double>(wrc::max_single_cuts),
                               static_cast<double>(q.size()) / wrc::elements_per_cut);
  if (static_cast<double>(negative.size()) > most) {
    for (const std::size_t i : negative) {
      q[i] = 0.0;
    }
    apply(q, u);
    return;
  }
  std::vector<double> pressures;
  for (const std::size_t i : negative) {
    pressures.push_back(q[i]);
    q[i] = 0.0;
  }
  std::vector<const double*> kernels(negative.size());
  std::vector<double> scratch(columns);
  for (std::size_t row = 0; row < problem_.rows() && !negative.empty(); ++row) {
    for (std::size_t c = 0; c < negative.size(); ++c) {
      const std::size_t from = negative[c] / columns;
      const std::size_t apart = row > from ? row - from : from - row;
      kernels[c] = tools_.mirrored.data() + apart * (2 * columns - 1) +
                   (columns - 1 - negative[c] % columns);
    }
    wrc::take_out(u.data() + row * columns, scratch.data(), kernels.data(), pressures.data(),
                  negative.size(), columns);
  }
  tally_.operations += 2.0 * static_cast<double>(negative.size() * q.size());
}

std::vector<double> ContactState::finish() {
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = std::max(0.0, q[i] + z[i]);
  }
  scale(q.data(), u.data(), problem_.sum, q.size());
  return std::move(q);
}

} // namespace multigrid
