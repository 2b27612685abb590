/// A step of a vehicle simulation by a table, and by the exact solution where the table errs.
///
/// Where the map of errors exceeds the table's tolerance, and outside the table, a solver answers
/// if there is one; over one cell, and before the border, its forces go over into those of the
/// table with a continuous slope. Numbers in the convention of the solver's scene; without one, of
/// the scene that the table was made of. Thread rule: as the solver's; without one a pure function
/// that allocates nothing.
#pragma once

#include <array>

#include "scene/vehicle_step.hpp"
#include "table/contact_table.hpp"

namespace wrc {

/// Flag of a wheel, beside those of results/wheel_state.hpp, in whose forces the exact solution has
/// a part.
inline constexpr int exact_solution = 16; // not a tuning constant

/// Likewise, whose load is beyond the table's largest: Fz^(2/3) goes on in proportion to the depth,
/// as in Hertz's theory, and everything else along its slope.
inline constexpr int beyond_load = 64; // not a tuning constant

struct TableStep {
  std::array<WheelForces, 2> wheels;
  /// Of the table's own part: bound and likely error of the force, over the load as in
  /// TableErrors, and likely error of derivatives, each over itself.
  std::array<std::array<double, 3>, 2> errors{};
  /// If they were requested, with their likely errors; zeros of a wheel that lifted.
  std::array<WheelOutputs, 2> outputs{};
  std::array<WheelOutputs, 2> output_errors{};
  bool converged = true; ///< what the solver found
};

/// Who answers where the table does not.
struct ExactAnswer {
  const Scene& scene; ///< of the same pair
  SceneSolver& solver;
};

/// Both wheels in the track frame, numbers inside.
std::array<TableContact, 2> contacts_in_table(const ContactTable& table, const VehicleState& state,
                                              const Convention& convention);

/// What a state does not give is 0, friction and speed of standstill those of the table. Throws
/// Error(invalid_argument) that names what is outside, and what the solver throws.
/// `places`: whether outputs are wanted, and flags of the flange tip and the chamfer.
TableStep step_in_table(const ContactTable& table, const VehicleState& state,
                        const ExactAnswer* exact, bool places = false);

} // namespace wrc
