#include "rolling/kalker_coefficients.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "rolling/constants.hpp"

namespace wrc {

namespace {

/// By the degree of Chebyshev's polynomials of ln(a/b)/ln 50, then of those of 4 nu - 1.
using Table = std::array<std::array<double, 5>, 13>;

/// ln(C11/(1 + a/b)).
/// origin: measured (fit_kalker_coefficients): the full solver's values; not a tuning constant.
constexpr Table c11_table{{
    {0.569732, 0.206903, 0.013853, 0.001413, 0.000165},
    {-0.810461, -0.161981, -0.016354, -0.001922, -0.000238},
    {-0.144745, -0.006997, 0.001704, 0.000405, 0.000069},
    {0.056640, 0.025225, 0.002730, 0.000292, 0.000032},
    {0.015580, -0.000200, -0.000822, -0.000178, -0.000030},
    {-0.008484, -0.005730, -0.000569, -0.000037, 0.000000},
    {-0.001692, 0.000537, 0.000297, 0.000061, 0.000010},
    {0.001457, 0.001301, 0.000105, -0.000003, -0.000001},
    {0.000133, -0.000242, -0.000091, -0.000019, 0.000000},
    {-0.000252, -0.000284, -0.000011, 0.000004, -0.000001},
    {0.000005, 0.000085, 0.000025, 0.000006, -0.000004},
    {0.000037, 0.000067, 0.000001, -0.000001, -0.000003},
    {-0.000004, -0.000013, -0.000005, -0.000003, 0.000000},
}};

/// ln(C22/C11)/nu: C22 is C11 for nu = 0.
/// origin: measured (fit_kalker_coefficients): the full solver's values; not a tuning constant.
constexpr Table c22_table{{
    {-0.345843, -0.057386, -0.006412, -0.001120, 0.000000},
    {1.030525, 0.162408, 0.015836, 0.002378, 0.000000},
    {0.100291, 0.011138, -0.000144, -0.000298, 0.000000},
    {-0.153056, -0.023173, -0.001927, -0.000257, 0.000000},
    {-0.015862, -0.000046, 0.000625, 0.000229, 0.000000},
    {0.035068, 0.004882, 0.000291, -0.000018, 0.000000},
    {0.001483, -0.000703, -0.000329, -0.000081, 0.000000},
    {-0.008184, -0.000956, 0.000016, 0.000027, 0.000000},
    {0.000337, 0.000256, 0.000178, 0.000005, 0.000000},
    {0.001786, 0.000240, -0.000105, 0.000010, 0.000000},
    {-0.000333, 0.000010, -0.000133, 0.000045, 0.000000},
    {-0.000479, 0.000042, -0.000027, 0.000021, 0.000000},
    {0.000005, 0.000031, -0.000006, 0.000012, 0.000000},
}};

/// ln(C23/(sqrt(a/b) (1 + a/b))).
/// origin: measured (fit_kalker_coefficients): the full solver's values; not a tuning constant.
constexpr Table c23_table{{
    {-0.274630, 0.306253, 0.011260, 0.001849, 0.000121},
    {-0.965196, -0.188952, -0.000615, -0.001893, -0.000090},
    {0.017705, 0.164714, 0.002002, 0.001539, 0.000058},
    {0.023540, -0.021964, 0.005592, -0.000261, 0.000051},
    {-0.012190, -0.033742, -0.004641, -0.000040, -0.000058},
    {0.004978, 0.012629, 0.000087, -0.000087, 0.000022},
    {0.002896, 0.006434, 0.001450, 0.000084, -0.000005},
    {-0.002615, -0.004420, -0.000500, 0.000006, -0.000002},
    {-0.000367, -0.000888, -0.000272, -0.000038, 0.000000},
    {0.000868, 0.001327, 0.000233, 0.000014, 0.000000},
    {-0.000105, -0.000057, 0.000012, 0.000013, 0.000004},
    {-0.000292, -0.000428, -0.000113, -0.000008, 0.000009},
    {-0.000010, -0.000010, 0.000008, 0.000007, 0.000007},
}};

/// C33 (a/b)/(1 + a/b).
/// origin: measured (fit_kalker_coefficients): the full solver's values; not a tuning constant.
constexpr Table c33_table{{
    {0.631119, -0.016377, 0.014378, 0.003691, 0.000676},
    {-0.228096, -0.350967, -0.029610, -0.002684, -0.000252},
    {0.025368, -0.006292, 0.010610, 0.003072, 0.000627},
    {0.025471, 0.045116, 0.003521, 0.000473, 0.000103},
    {-0.010708, -0.001533, -0.003191, -0.000561, -0.000032},
    {-0.003620, -0.007096, 0.000159, 0.000170, 0.000089},
    {0.002450, 0.000465, 0.000833, 0.000102, 0.000053},
    {0.000155, 0.000739, -0.000179, -0.000060, 0.000034},
    {-0.000555, -0.000075, -0.000076, 0.000007, 0.000046},
    {-0.000018, -0.000010, 0.000117, -0.000008, 0.000027},
    {0.000039, 0.000007, 0.000028, -0.000042, 0.000012},
    {-0.000018, -0.000001, -0.000006, -0.000018, 0.000010},
    {0.000000, 0.000011, 0.000002, 0.000002, 0.000005},
}};

enum class Coefficient { c11, c22, c23, c33 };

/// A function and its derivative by s = ln(a/b).
struct Sloped {
  double value = 0.0;
  double slope = 0.0;
};

/// A table's expansion, s within its range.
Sloped expanded(const Table& table, double s, double poisson) {
  const double u = s / largest_kalker_log_ratio;
  const double v = 4.0 * poisson - 1.0;
  Sloped sum;
  double value = 1.0; // of T_i(u), and of those before
  double before = u;
  double slope = 0.0;
  double slope_before = 1.0;
  for (const auto& row : table) {
    // Clenshaw's recurrence over nu.
    double first = 0.0;
    double second = 0.0;
    for (std::size_t j = row.size(); j-- > 1;) {
      const double next = row[j] + 2.0 * v * first - second;
      second = first;
      first = next;
    }
    const double weight = row[0] + v * first - second;
    sum.value += weight * value;
    sum.slope += weight * slope;
    const double next = 2.0 * u * value - before;
    const double next_slope = 2.0 * value + 2.0 * u * slope - slope_before;
    before = value;
    slope_before = slope;
    value = next;
    slope = next_slope;
  }
  sum.slope /= largest_kalker_log_ratio;
  return sum;
}

/// ln of a coefficient, s within the tables' range.
Sloped log_within(Coefficient which, double s, double poisson) {
  const double ratio = std::exp(s);
  const double rising = ratio / (1.0 + ratio); // d ln(1 + a/b)/ds
  if (which == Coefficient::c33) {
    const Sloped sum = expanded(c33_table, s, poisson);
    return {std::log(sum.value / rising), sum.slope / sum.value - (1.0 - rising)};
  }
  if (which == Coefficient::c23) {
    const Sloped sum = expanded(c23_table, s, poisson);
    return {sum.value + std::log1p(ratio) + 0.5 * s, sum.slope + rising + 0.5};
  }
  Sloped sum = expanded(c11_table, s, poisson);
  if (which == Coefficient::c22) {
    const Sloped more = expanded(c22_table, s, poisson);
    sum = {sum.value + poisson * more.value, sum.slope + poisson * more.slope};
  }
  return {sum.value + std::log1p(ratio), sum.slope + rising};
}

/// Lambda = ln(16 (a/b)^2).
double lambda(double s) {
  return std::log(16.0) + 2.0 * s;
}

/// ln of Kalker's asymptote of wide ellipses, a/b -> 0 (Kalker 1990, app. E).
double log_wide(Coefficient which, double s, double nu) {
  constexpr double pi = std::numbers::pi;
  switch (which) {
  case Coefficient::c11:
    return std::log(pi * pi / (4.0 * (1.0 - nu)));
  case Coefficient::c22:
    return std::log(pi * pi / 4.0);
  case Coefficient::c23:
    return std::log(pi / (3.0 * (1.0 - nu)) * (1.0 + nu * (std::log(16.0) - s - 5.0))) + 0.5 * s;
  case Coefficient::c33:
    break;
  }
  return std::log(pi * pi / (16.0 * (1.0 - nu))) - s;
}

/// The same of long ellipses, a/b -> infinity; not of C33.
double log_long(Coefficient which, double s, double nu) {
  constexpr double pi = std::numbers::pi;
  const double logarithm = lambda(s);
  const double next = 3.0 - std::log(4.0);
  if (which == Coefficient::c11) {
    const double d = logarithm - 2.0 * nu;
    return std::log(2.0 * pi / d * (1.0 + next / d)) + s;
  }
  if (which == Coefficient::c22) {
    const double d = (1.0 - nu) * logarithm + 2.0 * nu;
    return std::log(2.0 * pi / d * (1.0 + (1.0 - nu) * next / d)) + s;
  }
  return std::log(2.0 * pi / (3.0 * ((1.0 - nu) * logarithm - 2.0 + 4.0 * nu))) + 1.5 * s;
}

double coefficient(Coefficient which, double s, double nu) {
  if (std::abs(s) <= largest_kalker_log_ratio) {
    return std::exp(log_within(which, s, nu).value);
  }
  const double edge = std::copysign(largest_kalker_log_ratio, s);
  const Sloped at_edge = log_within(which, edge, nu);
  const double beyond = s - edge;
  if (which == Coefficient::c33 && s > 0.0) {
    return std::exp(at_edge.value) / (1.0 - at_edge.slope * beyond);
  }
  const auto log_asymptote = [&](double place) {
    return s < 0.0 ? log_wide(which, place, nu) : log_long(which, place, nu);
  };
  // ln of the coefficient over its asymptote, with its slope at the edge. What is left falls with
  // a/b for wide ellipses, and with 1/Lambda^2 for long ones.
  constexpr double width =
      1e-3; // not a tuning constant: of a difference, whose error is 1e-7 of it
  const double rest = at_edge.value - log_asymptote(edge);
  const double slope =
      at_edge.slope - (log_asymptote(edge + width) - log_asymptote(edge - width)) / (2.0 * width);
  double left = 0.0;
  if (s < 0.0) {
    left = (rest + (slope - rest) * beyond) * std::exp(beyond);
  } else {
    const double share = lambda(edge) / lambda(s);
    left = share * share * (rest + (0.5 * lambda(edge) * slope + 2.0 * rest) * (1.0 - share));
  }
  return std::exp(log_asymptote(s) + left);
}

} // namespace

KalkerCoefficients kalker_coefficients(double a_over_b, double poisson) {
  if (!(a_over_b > 0.0) || !std::isfinite(a_over_b)) {
    throw_invalid_argument("a_over_b", a_over_b, "must be finite and greater than 0");
  }
  if (!(poisson >= 0.0 && poisson <= 0.5)) {
    throw_invalid_argument("poisson", poisson, "must be between 0 and 0.5");
  }
  const double s = std::log(a_over_b);
  return {coefficient(Coefficient::c11, s, poisson), coefficient(Coefficient::c22, s, poisson),
          coefficient(Coefficient::c23, s, poisson), coefficient(Coefficient::c33, s, poisson)};
}

} // namespace wrc
