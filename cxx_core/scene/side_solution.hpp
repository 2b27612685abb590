/// One wheel on its rail: from the contact search to pressures.
///
/// Joins remesh and mechanics for one side:
///  1. the depth to which the wheel sinks is taken from the last solution, or else estimated from
///     the virtual penetration;
///  2. coarse half-space solutions settle depth, contact plane and the extent of contact;
///  3. the undeformed distance is sampled again with the wheel lowered by that depth (not at the
///     first touch: under a contact angle a sinking wheel also slides along the tangent) on the
///     final grid, and solved. If the depth found then differs so much that the slide it makes,
///     |change| sin(angle), exceeds a small share of the depth, the distance is sampled anew;
///  4. contact must not touch the edge of the area, nor may the pressures leave overlap beyond it:
///     else the area grows, and the result counts it.
/// With an accuracy asked, the grid is refined by two until the difference of two grids, by the
/// second order of the method (docs/method.md), says that pmax and approach are met. The grids'
/// aspect ratios are then steps of a ladder, so that influence coefficients kept from one position
/// serve the next.
/// Units mm, N, MPa, rad; left-hand frame of the side (geometry/frames.hpp).
/// Thread rule: solver and memory serve one thread at a time; otherwise a pure function.
/// Not known here: several patches in planes of their own; friction; forces between the wheels.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/wheelset_equilibrium.hpp"
#include "mechanics/normal_contact.hpp"
#include "mechanics/normal_solver.hpp"
#include "mechanics/pressure_field.hpp"
#include "remesh/contact_frame.hpp"
#include "remesh/potential_contact_area.hpp"
#include "remesh/undeformed_distance.hpp"
#include "scene/trial.hpp"

namespace wrc {

enum class SolverChoice { automatic, paper };

struct SideRequest {
  GapConvention gap = GapConvention::tangent;
  double combined_modulus = 0.0;
  /// Exactly one of the three is set.
  std::optional<double> vertical_load; ///< N
  std::optional<double> normal_load;   ///< N, along the frame's normal
  std::optional<double> vertical;      ///< height of the wheelset's centre, mm
  double accuracy = 1e-3;
  std::optional<std::array<std::size_t, 2>> grid; ///< [lateral, longitudinal], instead of accuracy
  double tolerance = 1e-5;                        ///< of the pressures, relative; with a grid given
  SolverChoice solver = SolverChoice::automatic;
  int maximum_iterations = 5000;
};

/// What a solution leaves for the next one at a neighbouring position: a start, never an answer.
struct SideMemory {
  bool valid = false;
  double depth = 0.0;
  double load = 0.0;     ///< the one prescribed, N
  Resolution resolution; ///< that met the accuracy
  double accuracy = 0.0;
  /// Where contact lay in the rectangle of virtual penetration, as shares of its sides.
  double lateral_first = 0.0, lateral_last = 1.0;
  double longitudinal_first = 0.0, longitudinal_last = 1.0;
};

struct StageTimes {
  double remesh = 0.0; ///< s
  double mechanics = 0.0;
};

struct SideSolution {
  bool in_contact = false;
  ContactFrame frame;
  Grid grid;
  double vertical = 0.0; ///< height of the wheelset's centre at which the distance was sampled
  double depth = 0.0;    ///< vertical, from the first touch to that height
  std::vector<double> undeformed_distance;
  NormalSolution normal;             ///< without displacement and residuals, see problem_of
  std::optional<double> normal_load; ///< of the normal contact problem; or its approach
  double combined_modulus = 0.0;
  double approach = 0.0; ///< along the frame's normal, from the first touch
  double peak_pressure = 0.0;
  std::optional<double> error_estimate; ///< relative, of pmax and approach; none if not known
  std::vector<PressureRegion> regions;
  int iterations = 0; ///< of all solutions together
  int regrown = 0;    ///< how often the area had to grow
  StageTimes times;
  std::vector<std::string> warnings;
};

/// `memory` is read if valid, and written.
SideSolution solve_side(const WheelSurface& wheel, const RailSurface& rail,
                        const SideEquilibrium& equilibrium, const SideRequest& request,
                        NormalSolver& solver, SideMemory& memory);

/// The normal contact problem that was solved last; refers to the distances in the solution.
NormalProblem problem_of(const SideSolution& solution);

} // namespace wrc
