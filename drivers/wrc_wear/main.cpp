// wrc_wear: wears a wheel profile over a mission of straight track and curves. The vehicle is
// reduced to where its wheelsets run; see docs/damage.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "reports/warning_summary.hpp"
#include "reports/worn_profile.hpp"
#include "support/gnuplot.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/parallel.hpp"
#include "support/program.hpp"
#include "support/scene_file.hpp"
#include "wrc_wear/mission.hpp"

namespace driver {
namespace {

constexpr double half_head = 32.5;    // from the gauge face to the contact, mm
constexpr double largest_step = 0.05; // of wear, from one update of the profile to the next, mm

/// A position of a wheelset in which part of the distance is run.
struct Passage {
  double curvature; // 1/mm, left-hand curves
  double speed;     // mm/s
  double lateral;   // mm to the left
  double yaw;       // rad
  double share;     // of the distance
};

/// Displacement to the right (outwards in a left-hand curve) at which radii differ by `wanted`; the
/// clearance of the flange, if they never do.
double lateral_for(Scene& scene, double wanted, double clearance) {
  scene.set("solve.until", "geometry");
  Solver solver; // reads profiles once
  double before = 0.0;
  for (double lateral = 0.0; lateral <= clearance; lateral += 0.25) {
    scene.set("pose.lateral", -lateral);
    solver.solve(scene);
    const double difference = -scene.number("rolling_radius_difference");
    if (difference >= wanted) {
      return lateral == 0.0 ? 0.0 : lateral - 0.25 * (difference - wanted) / (difference - before);
    }
    before = difference;
  }
  return clearance;
}

struct Options {
  std::string wheel = "S1002";
  std::string rail;
  std::string mission;
  std::string plot;
  std::string save;
  double distance = 20000.0;
  int threads = 2;
  std::vector<std::string> assignments;
};

/// `rail`: instead of that of the keys, if there is one.
Scene scene_on(const WornProfile& wheel, const std::optional<Profile>& rail,
               const Options& options) {
  Scene scene;
  scene.set("solve.accuracy", 1e-2);
  scene.set("solve.accuracy_of", "forces");
  scene.set("solve.results", "wear");
  scene.set("motion.pitch", "free");
  apply_assignments(scene, options.assignments);
  scene.set("wheelset.wheel", wheel.profile());
  if (rail) {
    use_rail(scene, *rail, options.rail);
  }
  return scene;
}

/// Wheelsets in straight track wander to both sides. In curves the leading one of a bogie runs
/// outwards with an angle of attack of half the wheelbase over the radius, as far as radii demand
/// or the flange permits; the trailing one stands radially at half of that.
std::vector<Passage> passages_of(Scene scene, const Mission& mission) {
  const double radius = scene.get_number("wheelset.radius");
  const double half_track = 0.5 * scene.get_number("track.gauge") + half_head;
  std::vector<Passage> passages;
  for (const Curve& curve : mission.curves) {
    if (curve.radius == 0.0) {
      constexpr std::array weights{1.0, 2.0, 3.0, 2.0, 1.0};
      for (std::size_t i = 0; i < weights.size(); ++i) {
        passages.push_back({0.0, 1e3 * curve.speed,
                            0.5 * mission.wander * (static_cast<double>(i) - 2.0), 0.0,
                            curve.share * weights[i] / 9.0});
      }
      continue;
    }
    const double curvature = 1e-3 / curve.radius;
    const double outwards =
        lateral_for(scene, 2.0 * half_track * radius * curvature, mission.clearance);
    const double yaw = -0.5 * mission.wheelbase * curvature;
    passages.push_back({curvature, 1e3 * curve.speed, -outwards, yaw, 0.5 * curve.share});
    passages.push_back({curvature, 1e3 * curve.speed, -0.5 * outwards, 0.0, 0.5 * curve.share});
  }
  return passages;
}

/// What a passage takes off per distance rolled.
struct Worn {
  double volume = 0.0;       ///< of the mean wheel, mm^2
  std::vector<double> s;     ///< positions on the wheel ...
  std::vector<double> areas; ///< ... and what goes there, mm^2
  std::vector<Warning> warnings{};
};

/// Each wheel is as often the left as the right one.
Worn worn_by(Scene scene, const Passage& passage) {
  scene.set("motion.speed", passage.speed);
  scene.set("motion.curvature", passage.curvature);
  scene.set("pose.lateral", passage.lateral);
  scene.set("pose.yaw", passage.yaw);
  scene.solve();
  Worn worn;
  worn.warnings = warnings_of(scene);
  for (const std::string side : side_names) {
    worn.volume += 0.5 * passage.share * scene.number_or(side + ".wear.volume", 0.0);
    const int patches = scene.count_of(side + ".patches");
    for (int i = 0; i < patches; ++i) {
      const std::string whole = side + ".patches." + std::to_string(i) + '.';
      const int parts = scene.count_of(whole + "parts");
      for (int k = 0; k < std::max(parts, 1); ++k) {
        const std::string name = parts > 0 ? whole + "parts." + std::to_string(k) + '.' : whole;
        const double width = scene.number_or(name + "creep_element_size.lateral", 0.0);
        const std::vector<double> places = scene.field(name + "wear_s_wheel");
        worn.s.insert(worn.s.end(), places.begin(), places.end());
        for (const double depth : scene.field(name + "wear_depth")) {
          worn.areas.push_back(0.5 * passage.share * depth * width);
        }
      }
    }
  }
  return worn;
}

void draw(const WornProfile& profile, const std::string& path, const std::string& title) {
  Gnuplot gnuplot;
  gnuplot.begin_multiplot(2, 1, title);
  gnuplot.script() << "set lmargin 9\nset rmargin 3\nset xrange [-45:45]\nset yrange [*:*] "
                      "reverse\nset size ratio -1\n"
                      "set ylabel 'larger radius downwards, mm'\nset key bottom right\n"
                      "set xlabel 's from the taping line, mm (to the field side)'\n";
  const auto heights = [&](const wrcontact::Profile::Points& points) {
    return gnuplot.block(points.lateral, points.height);
  };
  gnuplot.plot(
      {heights(profile.fresh()) + " with lines lw 1.5 lc rgb '" + colour::quiet + "' title 'new'",
       heights(profile.points()) + " with lines lw 2 lc rgb '" + colour::marked +
           "' title 'worn'"});
  gnuplot.script() << "set size noratio\nset yrange [0:*] noreverse\n"
                      "set ylabel 'worn off along the normal, mm'\n";
  gnuplot.plot({gnuplot.block(profile.fresh().lateral, profile.depths()) +
                " with lines lw 2 lc rgb '" + colour::marked + "' notitle"});
  gnuplot.draw(path, 900, 900);
}

/// Mistakes that show before the mission begins.
void check(const Options& options) {
  if (!options.plot.empty()) {
    require_picture_name(options.plot);
  }
  std::vector<std::filesystem::path> inputs = files_of(options.wheel, options.rail);
  inputs.emplace_back(options.mission);
  refuse_overwriting({options.plot, options.save}, inputs);
  for (const std::string& text : options.assignments) {
    const std::string key = split_assignment(text).key;
    const bool of_wheel = key == "wheelset.wheel" || profile_of(key) == "wheelset.wheel";
    const bool of_rail = !options.rail.empty() && profile_of(key) == "track.rail";
    if (of_wheel || of_rail || key.starts_with("convention.")) {
      throw Failure("--set " + text + ": must be a key other than " + key +
                    (of_wheel  ? ", for which there is --wheel"
                     : of_rail ? ", for which there is --rail"
                               : ""));
    }
  }
}

/// Wears the wheel over the mission and prints how it goes.
void run(Options options) {
  check(options);
  const Mission mission = options.mission.empty() ? Mission() : read_mission(options.mission);
  if (!options.rail.empty()) {
    options.assignments.push_back("track.rail=" + options.rail);
  }
  Scene plain;
  apply_assignments(plain, options.assignments); // refuses wrong ones before the table begins
  refuse_varying(plain, "in a mission");
  const double radius = plain.get_number("wheelset.radius");
  const Profile wheel = load_profile(plain, WRC_WHEEL, options.wheel);
  std::optional<Profile> rail; // read once
  if (!options.rail.empty()) {
    rail = load_profile(plain, WRC_RAIL, options.rail);
  }
  for (const std::string& warning : wheel.warnings()) {
    std::cerr << "wrc_wear: " << one_line(options.wheel) << ": " << one_line(warning) << '\n';
  }
  WornProfile profile(wheel, 0.25);
  double done = 0.0; // km
  double volume = 0.0;
  std::cout << "      km   depth mm   missing mm2      worn mm2   difference\n";
  int updates = 0;
  WarningSummary warnings;
  std::int64_t solved = 0;
  while (done < options.distance) {
    const std::vector<Passage> passages = passages_of(scene_on(profile, rail, options), mission);
    std::vector<Scene> scenes; // made by one thread: a profile serves one at a time
    for (std::size_t i = 0; i < passages.size(); ++i) {
      scenes.push_back(scene_on(profile, rail, options));
    }
    std::vector<Worn> worn(passages.size());
    for_each_index(passages.size(), options.threads,
                   [&](std::size_t i) { worn[i] = worn_by(std::move(scenes[i]), passages[i]); });
    profile.clear();
    double rate = 0.0; // mm^2 per distance rolled, no unit
    for (const Worn& each : worn) {
      warnings.add(solved++, each.warnings);
      rate += each.volume;
      for (std::size_t i = 0; i < each.s.size(); ++i) {
        profile.add(each.s[i], each.areas[i]);
      }
    }
    // Per turn the profile loses the volume per distance rolled.
    const double turns_per_km = 1e6 / (2.0 * std::numbers::pi * radius);
    const double step =
        std::min(options.distance - done, largest_step / (profile.noted_depth() * turns_per_km));
    profile.wear(step * turns_per_km);
    volume += step * turns_per_km * rate;
    done += step;
    ++updates;
    if (updates % 10 == 0 || done >= options.distance) {
      const std::vector<double> depths = profile.depths();
      const double missing = profile.missing_area();
      std::cout << std::fixed << std::setw(8) << std::setprecision(0) << done << std::setw(11)
                << std::setprecision(3) << *std::max_element(depths.begin(), depths.end())
                << std::setw(14) << std::setprecision(6) << missing << std::setw(14) << volume
                << std::scientific << std::setw(13) << std::setprecision(1)
                << missing / volume - 1.0 << std::endl;
    }
  }
  std::cerr << warnings.text("wrc_wear", solved);
  if (!options.save.empty()) {
    profile.profile().write(options.save, 0.25);
  }
  if (!options.plot.empty()) {
    draw(profile, options.plot,
         without_markup(std::filesystem::path(profile_name("wheelset.wheel", options.wheel))
                            .filename()
                            .string()) +
             " after " + general(options.distance, 6) + " km, worn area " + fixed(volume, 1) +
             " mm^2");
  }
}

} // namespace
} // namespace driver

int main(int argc, char** argv) {
  using namespace driver;
  Program app("wrc_wear",
              "Simulates the wear of a wheel profile on a mission of straight track and curves. "
              "Wear is computed on each element and summed along the profile, which is updated "
              "after at most 0.05 mm of wear; smoothing keeps the worn area.");
  Options options;
  app.add("--wheel", options.wheel, "wheel at the start, built-in name or file")
      .type("NAME|FILE")
      .show_default();
  app.add("--rail", options.rail, "rail, built-in name or file; default 60E1").type("NAME|FILE");
  app.add("--mission", options.mission, "curves, speeds and shares of the distance, see below")
      .type("FILE.toml");
  app.add("--distance", options.distance, "distance to run, km").within(1.0, 1e7).show_default();
  app.add("--threads", options.threads, "number of threads; results do not depend on it")
      .within(1, 256)
      .show_default();
  app.add("--plot", options.plot, "draw the new and the worn profile and the depth of wear")
      .type("FILE.png|svg");
  app.add("--save", options.save, "write the worn profile, as wrc_profile --convert does")
      .type("FILE");
  app.add("--set", options.assignments,
          "set a key in all scenes, such as wear.law=archard; may be repeated")
      .type("KEY=VALUE")
      .one_value_each();
  app.footer(std::string("\nA mission file, with the mission that is used without one:\n\n") +
             mission_text +
             "\nExamples:\n"
             "  wrc_wear --plot wear.png\n"
             "  wrc_wear --wheel worn.prw --rail 54E3 --mission line.toml --distance 50000 "
             "--save later.prw\n");
  return app.run(argc, argv, [&] {
    run(options);
    return 0;
  });
}
