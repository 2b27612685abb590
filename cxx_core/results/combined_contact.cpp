#include "results/combined_contact.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "accuracy/model_error.hpp"
#include "half_space/displacement_operator.hpp"
#include "mechanics/yielding.hpp"
#include "remesh/row_scales.hpp"
#include "remesh/undeformed_distance.hpp"
#include "results/constants.hpp"

namespace wrc {
namespace {

using Values = std::vector<double>;

/// One direction of a grid.
struct Cells {
  double begin = 0.0; ///< of the first cell
  double step = 1.0;
  std::size_t count = 0;

  [[nodiscard]] double end() const { return begin + step * static_cast<double>(count); }
};

Cells rows_of(const Grid& grid, double shift) {
  return {grid.lateral_first - 0.5 * grid.lateral_step + shift, grid.lateral_step,
          grid.lateral_count};
}

Cells columns_of(const Grid& grid, double shift) {
  return {grid.longitudinal_first - 0.5 * grid.longitudinal_step + shift, grid.longitudinal_step,
          grid.longitudinal_count};
}

/// Cells of a size from a cell's begin to both sides, until they cover a stretch.
Cells covering(double at, double step, double first, double last) {
  constexpr double rounding = 1e-9; // of a cell
  const double before = std::max(0.0, std::ceil((at - first) / step - rounding));
  const double after = std::max(1.0, std::ceil((last - at) / step - rounding));
  return {at - before * step, step, static_cast<std::size_t>(before + after)};
}

Grid grid_of(const Cells& rows, const Cells& columns) {
  return {rows.count,
          columns.count,
          rows.step,
          columns.step,
          rows.begin + 0.5 * rows.step,
          columns.begin + 0.5 * columns.step};
}

/// Cells of one direction that a cell of another overlaps, with the fractions of their widths.
struct Overlap {
  std::size_t first = 0;
  Values shares;
};

std::vector<Overlap> overlaps(const Cells& from, const Cells& to) {
  std::vector<Overlap> all;
  const auto last_cell = static_cast<double>(to.count - 1);
  for (std::size_t i = 0; i < from.count; ++i) {
    const double begin = (from.begin + from.step * static_cast<double>(i) - to.begin) / to.step;
    const double end = begin + from.step / to.step;
    // Rounding may leave a sliver of the outermost cells outside.
    const double first = std::clamp(std::floor(begin), 0.0, last_cell);
    const double last = std::clamp(std::ceil(end) - 1.0, first, last_cell);
    Overlap& overlap = all.emplace_back();
    overlap.first = static_cast<std::size_t>(first);
    for (std::size_t cell = overlap.first; cell <= static_cast<std::size_t>(last); ++cell) {
      const auto at = static_cast<double>(cell);
      overlap.shares.push_back(std::max(0.0, std::min(end, at + 1.0) - std::max(begin, at)));
    }
  }
  return all;
}

/// Where a part's frame lies in that of the whole.
struct Shift {
  double lateral = 0.0;
  double longitudinal = 0.0;
};

Shift shift_of(const ContactFrame& part, const ContactFrame& whole) {
  const Vector3 from_origin = part.origin - whole.origin;
  return {whole.lateral_of(from_origin), dot(from_origin, whole.longitudinal)};
}

/// The pressures of a part as means over the elements of the whole.
Values averaged(const PatchResult& part, const PatchResult& whole) {
  const Shift shift = shift_of(part.frame, whole.frame);
  const std::vector<Overlap> rows =
      overlaps(rows_of(part.grid, shift.lateral), rows_of(whole.grid, 0.0));
  const std::vector<Overlap> columns =
      overlaps(columns_of(part.grid, shift.longitudinal), columns_of(whole.grid, 0.0));
  Values values(whole.grid.element_count(), 0.0);
  const double* pressure = part.pressure.data();
  for (const Overlap& row : rows) {
    for (const Overlap& column : columns) {
      const double here = *pressure++;
      for (std::size_t i = 0; here > 0.0 && i < row.shares.size(); ++i) {
        double* line = values.data() + (row.first + i) * whole.grid.longitudinal_count;
        for (std::size_t j = 0; j < column.shares.size(); ++j) {
          line[column.first + j] += here * row.shares[i] * column.shares[j];
        }
      }
    }
  }
  return values;
}

/// Something of the rows of parts on those of the whole, the largest of all parts; empty if no part
/// has any.
template <class OfRows> Values of_rows(const PatchResult& whole, const OfRows& rows_of_part) {
  Values values;
  for (const PatchResult& part : whole.parts) {
    const Values rows = rows_of_part(part);
    const double shift = shift_of(part.frame, whole.frame).lateral + part.grid.lateral_first;
    for (std::size_t row = 0; !rows.empty() && row < whole.grid.lateral_count; ++row) {
      values.resize(whole.grid.lateral_count, 0.0);
      const double nearest = std::round((whole.grid.lateral(row) - shift) / part.grid.lateral_step);
      if (nearest >= 0.0 && nearest < static_cast<double>(rows.size())) {
        values[row] = std::max(values[row], rows[static_cast<std::size_t>(nearest)]);
      }
    }
  }
  return values;
}

/// All pressures together, by their moments.
PressureRegion combined_region(std::span<const Patch> parts, std::span<const Shift> shifts) {
  constexpr double square_share = 0.2; // <x^2> = a^2 / 5 (pressure/pressure_field.hpp)
  PressureRegion all;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const PressureRegion& part = parts[k].contact;
    all.peak_pressure = std::max(all.peak_pressure, part.peak_pressure);
    all.largest_element_pressure =
        std::max(all.largest_element_pressure, part.largest_element_pressure);
    all.normal_force += part.normal_force;
    all.centroid_longitudinal +=
        part.normal_force * (part.centroid_longitudinal + shifts[k].longitudinal);
    all.centroid_lateral += part.normal_force * (part.centroid_lateral + shifts[k].lateral);
  }
  if (!(all.normal_force > 0.0)) {
    return all;
  }
  all.centroid_longitudinal /= all.normal_force;
  all.centroid_lateral /= all.normal_force;
  double longitudinal_square = 0.0;
  double lateral_square = 0.0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const PressureRegion& part = parts[k].contact;
    const double weight = part.normal_force / all.normal_force;
    const double along =
        part.centroid_longitudinal + shifts[k].longitudinal - all.centroid_longitudinal;
    const double across = part.centroid_lateral + shifts[k].lateral - all.centroid_lateral;
    longitudinal_square +=
        weight *
        (square_share * part.semi_axis_longitudinal * part.semi_axis_longitudinal + along * along);
    lateral_square +=
        weight * (square_share * part.semi_axis_lateral * part.semi_axis_lateral + across * across);
  }
  all.semi_axis_longitudinal = std::sqrt(longitudinal_square / square_share);
  all.semi_axis_lateral = std::sqrt(lateral_square / square_share);
  return all;
}

/// One grid over the grids of all parts.
Grid combined_grid(std::span<const Patch> parts, std::span<const Shift> shifts) {
  const auto peak = static_cast<std::size_t>(
      std::max_element(parts.begin(), parts.end(),
                       [](const Patch& one, const Patch& other) {
                         return one.contact.peak_pressure < other.contact.peak_pressure;
                       }) -
      parts.begin());
  const Cells rows = rows_of(parts[peak].grid, shifts[peak].lateral);
  const Cells columns = columns_of(parts[peak].grid, shifts[peak].longitudinal);
  double first_row = rows.begin;
  double last_row = rows.end();
  double first_column = columns.begin;
  double last_column = columns.end();
  std::size_t elements = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Cells part_rows = rows_of(parts[k].grid, shifts[k].lateral);
    const Cells part_columns = columns_of(parts[k].grid, shifts[k].longitudinal);
    first_row = std::min(first_row, part_rows.begin);
    last_row = std::max(last_row, part_rows.end());
    first_column = std::min(first_column, part_columns.begin);
    last_column = std::max(last_column, part_columns.end());
    elements += parts[k].grid.element_count();
  }
  const double least_area = (last_row - first_row) * (last_column - first_column) /
                            static_cast<double>(max_elements_ratio * elements);
  const double larger = std::max(1.0, std::sqrt(least_area / (rows.step * columns.step)));
  return grid_of(covering(rows.begin, larger * rows.step, first_row, last_row),
                 covering(columns.begin, larger * columns.step, first_column, last_column));
}

} // namespace

Patch combined(std::span<const Patch> parts, const RailSurface& rail) {
  Patch whole;
  double weight = 0.0;
  Vector3 mean;
  for (const Patch& part : parts) {
    weight += part.penetration.weight;
    mean = mean +
           part.penetration.weight * Vector3{part.penetration.mean_x, part.penetration.mean_y, 0.0};
    whole.normal_force += part.normal_force;
    whole.turn = combined_turn(whole.turn, part.turn);
    whole.plane_error = std::max(whole.plane_error, part.plane_error);
    whole.contact_force.force = whole.contact_force.force + part.contact_force.force;
    whole.approach = std::max(whole.approach, part.approach);
    if (part.elastic_peak) {
      whole.elastic_peak = std::max(whole.elastic_peak.value_or(0.0), *part.elastic_peak);
    }
  }
  mean = (1.0 / weight) * mean;
  whole.frame = parts.front().frame.seen_from({mean.x, mean.y, height_near(rail, mean.x, mean.y)});
  for (const Patch& part : parts) {
    const Vector3 arm = part.frame.origin - whole.frame.origin;
    whole.contact_force.moment = whole.contact_force.moment + part.contact_force.moment +
                                 cross(arm, part.contact_force.force);
  }
  std::vector<Shift> shifts;
  for (const Patch& part : parts) {
    shifts.push_back(shift_of(part.frame, whole.frame));
  }
  whole.contact = combined_region(parts, shifts);
  whole.grid = combined_grid(parts, shifts);
  return whole;
}

std::vector<double> combined_pressure(const PatchResult& whole) {
  Values values(whole.grid.element_count(), 0.0);
  for (const PatchResult& part : whole.parts) {
    const Values of_part = averaged(part, whole);
    std::transform(values.begin(), values.end(), of_part.begin(), values.begin(), std::plus<>());
  }
  return values;
}

std::vector<double> displacement_of(const PatchResult& patch, const WheelDetails& side) {
  const std::vector<double> pressure = over_scales(patch.grid, patch.row_scales, patch.pressure);
  std::vector<double> values(pressure.size());
  DisplacementOperator displace(patch.grid, side.request.combined_modulus, side.request.elements,
                                row_angles(patch.frame, patch.grid));
  displace.apply(pressure, values);
  const YieldTerms terms(patch.grid, pressure, patch.row_scales, yielding_of(patch, side),
                         patch.groove.carried);
  for (std::size_t b = 0; b < terms.excess.size(); ++b) {
    std::vector<double> by_excess(pressure.size());
    displace.apply(terms.excess[b], by_excess);
    terms.add_indentation(b, by_excess, values);
  }
  return over_scales(patch.grid, patch.row_scales, values);
}

std::vector<double> scales_of_elements(const PatchResult& patch) {
  return times_scales(patch.grid, patch.row_scales,
                      std::vector<double>(patch.grid.element_count(), 1.0));
}

std::vector<double> combined_distance(const PatchResult& whole, const WheelDetails& side) {
  Values distance = sample_undeformed_distance(side.pair(), whole.frame, whole.grid);
  const Values groove = of_rows(whole, [](const PatchResult& part) { return part.groove.found; });
  for (std::size_t i = 0; !groove.empty() && i < distance.size(); ++i) {
    distance[i] += groove[i / whole.grid.longitudinal_count];
  }
  return distance;
}

std::vector<double> combined_displacement(const PatchResult& whole, const WheelDetails& side) {
  const Grid& grid = whole.grid;
  DisplacementOperator displace(grid, side.request.combined_modulus, side.request.elements,
                                row_angles(whole.frame, grid));
  std::vector<Values> by_part;
  std::vector<Cells> rows;
  const std::span<const YieldingBody> bodies = yielding_of(whole, side);
  const Values carried =
      of_rows(whole, [](const PatchResult& part) { return part.groove.carried; });
  const YieldTerms terms(grid, bodies.empty() ? Values() : combined_pressure(whole), {}, bodies,
                         carried);
  for (const PatchResult& part : whole.parts) {
    const Values pressure = averaged(part, whole);
    displace.apply(pressure, by_part.emplace_back(grid.element_count()));
    const YieldTerms of_part(grid, pressure, {}, bodies, carried);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      Values by_excess(grid.element_count());
      displace.apply(of_part.excess[b], by_excess);
      terms.add_indentation(b, by_excess, by_part.back());
    }
    rows.push_back(rows_of(part.grid, shift_of(part.frame, whole.frame).lateral));
  }
  Values values;
  values.reserve(grid.element_count());
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const double place = grid.lateral(row);
    const auto apart = [place](const Cells& cells) {
      return std::max(cells.begin - place, place - cells.end());
    };
    const auto nearest =
        static_cast<std::size_t>(std::min_element(rows.begin(), rows.end(),
                                                  [&apart](const Cells& one, const Cells& other) {
                                                    return apart(one) < apart(other);
                                                  }) -
                                 rows.begin());
    for (std::size_t i = row * grid.longitudinal_count; i < (row + 1) * grid.longitudinal_count;
         ++i) {
      double displacement = 0.0;
      for (std::size_t k = 0; k < whole.parts.size(); ++k) {
        // The weight is that of the weakest link between.
        const double weight = k == nearest ? 1.0
                                           : std::min(whole.parts[k].coupling_weight,
                                                      whole.parts[nearest].coupling_weight);
        displacement += weight * by_part[k][i];
      }
      values.push_back(displacement);
    }
  }
  return values;
}

} // namespace wrc
