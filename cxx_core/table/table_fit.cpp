// What brings a table's slopes on the tread to those of the full theory.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/smoothstep.hpp"
#include "table/constants.hpp"
#include "table/table_work.hpp"

namespace wrc {
namespace {

using Contact = TensorSpline<4, table_part_count, float>;
constexpr auto first_of_law = static_cast<std::size_t>(TablePart::longitudinal_law);
constexpr auto last_of_law = static_cast<std::size_t>(TablePart::size);

/// Values of a spline at its nodes.
std::vector<double> values_of(const Contact& spline) {
  const Contact::Axes& axes = spline.axes();
  std::vector<double> values;
  values.reserve(Contact::size_of(axes));
  Contact::Values found;
  for (std::size_t i = 0; i < axes[0].count; ++i) {
    for (std::size_t j = 0; j < axes[1].count; ++j) {
      for (std::size_t k = 0; k < axes[2].count; ++k) {
        for (std::size_t l = 0; l < axes[3].count; ++l) {
          spline.evaluate({axes[0].node(i), axes[1].node(j), axes[2].node(k), axes[3].node(l)},
                          found);
          values.insert(values.end(), found.value.begin(), found.value.end());
        }
      }
    }
  }
  return values;
}

/// A parabola through the neighbours on both sides, as far as they fit it (Savitzky and Golay,
/// Analytical Chemistry 36, 1964): linear creep forces are noisy by the accuracy of their nodes,
/// and slopes of splines through them by much more.
void smooth_law(const Contact::Axes& axes, std::vector<double>& values) {
  const auto reach = static_cast<std::ptrdiff_t>(std::lround(smoothing_reach / axes[0].step));
  const std::size_t stride = values.size() / axes[0].count;
  const std::vector<double> noisy = values;
  double second = 0.0;
  double fourth = 0.0;
  for (std::ptrdiff_t d = -reach; d <= reach; ++d) {
    second += static_cast<double>(d * d);
    fourth += static_cast<double>(d * d * d * d);
  }
  const auto count = static_cast<double>(2 * reach + 1);
  const auto last = static_cast<std::ptrdiff_t>(axes[0].count) - reach;
  for (std::size_t line = 0; line < stride && reach > 1; ++line) {
    const std::size_t part = line % table_part_count;
    const auto which = static_cast<TablePart>(part);
    if ((part < first_of_law || part > last_of_law) && which != TablePart::arm_z) {
      continue;
    }
    for (std::ptrdiff_t node = reach; node < last; ++node) {
      const double* const middle = noisy.data() + stride * static_cast<std::size_t>(node) + line;
      const auto at = [&](std::ptrdiff_t d) {
        return middle[d * static_cast<std::ptrdiff_t>(stride)];
      };
      std::array<double, 3> sums{};
      for (std::ptrdiff_t d = -reach; d <= reach; ++d) {
        sums[0] += at(d);
        sums[1] += at(d) * static_cast<double>(d);
        sums[2] += at(d) * static_cast<double>(d * d);
      }
      const double curved =
          (count * sums[2] - second * sums[0]) / (count * fourth - second * second);
      const double level = (sums[0] - curved * second) / count;
      double misfit = 0.0;
      for (std::ptrdiff_t d = -reach; d <= reach; ++d) {
        const auto x = static_cast<double>(d);
        misfit = std::max(misfit, std::abs(at(d) - level - x * (sums[1] / second + x * curved)));
      }
      const double amount = which == TablePart::log_ratio ? 1.0
                            : which == TablePart::arm_z   ? smoothed_arm
                            : which == TablePart::cross_law
                                ? smoothed_cross * std::abs(middle[-1]) // the lateral force by spin
                                : std::abs(level);
      const double ratio = std::min(1.0, misfit / (smoothed_noise * std::max(amount, 1e-300)));
      const double noise = std::pow(ratio, 4);
      values[stride * static_cast<std::size_t>(node) + line] =
          (1.0 - noise) * level + noise * *middle;
    }
  }
}

/// Factors of the linear forces of xi, eta and the spin, and what is added to arm_z.
using Corrections = TensorSpline<3, 4>;

/// A wheel that rolls freely at 20 m/s, without yaw.
TableState rolling_state(const ContactTable& table, double u, double roll, double s) {
  TensorSpline<3, 2>::Values touch;
  table.touch.evaluate({u, roll, 0.0}, touch);
  Contact::Values found;
  table.contact.evaluate({u, roll, 0.0, s}, found);
  const TablePose pose = pose_of_taping_point(table, from_aligned(table, u, roll, 0.0),
                                              touch.value[0] - s * std::exp(touch.value[1]), roll);
  TableState state;
  state.position = {0.0, pose.lateral, pose.vertical, roll, 0.0, 0.0};
  const double arm = std::cos(roll) * found.value[static_cast<std::size_t>(TablePart::arm_z)] -
                     std::sin(roll) * found.value[static_cast<std::size_t>(TablePart::arm_y)];
  state.velocity = {drawn_speed, 0.0, 0.0, 0.0, -drawn_speed / arm, 0.0};
  state.friction = friction_of_errors;
  return state;
}

/// At one place; no corrections where it is not so regular that they are small.
std::array<double, 4> corrections_at(const ContactTable& table, TableState state,
                                     TableNodes& nodes) {
  const std::array<double, 4> none{1.0, 1.0, 1.0, 0.0};
  SceneWheel& wheel = nodes.solve_exactly(state, true, fit_accuracy);
  const ForceJacobian* exact = wheel.jacobian();
  const Vector3 force = force_of(wheel);
  const TableContact found = contact_in_table(table, state, true);
  constexpr std::size_t by_speed = 4;
  constexpr std::size_t by_lateral = 5;
  if (exact == nullptr || found.lifted) {
    return none;
  }
  state.friction = 0.0;
  const double spin_force = found.force[1] - contact_in_table(table, state, false).force[1];
  const double slide = friction_of_errors * found.force[2];
  const double regular = least_spin_force * slide;
  const std::array<double, 4> result{
      (*exact)[0][by_speed] / found.rates[0][by_speed],
      (*exact)[1][by_lateral] / found.rates[1][by_lateral],
      1.0 + (force.y - found.force[1]) * spin_force / (spin_force * spin_force + regular * regular),
      (force.x - found.force[0]) / (*exact)[0][by_speed] / state.velocity[4]};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(result[i] - 1.0) <= largest_correction)) {
      return none;
    }
  }
  return result;
}

} // namespace

void fit_table(TableWork& work, const Progress& progress) {
  ContactTable& table = work.table;
  const Contact::Axes axes = table.contact.axes();
  std::vector<double> values = values_of(table.contact);
  smooth_law(axes, values);
  table.contact = Contact(axes, values);

  const TableRanges& ranges = table.ranges;
  const double reach = std::min(fit_reach, ranges.lateral);
  const auto count = static_cast<std::size_t>( // to one side
      std::lround(reach / fit_step * std::min(1.0, work.options.fineness)));
  const Corrections::Axes coarse{SplineAxis(-reach, reach, std::max<std::size_t>(5, 2 * count + 1)),
                                 SplineAxis(-0.5 * ranges.roll, 0.5 * ranges.roll, 5),
                                 SplineAxis(0.25, 1.0, 4)};
  const std::size_t poses = coarse[1].count * coarse[2].count;
  std::vector<double> corrections(Corrections::size_of(coarse));
  work.run_stage(Stage::fit, coarse[0].count, corrections, progress, [&] {
    return [&, own = work.nodes()](std::size_t i, double* to) mutable {
      for (std::size_t pose = 0; pose < poses; ++pose, to += 4) {
        const TableState state =
            rolling_state(table, coarse[0].node(i), coarse[1].node(pose / coarse[2].count),
                          coarse[2].node(pose % coarse[2].count));
        const auto found = corrections_at(table, state, *own);
        std::copy(found.begin(), found.end(), to);
      }
    };
  });
  const Corrections spline(coarse, std::move(corrections));
  double* value = values.data();
  for (std::size_t i = 0; i < axes[0].count; ++i) {
    const double u = axes[0].node(i);
    const double share = share_of_fit(table, u);
    for (std::size_t pose = 0; pose < axes[1].count * axes[2].count; ++pose) {
      const double roll = axes[1].node(pose / axes[2].count);
      // Beyond these places forces have the factors of the last one, but no offset.
      const double outside = std::max(std::abs(u) - coarse[0].last(), 0.0) / fit_fall +
                             std::max(std::abs(roll) / coarse[1].last() - 1.0, 0.0);
      const double offset = share * (1.0 - smoothstep(outside));
      for (std::size_t level = 0; level < axes[3].count; ++level, value += table_part_count) {
        Corrections::Values found;
        spline.evaluate({std::clamp(u, coarse[0].first, coarse[0].last()),
                         std::clamp(roll, coarse[1].first, coarse[1].last()),
                         std::max(axes[3].node(level), coarse[2].first)},
                        found);
        const auto part = [&](TablePart which) -> double& {
          return value[static_cast<std::size_t>(which)];
        };
        part(TablePart::longitudinal_law) *= 1.0 + share * (found.value[0] - 1.0);
        part(TablePart::lateral_law) *= 1.0 + share * (found.value[1] - 1.0);
        part(TablePart::spin_law) *= 1.0 + share * (found.value[2] - 1.0);
        part(TablePart::arm_z) += offset * found.value[3];
      }
    }
  }
  smooth_law(axes, values);
  table.contact = Contact(axes, std::move(values));
}

} // namespace wrc
