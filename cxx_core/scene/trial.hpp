/// One attempt at a side: grids for its patches, the solution on them, and what the next attempt
/// needs of it.
///
/// Errors are estimated from two attempts on different grids: pmax, approach (or force) and the
/// load per length across the rail, q(y) = integral of p along the rail, all fall with a power k
/// of the element size where the profiles are smooth, so the difference of the two grids is
/// (n_fine / n_coarse)^k - 1 times the error of the finer one (Richardson); k = 2 for constant
/// elements, 3 for smooth ones as long as the edge of contact does not rule. The load per length is
/// there because pmax of two coarse grids may agree by chance; it shows every feature that the
/// grids resolve differently across the rail. A patch counts by its pmax against that of the wheel.
/// Units mm, N, MPa; frame of remesh/contact_frame.hpp. Thread rule: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mechanics/joint_contact.hpp"
#include "mechanics/normal_contact.hpp"
#include "mechanics/pressure_field.hpp"
#include "remesh/contact_frame.hpp"
#include "remesh/contact_patches.hpp"
#include "remesh/plane_area.hpp"

namespace wrc {

/// Elements across the contact.
struct Resolution {
  double lateral = 0.0;
  double longitudinal = 0.0;

  [[nodiscard]] Resolution times(double factor) const {
    return {factor * lateral, factor * longitudinal};
  }
};

/// Grids of an area: steps aimed at and, if these count, the numbers of elements given by hand.
struct Mesh {
  double lateral_step = 0.0;
  double longitudinal_step = 0.0;
  std::optional<std::array<std::size_t, 2>> counts;
};

/// Elements no larger than aimed at, with an aspect ratio of a ladder, centred over the area; or
/// the numbers of elements given. Where the area ends at a boundary the grid ends there, too.
Grid mesh_grid(const PlaneArea& area, const Mesh& mesh, const BoundaryEdges& edges = {});

/// Where a patch is looked for, and on what grid.
struct PatchPlan {
  ContactPatch place;
  ContactFrame frame;
  PlaneArea area;
  Mesh mesh;
};

/// A patch's grid, its part of the solution, and what the next one needs of it.
struct PatchTrial {
  ContactPatch place;
  ContactFrame frame;
  PlaneArea area;
  Grid grid;
  double share = 1.0;     ///< of the approach, along the patch's normal
  double closeness = 0.0; ///< of the interaction with another patch: the largest
  std::vector<double> distance;
  std::vector<double> pressure;
  double normal_force = 0.0;
  PressureRegion contact; ///< all elements under pressure together

  [[nodiscard]] bool no_contact() const { return contact.element_count == 0; }
  [[nodiscard]] bool touches_edge() const { return contact.touches_edge.any(); }
  /// Elements across the contact.
  [[nodiscard]] double rows() const {
    return static_cast<double>(contact.box.lateral_last - contact.box.lateral_first + 1);
  }
  /// Elements along the contact.
  [[nodiscard]] double columns() const {
    return static_cast<double>(contact.box.longitudinal_last - contact.box.longitudinal_first + 1);
  }
  [[nodiscard]] Resolution resolution() const { return {rows(), columns()}; }
  /// Length of the contact over its width.
  [[nodiscard]] double slenderness() const {
    return columns() * grid.longitudinal_step / (rows() * grid.lateral_step);
  }
  /// The area with each edge that contact touches moved out, across and along the rail where there
  /// are at least so many elements in contact.
  [[nodiscard]] PlaneArea grown(double share, double least_elements) const;
  /// The area around the contact found, with some room in elements.
  [[nodiscard]] PlaneArea contact_area(double margin) const;
  /// Deepest overlap of the undeformed bodies along the normal at an approach from the trial's
  /// depth, by parabolas through the least distance and its neighbours.
  [[nodiscard]] double overlap(double approach) const;
  /// Steps that put this many elements across the contact.
  [[nodiscard]] Mesh mesh_across(const Resolution& elements) const {
    return {rows() * grid.lateral_step / elements.lateral,
            columns() * grid.longitudinal_step / elements.longitudinal,
            {}};
  }
};

/// All patches of a wheel, ordered by y, solved together.
struct Trial {
  Elements elements = Elements::smooth;
  double depth = 0.0; ///< at which distances were sampled
  std::vector<PatchTrial> patches;
  std::vector<double> links; ///< closeness of each patch and the next
  double approach = 0.0;     ///< answer to the joint problem, from that depth
  double next_depth = 0.0;   ///< the depth that the solution asks for
  StopReason stop_reason = StopReason::tolerance_met;
  double pressure_error = 0.0;
  std::optional<PatchInteraction> interaction; ///< none: the patches do not feel each other
  std::optional<double> left_out_s;            ///< as in the plan

  [[nodiscard]] bool no_contact() const;
  [[nodiscard]] bool touches_edge() const;
  /// Patches that feel each other by their closeness.
  [[nodiscard]] bool has_close_patches() const;
  /// Planes that other patches have turned.
  [[nodiscard]] bool has_turned_planes() const;
  [[nodiscard]] double peak_pressure() const;
  [[nodiscard]] double normal_force() const;
  /// The patch in contact that holds the deepest place of another one; none if there is none.
  [[nodiscard]] const PatchTrial* matching(const ContactPatch& place) const;
  /// What the error of a patch's pmax counts, against the wheel's.
  [[nodiscard]] double weight(const PatchTrial& patch) const;
};

/// Relative error of pmax and approach that the elements along the rail leave. The wheel is round
/// there, so it follows the law of Hertzian contact: 1/n^2 with n elements through the peak, and
/// more where the contact is slender, that is longer than wide; `longitudinal_resolution`, the
/// elements for an error and a slenderness, is its inverse. A crest that runs across the rail's
/// direction aslant counts as a peak of few elements (narrow_error).
double longitudinal_error(const Trial& trial);
double longitudinal_resolution(double error, double slenderness, Elements elements);

/// Relative error of pmax that the rows across the rail leave at peaks only a few rows wide, such
/// as a lobe that has just begun beside a wide one: two grids that both miss it agree by chance. By
/// the same law for an axis as long as the other one, with the width of n rows that the second
/// difference at the top tells, times a roughness of 1 + (5/n)^2, since peaks of few rows are no
/// semi-ellipses; a lower peak counts with four times as much, as far as that lifts it above the
/// highest one.
double narrow_error(const Trial& trial);

/// Relative error of pmax and approach (force if the position is prescribed) on the finer grid.
double estimate_error(const Trial& coarser, const Trial& finer, bool position_is_prescribed);

} // namespace wrc
