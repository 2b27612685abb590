/// What a requested accuracy is of.
///
///   forces: depth (force, if the position is prescribed), normal and lateral force, centre of
///     pressure and moments; contact area to 11 (at 1e-2) to 22 times (at 3e-4) as much.
///     Integrals, for vehicle dynamics.
///   pressures: the largest pressure as well, which may sit on a crest a tenth of a millimetre
///   wide.
/// Thread rule: a plain value.
#pragma once

namespace wrc {

enum class AccuracyOf { forces, pressures };

} // namespace wrc
