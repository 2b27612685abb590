#include "table/table_equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "scene/constants.hpp"
#include "table/constants.hpp"

namespace wrc {
namespace {

using Two = std::array<double, 2>;
using Wheels = std::array<TableContact, 2>;

class TableBalance {
public:
  TableBalance(const ContactTable& table, const VehicleState& state, const StaticLoads& loads,
               const Two& requested)
      : table_(table), state_(state), of_(loads.of), requested_(requested) {
    state_.derivatives = true;
  }

  /// At a height and a roll, numbers inside.
  Wheels wheels(const Two& place) {
    state_.position[2] = to_caller(place[0], table_.convention, dimensions::turning_length);
    state_.position[3] = to_caller(place[1], table_.convention, dimensions::angle);
    return contacts_in_table(table_, state_, table_.convention);
  }

  /// Depths of these loads, from a place that may be far.
  Two place_at_depths(Two place, const Two& each) {
    Two target{};
    for (std::size_t i = 0; i < 2; ++i) {
      target[i] = std::pow(each[i] / table_.ranges.load, 2.0 / 3.0);
    }
    constexpr Two step{depth_step, roll_step};
    for (int i = 0; i < most_table_iterations; ++i) {
      const Wheels at = wheels(place);
      const Wheels higher = wheels({place[0] + step[0], place[1]});
      const Wheels turned = wheels({place[0], place[1] + step[1]});
      std::array<Two, 2> slope{};
      Two missing{};
      for (std::size_t wheel = 0; wheel < 2; ++wheel) {
        missing[wheel] = target[wheel] - at[wheel].depth;
        slope[wheel] = {(higher[wheel].depth - at[wheel].depth) / step[0],
                        (turned[wheel].depth - at[wheel].depth) / step[1]};
      }
      const Two change = newton_change(slope, missing);
      const double whole = std::max({1.0, std::abs(change[0]) / largest_height_change,
                                     std::abs(change[1]) / largest_roll_change});
      place = {place[0] + change[0] / whole, place[1] + change[1] / whole};
      if (std::hypot(missing[0], missing[1]) < depth_met) {
        break;
      }
    }
    return place;
  }

  /// What is missing of the loads, and the change of the place that lessens it.
  struct Step {
    double missing = 0.0;
    Two change{};
    bool is_possible = true;
  };
  Step step(const Two& place) {
    const Wheels found = wheels(place);
    Two missing = requested_;
    std::array<Two, 2> slope{};
    const auto take = [&](std::size_t load, const TableContact& wheel, std::size_t row,
                          double arm) {
      missing[load] -= wheel.force[row] / arm;
      slope[load][0] += wheel.rates[row][1] / arm;
      slope[load][1] += wheel.rates[row][2] / arm;
    };
    Step result;
    for (std::size_t wheel = 0; wheel < 2; ++wheel) {
      result.is_possible = result.is_possible && found[wheel].inside && !found[wheel].lifted;
      if (of_ == LoadsOf::wheels) {
        take(wheel, found[wheel], 2, 1.0);
      } else {
        take(0, found[wheel], 2, 1.0);
        take(1, found[wheel], 3, usual_contact_arm);
      }
    }
    const double size = std::max(requested_[0], of_ == LoadsOf::wheels ? requested_[1] : 0.0);
    result.missing = std::hypot(missing[0], missing[1]) / size;
    result.change = newton_change(slope, missing);
    return result;
  }

private:
  const ContactTable& table_;
  VehicleState state_;
  LoadsOf of_;
  Two requested_;
};

} // namespace

TableEquilibrium find_table_equilibrium(const ContactTable& table, const VehicleState& state,
                                        const StaticLoads& loads) {
  Two requested = checked_loads(loads, table.convention);
  const Two each = loads_of_wheels(loads.of, requested);
  for (const double load : each) {
    if (load > table.ranges.load) {
      throw_invalid_argument("load of a wheel", load,
                             "must be at most " + text_of(table.ranges.load) +
                                 " N, the table's largest");
    }
  }
  if (loads.of == LoadsOf::axle) {
    requested[1] /= usual_contact_arm;
  }
  TableBalance balance(table, state, loads, requested);
  Two place = balance.place_at_depths({table.radius, 0.0}, each);
  TableBalance::Step step = balance.step(place);
  TableEquilibrium result;
  for (int i = 0; i < most_table_iterations && step.is_possible && !result.converged; ++i) {
    result.converged = step.missing <= load_share_met;
    Two next{place[0] + step.change[0], place[1] + step.change[1]};
    TableBalance::Step ahead = balance.step(next);
    for (int halving = 0;
         halving < most_table_iterations && !(ahead.is_possible && ahead.missing < step.missing);
         ++halving) {
      next = {0.5 * (place[0] + next[0]), 0.5 * (place[1] + next[1])};
      ahead = balance.step(next);
    }
    if (ahead.missing < step.missing) {
      place = next;
      step = ahead;
    }
  }
  result.vertical = to_caller(place[0], table.convention, dimensions::turning_length);
  result.roll = to_caller(place[1], table.convention, dimensions::angle);
  return result;
}

} // namespace wrc
