#include "results/grade.hpp"

#include <algorithm>
#include <array>

#include "results/constants.hpp"

namespace wrc {
namespace {

/// Of classes without an error: whether the numbers are not those of the bodies or of the contact
/// meant. Others are remarks: on the input, or on a cause whose effect the error estimate includes.
bool spoils_numbers(WarningClass kind) {
  switch (kind) {
  case WarningClass::profile_dimensions:
  case WarningClass::profile_origin:
  case WarningClass::profile_signs:
  case WarningClass::profile_tilt:
  case WarningClass::profile_gap:
  case WarningClass::profile_step:
  case WarningClass::profile_overlap:
  case WarningClass::profile_outliers:
  case WarningClass::profile_swing:
  case WarningClass::profile_end:
  case WarningClass::not_converged:
  case WarningClass::not_settled:
  case WarningClass::grid_edge:
  case WarningClass::vertical_angle:
  case WarningClass::patch_left_out:
  case WarningClass::model_validity:
  case WarningClass::pressure:
    return true;
  default:
    return false;
  }
}

} // namespace

std::string_view name_of(Grade grade) {
  constexpr std::array<std::string_view, 3> names{"fine", "a little over", "do not use"};
  return names[static_cast<std::size_t>(grade)];
}

Grade grade_of(const Warning& warning) {
  if (!warning.excess) {
    return spoils_numbers(warning.kind) ? Grade::do_not_use : Grade::fine;
  }
  return !(*warning.excess <= usable_excess) ? Grade::do_not_use
         : *warning.excess > 1.0             ? Grade::slightly_over
                                             : Grade::fine;
}

Grade grade_of(const Warnings& warnings) {
  Grade worst = Grade::fine;
  for (const Warning& warning : warnings) {
    worst = std::max(worst, grade_of(warning));
  }
  return worst;
}

} // namespace wrc
