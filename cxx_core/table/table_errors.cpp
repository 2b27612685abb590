// Errors of a table: of random states in the cells of its map, and of others that are held out.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "results/wheel_state.hpp"
#include "table/constants.hpp"
#include "table/table_work.hpp"

namespace wrc {
namespace {

/// What a state says: its cell; the error of the force, over what friction makes of it; that of
/// derivatives, or less than 0; those of the outputs, or less than 0.
constexpr std::size_t sample_count = 3 + output_count; // not a tuning constant
using Sample = std::array<double, sample_count>;

struct SampleCounts {
  ErrorMap::Counts cells;
  std::size_t states_of_cell, held_out;
};

SampleCounts sample_counts_of(const TableOptions& options) {
  const auto at_least = [](double least, double count) {
    return static_cast<std::size_t>(std::lround(std::max(least, count)));
  };
  return {{at_least(2.0, cells_per_length * 2.0 * options.ranges.lateral), 4},
          at_least(10.0, 30.0 * options.fineness),
          at_least(500.0, 10000.0 * options.fineness)};
}

/// Nor a NaN.
double finite(double error) {
  return error < error_without_answer ? error : error_without_answer;
}

double error_of_force(const ContactTable& table, const TableContact& found, const Vector3& exact) {
  const Vector3 force{found.force[0], found.force[1], found.force[2]};
  return finite(norm(force - exact) / std::max(exact.z, least_load_share * table.ranges.load));
}

/// The largest of the columns, each over itself or, where the wheel slides, over what it is where
/// all sticks.
double error_of_derivatives(const ContactTable& table, TableState state, const TableContact& found,
                            const ForceJacobian& exact) {
  state.friction = sticking_friction;
  const TableContact sticking = contact_in_table(table, state, true);
  double largest = 0.0;
  for (const std::size_t column : {0U, 1U, 2U, 3U, 4U, 5U, 8U, 9U}) {
    std::array<double, 3> squares{};
    for (std::size_t row = 0; row < 3; ++row) {
      const double rate = exact[row][column];
      squares[0] += std::pow(found.rates[row][column] - rate, 2);
      squares[1] += rate * rate;
      squares[2] += std::pow(sticking.rates[row][column], 2);
    }
    largest = std::max(largest, std::sqrt(squares[0] / std::max(squares[1], squares[2])));
  }
  return finite(largest);
}

Sample sample_of(const ContactTable& table, const TableState& state, bool derivatives,
                 TableNodes& nodes) {
  Sample sample;
  sample.fill(-1.0);
  const TableContact found = contact_in_table(table, state, derivatives);
  SceneWheel& wheel = nodes.solve_exactly(state, derivatives, table_creep_accuracy);
  sample[0] = static_cast<double>(table.errors.cell_of({found.lateral, found.depth}));
  sample[1] = error_of_force(table, found, force_of(wheel)) / error_by_friction(state.friction);
  if (found.lifted || wheel.patches.empty()) {
    return sample;
  }
  if (const ForceJacobian* jacobian = derivatives ? wheel.jacobian() : nullptr) {
    sample[2] = error_of_derivatives(table, state, found, *jacobian);
  }
  int flags = 0;
  const WheelOutputs outputs = outputs_in_table(table, found, flags);
  const WheelOutputs exact = outputs_of(wheel);
  for (std::size_t i = 0; i < output_count; ++i) {
    sample[3 + i] = finite(std::abs(outputs[i] - exact[i]) / output_scale(found, exact, i));
  }
  return sample;
}

/// The number that at most this fraction of them exceeds; 0 of none.
double quantile(std::vector<double>& numbers, double share) {
  if (numbers.empty()) {
    return 0.0;
  }
  std::sort(numbers.begin(), numbers.end());
  const auto beyond = static_cast<std::size_t>(share * static_cast<double>(numbers.size()));
  return numbers[numbers.size() - 1 - beyond];
}

void make_map(TableWork& work, const SampleCounts& counts, const Progress& progress) {
  ErrorMap& map = work.table.errors;
  const TableRanges& ranges = work.options.ranges;
  map = ErrorMap({{{-ranges.lateral, ranges.lateral}, {0.0, largest_depth}}}, counts.cells);
  const std::size_t cells = map.cell_count();
  const std::size_t states = counts.states_of_cell * cells;
  std::vector<double> numbers(states * sample_count);
  work.run_stage(Stage::map, states, numbers, progress, [&] {
    return [&, own = work.nodes()](std::size_t i, double* to) mutable {
      const bool derivatives = i / cells % 4 == 0;
      const TableState state = random_state(work.table, i % cells, i / cells);
      const Sample sample = sample_of(work.table, state, derivatives, *own);
      std::copy(sample.begin(), sample.end(), to);
    };
  });
  // A vertex has the states of all cells around it.
  constexpr std::size_t kinds = sample_count - 1;
  std::vector<std::array<std::vector<double>, kinds>> around(map.vertices().size());
  for (std::size_t i = 0; i < states; ++i) {
    const double* const sample = numbers.data() + i * sample_count;
    for (const std::size_t vertex : map.vertices_of(static_cast<std::size_t>(sample[0]))) {
      for (std::size_t kind = 0; kind < kinds; ++kind) {
        if (const double error = sample[1 + kind]; error >= 0.0) {
          around[vertex][kind].push_back(error);
        }
      }
    }
  }
  std::vector<double> of_derivatives;
  for (std::size_t vertex = 0; vertex < around.size(); ++vertex) {
    ErrorMap::Errors& errors = map.vertices()[vertex];
    errors[bound_of_force] = quantile(around[vertex][0], 0.0);
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      errors[likely_of_force + kind] = quantile(around[vertex][kind], likely_share);
    }
    of_derivatives.push_back(errors[likely_of_derivatives]);
  }
  work.table.measured.map_states = states;
  work.table.measured.derivatives_median = quantile(of_derivatives, 0.5);
}

/// Error of the force of each held-out state, and the table's two that come with it.
std::vector<std::array<double, 3>> held_out(TableWork& work, Stage stage, std::size_t count,
                                            const Progress& progress) {
  const std::size_t cells = work.table.errors.cell_count();
  // Numbers of states that no sample shares.
  const std::uint64_t first = 1ULL << (stage == Stage::factor ? 32U : 33U);
  std::vector<double> numbers(count);
  std::vector<std::array<double, 3>> found(count);
  work.run_stage(stage, count, numbers, progress, [&] {
    return [&, own = work.nodes()](std::size_t i, double* to) mutable {
      const TableState state = random_state(work.table, i % cells, first + i / cells);
      const TableContact contact = contact_in_table(work.table, state, false);
      const SceneWheel& wheel = own->solve_exactly(state, false, table_creep_accuracy);
      *to = error_of_force(work.table, contact, force_of(wheel));
    };
  });
  for (std::size_t i = 0; i < count; ++i) {
    const TableState state = random_state(work.table, i % cells, first + i / cells);
    const TableContact contact = contact_in_table(work.table, state, false);
    found[i] = {numbers[i], contact.errors[bound_of_force], contact.errors[likely_of_force]};
  }
  return found;
}

} // namespace

void measure_table(TableWork& work, const Progress& progress) {
  const auto part = [&progress](double from, double to) -> Progress {
    return progress ? Progress([&progress, from, to](double share) {
      progress(from + share * (to - from));
    })
                    : Progress();
  };
  const SampleCounts counts = sample_counts_of(work.options);
  make_map(work, counts, part(0.0, 0.7));
  TableErrors& measured = work.table.measured;
  std::array<std::vector<double>, 2> ratios;
  for (const auto& [error, bound, likely] :
       held_out(work, Stage::factor, counts.held_out, part(0.7, 0.85))) {
    ratios[0].push_back(error / std::max(bound, std::numeric_limits<double>::min()));
    ratios[1].push_back(error / std::max(likely, std::numeric_limits<double>::min()));
  }
  measured.factor = std::max(1.0, quantile(ratios[0], calibrated_share));
  measured.likely_factor = quantile(ratios[1], calibrated_likely_share);
  for (ErrorMap::Errors& vertex : work.table.errors.vertices()) {
    vertex[bound_of_force] *= measured.factor;
    vertex[likely_of_force] *= measured.likely_factor;
  }
  std::vector<double> errors;
  measured.states = counts.held_out;
  for (const auto& [error, bound, likely] :
       held_out(work, Stage::check, counts.held_out, part(0.85, 1.0))) {
    measured.beyond += error > bound ? 1 : 0;
    measured.beyond_likely += error > likely ? 1 : 0;
    errors.push_back(error);
  }
  measured.percentile_99 = quantile(errors, 0.01);
  measured.median = quantile(errors, 0.5);
  measured.worst = errors.back();
}

TableState random_state(const ContactTable& table, std::size_t cell, std::uint64_t number) {
  RandomNumbers random(number * table.errors.cell_count() + cell + 1);
  const ErrorMap::Ranges ranges = table.errors.ranges_of(cell);
  const double u = random.between(ranges[0].first, ranges[0].last);
  const double s = random.between(ranges[1].first, ranges[1].last);
  // Sums of two numbers: small angles are more frequent, as on vehicles.
  const double roll = table.ranges.roll * (random.next() + random.next() - 1.0);
  const double yaw = table.ranges.yaw * (random.next() + random.next() - 1.0);
  TensorSpline<3, 2>::Values touch;
  table.touch.evaluate({u, roll, yaw * yaw}, touch);
  const TablePose pose = pose_of_taping_point(table, from_aligned(table, u, roll, yaw),
                                              touch.value[0] - s * std::exp(touch.value[1]), roll);
  TableState state;
  state.position = {0.0, pose.lateral, pose.vertical, roll, 0.0, yaw};
  state.friction = random.between(least_drawn_friction, largest_drawn_friction);

  TensorSpline<4, table_part_count, float>::Values found;
  table.contact.evaluate({u, roll, yaw * yaw, s}, found);
  const auto part = [&found](TablePart which) {
    return found.value[static_cast<std::size_t>(which)];
  };
  // Linear forces over friction from 0.05 to 10, in all directions.
  const double direction = random.between(0.0, 2.0 * std::numbers::pi);
  const double ratio = 0.05 * std::pow(200.0, random.next());
  const double p = std::max(part(TablePart::load), 0.0);
  const double bound = state.friction * part(TablePart::normal) * std::sqrt(p); // over p
  const double xi = ratio * std::cos(direction) * bound / part(TablePart::longitudinal_law);
  const double eta = ratio * std::sin(direction) * bound / part(TablePart::lateral_law);
  const double speed = drawn_speed;
  const Vector3 axle{-std::sin(yaw) * std::cos(roll), std::cos(yaw) * std::cos(roll),
                     std::sin(roll)};
  const Vector3 arm{part(TablePart::arm_x) * yaw, part(TablePart::arm_y), part(TablePart::arm_z)};
  const Vector3 by_pitch = cross(axle, arm);
  const double pitch = (xi - 1.0) * speed / by_pitch.x;
  const double angle = part(TablePart::angle);
  const double turned = pitch * (by_pitch.y * std::cos(angle) + by_pitch.z * std::sin(angle));
  state.velocity = {speed, (eta * speed - turned) / std::cos(angle), 0.0, 0.0, pitch, 0.0};
  return state;
}

} // namespace wrc
