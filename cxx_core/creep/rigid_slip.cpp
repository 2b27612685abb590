#include "creep/rigid_slip.hpp"

#include <algorithm>
#include <cmath>

namespace wrc {
namespace {

/// Along its tangent.
SlipRow continued(SlipRow row, double lateral, bool on_curve) {
  if (on_curve) {
    const double apart = lateral - row.on_grid();
    row.lateral += row.cosine * apart;
    row.height += row.sine * apart;
    row.excess = lateral - row.lateral;
    return row;
  }
  row.height += row.sine / row.cosine * (lateral - row.lateral);
  row.lateral = lateral;
  return row;
}

/// Meets the surfaces row by row, from the middle outwards.
class SlipRowSampler {
public:
  SlipRowSampler(const PosedPair& pair, const ContactFrame& frame, const SlipChoice& choice)
      : choice_(choice), frame_(frame), rail_(pair.rail, frame), wheel_(pair, frame),
        first_height_(wheel_.height()) {}

  /// Back to the plane's origin, to go the other way.
  void restart() {
    rail_.restart();
    wheel_.start_from(first_height_);
  }

  SlipRow sample(double lateral, const SlipRow& before) {
    const auto on_rail = rail_.solve(0.0, lateral);
    const auto on_wheel = wheel_.solve(0.0, lateral);
    if (!on_rail || !on_wheel) {
      return continued(before, lateral, frame_.curve != nullptr);
    }
    const double height =
        choice_.surface == SlipSurface::wheel ? *on_wheel : 0.5 * (*on_rail + *on_wheel);
    const double slope =
        choice_.variation == SlipVariation::plane_axes
            ? 0.0
            : 0.5 * (rail_.inclination(lateral) + wheel_.inclination(0.0, lateral, *on_wheel));
    const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
    if (!frame_.curve) {
      return {lateral, height, slope * cosine, cosine};
    }
    const ContactFrame::Row row = frame_.row_at(lateral);
    const Vector3 place = row.place + height * row.normal;
    const Vector3 tangent = cosine * (row.lateral + slope * row.normal);
    const double across = dot(place, frame_.lateral);
    return {across, dot(place, frame_.normal), dot(tangent, frame_.normal),
            dot(tangent, frame_.lateral), lateral - across};
  }

private:
  const SlipChoice choice_;
  const ContactFrame& frame_;
  RailRay rail_;
  WheelRay wheel_;
  const double first_height_;
};

using ByTwist = std::array<double, twist_count>;

void accumulate(ByTwist& sum, double factor, const ByTwist& part) {
  for (std::size_t i = 0; i < twist_count; ++i) {
    sum[i] += factor * part[i];
  }
}

double applied(const ByTwist& by, const Twist& twist) {
  double sum = 0.0;
  for (std::size_t i = 0; i < twist_count; ++i) {
    sum += by[i] * twist[i];
  }
  return sum;
}

/// The slip of a row by the velocities.
struct RowByTwist {
  ByTwist along, across, turning;
};

RowByTwist by_twist(const SlipRow& row, double approach) {
  const double height = row.height + approach;
  return {{1.0, 0.0, 0.0, 0.0, height, -row.lateral},
          {0.0, row.cosine, row.sine, row.lateral * row.sine - height * row.cosine, 0.0, 0.0},
          {0.0, 0.0, 0.0, 0.0, -row.sine, row.cosine}};
}

} // namespace

std::vector<SlipRow> slip_rows(const PosedPair& pair, const ContactFrame& frame, const Grid& grid,
                               std::span<const double> pressure, const SlipChoice& choice) {
  std::vector<SlipRow> rows(grid.lateral_count);
  SlipRowSampler sampler(pair, frame, choice);
  const auto is_loaded = [&](std::size_t row) {
    if (pressure.empty()) {
      return true;
    }
    const auto values = pressure.subspan(row * grid.longitudinal_count, grid.longitudinal_count);
    return std::any_of(values.begin(), values.end(), [](double p) { return p > 0.0; });
  };
  const std::size_t middle =
      nearest_to_zero(grid.lateral_first, grid.lateral_step, grid.lateral_count);
  const auto sample = [&](std::size_t row, SlipRow& before) {
    if (is_loaded(row)) {
      before = sampler.sample(grid.lateral(row), before);
    }
    rows[row] = continued(before, grid.lateral(row), frame.curve != nullptr);
  };
  SlipRow before;
  for (std::size_t row = middle; row < grid.lateral_count; ++row) {
    sample(row, before);
  }
  sampler.restart();
  before = rows[middle];
  for (std::size_t row = middle; row-- > 0;) {
    sample(row, before);
  }
  return rows;
}

SlipOfRow slip_of_row(const SlipRow& row, const Twist& twist, double approach) {
  const RowByTwist by = by_twist(row, approach);
  return {applied(by.along, twist), applied(by.across, twist), applied(by.turning, twist)};
}

std::vector<LoadedRow> loaded_rows(const std::vector<SlipRow>& rows, const Grid& grid,
                                   std::span<const double> pressure) {
  std::vector<LoadedRow> result;
  const double area = grid.element_area();
  // Within an element as well, so that a single one has moments.
  const double along = grid.longitudinal_step * grid.longitudinal_step / 12.0;
  const double across = grid.lateral_step * grid.lateral_step / 12.0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    LoadedRow loaded{rows[row]};
    const double* const values = pressure.data() + row * grid.longitudinal_count;
    for (std::size_t i = 0; i < grid.longitudinal_count; ++i) {
      const double x = grid.longitudinal(i);
      loaded.force += values[i];
      loaded.first += values[i] * x;
      loaded.second += values[i] * x * x;
    }
    if (loaded.force > 0.0) {
      loaded.force *= area;
      loaded.first *= area;
      loaded.second = area * loaded.second + along * loaded.force;
      loaded.across = across * loaded.force;
      result.push_back(loaded);
    }
  }
  return result;
}

LoadedRow moved_row(LoadedRow row, double longitudinal, double lateral, double height,
                    double on_grid) {
  row.second += longitudinal * (2.0 * row.first + longitudinal * row.force);
  row.first += longitudinal * row.force;
  row.lateral += lateral;
  row.height += height;
  row.excess += on_grid - lateral;
  return row;
}

SlipGeometry slip_geometry(std::vector<LoadedRow> rows, double approach) {
  SlipGeometry geometry{std::move(rows), approach};
  double force = 0.0;
  double x = 0.0;
  double y = 0.0;
  double squares = 0.0;
  ByTwist along{};
  ByTwist across{};
  ByTwist moment{};
  for (const LoadedRow& row : geometry.rows) {
    const RowByTwist by = by_twist(row, approach);
    force += row.force;
    x += row.first;
    y += row.force * row.on_grid();
    squares += row.second + row.force * row.on_grid() * row.on_grid() + row.across;
    accumulate(along, row.force, by.along);
    accumulate(across, row.force, by.across);
    accumulate(across, row.first, by.turning);
    accumulate(moment, -row.force * row.on_grid(), by.along);
    accumulate(moment, row.first, by.across);
    accumulate(moment, row.second + row.across, by.turning);
  }
  if (!(force > 0.0)) {
    return geometry;
  }
  x /= force;
  y /= force;
  auto& [longitudinal, lateral, spin] = geometry.creepages_by_twist;
  accumulate(moment, y, along);
  accumulate(moment, -x, across);
  accumulate(spin, 1.0 / (squares - force * (x * x + y * y)), moment);
  accumulate(longitudinal, 1.0 / force, along);
  accumulate(longitudinal, y, spin);
  accumulate(lateral, 1.0 / force, across);
  accumulate(lateral, -x, spin);
  return geometry;
}

Creepages fitted_creepages(const SlipGeometry& geometry, const Twist& twist) {
  const CreepagesByTwist& by = geometry.creepages_by_twist;
  return {applied(by[0], twist), applied(by[1], twist), applied(by[2], twist)};
}

double slip_variation(const SlipGeometry& geometry, const Twist& twist,
                      const Creepages& creepages) {
  double squares = 0.0;
  double force = 0.0;
  for (const LoadedRow& row : geometry.rows) {
    const SlipOfRow slip = slip_of_row(row, twist, geometry.approach);
    const double along = slip.along - creepages.longitudinal + creepages.spin * row.on_grid();
    const double across = slip.across - creepages.lateral;
    const double turning = slip.turning - creepages.spin;
    squares += row.force * (along * along + across * across) +
               turning * (2.0 * row.first * across + (row.second + row.across) * turning);
    force += row.force;
  }
  return force > 0.0 ? std::sqrt(std::max(squares, 0.0) / force) : 0.0;
}

SlipField slip_beyond(const SlipGeometry& geometry, const std::vector<SlipRow>& rows,
                      const Grid& grid, const Twist& twist) {
  const Creepages creepages = fitted_creepages(geometry, twist);
  const double approach = geometry.approach;
  SlipField field;
  field.x.reserve(grid.element_count());
  field.y.reserve(grid.element_count());
  for (const SlipRow& row : rows) {
    const SlipOfRow slip = slip_of_row(row, twist, approach);
    const double along = slip.along - creepages.longitudinal + creepages.spin * row.on_grid();
    const double across = slip.across - creepages.lateral;
    const double turning = slip.turning - creepages.spin;
    for (std::size_t i = 0; i < grid.longitudinal_count; ++i) {
      field.x.push_back(along);
      field.y.push_back(across + turning * grid.longitudinal(i));
    }
  }
  return field;
}

Wrench wrench_of(const CreepagesByTwist& by, const std::array<double, 3>& forces) {
  Wrench wrench{};
  for (std::size_t i = 0; i < forces.size(); ++i) {
    accumulate(wrench, forces[i], by[i]);
  }
  return wrench;
}

Wrench wrench_beyond(const SlipGeometry& geometry, const std::vector<SlipRow>& rows,
                     const Grid& grid, std::span<const double> traction_x,
                     std::span<const double> traction_y) {
  Wrench wrench{};
  std::array<double, 3> sums{};
  std::size_t at = 0;
  for (const SlipRow& row : rows) {
    const RowByTwist by = by_twist(row, geometry.approach);
    double along = 0.0;
    double across = 0.0;
    double moment = 0.0;
    for (std::size_t i = 0; i < grid.longitudinal_count; ++i, ++at) {
      along += traction_x[at];
      across += traction_y[at];
      moment += grid.longitudinal(i) * traction_y[at];
    }
    accumulate(wrench, along, by.along);
    accumulate(wrench, across, by.across);
    accumulate(wrench, moment, by.turning);
    sums[0] += along;
    sums[1] += across;
    sums[2] += moment - row.on_grid() * along;
  }
  accumulate(wrench, -1.0, wrench_of(geometry.creepages_by_twist, sums));
  for (double& component : wrench) {
    component *= grid.element_area();
  }
  return wrench;
}

} // namespace wrc
