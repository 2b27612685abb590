/// All patches of a wheel on one set of grids, solved together, and what is read off them.
///
/// Units mm, N, MPa; frame of patches/contact_frame.hpp. Thread rule: plain values.
/// Not known here: how the grids were chosen, and how far off the solution is (resolution.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mechanics/normal_contact.hpp"
#include "patches/contact_frame.hpp"
#include "patches/contact_patches.hpp"
#include "pressure/pressure_field.hpp"
#include "remesh/rail_normals.hpp"

namespace wrc {

/// What passes leave on the rows of a patch whose steel yields.
struct Groove {
  /// Of wheel and rail: depth in the direction of the patch's normal, mm, after this pass.
  std::array<std::vector<double>, 2> depth;
  /// Of both bodies together, before this pass, and the largest pressures carried then, MPa; none:
  /// it is the first.
  std::vector<double> found;
  std::vector<double> carried;
};

/// The record of a patch, from the plan to the result.
struct Patch {
  ContactPatch penetration;
  ContactFrame frame;
  /// Of its gap along the rail, 0 to 1 (remesh/bend_along.hpp); 1 also of pressures that rise to
  /// the onset of yield in a rim. Such pressures end as those of pressure/smooth_pressure.hpp.
  double bend = 0.0;
  Grid grid;
  double coupling_weight = 0.0; ///< of the interaction with another patch: the largest
  std::vector<double> undeformed_distance;
  std::vector<double> row_scales;      ///< of rows inclined to the plane (remesh/row_scales.hpp)
  std::vector<double> approach_shares; ///< with a load: of a vertical approach (rail_normals.hpp)
  std::vector<double> pressure;        ///< empty: not solved yet
  double normal_force = 0.0;           ///< sum of the pressures times the area of an element
  ContactForce contact_force;     ///< of the rail on the wheel; moment about the frame's origin
  SurfaceTurn turn;               ///< of the rail under the pressures
  double plane_error = 0.0;       ///< of its contact (model_error.hpp)
  double plane_force_error = 0.0; ///< likewise, without that of the largest pressure
  PressureRegion contact;         ///< all elements under pressure together
  double peak_error = 0.0;        ///< of a peak from a section (peak_section.hpp), MPa
  /// Largest pressure of the elastic solution, where steel yields; 0 of a patch that it has not.
  std::optional<double> elastic_peak;
  Groove groove;         ///< of that steel; where it was pressed before, distances include it
  double ridge = 0.0;    ///< under its pressures (peak_section.hpp), rad
  double growth = 0.0;   ///< of the peak at that ridge with every element e times narrower, MPa
  std::size_t plane = 0; ///< patches of the same one are one contact
  double approach = 0.0; ///< deepest overlap of the undeformed bodies along the normal
  std::optional<double> area; ///< of an approximate model, in closed form

  [[nodiscard]] bool no_contact() const { return contact.element_count == 0; }
  /// Elements along the contact.
  [[nodiscard]] double columns() const {
    return static_cast<double>(contact.box.longitudinal_last - contact.box.longitudinal_first + 1);
  }
  /// Across it.
  [[nodiscard]] double rows() const {
    return static_cast<double>(contact.box.lateral_last - contact.box.lateral_first + 1);
  }
  /// Deepest overlap of the undeformed bodies along the normal, by parabolas through the least
  /// distance and its neighbours.
  [[nodiscard]] double overlap() const;
};

/// Patches that share a plane.
struct PlanePatches {
  std::vector<std::size_t> patches; ///< of a solution, largest normal force first
  double normal_force = 0.0;
};

struct GridSolution {
  Elements elements = Elements::smooth;
  double depth = 0.0;         ///< vertical, from the first touch: of planes, grids and distances
  std::vector<Patch> patches; ///< ordered by y
  std::vector<double> links;  ///< coupling weight of each patch and the next
  std::size_t main = 0;       ///< the patch that holds the first contact
  StopReason stop_reason = StopReason::tolerance_met;
  double pressure_error = 0.0;
  std::optional<PatchInteraction> interaction; ///< none: the patches do not interact
  std::optional<double>
      left_out_s; ///< the vertical convention leaves out a patch there, mm on the wheel

  [[nodiscard]] bool no_contact() const;
  [[nodiscard]] double peak_pressure() const;
  [[nodiscard]] Vector3 force() const;
  /// Force of the patches in the plane of the main one.
  [[nodiscard]] Vector3 force_of_main() const;
  [[nodiscard]] double sharpest_ridge() const;
  /// Largest normal force first; without the patches that do not touch, if there are pressures.
  [[nodiscard]] std::vector<PlanePatches> patches_by_plane(bool solved) const;
};

} // namespace wrc
