/// Error of taking creep forces on a path as those of steady rolling at each position.
///
/// A contact remembers what it has rolled over for about its own length. Where forces change along
/// the path, steady ones lead those of transient rolling, per patch by at most about
///   E = max(min(0.7 L |dF/ds|, 0.12 mu N), min(0.7 L |dF/dv dv/ds|, 2 mu N)),
/// L the length of the contact along rolling, F = (Fx, Fy) the steady creep force and v the
/// velocities: the limit is that of loads and positions, not of creepages. Measured on sequences of
/// transient rolling (cxx_core/creep/README.md); at a single position the error lags behind the
/// slope, so that the largest E of the last two contact lengths counts.
///
/// dF/ds follows from the derivatives by positions and velocities and from the rates of these:
/// velocities of wheelset and rails, slopes of rails, and Motion::acceleration; where a rail or a
/// wheel varies, also from a solution a little behind. With a load given, the height follows the
/// other positions. Units mm, N, s, rad. Thread rule: pure functions, except for
/// find_steady_errors, which fills in its argument.
///
/// Not known here: loads that change by themselves, accelerations of rails, patches that have
/// ended, wheels slower than Motion::standstill_speed.
#pragma once

#include <optional>

namespace wrc {

struct WheelRates;
struct WheelResult;

/// E over mu N; `rate`: |dF/ds|, N/mm, `by_velocities`: the part by velocities; `bound`: mu N.
double steady_error(double contact_length, double rate, double by_velocities, double bound);

/// A wheel at a position before, `distance` behind along the path, mm.
struct WheelBehind {
  const WheelResult& wheel;
  double distance;
};

/// Fills in CreepResult::steady_error of a wheel that moves along the track with creep forces of
/// steady rolling and their derivatives; nothing of others. `behind`: at the same pose, where
/// profiles vary.
void find_steady_errors(WheelResult& wheel, const WheelRates& rates,
                        const std::optional<WheelBehind>& behind);

/// Of the patches by their loads; none if it is not known of one that carries load.
std::optional<double> steady_error_of(const WheelResult& wheel);

/// Warns where it is more than the accuracy.
void warn_of_steady_forces(WheelResult& wheel, double accuracy);

} // namespace wrc
