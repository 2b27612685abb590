/// Normal contact by the library's solver, with multi-level multi-summation, by full multigrid and
/// by elimination: time, operations and errors at one tolerance.
///
/// Prints two tables in markdown (usage below): the methods on Hertz's contact and a two-lobed
/// wheel (problems.hpp), and a product u = K q by FFT and by multi-summation. All stop when the
/// same estimate of the error, max|z| / max q with z from the periodic inverse, is below 3/4 of the
/// tolerance, and then take one step along z. Errors are the largest one of the pressures and that
/// of the largest pressure, both relative to it, against pressures on the same grid solved to 1e-9.
/// Residuals come from an exact product of their own. Times are those of the process, on one
/// thread, medians after one run that does not count; plans, spectra and kernels are there before.
/// Multi-summation takes the order and reach with the fewest operations that meet the tolerance.
/// Elimination takes part up to 1000 elements in contact.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "multigrid/methods.hpp"
#include "multigrid/multi_summation.hpp"

namespace {

using namespace multigrid;

constexpr const char* usage =
    "compare_multigrid [--sides N,N,...] [--repeats N] [--tolerance T] [--summation ORDER,REACH]\n"
    "                  [--check]\n"
    "\n"
    "  --sides      elements along a side of the square grids; default 64\n"
    "  --repeats    of each solution that is timed; default 5\n"
    "  --tolerance  largest error of the pressures relative to the largest; default 1e-4\n"
    "  --summation  order and reach of multi-summation; default: the cheapest that meet it\n"
    "  --check      ends with status 1 if a method misses the tolerance\n";

struct Options {
  std::vector<std::size_t> sides{64};
  int repeats = 5;
  double tolerance = 1e-4;
  bool fixed_summation = false;
  bool check = false;
};

/// Elements in contact up to which elimination takes part.
/// origin: bound: a hundred times slower than the library by then.
constexpr double most_eliminated = 1000.0;
/// origin: bound: ends the search; 6 to 15 are found.
constexpr int longest_reach = 24;

double milliseconds_now() {
  return 1e3 * static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// Median, ms. Runs that are short for the clock are repeated within a measurement.
double time_of(int repeats, const std::function<void()>& run) {
  constexpr double shortest = 2.0;
  const double before = milliseconds_now();
  run();
  const double once = std::max(milliseconds_now() - before, 1e-3);
  const int times = static_cast<int>(std::ceil(shortest / once));
  std::vector<double> measured;
  for (int i = 0; i < repeats; ++i) {
    const double start = milliseconds_now();
    for (int k = 0; k < times; ++k) {
      run();
    }
    measured.push_back((milliseconds_now() - start) / times);
  }
  std::sort(measured.begin(), measured.end());
  return measured[measured.size() / 2];
}

std::unique_ptr<Product> fft_product(std::size_t rows, std::size_t columns,
                                     const wrc::InfluenceKernel& kernel,
                                     wrc::InfluenceCache& cache) {
  return std::make_unique<FftProduct>(rows, columns, kernel, cache, FftProduct::Kind::exact);
}

/// What summation_product makes.
SummationAccuracy summation;

std::unique_ptr<Product> summation_product(std::size_t rows, std::size_t columns,
                                           const wrc::InfluenceKernel& kernel,
                                           wrc::InfluenceCache& /*cache*/) {
  return std::make_unique<MultiSummation>(rows, columns, kernel, summation);
}

class Comparison {
public:
  /// `tried`: orders, and reaches that smaller grids have needed.
  Comparison(const char* name, const Problem& problem, const Options& options,
             std::span<SummationAccuracy> tried)
      : name_(name), problem_(problem), options_(options), tried_(tried) {
    wrc::NormalSolver solver(wrc::PlannerRigor::estimate, wrc::Precision::double_only);
    reference_ = solve_by_library(problem_, solver, 1e-9).q;
    largest_ = *std::max_element(reference_.begin(), reference_.end());
    in_contact_ =
        std::count_if(reference_.begin(), reference_.end(), [](double q) { return q > 0; });
  }

  void run() {
    for (const wrc::Precision precision : {wrc::Precision::mixed, wrc::Precision::double_only}) {
      wrc::NormalSolver solver(wrc::PlannerRigor::estimate, precision);
      add(
          precision == wrc::Precision::mixed ? "library" : "library, double precision",
          [&] { return solve_by_library(problem_, solver, options_.tolerance); }, &solver);
    }
    wrc::InfluenceCache cache;
    auto tools = make_tools(problem_, fft_product, cache);
    if (static_cast<double>(in_contact_) <= most_eliminated) {
      add("elimination", [&] { return solve_by_elimination(problem_, tools); });
    }
    if (problem_.rows() <= coarsest_side) {
      return; // elimination on the coarsest grid is all that there is
    }
    add("CG, FFT", [&] { return solve_by_gradients(problem_, tools, options_.tolerance); });
    add("full multigrid, FFT",
        [&] { return solve_by_full_multigrid(problem_, tools, options_.tolerance); });
    tools = tools_of_summation(cache);
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(),
                  problem_.rows() <= longest_summed_side ? "CG, plain sum"
                                                         : "CG, multi-summation %d, %d",
                  summation.order, summation.reach);
    add(text.data(), [&] { return solve_by_gradients(problem_, tools, options_.tolerance); });
  }
  [[nodiscard]] bool met() const { return met_; }

private:
  [[nodiscard]] double error_of(const Answer& answer) const {
    double error = 0.0;
    for (std::size_t i = 0; i < answer.q.size(); ++i) {
      error = std::max(error, std::abs(answer.q[i] - reference_[i]) / largest_);
    }
    return error;
  }

  /// With the order and reach whose product is the cheapest of those that meet the tolerance.
  std::vector<GridTools> tools_of_summation(wrc::InfluenceCache& cache) {
    if (!options_.fixed_summation) {
      SummationAccuracy best;
      double fewest = HUGE_VAL;
      for (SummationAccuracy& tried : tried_) {
        for (bool met = false; !met && tried.reach <= longest_reach;) {
          summation = tried;
          auto tools = make_tools(problem_, summation_product, cache);
          const double operations = tools.front().product->operations();
          if (operations >= fewest) {
            break;
          }
          met = error_of(solve_by_gradients(problem_, tools, options_.tolerance)) <=
                options_.tolerance;
          if (met) {
            fewest = operations;
            best = tried;
          } else {
            ++tried.reach;
          }
        }
      }
      summation = best;
    }
    return make_tools(problem_, summation_product, cache);
  }

  void add(const char* method, const std::function<Answer()>& solve,
           wrc::NormalSolver* solver = nullptr) {
    Answer answer;
    const double time = time_of(options_.repeats, [&] { answer = solve(); });
    if (solver != nullptr) {
      count_library(problem_, *solver, options_.tolerance, answer);
    }
    const double error = error_of(answer);
    const double peak =
        std::abs(*std::max_element(answer.q.begin(), answer.q.end()) / largest_ - 1.0);
    const Residual residual = residual_of(problem_, answer.q);
    std::printf("| %s %zu² | %td | %s | %.3g | %.3g | %d | %d | %.1e | %.1e | %.1e |\n", name_,
                problem_.rows(), in_contact_, method, time, 1e-6 * answer.operations,
                answer.iterations, answer.products, error, peak, residual.gap);
    std::fflush(stdout);
    constexpr double rounding = 1e-9;
    if (!(error <= options_.tolerance) || !(residual.gap <= options_.tolerance) ||
        !(residual.load <= rounding)) {
      met_ = false;
    }
  }

  const char* name_;
  const Problem& problem_;
  const Options& options_;
  std::span<SummationAccuracy> tried_;
  std::vector<double> reference_;
  double largest_ = 0.0;
  std::ptrdiff_t in_contact_ = 0;
  bool met_ = true;
};

void compare_products(std::size_t side, const Options& options) {
  const Problem problem = make_problem(Shape::hertz, side);
  wrc::NormalSolver solver;
  const std::vector<double> q = solve_by_library(problem, solver, options.tolerance).q;
  wrc::InfluenceCache cache;
  FftProduct exact(side, side, problem.kernel(), cache, FftProduct::Kind::exact);
  const auto count = static_cast<double>(q.size());
  std::vector<double> u(q.size());
  std::vector<double> approximate(q.size());
  const double time = time_of(options.repeats, [&] { exact.apply(q.data(), u.data()); });
  const double largest = *std::max_element(u.begin(), u.end());
  std::printf("| %zu² | FFT | %.3g | %.0f | |\n", side, time, exact.operations() / count);
  for (const SummationAccuracy& accuracy : {SummationAccuracy{4, 3}, SummationAccuracy{4, 6},
                                            SummationAccuracy{6, 9}, SummationAccuracy{8, 12}}) {
    MultiSummation product(side, side, problem.kernel(), accuracy);
    const double summed =
        time_of(options.repeats, [&] { product.apply(q.data(), approximate.data()); });
    double error = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      error = std::max(error, std::abs(approximate[i] - u[i]) / largest);
    }
    std::printf("| %zu² | multi-summation %d, %d | %.3g | %.0f | %.1e |\n", side, accuracy.order,
                accuracy.reach, summed, product.operations() / count, error);
    std::fflush(stdout);
  }
}

std::vector<std::size_t> sides_of(const std::string& list) {
  std::vector<std::size_t> sides;
  std::istringstream words(list + ',');
  for (std::string word; std::getline(words, word, ',');) {
    sides.push_back(static_cast<std::size_t>(wrc::evidence::whole_number_of(word, "--sides", 8)));
  }
  return sides;
}

SummationAccuracy summation_of(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    throw wrc::evidence::WrongArgument("--summation = \"" + text + "\": allowed is ORDER,REACH");
  }
  return {wrc::evidence::number_of<int>(
              text.substr(0, comma), "--summation, order",
              [](int order) { return order >= 2 && order % 2 == 0; }, "an even number from 2 on"),
          wrc::evidence::whole_number_of(text.substr(comma + 1), "--summation, reach")};
}

Options options_of(const wrc::evidence::Arguments& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.count(); ++i) {
    const std::string name = arguments.text(i);
    if (name == "--check") {
      options.check = true;
      continue;
    }
    const bool known =
        name == "--sides" || name == "--repeats" || name == "--tolerance" || name == "--summation";
    if (!known || i + 1 == arguments.count()) {
      throw wrc::evidence::WrongArgument(known ? name + " needs a value"
                                               : '"' + name + "\" is no option");
    }
    const std::string value = arguments.text(++i);
    if (name == "--sides") {
      options.sides = sides_of(value);
    } else if (name == "--repeats") {
      options.repeats = wrc::evidence::whole_number_of(value, name);
    } else if (name == "--tolerance") {
      options.tolerance = wrc::evidence::positive_number_of(value, name);
    } else {
      options.fixed_summation = true;
      summation = summation_of(value);
    }
  }
  return options;
}

int compare(const wrc::evidence::Arguments& arguments) {
  const Options options = options_of(arguments);
  bool met = true;
  std::printf("Tolerance %g\n\n", options.tolerance);
  std::puts(
      "| problem | in contact | method | time, ms | operations, 1e6 | iterations | products | "
      "error of pressures | of pmax | residual |\n|---|---|---|---|---|---|---|---|---|---|");
  for (const Shape shape : {Shape::hertz, Shape::two_lobes}) {
    std::array<SummationAccuracy, 3> tried{{{4, 2}, {6, 3}, {8, 4}}};
    for (const std::size_t side : options.sides) {
      const Problem problem = make_problem(shape, side);
      Comparison comparison(shape == Shape::hertz ? "Hertz" : "two lobes", problem, options, tried);
      comparison.run();
      met = met && comparison.met();
    }
  }
  std::puts("\n| elements | product | time, ms | operations per element | error of u |\n"
            "|---|---|---|---|---|");
  for (const std::size_t side : options.sides) {
    if (side <= longest_summed_side) {
      continue;
    }
    compare_products(side, options);
  }
  if (options.check && !met) {
    std::fputs("a method misses the tolerance\n", stderr);
    return 1;
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return wrc::evidence::run(argc, argv, usage, compare);
}
