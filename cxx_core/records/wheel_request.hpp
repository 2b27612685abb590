/// The request for one wheel on its rail.
///
/// Units mm, N, MPa. Thread rule: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "accuracy/accuracy_of.hpp"
#include "accuracy/element_limit.hpp"
#include "half_space/influence_coefficients.hpp"
#include "half_space/steel.hpp"
#include "patches/contact_patch.hpp"
#include "records/module.hpp"
#include "remesh/undeformed_distance.hpp"

namespace wrc {

/// Of the pressures: the library's, or that of Polonsky & Keer (1999).
enum class SolverChoice { standard, paper };

/// Which contacts follow the mean curve of both bodies: none, all, or those where the error of a
/// plane comes near the accuracy.
enum class CurvedChoice { no, yes, by_accuracy };

/// How the wheels of a scene are solved, each alike.
struct WheelOptions : PatchOptions {
  GapConvention gap = GapConvention::tangent;
  Module until = Module::mechanics; ///< the last one to run
  AccuracyOf accuracy_of = AccuracyOf::pressures;
  double accuracy = 1e-3;
  std::optional<std::array<std::size_t, 2>> grid; ///< [lateral, longitudinal], instead of accuracy
  double tolerance = 1e-5;                        ///< of the pressures, relative; with a grid given
  SolverChoice solver = SolverChoice::standard;
  Elements elements = Elements::smooth;
  CurvedChoice curved = CurvedChoice::no;
  int passes = 1; ///< of the wheel over the same place, where steel yields
  /// Limit of the grids of a wheel that follow from the accuracy, together; another limit of the
  /// same size for creep forces. By the accuracy if not set.
  std::optional<double> element_limit;

  [[nodiscard]] double most_elements() const {
    return element_limit.value_or(limit_by_accuracy(accuracy));
  }
};

struct WheelRequest : WheelOptions {
  double combined_modulus = 0.0;
  std::vector<YieldingBody> yielding; ///< none: both are elastic
  /// Exactly one of the three is set.
  std::optional<double> vertical_load; ///< N
  std::optional<double> normal_load;   ///< N, along the normal of the main patch
  std::optional<double> vertical;      ///< height of the wheelset's centre, mm
  int maximum_iterations = 5000;
  bool creep_forces = false; ///< whether pressures are also used for creep forces
  bool stresses = false;     ///< likewise the largest stress below them

  [[nodiscard]] bool position_is_prescribed() const { return vertical.has_value(); }
  /// The load of the two that is set, N; 0 if the position is prescribed.
  [[nodiscard]] double load() const { return normal_load.value_or(vertical_load.value_or(0.0)); }
};

} // namespace wrc
