/// Groups of the numbers of a result, one table each (scene/number_tables.hpp).
///
/// Thread rule: plain values.
#pragma once

#include <cstdint>

namespace wrc {

/// Names that have a table. Of the scene; of a wheel; of one of its near contacts; of a patch or a
/// part of it.
enum class NumberGroup : std::uint8_t {
  scene,
  time,
  wheelset,
  scene_spread,
  side,
  total,
  rigid_contact,
  centroid,
  residuals,
  spread,
  smoothed,
  sensitivities,
  at_load,
  jacobian,
  side_damage,
  near_contact,
  patch,
  reference, ///< position of a patch
  patch_centroid,
  creep,
  damage
};

} // namespace wrc
