// Bytes as steps of time of a wheelset with a history, which are accepted, repeated, forgotten or
// put back: each is refused as the header says or gives finite forces, whose creep forces stay
// within friction; a step repeated from the same state gives the same bits.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "base/error.hpp"
#include "scene/solve_scene.hpp"
#include "scene/vehicle_step.hpp"

namespace {

using History = std::shared_ptr<const wrc::ContactHistory>;

void demand(bool promise) {
  if (!promise) {
    __builtin_trap();
  }
}

/// A number for a byte: none, small, usual or absurd, of both signs.
double number_of(std::uint8_t byte, double usual) {
  constexpr std::array sizes{0.0, 1e-9, 0.01, 1.0, 1.0, 3.0, 50.0, 1e6};
  return (byte & 128U ? -1.0 : 1.0) * usual * sizes[byte % sizes.size()] *
         (1.0 + static_cast<double>((byte >> 3U) & 15U) / 16.0);
}

struct Found {
  std::array<wrc::WheelForces, 2> forces{};
  History after;
  bool is_solved = false;
};

void check_patches(const wrc::SceneResult& result) {
  for (const auto* wheel : {&result.left, &result.right}) {
    if (!*wheel) {
      continue;
    }
    for (const wrc::PatchResult& patch : (*wheel)->patches) {
      if (patch.creep) {
        constexpr double rounding = 1e-6;
        demand(std::hypot(patch.creep->longitudinal_force, patch.creep->lateral_force) <=
               patch.creep->friction * patch.normal_force * (1.0 + rounding) + rounding);
      }
    }
  }
}

Found solved(const wrc::Scene& scene, wrc::VehicleState state, const History& history,
             wrc::SceneSolver& solver) {
  Found found;
  state.history = history;
  try {
    const wrc::Scene posed = wrc::scene_at(scene, state);
    wrc::SceneResult result = solver.solve(posed);
    check_patches(result);
    found.forces = wrc::wheel_forces(result, posed.convention, state.derivatives);
    found.after = wrc::history_after(result);
    found.is_solved = true;
  } catch (const wrc::Error& error) {
    demand(error.code() == wrc::ErrorCode::invalid_argument ||
           error.code() == wrc::ErrorCode::no_contact);
  }
  return found;
}

void check(const Found& found) {
  for (const wrc::WheelForces& wheel : found.forces) {
    for (std::size_t i = 0; i < 6; ++i) {
      demand(std::isfinite(wheel.force[i]));
      for (std::size_t j = 0; j < 6; ++j) {
        demand(std::isfinite(wheel.by_position[i][j]) && std::isfinite(wheel.by_velocity[i][j]));
      }
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t bytes_of_step = 9;
  constexpr std::size_t most_steps = 6;
  static wrc::SceneSolver solver;
  wrc::Scene scene;
  scene.accuracy = 0.1;
  scene.accuracy_of = wrc::AccuracyOf::forces;
  History accepted = std::make_shared<const wrc::ContactHistory>();
  History kept = accepted;
  wrc::VehicleState state;
  state.position = {0.0, 0.0, 459.9, 0.0, 0.0, 0.0};
  for (std::size_t step = 0; step < most_steps && size >= bytes_of_step; ++step) {
    state.position[1] = number_of(data[0], 2.0);
    state.position[2] = 459.9 + number_of(data[1], 0.1);
    state.position[3] = number_of(data[2], 1e-3);
    state.position[5] = number_of(data[3], 5e-3);
    state.velocity = {number_of(data[4], 1e3),
                      number_of(data[5], 5.0),
                      number_of(data[6], 1.0),
                      0.0,
                      number_of(data[4], 1e3) / 460.0 + number_of(data[7], 0.01),
                      0.0};
    state.time_step = std::abs(number_of(data[8], 1e-3));
    state.derivatives = (data[6] & 64U) != 0;
    const Found found = solved(scene, state, accepted, solver);
    if (found.is_solved) {
      check(found);
      if ((data[7] & 64U) != 0) {
        demand(solved(scene, state, accepted, solver).forces[0].force == found.forces[0].force);
      }
      if ((data[8] & 64U) == 0) {
        accepted = found.after;
      }
    }
    if ((data[5] & 64U) != 0) {
      kept = accepted;
    } else if ((data[4] & 64U) != 0) {
      accepted = kept;
    }
    data += bytes_of_step;
    size -= bytes_of_step;
  }
  return 0;
}
