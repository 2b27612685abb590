// The steps of vehicle_steps.f90 from C++, to measure the cost of the Fortran interface. Usage:
// vehicle_steps_cxx [N]
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <string>

#include "wrcontact.hpp"

namespace {

constexpr std::array input_names{"pose.lateral", "pose.yaw",        "load.left",
                                 "load.right",   "friction.left",   "friction.right",
                                 "motion.speed", "motion.lateral",  "motion.yaw",
                                 "motion.roll",  "motion.vertical", "motion.curvature"};
/// Those that are added up.
constexpr std::array summed_names{
    "left.lateral_force", "right.lateral_force", "left.pmax", "right.pmax",
    "left.centroid.y",    "right.centroid.y",    "roll",      "vertical"};
/// Names per wheel.
constexpr std::array other_names{"total.force.x",
                                 "total.force.y",
                                 "total.force.z",
                                 "total.moment.x",
                                 "total.moment.y",
                                 "total.moment.z",
                                 "patch_count",
                                 "normal_force",
                                 "vertical_force",
                                 "depth",
                                 "angle",
                                 "approach",
                                 "centroid.x",
                                 "centroid.z",
                                 "centroid.s_wheel",
                                 "centroid.rolling_radius",
                                 "patches.0.normal_force",
                                 "patches.0.angle",
                                 "patches.0.x",
                                 "patches.0.y",
                                 "patches.0.z",
                                 "patches.0.pmax",
                                 "patches.0.approach",
                                 "patches.0.semi_axes.longitudinal",
                                 "patches.0.semi_axes.lateral",
                                 "patches.0.coupling_weight"};

/// Inputs and results of a step, by id.
struct Exchange {
  std::array<std::int32_t, input_names.size()> input_ids{};
  std::array<double, input_names.size()> inputs{0.0, 0.0, 8e4, 8e4, 0.3, 0.3, 2e4};
  static constexpr std::size_t result_count = summed_names.size() + 2 * other_names.size();
  std::array<std::int32_t, result_count> result_ids{};
  std::array<double, result_count> results{};

  explicit Exchange(const wrcontact::Scene& scene) {
    std::transform(input_names.begin(), input_names.end(), input_ids.begin(),
                   [&](const char* name) { return scene.key_id(name); });
    auto id = std::transform(summed_names.begin(), summed_names.end(), result_ids.begin(),
                             [&](const char* name) { return scene.number_id(name); });
    for (const std::string side : {"left.", "right."}) {
      id = std::transform(other_names.begin(), other_names.end(), id,
                          [&](const char* name) { return scene.number_id(side + name); });
    }
  }
  void set(wrcontact::Scene& scene) const { scene.set_numbers_by_id(input_ids, inputs); }
  void read(const wrcontact::Scene& scene) { scene.numbers_by_id(result_ids, results); }
};

/// Median time of setting the inputs and reading the results, in ns.
double exchange_time(wrcontact::Scene& scene, Exchange& exchange) {
  constexpr int rounds = 100;
  std::array<double, 1001> times{};
  for (double& time : times) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < rounds; ++i) {
      exchange.set(scene);
      exchange.read(scene);
    }
    const std::chrono::duration<double, std::nano> elapsed =
        std::chrono::steady_clock::now() - start;
    time = elapsed.count() / rounds;
  }
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return times[times.size() / 2];
}

long resident_kb() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line)) {
    if (line.starts_with("VmRSS:")) {
      return std::stol(line.substr(6));
    }
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::atoi(argv[1]) : 3000;
  wrcontact::Scene scene;
  wrcontact::Solver solver;
  scene.set("solve.accuracy", 1.0e-2);
  scene.set("solve.creep", "none");
  Exchange exchange(scene);
  double total = 0.0;
  long early = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 1; i <= steps; ++i) {
    exchange.inputs[0] = 5.0 * std::sin(2.0 * std::numbers::pi * i / 2000.0);
    exchange.inputs[1] = 2.0e-3 * std::cos(2.0 * std::numbers::pi * i / 2000.0);
    exchange.set(scene);
    if (!solver.solve(scene)) {
      return 1;
    }
    exchange.read(scene);
    for (std::size_t k = 0; k < summed_names.size(); ++k) {
      total += exchange.results[k];
    }
    if (i == std::max(steps / 10, 1000)) {
      early = resident_kb();
    }
  }
  const std::chrono::duration<double, std::micro> elapsed =
      std::chrono::steady_clock::now() - start;
  std::printf("steps %d\nmicroseconds_per_step %.3f\nsum %.16e\nresident_kb %ld\ngrowth_kb %ld\n",
              steps, elapsed.count() / steps, total, resident_kb(), resident_kb() - early);
  std::printf("nanoseconds_per_exchange %.0f\n", exchange_time(scene, exchange));
  return 0;
}
