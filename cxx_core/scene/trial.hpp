/// One attempt at a side: a grid, the solution on it, and what the next attempt needs of it.
///
/// Errors are estimated from two attempts on different grids: pmax, approach (or force) and the
/// load per length across the rail, q(y) = integral of p along the rail, all fall with the square
/// of the element size where the profiles are smooth, so the difference of the two grids is
/// (n_fine / n_coarse)^2 - 1 times the error of the finer one (Richardson). The load per length is
/// there because pmax of two coarse grids may agree by chance; it shows every feature that the
/// grids resolve differently across the rail.
/// Units mm, N, MPa; frame of remesh/contact_frame.hpp. Thread rule: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mechanics/normal_contact.hpp"
#include "mechanics/pressure_field.hpp"
#include "remesh/contact_frame.hpp"
#include "remesh/potential_contact_area.hpp"

namespace wrc {

/// Elements across the contact.
struct Resolution {
  double lateral = 0.0;
  double longitudinal = 0.0;
};

/// Grids of an area: steps aimed at and, if these count, the numbers of elements given by hand.
struct Mesh {
  double lateral_step = 0.0;
  double longitudinal_step = 0.0;
  std::optional<std::array<std::size_t, 2>> counts;
};

/// Elements no larger than aimed at, with an aspect ratio of a ladder, centred over the area; or
/// the numbers of elements given.
Grid mesh_grid(const PlaneArea& area, const Mesh& mesh);

/// A grid, its solution, and what the next one needs of it.
struct Trial {
  ContactFrame frame;
  PlaneArea area;
  Grid grid;
  double depth = 0.0;
  std::vector<double> distance;
  NormalSolution normal;
  std::optional<double> normal_load;
  PressureRegion contact;  ///< all elements under pressure together
  double next_depth = 0.0; ///< the depth that the solution asks for

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
  /// The area with each edge that contact touches moved out.
  [[nodiscard]] PlaneArea grown(double share) const {
    PlaneArea larger = area;
    const double width = share * area.width();
    const double length = share * area.length();
    larger.lateral_first -= contact.touches_edge.lateral_first ? width : 0.0;
    larger.lateral_last += contact.touches_edge.lateral_last ? width : 0.0;
    larger.longitudinal_first -= contact.touches_edge.longitudinal_first ? length : 0.0;
    larger.longitudinal_last += contact.touches_edge.longitudinal_last ? length : 0.0;
    return larger;
  }
  /// The area around the contact found, with some room.
  [[nodiscard]] PlaneArea contact_area(double margin) const {
    const double reach = 0.5 + margin;
    return {grid.lateral(contact.box.lateral_first) - reach * grid.lateral_step,
            grid.lateral(contact.box.lateral_last) + reach * grid.lateral_step,
            grid.longitudinal(contact.box.longitudinal_first) - reach * grid.longitudinal_step,
            grid.longitudinal(contact.box.longitudinal_last) + reach * grid.longitudinal_step};
  }
  [[nodiscard]] Resolution resolution() const { return {rows(), columns()}; }
  /// Steps that put this many elements across the contact.
  [[nodiscard]] Mesh mesh_across(const Resolution& elements) const {
    return {rows() * grid.lateral_step / elements.lateral,
            columns() * grid.longitudinal_step / elements.longitudinal,
            {}};
  }
};

/// Relative error of pmax and approach that the elements along the rail leave. The wheel is round
/// there, so it follows the law of Hertzian contact, 0.22/n^2 at most with n elements through the
/// peak; `longitudinal_resolution` is its inverse.
double longitudinal_error(const Trial& trial);
double longitudinal_resolution(double error);

/// Relative error of pmax and approach (force if the position is prescribed) on the finer grid.
double estimate_error(const Trial& coarser, const Trial& finer, bool position_is_prescribed);

} // namespace wrc
