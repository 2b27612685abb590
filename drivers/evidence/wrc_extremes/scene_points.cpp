// Wheel/rail scenes: the paper's Table 1, and the same with the left wheel at its flange.
#include <algorithm>
#include <cmath>

#include "wrc_extremes/measure.hpp"

namespace extremes {
namespace {

struct Base {
  const char* name;
  double lateral; ///< mm
};
constexpr Base table1{"Table 1", 0.0};
constexpr Base flange{"flange, y = 6.5 mm", 6.5};

/// A point of one key, and more settings that go with it.
Point key_point(const std::string& quantity, const Base& base, const std::string& key, double value,
                const char* unit, bool quick, const SceneSetup& more = {}) {
  return {quantity,
          base.name,
          in_words(key, value, unit),
          value,
          quick,
          [base, key, value, more](Row& row, std::uint64_t seed) {
            measure_scene(
                [&](wrcontact::Scene& scene) {
                  scene.set("pose.lateral", base.lateral);
                  if (more) {
                    more(scene);
                  }
                  scene.set(key, value);
                },
                row, seed);
          }};
}

void add_scene_loads(std::vector<Point>& points) {
  for (const Base& base : {table1, flange}) {
    for (int exponent = -8; exponent <= 13; ++exponent) {
      points.push_back(key_point("load", base, "load.both", std::pow(10.0, exponent), " N",
                                 base.lateral == 0.0 && (exponent == -8 || exponent == -6 ||
                                                         exponent == 5 || exponent == 9)));
    }
  }
}

void add_materials(std::vector<Point>& points) {
  for (const Base& base : {table1, flange}) {
    for (const double modulus : {0.5, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 2e9}) {
      points.push_back(key_point("modulus", base, "material.youngs_modulus", modulus, " MPa",
                                 base.lateral == 0.0 && (modulus == 0.5 || modulus == 1e3 ||
                                                         modulus == 1e5 || modulus == 1e9)));
    }
  }
  for (int exponent = -9; exponent <= 9; ++exponent) {
    const double ratio = std::pow(10.0, exponent);
    // Around the geometric mean, so that both moduli stay within 1e3 and 1e9 MPa up to 1e6.
    const double rail = 1e6 / std::sqrt(ratio);
    points.push_back(key_point(
        "modulus-ratio", table1, "material.wheel.youngs_modulus", 1e6 * std::sqrt(ratio), " MPa",
        exponent % 6 == 0,
        [rail](wrcontact::Scene& scene) { scene.set("material.rail.youngs_modulus", rail); }));
    points.back().value = ratio;
    points.back().setting = in_words("wheel/rail", ratio);
  }
  for (const double poisson : {-0.01, 0.0, 0.1, 0.2, 0.3, 0.4, 0.45, 0.49, 0.5, 0.51}) {
    points.push_back(key_point("poisson", table1, "material.poisson", poisson, "",
                               poisson < 0.05 || poisson > 0.49));
  }
}

void add_wheelsets(std::vector<Point>& points) {
  for (const Base& base : {table1, flange}) {
    for (const double radius : {49.0, 50.0, 70.0, 100.0, 150.0, 200.0, 300.0, 460.0, 700.0, 1000.0,
                                2000.0, 3500.0, 5000.0, 5001.0}) {
      points.push_back(key_point("radius", base, "wheelset.radius", radius, " mm",
                                 base.lateral == 0.0 && (radius < 60.0 || radius > 4000.0)));
    }
    for (int mrad = -210; mrad <= 210; mrad += mrad < -100 || mrad >= 100 ? 10 : 20) {
      points.push_back(key_point("yaw", base, "pose.yaw", 1e-3 * mrad, " rad",
                                 base.lateral == 0.0 && (mrad % 100 == 0 || mrad == 210)));
    }
    for (int mrad = -210; mrad <= 210; mrad += mrad < -50 || mrad >= 50 ? 20 : 10) {
      points.push_back(key_point("roll", base, "pose.roll", 1e-3 * mrad, " rad",
                                 base.lateral == 0.0 && (mrad % 50 == 0 || mrad == 210)));
    }
  }
}

void add_laterals(std::vector<Point>& points) {
  const Base solved{"roll solved", 0.0};
  const Base level{"no roll", 0.0};
  for (int y = -102; y <= 102; y += y >= -12 && y < 12 ? 1 : 2) {
    points.push_back(key_point("lateral", solved, "pose.lateral", y, " mm", y % 51 == 0));
    points.push_back(key_point("lateral", level, "pose.lateral", y, " mm", false,
                               [](wrcontact::Scene& scene) { scene.set("pose.roll", 0.0); }));
  }
}

void add_tracks(std::vector<Point>& points) {
  for (const Base& base : {table1, flange}) {
    for (int percent = -21; percent <= 21; percent += percent == -21 || percent == 20 ? 1 : 2) {
      points.push_back(
          key_point("inclination", base, "track.inclination", std::atan(0.01 * percent), " rad",
                    base.lateral == 0.0 && (percent == -20 || percent == 20 || percent == 21)));
    }
  }
  for (const double gauge : {599.0, 600.0, 700.0, 850.0, 1000.0, 1067.0, 1200.0, 1435.0, 1520.0,
                             1600.0, 1676.0, 1700.0, 1701.0}) {
    points.push_back(key_point(
        "gauge", {"Table 1, wheels follow", 0.0}, "track.gauge", gauge, " mm",
        gauge < 650.0 || gauge > 1690.0,
        [gauge](wrcontact::Scene& scene) { scene.set("wheelset.back_to_back", gauge - 75.0); }));
    points.push_back(key_point("gauge", {"Table 1, wheels stay", 0.0}, "track.gauge", gauge, " mm",
                               gauge == 600.0));
  }
}

/// Grid that prescribed grids are compared with: four times the rows, within 512 to 2048. An
/// automatic grid does not suffice, since the finest accuracy is 1e-5.
std::vector<double> reference_grid(int rows) {
  const double finer = std::clamp(4 * rows, 512, 2048);
  return {finer, 0.5 * finer};
}

/// Accuracies, and prescribed grids and tolerances.
void add_solving(std::vector<Point>& points) {
  for (const double accuracy : {0.2, 0.1, 0.03, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 9e-6}) {
    points.push_back({"accuracy", table1.name, in_words("solve.accuracy", accuracy), accuracy,
                      accuracy > 0.05 || accuracy < 1e-5, [accuracy](Row& row, std::uint64_t seed) {
                        measure_scene(
                            [accuracy](wrcontact::Scene& scene) {
                              scene.set("pose.lateral", 3.0);
                              scene.set("solve.accuracy", accuracy);
                            },
                            row, seed,
                            {accuracy > 5e-5 ? std::max(1e-5, 0.2 * accuracy) : 0.0, false});
                      }});
  }
  for (const int rows : {1, 2, 3, 4, 6, 8, 16, 32, 64, 128, 256, 512, 1024, 8193}) {
    for (const int columns : {std::max(1, rows / 2), rows == 1024 ? 4 : 0}) {
      if (columns == 0) {
        continue;
      }
      const std::string size = std::to_string(rows) + " x " + std::to_string(columns);
      points.push_back(
          {"scene-grid", table1.name, "solve.grid " + size,
           static_cast<double>(rows) * static_cast<double>(columns),
           rows <= 6 || rows == 16 || rows > 8192, [rows, columns](Row& row, std::uint64_t seed) {
             measure_scene(
                 [=](wrcontact::Scene& scene) {
                   scene.set("pose.lateral", 3.0);
                   scene.set("solve.grid", std::vector<double>{static_cast<double>(rows),
                                                               static_cast<double>(columns)});
                   scene.set("solve.tolerance", 1e-6);
                 },
                 row, seed, {0.0, false, reference_grid(rows)});
           }});
    }
  }
}

} // namespace

void add_scene_points(std::vector<Point>& points) {
  add_scene_loads(points);
  add_materials(points);
  add_wheelsets(points);
  add_laterals(points);
  add_tracks(points);
  add_solving(points);
}

namespace {

/// States that a simulation meets and that are no contact as usual: each has a result or a status.
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
  void add_point(const std::string& name, Verdict expected, const Measurement& measure) {
    points_.push_back({"state", "expected: " + std::string(name_of(expected)), name, ++count_, true,
                       [measure, expected](Row& row, std::uint64_t seed) {
                         extremes::measure(measure, row, seed);
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
  return [load](wrcontact::Scene& scene) { scene.set("load.both", load); };
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
  states.add("load below the rounding of positions", Verdict::none, loaded(1e-9));
  states.add("height prescribed above the rail", Verdict::none, at_height(461.0));
  states.add("height prescribed, pressed in", Verdict::held, at_height(459.75));
  states.add("height prescribed below the rail", Verdict::refused, at_height(300.0));
  states.add("wheel drop", Verdict::refused, at(-86.0));
  states.add("wheel beyond the rail", Verdict::refused, at(86.0));
  states.add("gauge too wide for the wheelset", Verdict::refused,
             [](wrcontact::Scene& scene) { scene.set("track.gauge", 1700.0); });
  states.add("no roll brings both wheels onto the rails", Verdict::refused,
             [](wrcontact::Scene& scene) {
               scene.set("pose.lateral", 70.0);
               scene.set("wheelset.back_to_back", 1300.0);
             });
  states.add("on the flange's tip", Verdict::warned, at(45.0));
  states.add("climbing on the flange", Verdict::warned, at(10.0));
  states.add("at the edge of the chamfer", Verdict::warned, at(-60.0));
  states.add("on the field-side chamfer", Verdict::warned, at(-81.0));
  states.add("leaving the chamfer's end", Verdict::warned, at(-82.2));
  states.add("overload", Verdict::refused, loaded(1e9));
  states.add_gap("gap array: no load", Verdict::none, block(0.0, {}));
  states.add_gap("gap array: approach above contact", Verdict::none, block(0.0, -1.0));
  states.add_gap("gap array: approach at first touch", Verdict::none, block(0.0, 5e-5));
  states.add_gap("gap array: one element", Verdict::held, block(1e-3, {}));
  states.add_gap("gap array: whole grid in contact", Verdict::held, block(1e6, {}));
}

} // namespace extremes
