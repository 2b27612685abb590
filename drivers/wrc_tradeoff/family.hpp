/// The scenes on which accuracy is measured: always the same ones.
///
/// Groups: `table1` (the paper's Table 1 at 21 lateral displacements), `manchester` (S1002 on the
/// Manchester UIC60), `two-patch` (S1002 on 56E1 where tread and flange carry together), `flange`
/// (displacements at the flange), and `spread`: pairs of profiles drawn in turn; displacement, yaw,
/// load (1 kN to 300 kN, uniform in its logarithm) and cant drawn from a fixed seed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "support/random_scenes.hpp"

namespace tradeoff {

struct Case {
  std::string name;
  std::string group;
  driver::Settings settings;
};
/// Of a wheel, 0 left and 1 right.
double load_of(const driver::Settings& scene, std::size_t side);

/// The first `count` scenes of the family, groups mixed so that few already show all of them; all
/// groups but `spread` have an end, `spread` has none.
std::vector<Case> make_family(std::size_t count);
/// Instead of the family: so many of driver::random_scene, group `random`.
std::vector<Case> make_random(std::size_t count);

} // namespace tradeoff
