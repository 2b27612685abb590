#include "table/table_build.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "keys/scene_keys.hpp"
#include "table/constants.hpp"
#include "table/finished_tasks.hpp"
#include "table/table_file.hpp"
#include "table/table_nodes.hpp"

namespace wrc {
namespace {

/// Numbers of nodes and states that follow from the fineness.
struct Counts {
  std::size_t lateral, roll, depth, states_of_cell, held_out;
  std::size_t yaw = 4; // of its square: forces of both signs alike
  CreepLawNodes law;
  ErrorMap::Counts cells;
};

std::size_t at_least(double least, double count) {
  return static_cast<std::size_t>(std::lround(std::max(least, count)));
}

Counts counts_of(const TableOptions& options) {
  const double fine = options.fineness;
  const double length = 2.0 * options.ranges.lateral; // mm
  Counts counts{};
  counts.lateral = at_least(8.0, 20.0 * length * fine) + 1;
  counts.roll = at_least(4.0, 9.0 * fine);
  counts.depth = at_least(6.0, 12.0 * fine);
  counts.states_of_cell = at_least(20.0, 100.0 * fine);
  counts.held_out = at_least(500.0, 10000.0 * fine);
  counts.law.translation = 2 * at_least(4.0, 8.0 * std::min(fine, 2.0)) + 1;
  counts.law.spin = 2 * at_least(3.0, 6.0 * std::min(fine, 2.0)) + 1;
  counts.law.ratio = at_least(4.0, 7.0 * std::min(fine, 2.0));
  counts.law.elements = at_least(20.0, 32.0 * std::min(fine, 2.0));
  counts.cells = {at_least(2.0, 2.0 * length), 4, 3};
  return counts;
}

void check_options(const TableOptions& options, Units units) {
  const auto check = [units](const char* name, double value, double least, double most,
                             const Dimension& dimension = dimensions::pure) {
    if (!(value >= least && value <= most)) {
      throw_invalid_argument(name, amount_text(value, units, dimension),
                             "must be between " + amount_text(least, units, dimension) + " and " +
                                 amount_text(most, units, dimension));
    }
  };
  check("lateral", options.ranges.lateral, 0.5, 30.0, dimensions::length);
  check("roll", options.ranges.roll, 1e-3, 0.1, dimensions::angle);
  check("yaw", options.ranges.yaw, 1e-3, 0.1, dimensions::angle);
  check("load", options.ranges.load, 1e3, 1e6, dimensions::force);
  check("tolerance", options.tolerance, 0.0, 1.0);
  check("fineness", options.fineness, 0.2, 4.0);
  check("threads", options.threads, 1.0, 1024.0);
  const Counts counts = counts_of(options);
  const double bytes = 4.0 * table_part_count * static_cast<double>(counts.lateral) *
                       static_cast<double>(counts.roll) * static_cast<double>(counts.yaw) *
                       static_cast<double>(counts.depth);
  if (bytes > largest_spline) {
    throw_invalid_argument("fineness", options.fineness,
                           "with these ranges the table would take " +
                               text_of(std::round(bytes / 1e6)) + " MB; it must be at most 1000");
  }
}

/// Yaw at a node of its square.
double yaw_of(const SplineAxis& squares, std::size_t node) {
  return std::max(std::sqrt(squares.node(node)), least_yaw_node * std::sqrt(squares.last()));
}

/// Numbers between 0 and 1, the same everywhere for a seed.
class RandomNumbers {
public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}
  double next() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
  double between(double low, double high) { return low + (high - low) * next(); }

private:
  std::mt19937_64 engine_;
};

/// Error of the force over the load.
double error_of(const ContactTable& table, const TableState& state, TableNodes& nodes,
                double& returned) {
  const TableContact found = contact_in_table(table, state, false);
  const Vector3 exact = nodes.exact_force(state);
  returned = found.error;
  const double error = norm(Vector3{found.force[0], found.force[1], found.force[2]} - exact) /
                       std::max(exact.z, least_load_share * table.ranges.load);
  return error < error_without_answer ? error : error_without_answer; // nor a NaN
}

/// Stages whose tasks take long.
enum class Stage : std::uint32_t { touch, nodes, errors_of_map, errors_of_factor, errors_of_check };

class TableBuilder {
public:
  TableBuilder(const Scene& scene, const TableOptions& options, const SceneSolver& solver)
      : scene_(scene), options_(options), solver_(solver), counts_(counts_of(options)) {
    table_.ranges = options.ranges;
    table_.identity = identity_of_table(scene);
    table_.convention = scene.convention;
    table_.friction = scene.left.friction.coefficient;
    table_.standstill_speed = scene.standstill_speed;
    nodes()->measure();
    const TableRanges& ranges = options.ranges;
    lateral_ = SplineAxis(-ranges.lateral, ranges.lateral, counts_.lateral);
    roll_ = SplineAxis(-ranges.roll, ranges.roll, counts_.roll);
    square_ = SplineAxis(0.0, ranges.yaw * ranges.yaw, counts_.yaw);
    depth_ = SplineAxis(0.0, 1.0, counts_.depth);
    if (!options.resume_file.empty()) {
      finished_.emplace(options.resume_file, inputs());
    }
  }

  ContactTable build() {
    try {
      make();
    } catch (...) {
      keep();
      throw;
    }
    keep();
    return std::move(table_);
  }

private:
  void keep() {
    if (finished_) {
      finished_->write();
    }
  }

  void make() {
    const double poisson = shear_constants(scene_.wheel_material, scene_.rail_material).poisson;
    table_.law = CreepLaw::make(poisson, counts_.law, options_.threads, part_of_progress(0.0, 0.1));
    align();
    find_touch(part_of_progress(0.1, 0.15));
    solve_nodes(part_of_progress(0.15, 0.6));
    measure_errors(part_of_progress(0.6, 1.0));
    table_.errors.set_tolerance(options_.tolerance);
    table_.tolerance = options_.tolerance;
  }

  /// What decides on the numbers of tasks, as bytes: all keys of the scene, too.
  [[nodiscard]] std::string inputs() const {
    const TableRanges& ranges = options_.ranges;
    std::string text = options_.version;
    const auto add = [&text](std::span<const double> numbers) {
      text.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
    };
    add(std::array{ranges.lateral, ranges.roll, ranges.yaw, ranges.load, options_.fineness,
                   std::bit_cast<double>(table_.identity.profiles)});
    for (const KeyDescription& key : scene_keys()) {
      const KeyValue value = key_value(scene_, key.name);
      (text += '\n') += key.name;
      if (const auto* words = std::get_if<std::string>(&value)) {
        text += *words;
      } else if (const auto* number = std::get_if<double>(&value)) {
        add({number, 1});
      } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
        add(*numbers);
      }
    }
    return text;
  }

  /// Tasks that each fill in an equal share of `numbers`; finished ones are not done again.
  template <class MakeWorker>
  void run_stage(Stage stage, std::size_t count, std::vector<double>& numbers,
                 const Progress& progress, const MakeWorker& make_worker) {
    const std::size_t share = numbers.size() / count;
    const auto of_stage = static_cast<std::uint32_t>(stage);
    run_tasks(count, options_.threads, progress, [&] {
      return [&, work = make_worker()](std::size_t task) mutable {
        const std::span<double> own(numbers.data() + task * share, share);
        if (finished_ && finished_->find(of_stage, task, own)) {
          return;
        }
        work(task, own.data());
        if (finished_) {
          finished_->add(of_stage, task, own);
        }
      };
    });
  }

  /// Not on the stack, which may be small.
  std::unique_ptr<TableNodes> nodes() {
    return std::make_unique<TableNodes>(scene_, solver_.beside(), table_);
  }

  [[nodiscard]] Progress part_of_progress(double from, double to) const {
    if (!options_.progress) {
      return {};
    }
    return [this, from, to](double share) { options_.progress(from + share * (to - from)); };
  }

  void align();
  void find_touch(const Progress& progress);
  void solve_nodes(const Progress& progress);
  void measure_errors(const Progress& progress);
  [[nodiscard]] std::vector<std::pair<double, double>> errors_of(Stage stage, std::size_t count,
                                                                 const Progress& progress);

  const Scene& scene_;
  const TableOptions& options_;
  const SceneSolver& solver_;
  const Counts counts_;
  ContactTable table_;
  SplineAxis lateral_, roll_, square_, depth_;
  std::optional<FinishedTasks> finished_;
};

/// The position at which first touch becomes steep; none within the range and a little beyond.
double flange_of(TableNodes& nodes, double range, double roll, double yaw) {
  constexpr double step = 0.05;
  constexpr double half = 0.005;
  const auto is_steep = [&](double u) {
    return nodes.touch_height(u + half, roll, yaw) - nodes.touch_height(u - half, roll, yaw) >
           2.0 * half * flange_slope;
  };
  double low = 0.0;
  while (!is_steep(low + step)) {
    low += step;
    if (low > range + 1.0) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }
  double high = low + step;
  for (int i = 0; i < 12; ++i) { // down to 1e-5 mm
    const double middle = 0.5 * (low + high);
    (is_steep(middle) ? high : low) = middle;
  }
  return high;
}

void TableBuilder::align() {
  const TensorSpline<2, 1>::Axes axes{roll_, square_};
  std::vector<double> shifts(roll_.count * square_.count);
  const std::unique_ptr<TableNodes> solver = nodes();
  const double range = options_.ranges.lateral;
  const double middle = flange_of(*solver, range, 0.0, yaw_of(square_, 0));
  run_tasks(std::isnan(middle) ? 0 : shifts.size(), options_.threads, {}, [&] {
    return [&, own = nodes()](std::size_t task) mutable {
      shifts[task] = flange_of(*own, range, roll_.node(task / square_.count),
                               yaw_of(square_, task % square_.count)) -
                     middle;
    };
  });
  const bool found =
      !std::isnan(middle) && std::none_of(shifts.begin(), shifts.end(), [](double s) {
        return std::isnan(s) || std::abs(s) > 0.5 * (alignment_begins - alignment_ends);
      });
  table_.flange = found ? middle : 0.0;
  table_.shift = TensorSpline<2, 1>(axes, found ? shifts : std::vector<double>(shifts.size()));
}

void TableBuilder::find_touch(const Progress& progress) {
  const TensorSpline<3, 2>::Axes axes{lateral_, roll_, square_};
  const std::size_t poses = roll_.count * square_.count;
  std::vector<double> values(2 * lateral_.count * poses);
  run_stage(Stage::touch, lateral_.count, values, progress, [&] {
    return [&, own = nodes()](std::size_t i, double* to) mutable {
      for (std::size_t pose = 0; pose < poses; ++pose) {
        const double roll = roll_.node(pose / square_.count);
        const double yaw = yaw_of(square_, pose % square_.count);
        const double lateral = from_aligned(table_, lateral_.node(i), roll, yaw);
        to[2 * pose] = own->touch_height(lateral, roll, yaw);
        to[2 * pose + 1] = std::log(own->depth_at_load(lateral, roll, yaw));
      }
    };
  });
  table_.touch = TensorSpline<3, 2>(axes, std::move(values));
}

void TableBuilder::solve_nodes(const Progress& progress) {
  using Contact = TensorSpline<4, table_part_count, float>;
  const Contact::Axes axes{lateral_, roll_, square_, depth_};
  std::vector<double> values(Contact::size_of(axes));
  const std::size_t poses = roll_.count * square_.count;
  constexpr std::size_t parts = table_part_count;
  run_stage(Stage::nodes, lateral_.count, values, progress, [&] {
    return [&, own = nodes()](std::size_t i, double* to) mutable {
      for (std::size_t pose = 0; pose < poses; ++pose, to += depth_.count * parts) {
        const double roll = roll_.node(pose / square_.count);
        const double square = square_.node(pose % square_.count);
        const double yaw = yaw_of(square_, pose % square_.count);
        TensorSpline<3, 2>::Values touch;
        table_.touch.evaluate({lateral_.node(i), roll, square}, touch);
        const double lateral = from_aligned(table_, lateral_.node(i), roll, yaw);
        for (std::size_t level = 1; level < depth_.count; ++level) {
          const double depth = depth_.node(level) * std::exp(touch.value[1]);
          const auto found = own->parts(lateral, touch.value[0] - depth, roll, yaw);
          std::copy(found.begin(), found.end(), to + level * parts);
        }
        for (std::size_t part = 1; part < parts; ++part) { // where forces go to 0, by a parabola
          to[part] = 3.0 * (to[parts + part] - to[2 * parts + part]) + to[3 * parts + part];
        }
      }
    };
  });
  table_.contact = Contact(axes, std::move(values));
}

std::vector<std::pair<double, double>> TableBuilder::errors_of(Stage stage, std::size_t count,
                                                               const Progress& progress) {
  const std::size_t cells = table_.errors.cells().size();
  const std::uint64_t first = // numbers of states that no sample shares
      stage == Stage::errors_of_map ? 0 : 1ULL << (stage == Stage::errors_of_factor ? 32U : 33U);
  std::vector<double> numbers(2 * count);
  run_stage(stage, count, numbers, progress, [&] {
    return [&, own = nodes()](std::size_t i, double* to) mutable {
      const TableState state = random_state(table_, i % cells, first + i / cells);
      to[0] = error_of(table_, state, *own, to[1]);
    };
  });
  std::vector<std::pair<double, double>> errors(count);
  for (std::size_t i = 0; i < count; ++i) {
    errors[i] = {numbers[2 * i], numbers[2 * i + 1]};
  }
  return errors;
}

void TableBuilder::measure_errors(const Progress& progress) {
  const TableRanges& ranges = options_.ranges;
  const ErrorMap::Ranges box{
      {{-ranges.lateral, ranges.lateral}, {0.0, 1.0}, {-ranges.roll, ranges.roll}}};
  const std::size_t cells = counts_.cells[0] * counts_.cells[1] * counts_.cells[2];
  table_.errors = ErrorMap(box, counts_.cells, std::vector<double>(cells));
  const auto part = [&progress](double from, double to) -> Progress {
    return progress ? Progress([&progress, from, to](double share) {
      progress(from + share * (to - from));
    })
                    : Progress();
  };
  table_.measured.map_states = counts_.states_of_cell * cells;
  const auto of_map = errors_of(Stage::errors_of_map, table_.measured.map_states, part(0.0, 0.6));
  std::vector<double> largest(cells);
  for (std::size_t i = 0; i < of_map.size(); ++i) {
    largest[i % cells] = std::max(largest[i % cells], of_map[i].first);
  }
  table_.errors = ErrorMap(box, counts_.cells, largest);

  const std::size_t count = counts_.held_out;
  const auto ratio_at = [](std::vector<double>& ratios, double share) {
    const auto beyond = static_cast<std::size_t>(share * static_cast<double>(ratios.size()));
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() - 1 - std::min(beyond, ratios.size() - 1)];
  };
  std::vector<double> ratios;
  for (const auto& [error, returned] : errors_of(Stage::errors_of_factor, count, part(0.6, 0.8))) {
    ratios.push_back(error / std::max(returned, std::numeric_limits<double>::min()));
  }
  table_.measured.factor = std::max(1.0, ratio_at(ratios, calibrated_share));
  for (double& error : largest) {
    error *= table_.measured.factor;
  }
  table_.errors = ErrorMap(box, counts_.cells, std::move(largest));

  std::vector<double> errors;
  table_.measured.states = count;
  for (const auto& [error, returned] : errors_of(Stage::errors_of_check, count, part(0.8, 1.0))) {
    table_.measured.beyond += error > returned ? 1 : 0;
    errors.push_back(error);
  }
  table_.measured.percentile_99 = ratio_at(errors, 0.01);
  table_.measured.median = errors[errors.size() / 2];
  table_.measured.worst = errors.back();
}

} // namespace

ContactTable build_table(const Scene& scene, const TableOptions& options,
                         const SceneSolver& solver) {
  check_options(options, scene.convention.units);
  check_scene_of_table(scene);
  for (const std::string& name : {scene.left.wheel.name, scene.left.rail.name}) {
    if (!is_name_of_table(name)) {
      throw_invalid_argument("a profile's name", name,
                             "must be text of one line, which a table's file keeps");
    }
  }
  if (scene.left.friction.coefficient != scene.right.friction.coefficient) {
    throw_invalid_argument("friction.right", scene.right.friction.coefficient,
                           "a table has the friction of both wheels: that of the left one is " +
                               text_of(scene.left.friction.coefficient) +
                               "; steps may have others");
  }
  return TableBuilder(scene, options, solver).build();
}

TableState random_state(const ContactTable& table, std::size_t cell, std::uint64_t number) {
  RandomNumbers random(number * table.errors.cells().size() + cell + 1);
  const ErrorMap::Ranges ranges = table.errors.ranges_of(cell);
  const double u = random.between(ranges[0].first, ranges[0].last);
  const double s = random.between(ranges[1].first, ranges[1].last);
  const double roll = random.between(ranges[2].first, ranges[2].last);
  const double yaw = random.between(-table.ranges.yaw, table.ranges.yaw);
  TensorSpline<3, 2>::Values touch;
  table.touch.evaluate({u, roll, yaw * yaw}, touch);
  const TablePose pose = pose_of_taping_point(table, from_aligned(table, u, roll, yaw),
                                              touch.value[0] - s * std::exp(touch.value[1]), roll);
  TableState state;
  state.position = {0.0, pose.lateral, pose.vertical, roll, 0.0, yaw};
  state.friction = random.between(least_drawn_friction, largest_drawn_friction);

  TensorSpline<4, table_part_count, float>::Values found;
  table.contact.evaluate({u, roll, yaw * yaw, s}, found);
  const auto part = [&found](TablePart which) {
    return found.value[static_cast<std::size_t>(which)];
  };
  // Linear forces over friction from 0.05 to 10, in all directions.
  const double direction = random.between(0.0, 2.0 * std::numbers::pi);
  const double ratio = 0.05 * std::pow(200.0, random.next());
  const double p = std::max(part(TablePart::load), 0.0);
  const double bound = state.friction * part(TablePart::normal) * std::sqrt(p); // over p
  const double xi = ratio * std::cos(direction) * bound / part(TablePart::longitudinal_law);
  const double eta = ratio * std::sin(direction) * bound / part(TablePart::lateral_law);
  const double speed = 2e4;
  const Vector3 axle{-std::sin(yaw) * std::cos(roll), std::cos(yaw) * std::cos(roll),
                     std::sin(roll)};
  const Vector3 arm{part(TablePart::arm_x) * yaw, part(TablePart::arm_y), part(TablePart::arm_z)};
  const Vector3 by_pitch = cross(axle, arm);
  const double pitch = (xi - 1.0) * speed / by_pitch.x;
  const double angle = part(TablePart::angle);
  const double turned = pitch * (by_pitch.y * std::cos(angle) + by_pitch.z * std::sin(angle));
  state.velocity = {speed, (eta * speed - turned) / std::cos(angle), 0.0, 0.0, pitch, 0.0};
  return state;
}

} // namespace wrc
