/// All patches of a wheel on one set of grids, solved together, and what is read off them.
///
/// Units mm, N, MPa; frame of patches/contact_frame.hpp. Thread rule: plain values.
/// Not known here: how the grids were chosen, and how far off the solution is (resolution.hpp).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mechanics/joint_contact.hpp"
#include "patches/contact_frame.hpp"
#include "patches/contact_patches.hpp"
#include "pressure/pressure_field.hpp"

namespace wrc {

/// A patch's grid and its part of the solution.
struct PatchOnGrid {
  ContactPatch place;
  ContactFrame frame;
  Grid grid;
  double share = 1.0;           ///< of the approach, along the patch's normal
  double coupling_weight = 0.0; ///< of the interaction with another patch: the largest
  std::vector<double> distance;
  std::vector<double> pressure;
  double normal_force = 0.0;
  PressureRegion contact;  ///< all elements under pressure together
  double peak_error = 0.0; ///< of a peak from a section (peak_section.hpp), MPa

  [[nodiscard]] bool no_contact() const { return contact.element_count == 0; }
  /// Elements along the contact.
  [[nodiscard]] double columns() const {
    return static_cast<double>(contact.box.longitudinal_last - contact.box.longitudinal_first + 1);
  }
  /// Deepest overlap of the undeformed bodies along the normal at an approach from the depth
  /// sampled, by parabolas through the least distance and its neighbours.
  [[nodiscard]] double overlap(double approach) const;
};

/// Patches that share a plane.
struct PlanePatches {
  std::vector<std::size_t> patches; ///< of a solution, largest normal force first
  double normal_force = 0.0;
};

struct GridSolution {
  Elements elements = Elements::smooth;
  double depth = 0.0;               ///< at which distances were sampled
  std::vector<PatchOnGrid> patches; ///< ordered by y
  std::vector<double> links;        ///< coupling weight of each patch and the next
  double approach = 0.0;            ///< answer to the joint problem, from that depth
  double depth_found = 0.0;         ///< the depth that the solution asks for
  StopReason stop_reason = StopReason::tolerance_met;
  double pressure_error = 0.0;
  std::optional<PatchInteraction> interaction; ///< none: the patches do not interact
  std::optional<double> left_out_s;            ///< see GridPlan

  [[nodiscard]] bool no_contact() const;
  [[nodiscard]] double peak_pressure() const;
  /// Largest normal force first; without the patches that do not touch, if there are pressures.
  [[nodiscard]] std::vector<PlanePatches> patches_by_plane(bool solved) const;
  /// Largest pressure of a patch over that of the wheel.
  [[nodiscard]] double weight(const PatchOnGrid& patch) const;
};

} // namespace wrc
