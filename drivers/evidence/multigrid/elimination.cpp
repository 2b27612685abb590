/// On each contact set, LAPACK's Cholesky factors give the pressures for unit approach and for the
/// distances; all elements of the wrong sign change sides at once, only the last of them once that
/// stops helping (Judice & Pires, Computers & Operations Research 21 (1994) 587-596). Costs n^3/3
/// operations for n elements in contact, and exchange.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "multigrid/methods.hpp"

extern "C" void dposv_(const char* triangle, const int* order, const int* right_sides,
                       double* matrix, const int* matrix_rows, double* values,
                       const int* value_rows, int* status);

namespace multigrid {
namespace {

double influence(const wrc::InfluenceTable& table, std::size_t one, std::size_t other,
                 std::size_t columns) {
  const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
  return table.row(apart(one / columns, other / columns))[apart(one % columns, other % columns)];
}

std::vector<std::size_t> elements_in(const std::vector<double>& contact) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    if (contact[i] > 0.0) {
      chosen.push_back(i);
    }
  }
  return chosen;
}

/// Answers to unit displacement, then to the values given, on the chosen elements.
struct TwoAnswers {
  std::vector<double> values;
  [[nodiscard]] double sum(std::size_t which) const {
    const auto size = static_cast<std::ptrdiff_t>(values.size() / 2);
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(which) * size;
    return std::accumulate(first, first + size, 0.0);
  }
  /// The multiple of the first that makes the sum of both as given: first * multiple - second.
  [[nodiscard]] double at(std::size_t i, double multiple) const {
    return multiple * values[i] - values[values.size() / 2 + i];
  }
};

TwoAnswers factorise(const wrc::InfluenceTable& table, const std::vector<std::size_t>& chosen,
                     const std::vector<double>& given, std::size_t columns, Answer& answer) {
  const std::size_t size = chosen.size();
  std::vector<double> matrix(size * size);
  TwoAnswers answers{std::vector<double>(2 * size, 1.0)};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = i; k < size; ++k) {
      matrix[i * size + k] = influence(table, chosen[i], chosen[k], columns);
    }
    answers.values[size + i] = given[chosen[i]];
  }
  const int order = static_cast<int>(size);
  const int right_sides = 2;
  int status = 0;
  dposv_("L", &order, &right_sides, matrix.data(), &order, answers.values.data(), &order, &status);
  if (status != 0) {
    throw std::runtime_error("the influence of the elements in contact is not positive definite");
  }
  const auto n = static_cast<double>(size);
  answer.operations += n * n * n / 3.0 + 4.0 * n * n;
  return answers;
}

} // namespace

std::vector<double> solve_correction(const wrc::InfluenceTable& table,
                                     const std::vector<double>& contact,
                                     const std::vector<double>& r, std::size_t columns,
                                     Answer& answer) {
  const std::vector<std::size_t> chosen = elements_in(contact);
  std::vector<double> correction(contact.size(), 0.0);
  if (chosen.empty()) {
    return correction;
  }
  const TwoAnswers answers = factorise(table, chosen, r, columns, answer);
  const double multiple = answers.sum(1) / answers.sum(0);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    correction[chosen[i]] = -answers.at(i, multiple);
  }
  return correction;
}

void eliminate(const Problem& problem, const wrc::InfluenceTable& table,
               const std::vector<double>& start, Answer& answer) {
  constexpr int most_exchanges = 1000;
  constexpr int patience_at_first = 3;
  const std::size_t columns = problem.columns();
  const std::vector<double>& h = problem.distance;
  std::vector<double> contact = start;
  if (contact.empty()) {
    const double least = *std::min_element(h.begin(), h.end());
    for (const double distance : h) {
      contact.push_back(distance == least ? 1.0 : 0.0);
    }
  }
  int patience = patience_at_first;
  std::size_t fewest = h.size() + 1;
  for (answer.iterations = 1; answer.iterations <= most_exchanges; ++answer.iterations) {
    const std::vector<std::size_t> chosen = elements_in(contact);
    const TwoAnswers answers = factorise(table, chosen, h, columns, answer);
    const double approach = (problem.sum + answers.sum(1)) / answers.sum(0);
    answer.q.assign(h.size(), 0.0);
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      answer.q[chosen[i]] = answers.at(i, approach);
      if (answer.q[chosen[i]] < 0.0) {
        wrong.push_back(chosen[i]);
      }
    }
    for (std::size_t i = 0; i < h.size(); ++i) {
      double overlap = contact[i] > 0.0 ? 0.0 : approach - h[i];
      for (std::size_t k = 0; k < chosen.size() && overlap > 0.0; ++k) {
        overlap -= influence(table, i, chosen[k], columns) * answer.q[chosen[k]];
        answer.operations += 2.0;
      }
      if (overlap > 1e-12 * approach) {
        wrong.push_back(i);
      }
    }
    if (wrong.empty()) {
      return;
    }
    patience = wrong.size() < fewest ? patience_at_first : patience - 1;
    fewest = std::min(fewest, wrong.size());
    if (patience < 0) {
      wrong = {*std::max_element(wrong.begin(), wrong.end())};
    }
    for (const std::size_t i : wrong) {
      contact[i] = contact[i] > 0.0 ? 0.0 : 1.0;
    }
  }
  throw std::runtime_error("the exchange of elements does not end");
}

Answer solve_by_elimination(const Problem& problem, std::vector<GridTools>& tools) {
  const std::vector<Problem> problems = coarsened(problem);
  Answer answer;
  eliminate(problems.back(), *tools.back().table, {}, answer);
  for (std::size_t k = problems.size() - 1; k-- > 0;) {
    eliminate(problems[k], *tools[k].table, refined(problems[k + 1], answer.q, problems[k]),
              answer);
  }
  return answer;
}

} // namespace multigrid
