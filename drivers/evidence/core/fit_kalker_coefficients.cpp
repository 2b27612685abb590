// Makes the tables of cxx_core/rolling/kalker_coefficients.cpp from the library's full solver.
//
//   fit_kalker_coefficients sample FILE [PART PARTS]   appends solutions without slip (an hour in
//   all;
//                                                      several processes may share it, each its
//                                                      FILE)
//   fit_kalker_coefficients fit FILE...                prints coefficients of each ellipse, how
//   well
//                                                      the expansion meets them, and the tables
//   fit_kalker_coefficients quick                      a few coarse solutions, against the library
//
// Each ellipse is solved on several grids at several positions each; the coefficients are regressed
// on the sizes of the elements and taken at size 0. The elements that lie in an ellipse are not
// quite one of its ratio of axes: samples are moved to it with the coefficients' slope, so that
// little depends on the grid's position; the slope is that of a first expansion.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "rolling/kalker_coefficients.hpp"
#include "support/no_slip_samples.hpp"

extern "C" void dgels_(const char* transposed, const int* rows, const int* columns,
                       const int* right_sides, double* matrix, const int* matrix_rows,
                       double* values, const int* value_rows, double* work, const int* work_size,
                       int* status);

namespace {

using namespace wrc;
using namespace wrc::test;

constexpr std::size_t ratio_intervals = 24; ///< nodes of Chebyshev in ln(a/b), one fewer
constexpr std::size_t poisson_intervals = 4;
constexpr std::size_t ratio_degree = 12;
constexpr std::size_t poisson_degree = 4;
constexpr double tolerance = 1e-4;
const double largest = std::log(50.0);

struct Schedule {
  SampleGrid grid;
  int places = 0;
};

/// Long ellipses need many elements along, for C33.
std::vector<Schedule> schedule_of(double log_ratio) {
  std::vector<Schedule> all{{{32, 32}, 16}, {{48, 48}, 16},   {{64, 64}, 16},
                            {{96, 96}, 12}, {{128, 128}, 10}, {{192, 192}, 5}};
  if (log_ratio >= std::log(4.0)) {
    all.insert(all.end(), {{{256, 64}, 8}, {{512, 64}, 4}, {{512, 128}, 3}});
  }
  return all;
}

int take_samples(const std::string& path, std::size_t part, std::size_t parts) {
  std::FILE* file = std::fopen(path.c_str(), "a");
  if (file == nullptr) {
    std::fprintf(stderr, "cannot write %s\n", path.c_str());
    return 1;
  }
  RollingSolver solver;
  for (std::size_t i = part; i <= ratio_intervals; i += parts) {
    const double s =
        largest * std::cos(std::numbers::pi * static_cast<double>(i) / ratio_intervals);
    for (std::size_t j = 0; j <= poisson_intervals; ++j) {
      const double nu =
          0.25 * (1.0 - std::cos(std::numbers::pi * static_cast<double>(j) / poisson_intervals));
      for (const Schedule& schedule : schedule_of(s)) {
        for (int place = 0; place < schedule.places; ++place) {
          const NoSlipSample c =
              no_slip_sample(std::exp(s), nu, schedule.grid, place, tolerance, solver);
          std::fprintf(file, "%.10g %.10g %zu %zu %d %.8g %.8g %.8g %.8g %.8g\n", s, nu,
                       schedule.grid.along, schedule.grid.across, place, c.c11, c.c22, c.c23, c.c32,
                       c.c33);
        }
      }
      std::fflush(file);
    }
  }
  std::fclose(file);
  return 0;
}

struct Fitted {
  std::vector<double> values;
  double error_of_first = 0.0; ///< standard error
};

/// Least squares; `rows` of equal length.
Fitted least_squares(const std::vector<std::vector<double>>& rows, std::vector<double> right) {
  const int count = static_cast<int>(rows.size());
  const int unknowns = static_cast<int>(rows.front().size());
  std::vector<double> matrix(rows.size() * rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      matrix[j * rows.size() + i] = rows[i][j];
    }
  }
  std::vector<double> work(static_cast<std::size_t>(64 * (count + unknowns)));
  const int work_size = static_cast<int>(work.size());
  const int one = 1;
  int status = 0;
  dgels_("N", &count, &unknowns, &one, matrix.data(), &count, right.data(), &count, work.data(),
         &work_size, &status);
  if (status != 0) {
    std::fprintf(stderr, "least squares failed\n");
    std::exit(1);
  }
  Fitted fitted;
  const auto n = static_cast<std::size_t>(unknowns);
  fitted.values.assign(right.begin(), right.begin() + unknowns);
  double rest = 0.0;
  for (std::size_t i = n; i < rows.size(); ++i) {
    rest += right[i] * right[i];
  }
  // First row of the inverse of R: its length is the factor of the first value's error.
  std::vector<double> inverse(n);
  double square = 0.0;
  for (std::size_t j = 0; j < n; ++j) {
    double sum = j == 0 ? 1.0 : 0.0;
    for (std::size_t k = 0; k < j; ++k) {
      sum -= inverse[k] * matrix[j * rows.size() + k];
    }
    inverse[j] = sum / matrix[j * rows.size() + j];
    square += inverse[j] * inverse[j];
  }
  fitted.error_of_first =
      std::sqrt(rest / std::max(1.0, static_cast<double>(rows.size() - n)) * square);
  return fitted;
}

/// ln of the ratio of axes that the elements in the ellipse have by their second moments, over that
/// of the ellipse.
double log_ratio_error(const SampleGrid& grid, int place) {
  static std::map<std::array<std::size_t, 3>, double> known;
  const auto [found, is_new] =
      known.try_emplace({grid.along, grid.across, static_cast<std::size_t>(place)}, 0.0);
  if (is_new) {
    const auto [place_x, place_y] = grid_place(place);
    double squares_x = 0.0;
    double squares_y = 0.0;
    for (std::size_t j = 0; j <= grid.across; ++j) {
      const double y =
          -1.0 + 2.0 / static_cast<double>(grid.across) * (place_y - 0.5 + static_cast<double>(j));
      for (std::size_t i = 0; i <= grid.along; ++i) {
        const double x =
            -1.0 + 2.0 / static_cast<double>(grid.along) * (place_x - 0.5 + static_cast<double>(i));
        if (x * x + y * y < 1.0) {
          squares_x += x * x;
          squares_y += y * y;
        }
      }
    }
    found->second = 0.5 * std::log(squares_x / squares_y);
  }
  return found->second;
}

using Four = std::array<double, 4>; ///< C11, C22, C23, C33

struct Sample {
  SampleGrid grid;
  int place = 0;
  Four values{};
};
using Ellipses = std::map<std::pair<double, double>, std::vector<Sample>>; ///< by s and nu

Ellipses read_samples(const std::vector<std::string>& paths) {
  Ellipses ellipses;
  for (const std::string& path : paths) {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
      std::istringstream text(line);
      double s = 0.0;
      double nu = 0.0;
      double c32 = 0.0;
      Sample sample;
      if (text >> s >> nu >> sample.grid.along >> sample.grid.across >> sample.place >>
          sample.values[0] >> sample.values[1] >> sample.values[2] >> c32 >> sample.values[3]) {
        sample.values[2] = 0.5 * (sample.values[2] + c32); // equal except for the elements' size
        ellipses[{s, nu}].push_back(sample);
      }
    }
  }
  return ellipses;
}

struct Extrapolated {
  Four values{};
  Four errors{};
};

Extrapolated extrapolate(double s, const std::vector<Sample>& samples, const Four& slopes) {
  const bool both = s >= std::log(4.0); // whether the sizes along and across differ
  Extrapolated result;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<std::vector<double>> rows;
    std::vector<double> right;
    for (const Sample& sample : samples) {
      const double along = 1.0 / static_cast<double>(sample.grid.along);
      const double across = 1.0 / static_cast<double>(sample.grid.across);
      // The scatter falls with the power 3/2 of the coarser size.
      const double weight = std::pow(std::max(along, across), -1.5);
      rows.push_back({weight, weight * along, weight * along * along});
      if (both) {
        rows.back().push_back(weight * across);
      }
      if (both && k != 3) { // C33 of long ellipses, a small difference, scatters too much for it
        rows.back().push_back(weight * across * across);
      }
      right.push_back(weight * sample.values[k] *
                      std::exp(-slopes[k] * log_ratio_error(sample.grid, sample.place)));
    }
    const Fitted fitted = least_squares(rows, right);
    result.values[k] = fitted.values[0];
    result.errors[k] = fitted.error_of_first;
  }
  return result;
}

std::vector<double> chebyshev(std::size_t degree, double x) {
  std::vector<double> values{1.0, x};
  while (values.size() <= degree) {
    values.push_back(2.0 * x * values.back() - values[values.size() - 2]);
  }
  values.resize(degree + 1);
  return values;
}

/// What is expanded: see the tables' comments in kalker_coefficients.cpp.
double transformed(std::size_t k, double s, double nu, const Four& c) {
  const double ratio = std::exp(s);
  switch (k) {
  case 0:
    return std::log(c[0] / (1.0 + ratio));
  case 1:
    return std::log(c[1] / c[0]) / nu;
  case 2:
    return std::log(c[2] / (std::sqrt(ratio) * (1.0 + ratio)));
  default:
    return c[3] * ratio / (1.0 + ratio);
  }
}

/// By degree in ln(a/b), then in nu.
using Table = std::array<std::array<double, poisson_degree + 1>, ratio_degree + 1>;

double evaluate(const Table& table, double s, double nu) {
  const std::vector<double> by_ratio = chebyshev(ratio_degree, s / largest);
  const std::vector<double> by_poisson = chebyshev(poisson_degree, 4.0 * nu - 1.0);
  double sum = 0.0;
  for (std::size_t i = 0; i <= ratio_degree; ++i) {
    for (std::size_t j = 0; j <= poisson_degree; ++j) {
      sum += table[i][j] * by_ratio[i] * by_poisson[j];
    }
  }
  return sum;
}

Four evaluate(const std::array<Table, 4>& tables, double s, double nu) {
  const double ratio = std::exp(s);
  const double c11 = (1.0 + ratio) * std::exp(evaluate(tables[0], s, nu));
  return {c11, c11 * std::exp(nu * evaluate(tables[1], s, nu)),
          std::sqrt(ratio) * (1.0 + ratio) * std::exp(evaluate(tables[2], s, nu)),
          (1.0 + ratio) / ratio * evaluate(tables[3], s, nu)};
}

using Reduced = std::map<std::pair<double, double>, Extrapolated>;

std::array<Table, 4> expand(const Reduced& reduced) {
  constexpr double floor = 2e-4; // the expansion's own error: no ellipse counts more
  std::array<Table, 4> tables{};
  for (std::size_t k = 0; k < 4; ++k) {
    // C22/C11 is 1 for nu = 0, which leaves one value of nu fewer.
    const std::size_t columns = k == 1 ? poisson_degree : poisson_degree + 1;
    std::vector<std::vector<double>> rows;
    std::vector<double> right;
    for (const auto& [place, found] : reduced) {
      const auto [s, nu] = place;
      if (k == 1 && nu == 0.0) {
        continue;
      }
      const double error = k == 3 ? found.errors[3] * std::exp(s) / (1.0 + std::exp(s))
                                  : found.errors[k] / found.values[k];
      const double weight = (k == 1 ? nu : 1.0) / (error + floor);
      const std::vector<double> by_ratio = chebyshev(ratio_degree, s / largest);
      const std::vector<double> by_poisson = chebyshev(poisson_degree, 4.0 * nu - 1.0);
      std::vector<double> row;
      for (std::size_t i = 0; i <= ratio_degree; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
          row.push_back(weight * by_ratio[i] * by_poisson[j]);
        }
      }
      rows.push_back(row);
      right.push_back(weight * transformed(k, s, nu, found.values));
    }
    const Fitted fitted = least_squares(rows, right);
    for (std::size_t i = 0; i <= ratio_degree; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        tables[k][i][j] = fitted.values[i * columns + j];
      }
    }
  }
  return tables;
}

int fit(const std::vector<std::string>& paths) {
  const Ellipses ellipses = read_samples(paths);
  if (ellipses.size() != (ratio_intervals + 1) * (poisson_intervals + 1)) {
    std::fprintf(stderr, "%zu ellipses in the files, there must be %zu\n", ellipses.size(),
                 (ratio_intervals + 1) * (poisson_intervals + 1));
    return 1;
  }
  Reduced reduced;
  std::array<Table, 4> tables{};
  for (int pass = 0; pass < 2; ++pass) {
    for (const auto& [place, samples] : ellipses) {
      const auto [s, nu] = place;
      Four slopes{};
      if (pass > 0) {
        constexpr double width = 1e-3;
        const Four above = evaluate(tables, s + width, nu);
        const Four below = evaluate(tables, s - width, nu);
        for (std::size_t k = 0; k < 4; ++k) {
          slopes[k] = std::log(above[k] / below[k]) / (2.0 * width);
        }
      }
      reduced[place] = extrapolate(s, samples, slopes);
    }
    tables = expand(reduced);
  }
  std::printf("a/b, nu: C11, C22, C23, C33 (standard error, difference of the expansion)\n");
  for (const auto& [place, found] : reduced) {
    const Four values = evaluate(tables, place.first, place.second);
    std::printf("%8.4f %.4f:", std::exp(place.first), place.second);
    for (std::size_t k = 0; k < 4; ++k) {
      std::printf("  %.5f (%.0e, %+.0e)", found.values[k], found.errors[k] / found.values[k],
                  values[k] / found.values[k] - 1.0);
    }
    std::printf("\n");
  }
  const char* names[] = {"c11", "c22", "c23", "c33"};
  for (std::size_t k = 0; k < 4; ++k) {
    std::printf("constexpr Table %s_table{{\n", names[k]);
    for (const auto& row : tables[k]) {
      std::printf("    {%.6f, %.6f, %.6f, %.6f, %.6f},\n", row[0], row[1], row[2], row[3], row[4]);
    }
    std::printf("}};\n");
  }
  return 0;
}

int quick() {
  RollingSolver solver;
  double worst = 0.0;
  for (const double ratio : {0.2, 1.0, 5.0}) {
    std::vector<Sample> samples;
    for (const std::size_t count : {std::size_t{24}, std::size_t{48}}) {
      for (int place = 0; place < 6; ++place) {
        const SampleGrid grid{count, count};
        const NoSlipSample c = no_slip_sample(ratio, 0.25, grid, place, tolerance, solver);
        samples.push_back({grid, place, {c.c11, c.c22, 0.5 * (c.c23 + c.c32), c.c33}});
      }
    }
    const KalkerCoefficients known = kalker_coefficients(ratio, 0.25);
    const Four expected{known.c11, known.c22, known.c23, known.c33};
    for (std::size_t k = 0; k < 3; ++k) {
      double means[2] = {};
      for (std::size_t i = 0; i < samples.size(); ++i) {
        means[i / 6] += samples[i].values[k] / 6.0;
      }
      const double error = (2.0 * means[1] - means[0]) / expected[k] - 1.0;
      std::printf("a/b %g, nu 0.25, coefficient %zu: %+.1e\n", ratio, k + 1, error);
      worst = std::max(worst, std::abs(error));
    }
  }
  // Scatter of few coarse grids.
  return worst < 1e-2 ? 0 : 1;
}

constexpr const char* usage =
    "fit_kalker_coefficients sample FILE [PART PARTS] | fit FILE... | quick\n\n"
    "sample  appends solutions without slip to FILE, or part PART (from 0) of PARTS\n"
    "fit     prints coefficients of each ellipse, and the tables of the library\n"
    "quick   compares a few coarse solutions with the library\n";

int choose(const evidence::Arguments& arguments) {
  const std::string task = arguments.text(0);
  if (task == "sample" && arguments.count() > 1) {
    arguments.refuse_beyond(4);
    const int parts = arguments.whole(3, "PARTS", 1);
    const int part = arguments.whole(2, "PART", 0, 0);
    if (part >= parts) {
      throw evidence::WrongArgument("PART = " + std::to_string(part) + ": must be between 0 and " +
                                    std::to_string(parts - 1));
    }
    return take_samples(arguments.text(1), static_cast<std::size_t>(part),
                        static_cast<std::size_t>(parts));
  }
  if (task == "fit" && arguments.count() > 1) {
    std::vector<std::string> files;
    for (std::size_t i = 1; i < arguments.count(); ++i) {
      files.push_back(arguments.text(i));
    }
    return fit(files);
  }
  if (task == "quick") {
    arguments.refuse_beyond(1);
    return quick();
  }
  throw evidence::WrongArgument('"' + task +
                                "\": must be sample FILE [PART PARTS], fit FILE... or quick");
}

} // namespace

int main(int argc, char** argv) {
  return evidence::run(argc, argv, usage, choose);
}
