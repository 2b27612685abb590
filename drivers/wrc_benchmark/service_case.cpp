#include "wrc_benchmark/motion_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <utility>

#include "support/numbers.hpp"
#include "support/random_scenes.hpp"
#include "support/scene.hpp"
#include "support/service_run.hpp"
#include "wrc_benchmark/yardstick.hpp"

namespace benchmark {
namespace {

struct Pairing {
  const char* wheel;
  const char* rail;
};
constexpr std::array pairings{Pairing{"S1002", "60E1"}, Pairing{"LMA", "CHN60"},
                              Pairing{"S1002", "56E1"}};

enum class Prescribed { load, position };

/// A step of the run, and where it ends up.
struct Step {
  driver::ServiceStep run;
  double roll = 0.0;
  std::array<double, 2> height{}; ///< of the wheelset's centre, at which the wheel bears its load
};

/// Results of one wheel.
struct WheelResult {
  double depth = 0.0;
  double normal_force = 0.0;
  double lateral_force = 0.0;
  double vertical_force = 0.0;
  double pmax = 0.0;
  double solutions = 0.0;
  double error_estimate = 0.0; ///< 0 if there is none
};

/// Goes from step to step with one handle. If positions are prescribed each wheel is a scene of its
/// own: both are pressed in by different depths, so that they need different heights.
class Wheelset {
public:
  Wheelset(const Pairing& pair, Prescribed prescribed, double accuracy,
           const std::string& accuracy_of, std::string creep = "none")
      : prescribed_(prescribed), creep_(std::move(creep)),
        scenes_(prescribed == Prescribed::load ? 1 : 2) {
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      driver::Scene& scene = scenes_[i];
      driver::make_pair(pair.wheel, pair.rail).apply(scene);
      scene.set("solve.accuracy", accuracy);
      scene.set("solve.accuracy_of", accuracy_of);
      scene.set("solve.side", prescribed == Prescribed::load ? "both" : driver::side_names.at(i));
    }
  }

  /// The timed part. A solution that has not converged is compared like any other.
  void solve(const Step& step) {
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      set(step, i);
      solver_.solve(scenes_[i]);
    }
  }

  [[nodiscard]] std::array<WheelResult, 2> results() const {
    std::array<WheelResult, 2> results;
    for (std::size_t side = 0; side < results.size(); ++side) {
      results.at(side) = {number(side, "depth"),
                          number(side, "normal_force"),
                          number(side, "lateral_force"),
                          number(side, "vertical_force"),
                          number(side, "pmax"),
                          number(side, "solutions"),
                          scene_of(side).number_or(result_name(side, "discretisation_error"), 0.0)};
    }
    return results;
  }

  /// Where the solution stands.
  [[nodiscard]] double roll() const { return scenes_.front().number("roll"); }
  [[nodiscard]] double height(std::size_t side) const {
    return number(side, "vertical") - number(side, "depth");
  }

private:
  void set(const Step& step, std::size_t index) {
    driver::Scene& scene = scenes_[index];
    driver::set_pose(step.run, scene);
    if (prescribed_ == Prescribed::position) {
      scene.set("pose.roll", step.roll);
      scene.set("pose.vertical", step.height.at(index));
    }
    if (creep_ == "motion") {
      driver::set_motion(step.run, scene);
    } else if (creep_ == "creepages") {
      // A wheelset that runs straight: conicity 0.1 and a contact angle of 0.05 rad.
      constexpr double radius = 460.0;
      const double longitudinal = 0.1 * step.run.lateral / radius;
      scene.set("creepage.left", std::vector{-longitudinal, -step.run.yaw, 0.05 / radius});
      scene.set("creepage.right", std::vector{longitudinal, -step.run.yaw, -0.05 / radius});
    }
  }

  [[nodiscard]] const driver::Scene& scene_of(std::size_t side) const {
    return scenes_[scenes_.size() == 1 ? 0 : side];
  }
  [[nodiscard]] static std::string result_name(std::size_t side, const std::string& name) {
    return std::string(driver::side_names.at(side)) + '.' + name;
  }
  [[nodiscard]] double number(std::size_t side, const std::string& name) const {
    return scene_of(side).number(result_name(side, name));
  }

  Prescribed prescribed_;
  std::string creep_; ///< as ServiceRow's
  std::vector<driver::Scene> scenes_;
  driver::Solver solver_;
};

/// The run of one pair of profiles, with references at the steps where errors are measured.
struct Run {
  Pairing pair;
  std::vector<Step> steps; ///< the first one is the cold start
  std::size_t judging_stride = 1;
  using Truth = std::vector<std::array<WheelResult, 2>>;
  std::map<std::pair<Prescribed, std::string>, Truth> truth; ///< the string as ServiceRow::creep

  [[nodiscard]] bool is_judged(std::size_t index) const {
    return index > 0 && (index - 1) % judging_stride == 0;
  }
};

/// Positions are those of loads solved at the default accuracy, the same for all rows, so that
/// rows of a position can be compared with each other.
std::vector<Step> make_steps(const Pairing& pair, int count) {
  constexpr double accuracy = 1e-3;
  Wheelset wheelset(pair, Prescribed::load, accuracy, "pressures");
  std::vector<Step> steps;
  for (int i = 0; i <= count; ++i) {
    Step step{driver::service_step(i), 0.0, {}};
    wheelset.solve(step);
    step.roll = wheelset.roll();
    step.height = {wheelset.height(0), wheelset.height(1)};
    steps.push_back(step);
  }
  return steps;
}

std::vector<std::string> creep_of_rows(const Plan& plan) {
  return plan.creep ? std::vector<std::string>{"none", "creepages", "motion"}
                    : std::vector<std::string>{"none"};
}

Run make_run(const Pairing& pair, int count, const std::vector<std::string>& creep_of) {
  constexpr std::size_t judged = 40;
  constexpr double finest = 1e-5;
  constexpr double finest_creep = 1e-4; // a finer one takes a tenth of a second and more
  Run run{pair, make_steps(pair, count), 1, {}};
  run.judging_stride = std::max<std::size_t>(1, static_cast<std::size_t>(count) / judged);
  for (const Prescribed prescribed : {Prescribed::load, Prescribed::position}) {
    for (const std::string& creep : creep_of) {
      Wheelset wheelset(pair, prescribed, creep == "none" ? finest : finest_creep, "pressures",
                        creep);
      Run::Truth& truth = run.truth[{prescribed, creep}];
      for (std::size_t i = 0; i < run.steps.size(); ++i) {
        if (run.is_judged(i)) {
          wheelset.solve(run.steps[i]);
          truth.push_back(wheelset.results());
        }
      }
    }
  }
  return run;
}

/// The greatest of all steps counts.
void judge(const std::array<WheelResult, 2>& results, const std::array<WheelResult, 2>& truths,
           Prescribed prescribed, ServiceRow::Errors& errors) {
  const auto relative = [](double value, double truth) { return std::abs(value / truth - 1.0); };
  for (std::size_t side = 0; side < results.size(); ++side) {
    const WheelResult& result = results.at(side);
    const WheelResult& truth = truths.at(side);
    errors.pmax = std::max(errors.pmax, relative(result.pmax, truth.pmax));
    const double lateral_force =
        std::abs(result.lateral_force - truth.lateral_force) / truth.vertical_force;
    errors.lateral_force = std::max(errors.lateral_force, lateral_force);
    if (prescribed == Prescribed::load) {
      errors.depth = std::max(errors.depth.value_or(0.0), relative(result.depth, truth.depth));
    } else {
      errors.normal_force = std::max(errors.normal_force.value_or(0.0),
                                     relative(result.normal_force, truth.normal_force));
    }
  }
}

ServiceRow measure_row(const Run& run, Prescribed prescribed, double accuracy,
                       const std::string& accuracy_of, const std::string& creep) {
  Wheelset wheelset(run.pair, prescribed, accuracy, accuracy_of, creep);
  wheelset.solve(run.steps.front()); // reads profiles, makes plans
  ServiceRow row;
  std::vector<double> times;
  std::vector<double> solutions;
  auto truth = run.truth.at({prescribed, creep}).begin();
  Yardstick yardstick{GridSize()};
  const std::size_t sampling_stride = std::max<std::size_t>(1, run.steps.size() / 20);
  for (std::size_t i = 1; i < run.steps.size(); ++i) {
    if (i % sampling_stride == 0) {
      yardstick.sample(); // a shared machine changes its pace within a row
    }
    ProcessorStopwatch watch;
    wheelset.solve(run.steps[i]);
    times.push_back(watch.lap());
    const auto results = wheelset.results();
    solutions.insert(solutions.end(), {results[0].solutions, results[1].solutions});
    if (run.is_judged(i)) {
      judge(results, *truth++, prescribed, row.errors);
    }
  }
  for (const auto& results : run.truth.at({prescribed, creep})) {
    for (const WheelResult& result : results) {
      row.reference_estimate = std::max(row.reference_estimate, result.error_estimate);
    }
  }
  row.wheel = run.pair.wheel;
  row.rail = run.pair.rail;
  row.accuracy_of = accuracy_of;
  row.prescribed = prescribed == Prescribed::load ? "load" : "position";
  row.accuracy = accuracy;
  row.creep = creep;
  row.steps = static_cast<int>(times.size());
  row.solutions_mean = driver::mean(solutions);
  row.solutions_max = quantile(solutions, 1.0);
  row.times = {driver::mean(times), median(times), quantile(times, 0.99), quantile(times, 0.999),
               quantile(times, 1.0)};
  row.fft_pair_ms = yardstick.milliseconds();
  return row;
}

} // namespace

std::vector<ServiceRow> measure_service(const Plan& plan) {
  std::vector<ServiceRow> rows;
  for (const Pairing& pair : pairings) {
    const std::string name = std::string(pair.wheel) + " on " + pair.rail;
    std::cerr << "wrc_benchmark: service, " << name << ", positions and true results ...\n";
    const Run run = make_run(pair, plan.steps.value_or(2000), creep_of_rows(plan));
    for (const double accuracy : plan.accuracies()) {
      for (const char* accuracy_of : {"forces", "pressures"}) {
        for (const Prescribed prescribed : {Prescribed::load, Prescribed::position}) {
          for (const std::string& creep : creep_of_rows(plan)) {
            rows.push_back(measure_row(run, prescribed, accuracy, accuracy_of, creep));
            std::cerr << "wrc_benchmark: service, " << name << ", " << accuracy << " of "
                      << accuracy_of << ", " << rows.back().prescribed
                      << ", creep forces: " << creep << ": "
                      << driver::fixed(rows.back().times.mean, 3) << " ms per step\n";
          }
        }
      }
    }
  }
  return rows;
}

} // namespace benchmark
