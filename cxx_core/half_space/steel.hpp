/// Steels that yield: their yield stress, grades by name, and the law of pressures beyond it.
///
/// What a body of yield stress s takes of a pressure p beyond its elastic range is
///   P = s f(p/s),  f(t) = max(t - yield_onset, 0)^yield_exponent.
/// Contact of such bodies adds sum_b c_b/2 P_b.A P_b to its energy (mechanics/yielding.hpp), c_b
/// yield_stiffness times the body's part of the compliance. The law has no length, and does nothing
/// below yield_onset s. It is that of a first pressing: no residual stress, no ratcheting, and no
/// yielding by tractions. Units MPa. Thread rule: pure functions.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "half_space/material.hpp"

namespace wrc {

struct Steel {
  std::optional<double> yield_stress; ///< none: elastic
  std::string_view grade = {};        ///< by which it was named, if it was

  bool operator==(const Steel&) const = default;
};

/// None if there is no such grade. Grades of wheels have the least yield stress that EN 13262
/// requires. EN 13674-1 has none for rails: estimated from their tensile strength.
std::optional<Steel> steel_of_grade(std::string_view grade);

/// "R260, 480 MPa (estimate: 0.55 of the tensile strength)", "500 MPa", or "elastic".
std::string text_of(const Steel& steel);
/// "wheel 500 MPa; rail elastic", or "elastic" if both are.
std::string text_of(const Steel& of_wheel, const Steel& of_rail);

/// k: 1/sqrt(3) of the yield stress; of a steel without one that of common rails.
double shear_yield_of(const Steel& steel);

/// A body that yields.
struct YieldingBody {
  double stress = 0.0;   ///< its yield stress
  double share = 1.0;    ///< its part of the compliance of both bodies
  double of_wheel = 0.0; ///< the wheel's part of its indentation; the rest is the rail's
};

/// Those of wheel and rail that yield, as one if their yield stress is the same; none if both are
/// elastic.
std::vector<YieldingBody> yielding_bodies(const Material& wheel, const Steel& of_wheel,
                                          const Material& rail, const Steel& of_rail);

/// The smaller yield stress; infinite without bodies that yield.
double softest_of(std::span<const YieldingBody> bodies);

/// The pressure at which the softer one begins to yield; infinite without bodies that do.
double onset_of_yield(std::span<const YieldingBody> bodies);

/// P, and its first and second derivative by the pressure.
struct Excess {
  double value = 0.0;
  double slope = 0.0;
  double curvature = 0.0;
};
Excess excess_of(double pressure, double yield_stress);

/// Of steel that has carried a pressure before: what it takes more than it took then, with a smooth
/// start over yield_again_range of that. P~ is convex, too.
Excess excess_of(double pressure, double yield_stress, double carried);

/// About the pressure that steel carries where elastic bodies would carry `pressure`: a place to
/// start from.
double yielded_estimate(double pressure, double yield_stress);

} // namespace wrc
