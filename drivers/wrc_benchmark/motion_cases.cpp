#include "wrc_benchmark/motion_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/parallel.hpp"
#include "support/scene.hpp"
#include "wrc_benchmark/transform.hpp"
#include "wrc_benchmark/yardstick.hpp"

namespace benchmark {
namespace {

struct Pose {
  double lateral = 0.0;
  double yaw = 0.0;
};

/// How the scene changes from step to step.
struct Motion {
  std::string name;
  std::vector<Pose> poses;
};

/// Lateral 3 mm sin(phase) over a wave of 8 m; the wheelset stands along its path, so that the yaw
/// is the path's slope, 2.4 mrad at the most. Steps of 40 mm: 1 ms at 40 m/s.
Motion hunting(int steps) {
  constexpr double amplitude = 3.0;
  constexpr double wavelength = 8000.0;
  constexpr double distance = 40.0;
  Motion motion{"hunting", {}};
  for (int i = 0; i < steps; ++i) {
    const double number = 2.0 * std::numbers::pi / wavelength;
    const double phase = number * distance * i;
    motion.poses.push_back({amplitude * std::sin(phase), amplitude * number * std::cos(phase)});
  }
  return motion;
}

/// Even steps, to the left from the centre on, and back and forth before the wheel leaves the rail.
Motion shift(const std::string& name, double step, int steps) {
  constexpr double turn = 6.5; // mm
  Motion motion{name, {}};
  for (int i = 0; i < steps; ++i) {
    const double way = std::fmod(i * step, 4.0 * turn);
    const double lateral = way < turn         ? way
                           : way < 3.0 * turn ? 2.0 * turn - way
                                              : way - 4.0 * turn;
    motion.poses.push_back({lateral, 0.0});
  }
  return motion;
}

void set_pose(driver::Scene& scene, const Pose& pose) {
  scene.set("pose.lateral", pose.lateral);
  scene.set("pose.yaw", pose.yaw);
}

double patch_width() {
  driver::Scene scene;
  scene.solve();
  return 2.0 * scene.number("left.patches.0.semi_axes.lateral");
}

/// Errors are measured at about this many steps, evenly spread.
std::size_t judging_stride(const Motion& motion) {
  constexpr std::size_t judged = 10;
  return std::max<std::size_t>(1, motion.poses.size() / judged);
}

std::vector<double> pmax_of(const driver::Scene& scene) {
  return {scene.number("left.pmax"), scene.number("right.pmax")};
}

/// pmax of both wheels at the steps where errors are measured, on a grid fine enough for errors of
/// about 1e-6.
std::vector<std::vector<double>> fine_pmax(const Motion& motion) {
  driver::Scene scene;
  scene.set("solve.grid", std::vector<double>{384.0, 384.0});
  scene.set("solve.tolerance", 1e-7);
  std::vector<std::vector<double>> pmax;
  for (std::size_t i = 0; i < motion.poses.size(); i += judging_stride(motion)) {
    set_pose(scene, motion.poses[i]);
    scene.solve();
    pmax.push_back(pmax_of(scene));
  }
  return pmax;
}

/// The paper's method takes a second per step, so that it solves only every other one of these
/// steps.
Row run(const Motion& motion, const std::string& method, double accuracy,
        const std::vector<std::vector<double>>& true_pmax) {
  const std::size_t stride = method == "paper" ? 2 * judging_stride(motion) : 1;
  driver::Scene scene;
  driver::Solver solver;
  scene.set("solve.accuracy", accuracy);
  scene.set("solve.method", method == "paper" ? "paper" : "auto");
  set_pose(scene, motion.poses.front());
  solver.solve(scene);
  std::vector<Times> times;
  std::vector<double> fills;
  std::vector<double> iterations;
  double error = 0.0;
  for (std::size_t i = 0; i < motion.poses.size(); i += stride) {
    ProcessorStopwatch watch;
    set_pose(scene, motion.poses[i]);
    solver.solve(scene);
    times.push_back(Times::of(scene, watch.lap()));
    fills.push_back(scene.number("left.fill"));
    iterations.push_back(scene.number("left.iterations"));
    if (i % judging_stride(motion) == 0) {
      const auto pmax = pmax_of(scene);
      const auto& truth = true_pmax[i / judging_stride(motion)];
      for (std::size_t side = 0; side < pmax.size(); ++side) {
        error = std::max(error, std::abs(pmax[side] / truth[side] - 1.0));
      }
    }
  }
  Row row;
  row.case_name = "vehicle-step";
  row.motion = motion.name;
  row.grid = GridSize::of(scene);
  row.method = method;
  row.state = "warm";
  row.wheels = 2;
  row.accuracy = accuracy;
  row.fill = median(fills);
  row.iterations = median(iterations);
  row.times = median(times);
  row.min_ms = quantile(totals(times), 0.0);
  row.percentile_90_ms = quantile(totals(times), 0.9);
  row.worst_ms = quantile(totals(times), 1.0);
  row.repeats = static_cast<int>(times.size());
  if (method != "paper") { // whose gaps are vertical: another problem
    row.error_pmax = error;
  }
  return row;
}

} // namespace

std::vector<Row> measure_vehicle_steps(const Plan& plan) {
  const int steps = plan.steps.value_or(200);
  const double width = patch_width();
  const Motion motions[] = {hunting(steps), shift("1 %", 0.01 * width, steps / 4 + 1),
                            shift("0.1 %", 0.001 * width, steps / 4 + 1)};
  Yardstick yardstick{GridSize()};
  std::vector<Row> rows;
  for (const Motion& motion : motions) {
    const auto true_pmax = fine_pmax(motion);
    for (const double accuracy : plan.accuracies()) {
      for (const std::string& method : plan.methods) {
        if (method == "default" || motion.name == "hunting" || plan.methods.size() == 1) {
          yardstick.sample();
          rows.push_back(run(motion, method, accuracy, true_pmax));
        }
      }
    }
  }
  for (Row& row : rows) {
    row.fft_pair_ms = yardstick.milliseconds();
  }
  return rows;
}

namespace {

/// Wall time of the same number of transforms on each of several threads.
double measure_busy_threads(int threads) {
  Stopwatch watch;
  driver::for_each_index(static_cast<std::size_t>(threads), threads, [](std::size_t) {
    constexpr int pairs = 400;
    const GridSize grid;
    measure_transform({2 * grid.lateral, 2 * grid.longitudinal}, pairs);
  });
  return watch.lap();
}

/// 64 scenes of a wheelset that moves across the track.
class Scenes {
public:
  static constexpr int count = 64;

  Scenes() : scenes_(count) {
    for (int i = 0; i < count; ++i) {
      const double share = static_cast<double>(i) / (count - 1);
      driver::Scene& scene = scenes_[static_cast<std::size_t>(i)];
      set_pose(scene, {-3.0 + 6.0 * share, 2.4e-3 * (1.0 - 2.0 * share)});
      handles_.push_back(scene.handle());
    }
  }

  /// Stages are added up over scenes and threads, the total is wall time.
  Times solve(int threads) {
    Stopwatch watch;
    ProcessorStopwatch processor;
    if (wrc_solve_batch(handles_.data(), count, threads, nullptr) != WRC_OK) {
      throw driver::Failure("batch: a scene could not be solved");
    }
    Times sum;
    sum.total = watch.lap();
    processor_ms_ = processor.lap();
    for (const driver::Scene& scene : scenes_) {
      const Times times = Times::of(scene, scene.number("time_ms.total"));
      sum.setup += times.setup;
      sum.geometry += times.geometry;
      sum.remesh += times.remesh;
      sum.mechanics += times.mechanics;
    }
    return sum;
  }
  /// Processor time of the last solution.
  [[nodiscard]] double processor_ms() const { return processor_ms_; }
  [[nodiscard]] std::vector<double> pressures() const {
    std::vector<double> all;
    for (const driver::Scene& scene : scenes_) {
      for (const std::string& side : driver::sides_of(scene)) {
        const auto field = scene.field(side + ".pressure");
        all.insert(all.end(), field.begin(), field.end());
      }
    }
    return all;
  }
  [[nodiscard]] const driver::Scene& middle() const { return scenes_[count / 2]; }

private:
  std::vector<driver::Scene> scenes_;
  std::vector<wrc_scene*> handles_;
  double processor_ms_ = 0.0;
};

Row batch_row(const driver::Scene& scene, int threads, const std::vector<Times>& times) {
  Row row;
  row.case_name = "batch";
  row.grid = GridSize::of(scene);
  row.method = "default";
  row.state = "cold";
  row.wheels = 2 * Scenes::count;
  row.threads = threads;
  row.accuracy = 1e-3;
  row.fill = scene.number("left.fill");
  row.iterations = scene.number("left.iterations");
  row.times = median(times);
  row.min_ms = quantile(totals(times), 0.0);
  row.repeats = static_cast<int>(times.size());
  return row;
}

} // namespace

Batch measure_batch(int repeat) {
  Scenes scenes;
  std::vector<Times> one;
  std::vector<Times> two;
  std::vector<double> alone;
  std::vector<double> together;
  std::vector<double> work_ratios;
  Batch batch;
  batch.bitwise_equal = true;
  for (int i = 0; i < repeat; ++i) {
    alone.push_back(measure_busy_threads(1));
    together.push_back(measure_busy_threads(2));
    one.push_back(scenes.solve(1));
    const double processor_of_one = scenes.processor_ms();
    const auto expected = scenes.pressures();
    two.push_back(scenes.solve(2));
    work_ratios.push_back(scenes.processor_ms() / processor_of_one);
    batch.bitwise_equal = batch.bitwise_equal && scenes.pressures() == expected;
  }
  batch.work_ratio = median(work_ratios);
  batch.machine_speedup = 2.0 * median(alone) / median(together);
  batch.speedup = median(one).total / median(two).total;
  batch.rows = {batch_row(scenes.middle(), 1, one), batch_row(scenes.middle(), 2, two)};
  const double pair = Yardstick(GridSize()).milliseconds();
  for (Row& row : batch.rows) {
    row.fft_pair_ms = pair;
  }
  return batch;
}

} // namespace benchmark
