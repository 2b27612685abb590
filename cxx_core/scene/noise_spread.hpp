/// What the noise of measured profiles leaves uncertain of a scene's results.
///
/// The scene is solved again with each of the curves that are equally likely
/// (measured/noise_removal.hpp), all profiles at once. A spread is 2.23 times the root mean square
/// of the differences from the result: the truth is within it in 95 of 100 cases, if the likely
/// curves are as the truth is. Of the geometry and the normal contact; creep forces are solved only
/// if loads depend on them. On grids of their own, whatever grid, tolerance or solver the scene
/// prescribes. Units mm, MPa. Cost: 11 to 15 solutions to an accuracy of 1e-2, of smoothed_of five.
/// Thread rule: a value; both keep what they have computed.
#pragma once

#include "scene/noisy_scene.hpp"
#include "scene/scene_result.hpp"

namespace wrc {

/// 0 with exact profiles, which are built in.
const SceneSpread& spread_of(SceneResult& result);
/// That of exact profiles: 0 for each number that the result has. Solves nothing.
SceneSpread exact_spread(const SceneResult& result);
/// pmax and area by the wavelength that all profiles of points are smoothed with, in place of their
/// own smoothing; null with exact profiles.
const SmoothedScene* smoothed_of(SceneResult& result);

} // namespace wrc
