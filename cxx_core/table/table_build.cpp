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
#include "table/table_file.hpp"
#include "table/table_nodes.hpp"
#include "table/table_work.hpp"

namespace wrc {
namespace {

/// Numbers of nodes that follow from the fineness.
struct Counts {
  std::size_t lateral, roll, depth;
  std::size_t yaw = 4; // of its square: forces of both signs alike
  CreepLawNodes law;
};

std::size_t at_least(double least, double count) {
  return static_cast<std::size_t>(std::lround(std::max(least, count)));
}

Counts counts_of(const TableOptions& options) {
  const double fine = options.fineness;
  const double length = 2.0 * options.ranges.lateral; // mm
  Counts counts{};
  counts.lateral = at_least(8.0, 20.0 * length * fine) + 1;
  counts.roll = at_least(4.0, 13.0 * fine);
  counts.depth = at_least(6.0, 12.0 * fine);
  counts.law.translation = 2 * at_least(4.0, 14.0 * std::min(fine, 2.0)) + 1;
  counts.law.spin = 2 * at_least(3.0, 14.0 * std::min(fine, 2.0)) + 1;
  counts.law.ratio = at_least(4.0, 9.0 * std::min(fine, 2.0));
  counts.law.elements = at_least(20.0, 32.0 * std::min(fine, 2.0));
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
  const double bytes = 4.0 * (table_part_count + place_part_count) *
                       static_cast<double>(counts.lateral) * static_cast<double>(counts.roll) *
                       static_cast<double>(counts.yaw) * static_cast<double>(counts.depth);
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

class TableBuilder {
public:
  TableBuilder(const Scene& scene, const TableOptions& options, const SceneSolver& solver)
      : work_{scene, options, solver, {}, {}}, counts_(counts_of(options)) {
    table_.ranges = options.ranges;
    table_.version = options.version;
    table_.identity = identity_of_table(scene);
    table_.convention = scene.convention;
    table_.friction = scene.left.friction.coefficient;
    table_.standstill_speed = scene.standstill_speed;
    work_.nodes()->measure();
    const TableRanges& ranges = options.ranges;
    lateral_ = SplineAxis(-ranges.lateral, ranges.lateral, counts_.lateral);
    roll_ = SplineAxis(-ranges.roll, ranges.roll, counts_.roll);
    square_ = SplineAxis(0.0, ranges.yaw * ranges.yaw, counts_.yaw);
    depth_ = SplineAxis(0.0, 1.0, counts_.depth);
    if (!options.resume_file.empty()) {
      work_.finished.emplace(options.resume_file, inputs());
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
    if (work_.finished) {
      work_.finished->write();
    }
  }

  void make() {
    const auto part = [this](double from, double to) { return work_.part_of_progress(from, to); };
    const double poisson =
        shear_constants(work_.scene.wheel_material, work_.scene.rail_material).poisson;
    table_.law = CreepLaw::make(poisson, counts_.law, options_.threads, part(0.0, 0.1));
    align();
    find_touch(part(0.1, 0.15));
    solve_nodes(part(0.15, 0.6));
    fit_table(work_, part(0.6, 0.65));
    measure_table(work_, part(0.65, 1.0));
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
      const KeyValue value = key_value(work_.scene, key.name);
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

  void align();
  void find_touch(const Progress& progress);
  void solve_nodes(const Progress& progress);

  TableWork work_;
  ContactTable& table_ = work_.table;
  const TableOptions& options_ = work_.options;
  const Counts counts_;
  SplineAxis lateral_, roll_, square_, depth_;
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
  const std::unique_ptr<TableNodes> solver = work_.nodes();
  const double range = options_.ranges.lateral;
  const double middle = flange_of(*solver, range, 0.0, yaw_of(square_, 0));
  run_tasks(std::isnan(middle) ? 0 : shifts.size(), options_.threads, {}, [&] {
    return [&, own = work_.nodes()](std::size_t task) mutable {
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
  work_.run_stage(Stage::touch, lateral_.count, values, progress, [&] {
    return [&, own = work_.nodes()](std::size_t i, double* to) mutable {
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
  using Places = TensorSpline<4, place_part_count, float>;
  const Contact::Axes axes{lateral_, roll_, square_, depth_};
  constexpr std::size_t parts = table_part_count + place_part_count;
  const std::size_t nodes_in_all = Contact::size_of(axes) / table_part_count;
  std::vector<double> values(parts * nodes_in_all);
  const std::size_t poses = roll_.count * square_.count;
  work_.run_stage(Stage::nodes, lateral_.count, values, progress, [&] {
    return [&, own = work_.nodes()](std::size_t i, double* to) mutable {
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
  const auto part_of_nodes = [&](std::size_t first, std::size_t count) {
    std::vector<double> chosen;
    chosen.reserve(count * nodes_in_all);
    for (std::size_t node = 0; node < nodes_in_all; ++node) {
      const auto from = values.begin() + static_cast<std::ptrdiff_t>(parts * node + first);
      chosen.insert(chosen.end(), from, from + static_cast<std::ptrdiff_t>(count));
    }
    return chosen;
  };
  table_.contact = Contact(axes, part_of_nodes(0, table_part_count));
  table_.places = Places(axes, part_of_nodes(table_part_count, place_part_count));
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

} // namespace wrc
