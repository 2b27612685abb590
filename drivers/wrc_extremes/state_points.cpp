// States that a simulation meets and that are no contact as usual: each has a result or a status.
#include <cmath>

#include "wrc_extremes/measure.hpp"

namespace extremes {
namespace {

/// Adds one state; `expected` is what the library promises for it.
class States {
public:
  explicit States(std::vector<Point>& points) : points_(points) {}

  void add(const std::string& name, Verdict expected, const SceneSetup& setup) {
    add_point(name, expected,
              [setup](Row& row, std::uint64_t seed) { measure_scene(setup, row, seed); });
  }
  void add_gap(const std::string& name, Verdict expected, const NormalCase& one) {
    add_point(name, expected,
              [one](Row& row, std::uint64_t seed) { measure_normal(one, row, seed); });
  }

private:
  void add_point(const std::string& name, Verdict expected,
                 const std::function<void(Row&, std::uint64_t)>& measure) {
    points_.push_back({"state", "expected: " + std::string(name_of(expected)), name, ++count_, true,
                       [measure, expected](Row& row, std::uint64_t seed) {
                         measure(row, seed);
                         if (row.verdict != expected) {
                           row.message =
                               "is " + std::string(name_of(row.verdict)) + ": " + row.message;
                           row.verdict = Verdict::wrong;
                         }
                       }});
  }

  std::vector<Point>& points_;
  double count_ = 0.0;
};

SceneSetup at(double lateral) {
  return [lateral](wrcontact::Scene& scene) { scene.set("pose.lateral", lateral); };
}
SceneSetup at_height(double vertical) {
  return [vertical](wrcontact::Scene& scene) { scene.set("pose.vertical", vertical); };
}
SceneSetup loaded(double load) {
  return [load](wrcontact::Scene& scene) { scene.set("load.vertical", load); };
}

NormalCase block(double load, std::optional<double> approach) {
  NormalCase one;
  GapProblem& problem = one.problem;
  problem.rows = 16;
  problem.columns = 12;
  problem.lateral_step = 0.5;
  problem.longitudinal_step = 0.5;
  problem.combined_modulus = 115384.61538461539;
  problem.normal_load = load;
  problem.approach = approach;
  for (std::size_t i = 0; i < problem.count(); ++i) {
    const double x = static_cast<double>(i % 12) - 5.5;
    const double y = static_cast<double>(i / 12) - 7.5;
    problem.distance.push_back(1e-4 * (x * x + y * y));
  }
  one.tolerance = 1e-12;
  return one;
}

} // namespace

void add_state_points(std::vector<Point>& points) {
  States states(points);
  states.add("no load", Verdict::none, loaded(0.0));
  states.add("load below what positions can tell", Verdict::none, loaded(1e-9));
  states.add("height prescribed above the rail", Verdict::none, at_height(461.0));
  states.add("height prescribed, pressed in", Verdict::held, at_height(459.75));
  states.add("height prescribed below the rail", Verdict::refused, at_height(300.0));
  states.add("wheel drop", Verdict::refused, at(-86.0));
  states.add("wheel beyond the rail", Verdict::refused, at(86.0));
  states.add("gauge too wide for the wheelset", Verdict::refused,
             [](wrcontact::Scene& scene) { scene.set("track.gauge", 1700.0); });
  states.add("no roll sets both wheels on the rails", Verdict::refused,
             [](wrcontact::Scene& scene) {
               scene.set("pose.lateral", 70.0);
               scene.set("wheelset.back_to_back", 1300.0);
             });
  states.add("on the flange's tip", Verdict::held, at(45.0));
  states.add("climbing on the flange", Verdict::held, at(10.0));
  states.add("at the edge of the chamfer", Verdict::warned, at(-60.0));
  states.add("on the field-side chamfer", Verdict::held, at(-81.0));
  states.add("leaving the chamfer's end", Verdict::warned, at(-82.2));
  states.add("overload", Verdict::refused, loaded(1e9));
  states.add_gap("gap array: no load", Verdict::none, block(0.0, {}));
  states.add_gap("gap array: approach above contact", Verdict::none, block(0.0, -1.0));
  states.add_gap("gap array: approach at first touch", Verdict::none, block(0.0, 5e-5));
  states.add_gap("gap array: one element", Verdict::held, block(1e-3, {}));
  states.add_gap("gap array: whole grid in contact", Verdict::held, block(1e6, {}));
}

} // namespace extremes
