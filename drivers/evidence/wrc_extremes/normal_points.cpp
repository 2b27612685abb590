// Gaps given directly: load, grid, element shape, units, shape of the gap, tolerance.
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "wrc_extremes/measure.hpp"

namespace extremes {
namespace {

constexpr double steel_modulus = 210000.0 / (2.0 * (1.0 - 0.3 * 0.3));
constexpr double base_load = 80000.0;
constexpr double base_side = 20.0; // mm
constexpr double base_tolerance = 1e-12;
/// Relative radii, mm; under the base load they press an ellipse into a third of the base grid.
constexpr double radius_along = 460.0;
constexpr double radius_across = 300.0;

using Shape = std::function<double(double x, double y)>;

GapProblem sampled(std::size_t rows, std::size_t columns, double lateral_step,
                   double longitudinal_step, const Shape& shape) {
  GapProblem problem;
  problem.rows = rows;
  problem.columns = columns;
  problem.lateral_step = lateral_step;
  problem.longitudinal_step = longitudinal_step;
  problem.combined_modulus = steel_modulus;
  problem.normal_load = base_load;
  problem.distance.reserve(rows * columns);
  const auto centred = [](std::size_t index, std::size_t count, double step) {
    return (static_cast<double>(index) - 0.5 * static_cast<double>(count - 1)) * step;
  };
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      problem.distance.push_back(
          shape(centred(column, columns, longitudinal_step), centred(row, rows, lateral_step)));
    }
  }
  return problem;
}

double paraboloid(double x, double y) {
  return x * x / (2.0 * radius_along) + y * y / (2.0 * radius_across);
}

/// The Hertz case on a square of 20 mm.
GapProblem hertz(std::size_t rows = 32, std::size_t columns = 16) {
  return sampled(rows, columns, base_side / static_cast<double>(rows),
                 base_side / static_cast<double>(columns), paraboloid);
}

/// Hertz's approach and largest pressure for the relative curvatures of the base case: with
/// e^2 = 1 - b^2/a^2 and the complete elliptic integrals K, E the ratio of curvatures is
/// (E/(1 - e^2) - K)/(K - E), and approach = 3 Q K/(2 pi E* a) (Johnson, Contact Mechanics, 1985,
/// eqs. 4.25 to 4.28). Solved for e by bisection.
struct Hertz {
  double approach = 0.0;
  double pmax = 0.0;
};
Hertz hertz_answer(double load) {
  const double ratio = radius_along / radius_across;
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 200; ++i) {
    const double e = 0.5 * (low + high);
    const double integral_k = std::comp_ellint_1(e);
    const double integral_e = std::comp_ellint_2(e);
    // Near a circle both differences vanish: their ratio is 1 + 3/4 e^2 there.
    const double found =
        e < 1e-3 ? 1.0 + 0.75 * e * e
                 : (integral_e / (1.0 - e * e) - integral_k) / (integral_k - integral_e);
    (found < ratio ? low : high) = e;
  }
  const double e = 0.5 * (low + high);
  const double integral_k = std::comp_ellint_1(e);
  const double integral_d = (integral_k - std::comp_ellint_2(e)) / (e * e);
  // The longer semi-axis lies along the smaller curvature, 1/radius_along.
  const double a =
      std::cbrt(3.0 * load * integral_d / (std::numbers::pi * steel_modulus) * radius_along);
  const double b = a * std::sqrt(1.0 - e * e);
  return {1.5 * load * integral_k / (std::numbers::pi * steel_modulus * a),
          1.5 * load / (std::numbers::pi * a * b)};
}

void add_loads(std::vector<Point>& points) {
  for (int exponent = -12; exponent <= 12; ++exponent) {
    const double load = std::pow(10.0, exponent);
    points.push_back({"load", "Hertz gap, 32 x 16", in_words("load", load, " N"), load,
                      exponent % 6 == 0, [load](Row& row, std::uint64_t seed) {
                        NormalCase one{hertz(), base_tolerance};
                        one.problem.normal_load = load;
                        measure_normal(one, row, seed);
                      }});
  }
}

/// Grids on the same square; those whose contact has elements enough are compared with Hertz.
void add_grids(std::vector<Point>& points) {
  using Size = std::array<std::size_t, 2>;
  for (const Size& size_of_grid :
       {Size{1, 1}, Size{1, 2}, Size{2, 1}, Size{2, 2}, Size{3, 3}, Size{1, 512}, Size{512, 1},
        Size{8, 4}, Size{32, 16}, Size{31, 13}, Size{64, 32}, Size{127, 61}, Size{256, 128},
        Size{512, 256}, Size{1024, 512}, Size{2048, 1024}, Size{4096, 2048}}) {
    const std::size_t rows = size_of_grid[0];
    const std::size_t columns = size_of_grid[1];
    const std::size_t count = rows * columns;
    const std::string size = std::to_string(rows) + " x " + std::to_string(columns);
    points.push_back(
        {"grid", "Hertz gap", size, static_cast<double>(count), count <= 512,
         [rows, columns](Row& row, std::uint64_t seed) {
           const bool small = rows * columns <= most_dense_elements;
           measure_normal({hertz(rows, columns), small ? base_tolerance : 1e-6}, row, seed);
           if (row.approach && rows >= 32 && columns >= 13) {
             const Hertz exact = hertz_answer(base_load);
             row.truth = "closed form";
             row.error = std::max(std::abs(*row.approach / exact.approach - 1.0),
                                  std::abs(*row.pmax / exact.pmax - 1.0));
           }
         }});
  }
  points.push_back({"grid", "Hertz gap", "0 x 16", 0.1, true, [](Row& row, std::uint64_t seed) {
                      GapProblem problem = hertz();
                      problem.rows = 0;
                      measure_normal({problem, base_tolerance}, row, seed);
                    }});
  constexpr std::size_t beyond = (std::size_t{1} << 26) + 1;
  points.push_back({"grid", "Hertz gap", "67108865 x 1", static_cast<double>(beyond), true,
                    [](Row& row, std::uint64_t seed) {
                      GapProblem problem = hertz();
                      problem.rows = beyond;
                      problem.columns = 1;
                      measure_normal({problem, base_tolerance}, row, seed);
                    }});
}

/// Elements `aspect` times as wide as long, contact over about half of the elements: the gap rises
/// over the grid by a multiple of the depth to which a punch of its size sinks.
GapProblem stretched(double aspect) {
  constexpr double base_step = 0.8;
  const double wide = std::sqrt(aspect);
  GapProblem problem =
      sampled(32, 16, base_step * wide, base_step / wide, [](double, double) { return 0.0; });
  const NormalAnswer punch = solve_normal({problem, 1e-6});
  const double rise = 6.0 * punch.approach;
  const double half_width = 16.0 * base_step * wide;
  const double half_length = 8.0 * base_step / wide;
  GapProblem made =
      sampled(32, 16, problem.lateral_step, problem.longitudinal_step, [=](double x, double y) {
        return rise * ((x / half_length) * (x / half_length) + (y / half_width) * (y / half_width));
      });
  return made;
}

void add_aspects(std::vector<Point>& points) {
  for (const double aspect : {1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0,
                              10.0,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e12}) {
    const bool quick = aspect == 1e-3 || aspect == 1.0 || aspect == 1e3 || aspect == 1e12;
    points.push_back({"aspect", "paraboloid, 32 x 16", in_words("lateral/longitudinal", aspect),
                      aspect, quick, [aspect](Row& row, std::uint64_t seed) {
                        measure_normal({stretched(aspect), base_tolerance}, row, seed);
                      }});
  }
}

/// The same problem in other units; its answer is scaled back and compared.
struct Scale {
  const char* what;
  double length_power, modulus_power;
};

void add_units(std::vector<Point>& points) {
  for (const Scale& scale :
       {Scale{"lengths", 1.0, 0.0}, Scale{"moduli", 0.0, 1.0},
        Scale{"lengths and moduli", 1.0, 1.0}, Scale{"lengths, moduli the other way", 1.0, -1.0}}) {
    for (const double tolerance : {1e-6, tolerance_floor}) {
      for (int exponent = -12; exponent <= 12; exponent += 2) {
        const double factor = std::pow(10.0, exponent);
        const double length = std::pow(factor, scale.length_power);
        const double modulus = std::pow(factor, scale.modulus_power);
        const std::string base = in_words("Hertz gap, tolerance", tolerance);
        points.push_back(
            {"units", base, in_words(std::string(scale.what) + " x", factor), factor,
             exponent % 12 == 0 && scale.modulus_power >= 0.0, [=](Row& row, std::uint64_t seed) {
               const NormalCase plain{hertz(), tolerance};
               NormalCase scaled = plain;
               scaled.problem.lateral_step *= length;
               scaled.problem.longitudinal_step *= length;
               scaled.problem.combined_modulus *= modulus;
               scaled.problem.normal_load *= length * length * modulus;
               for (double& value : scaled.problem.distance) {
                 value *= length;
               }
               measure_normal(scaled, row, seed);
               if (!row.approach) {
                 return;
               }
               const NormalAnswer one = solve_normal(plain);
               const NormalAnswer other = solve_normal(scaled);
               double difference = std::abs(other.approach / length / one.approach - 1.0);
               for (std::size_t i = 0; i < one.pressure.size(); ++i) {
                 difference =
                     std::max(difference,
                              std::abs(other.pressure[i] / modulus - one.pressure[i]) / one.pmax);
               }
               row.truth = "unscaled";
               row.error = difference;
               constexpr double permitted = 1e-12;
               if (row.verdict == Verdict::held && difference > permitted) {
                 row.verdict = Verdict::faded;
               }
             }});
      }
    }
  }
}

struct NamedGap {
  const char* name;
  std::function<GapProblem(std::uint64_t seed)> make;
};

double uniform(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

std::vector<NamedGap> gaps() {
  const auto fixed = [](const Shape& shape) {
    return [shape](std::uint64_t) {
      return sampled(32, 16, base_side / 32.0, base_side / 16.0, shape);
    };
  };
  const auto holed = [](double value) {
    return [value](std::uint64_t seed) {
      GapProblem problem = hertz();
      std::mt19937_64 engine(seed);
      for (int i = 0; i < 20; ++i) {
        problem.distance[engine() % problem.count()] = value;
      }
      return problem;
    };
  };
  const auto noisy = [](double height) {
    return [height](std::uint64_t seed) {
      GapProblem problem = hertz();
      std::mt19937_64 engine(seed);
      for (double& distance : problem.distance) {
        distance += height * uniform(engine);
      }
      return problem;
    };
  };
  return {
      {"paraboloid", fixed(paraboloid)},
      {"flat", fixed([](double, double) { return 0.0; })},
      {"flat, 1 km away", fixed([](double, double) { return 1e6; })},
      {"wedge", fixed([](double x, double y) { return 0.01 * std::abs(y) + x * x / 900.0; })},
      {"cone", fixed([](double x, double y) { return 0.01 * std::hypot(x, y); })},
      {"step of 0.05 mm",
       fixed([](double x, double y) { return paraboloid(x, y) + (y > 0.0 ? 0.05 : 0.0); })},
      {"step of 1 mm",
       fixed([](double x, double y) { return paraboloid(x, y) + (y > 0.0 ? 1.0 : 0.0); })},
      {"waves of 0.02 mm", fixed([](double x, double y) {
         return paraboloid(x, y) + 0.02 * std::sin(3.0 * x) * std::sin(2.0 * y);
       })},
      {"valley", fixed([](double x, double y) { return -0.5 * paraboloid(x, y); })},
      {"saddle", fixed([](double x, double y) { return (x * x - y * y) / 900.0; })},
      {"white noise 0.001 mm", noisy(0.001)},
      {"white noise 0.1 mm", noisy(0.1)},
      {"white noise 10 mm", noisy(10.0)},
      {"body ends (1e3 mm beside)",
       fixed([](double x, double y) { return std::abs(y) > 2.0 ? 1e3 : paraboloid(x, y); })},
      {"body ends (1e300 mm beside)",
       fixed([](double x, double y) { return std::abs(y) > 2.0 ? 1e300 : paraboloid(x, y); })},
      {"20 elements at 1e9 mm", holed(1e9)},
      {"20 elements NaN", holed(std::numeric_limits<double>::quiet_NaN())},
      {"one row infinite",
       [](std::uint64_t) {
         GapProblem problem = hertz();
         std::fill_n(problem.distance.begin(), problem.columns,
                     std::numeric_limits<double>::infinity());
         return problem;
       }},
  };
}

void add_gaps(std::vector<Point>& points) {
  double index = 0.0;
  for (const NamedGap& gap : gaps()) {
    points.push_back({"gap", "32 x 16", gap.name, ++index, true,
                      [make = gap.make](Row& row, std::uint64_t seed) {
                        measure_normal({make(seed), base_tolerance}, row, seed);
                      }});
  }
}

void add_tolerances(std::vector<Point>& points) {
  const auto all = std::make_shared<const std::vector<NamedGap>>(gaps());
  for (const std::size_t which : {std::size_t{0}, std::size_t{1}, std::size_t{11}}) {
    for (const double tolerance : {0.2, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10,
                                   1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 1e-20}) {
      const bool quick = which == 0 && (tolerance == 0.2 || tolerance == 1e-6 ||
                                        tolerance == 1e-13 || tolerance == 1e-20);
      points.push_back({"tolerance", (*all)[which].name, in_words("tolerance", tolerance),
                        tolerance, quick, [all, which, tolerance](Row& row, std::uint64_t seed) {
                          measure_normal({(*all)[which].make(seed), tolerance}, row, seed);
                        }});
    }
  }
}

} // namespace

void add_normal_points(std::vector<Point>& points) {
  add_loads(points);
  add_grids(points);
  add_aspects(points);
  add_units(points);
  add_gaps(points);
  add_tolerances(points);
}

} // namespace extremes
