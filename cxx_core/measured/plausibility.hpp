/// Whether points can be those of a wheel or a rail: warnings with numbers, errors in strict mode.
///
/// Checked are the width, a wheel's flange (height, side, distance from the taping line), a rail's
/// height of the crown, and on the part that can be in contact whether lateral ascends, gaps and
/// steps; that part is, of a wheel, from the flange tip to the chamfer, of a rail, down to 14 mm
/// below the top. Units mm, frame of profile.hpp. Thread rule: no state.
#pragma once

#include <span>

#include "measured/reader_lines.hpp"
#include "profile/profile.hpp"

namespace wrc::reading {

/// Points in the order of profile.hpp; `tape_offset` is the distance of a wheel's taping line from
/// its flange back. If they are aligned to a nominal profile, a worn tread is not at height 0.
void check_points(std::span<const Position> points, ProfileKind kind, double tape_offset, Log& log,
                  bool is_aligned = false);

/// How far points are off a smooth line.
struct Scatter {
  double deviation = 0.0;    ///< mm, rms
  double pressure = 0.0;     ///< that flattens it, MPa
  bool is_of_digits = false; ///< no more than the rounding of the points' last digit

  /// Whether it changes the pressures of a contact noticeably.
  [[nodiscard]] bool matters() const;
};
Scatter scatter_of(std::span<const Position> points);
/// The same where the deviation is known from elsewhere, and at which distance it is independent.
Scatter scatter_of(std::span<const Position> points, double deviation, double distance);

/// Warns of places where the curve through the points leaves them.
void check_curve(const Profile& profile, Log& log);

/// Height of a wheel's points at lateral 0, on its running surface; none if they do not reach it.
std::optional<double> height_at_taping_line(std::span<const Position> points);

} // namespace wrc::reading
