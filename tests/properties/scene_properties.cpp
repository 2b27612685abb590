#include "scene_properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace properties {

namespace {

/// Sums of a few thousand pressures round.
constexpr double summation = 1e-10;
/// Of the conversion of units, on the way in and out.
constexpr double conversion = 1e-12;
/// Where patches interact their influence is interpolated (docs/results.md).
constexpr double interpolation = 2e-3;
/// The same where contact reaches the boundary between them, which a warning tells.
constexpr double boundary = 5e-2;

std::string differ(const std::string& what, double one, double other) {
  std::ostringstream text;
  text.precision(17);
  text << what << ": " << one << " and " << other;
  return text.str();
}

bool near(double one, double other, double share) {
  if (std::isnan(one) && std::isnan(other)) { // absent in both
    return true;
  }
  return std::abs(one - other) <= share * std::max(std::abs(one), std::abs(other));
}

bool is_half_space(const DrawnScene& scene) {
  return scene.text_or("solve.model", "half-space") == "half-space";
}

std::string patch_name(const std::string& side, int index) {
  return side + ".patches." + std::to_string(index);
}

std::string other_side(const std::string& name) {
  if (name.starts_with("left.")) {
    return "right." + name.substr(5);
  }
  return name.starts_with("right.") ? "left." + name.substr(6) : name;
}

/// Whether a number changes its sign in the mirror; moments are axial vectors.
bool turns(const std::string& name) {
  if (name.ends_with("wheel_angle") || name.ends_with("moment.y") || name.starts_with("spread.")) {
    return false;
  }
  for (const char* end : {"roll", ".y", "lateral_force", "angle", "moment.x", "moment.z",
                          "rolling_radius_difference"}) {
    if (name.ends_with(end)) {
      return true;
    }
  }
  return false;
}

bool is_force(const std::string& name) {
  return name.ends_with("_force") || name.ends_with("force.x") || name.ends_with("force.y") ||
         name.ends_with("force.z");
}

bool is_moment(const std::string& name) {
  return name.find("moment.") != std::string::npos;
}

bool is_stress(const std::string& name) {
  constexpr std::array ends{"pmax",         "pmax_elastic",  "pmax_element", "stress.von_mises_max",
                            "stress.shear", "stress.tension"};
  return std::any_of(ends.begin(), ends.end(),
                     [&name](const char* end) { return name.ends_with(end); });
}

/// How accurate a side's depth is as it says itself: as asked, or as estimated on a grid that was
/// given; none if it says that it is not.
std::optional<double> told_accuracy(const DrawnScene& scene, const Outcome& outcome,
                                    const std::string& side) {
  if (outcome.is_told_inaccurate(side)) {
    return std::nullopt;
  }
  if (!scene.has_grid() || !is_half_space(scene)) {
    return scene.accuracy();
  }
  const std::string estimate = side + ".error_estimate";
  return outcome.has(estimate) ? std::optional(outcome.at(estimate)) : std::nullopt;
}

/// The first part's name; whether there is one tells whether a patch has parts.
std::string first_part(const std::string& patch) {
  return patch + ".parts.0";
}

bool is_vertical(const DrawnScene& scene) {
  return scene.text_or("solve.method", "auto") == "paper";
}

/// Share of a plane's normal across the rail that is across it: planes of vertical gaps are yawed.
double share_across(const DrawnScene& scene) {
  return is_vertical(scene) && scene.has("pose.yaw") ? std::cos(scene.number("pose.yaw")) : 1.0;
}

/// Of a patch, along the normal of its plane.
double force_along_normal(const Outcome& outcome, const std::string& patch, double across) {
  const double angle = outcome.at(patch + ".plane_angle");
  return std::abs(outcome.at(patch + ".vertical_force") * std::cos(angle) -
                  outcome.at(patch + ".lateral_force") * std::sin(angle) * across);
}

/// A patch or a part of one. `across`: share of the plane's normal across the rail that is across
/// it.
std::string check_patch(const Outcome& outcome, const std::string& patch, double across,
                        bool is_curved) {
  const std::vector<double>& pressure = outcome.pressures.at(patch);
  const double element = outcome.at(patch + ".element_size.lateral") *
                         outcome.at(patch + ".element_size.longitudinal");
  double sum = 0.0;
  double largest = 0.0;
  for (const double p : pressure) {
    if (!(p >= 0.0) || !std::isfinite(p)) {
      return patch + " has a pressure of " + std::to_string(p);
    }
    sum += p * element;
    largest = std::max(largest, p);
  }
  // Whatever the inclination of the rail's surface, along the plane's normal pressures add up to
  // the force; those along a curve do but for the turn of their normals.
  const bool has_plane = outcome.has(patch + ".plane_error");
  const double along = force_along_normal(outcome, patch, across);
  const double turn = has_plane && is_curved ? outcome.at(patch + ".turn") : 0.0;
  if (!near(sum, has_plane ? along : outcome.at(patch + ".normal_force"),
            summation + turn * turn)) {
    return differ(patch + ", sum of pressures and force", sum, along);
  }
  // Fields of a whole are means over its elements.
  const double told = outcome.at(patch + ".pmax_element");
  const bool is_whole = outcome.has(first_part(patch) + ".pmax");
  if (std::isnan(told)) { // an end of a body leaves them without a bound
    return "";
  }
  if (is_whole ? largest > (1.0 + summation) * told : !near(largest, told, summation)) {
    return differ(patch + ", largest pressure", largest, outcome.at(patch + ".pmax_element"));
  }
  return "";
}

std::string check_load(const DrawnScene& scene, const Outcome& outcome, const std::string& side) {
  constexpr double share = 1e-8;
  if (scene.has("pose.vertical")) {
    return "";
  }
  if (!scene.has("load.of")) {
    const double load = scene.number("load." + side);
    const double force = outcome.at(side + ".pressure_force.z");
    return near(force, load, share) ? "" : differ(side + ", force and load", force, load);
  }
  // Along the force of the deepest patch, whichever that is; or along the gap.
  const double load = scene.number("load.both");
  if (is_vertical(scene)) {
    const double force = force_along_normal(outcome, patch_name(side, 0), share_across(scene));
    return near(force, load, share) ? "" : differ(side + ", force and load", force, load);
  }
  double force = 0.0;
  for (int main = 0; outcome.has(patch_name(side, main) + ".pmax"); ++main) {
    force = 0.0;
    for (int i = 0; outcome.has(patch_name(side, i) + ".pmax"); ++i) {
      const double turn = outcome.at(patch_name(side, i) + ".angle") -
                          outcome.at(patch_name(side, main) + ".angle");
      force += outcome.at(patch_name(side, i) + ".normal_force") * std::cos(turn);
    }
    if (near(force, load, share)) {
      return "";
    }
  }
  return differ(side + ", force and load", force, load);
}

} // namespace

wrc_status status_of(wrcontact::Scene& scene) {
  return wrc_scene_solve(scene.handle());
}

Outcome solved(const DrawnScene& drawn, bool with_fields) {
  wrcontact::Scene scene = drawn.made();
  const wrc_status status = status_of(scene);
  return {scene, status, with_fields};
}

/// A largest pressure above this needs a warning of its reason, MPa.
constexpr double implausible_pressure = 1e4;

/// A largest pressure or traction without a bound, or without one that elements show, and a warning
/// says so; a spread where points do not tell their noise, or cannot be smoothed.
bool is_withheld(const Outcome& outcome, const std::string& name, double value) {
  const bool is_peak = name.ends_with(".pmax") || name.ends_with(".pmax_elastic") ||
                       name.ends_with(".pmax_element") || name.ends_with(".traction_max");
  return std::isnan(value) &&
         (name.find("spread.") != std::string::npos ||
          name.find("smoothed_") != std::string::npos ||
          (is_peak && outcome.warns(name.substr(0, name.find('.')), "pressures have no bound")));
}

std::string check_equilibrium(const DrawnScene& scene, const Outcome& outcome) {
  for (const auto& [name, value] : outcome.numbers) {
    if (!std::isfinite(value) && !is_withheld(outcome, name, value)) {
      return name + " is not finite";
    }
  }
  for (const std::string& side : outcome.sides()) {
    if (outcome.at(side + ".pmax") > implausible_pressure &&
        outcome.at(side + ".warning_count") == 0.0) {
      return side + ".pmax has no warning";
    }
    int patches = 0; // as they were solved
    const double across = share_across(scene);
    for (const auto& [patch, pressure] : outcome.pressures) {
      if (!patch.starts_with(side)) {
        continue;
      }
      patches += outcome.has(first_part(patch) + ".pmax") ? 0 : 1;
      if (is_half_space(scene)) {
        const bool is_curved = scene.text_or("solve.curved", "no") != "no";
        if (std::string wrong = check_patch(outcome, patch, across, is_curved); !wrong.empty()) {
          return wrong;
        }
      }
    }
    if (outcome.status != WRC_OK || !is_half_space(scene)) {
      continue;
    }
    if (patches > 0) {
      if (std::string text = check_load(scene, outcome, side); !text.empty()) {
        return text;
      }
    }
    const std::string estimate = side + ".error_estimate";
    if (outcome.is_told_inaccurate(side) && !outcome.has(estimate)) {
      continue; // without an estimate nothing is promised
    }
    const double accuracy =
        std::max(scene.accuracy(), outcome.is_told_inaccurate(side) ? outcome.at(estimate) : 0.0);
    const double tolerance = accuracy + (patches < 2                           ? 0.0
                                         : outcome.warns(side, "neighbouring") ? boundary
                                                                               : interpolation);
    if (outcome.has(side + ".residuals.complementarity") &&
        !(outcome.at(side + ".residuals.complementarity") <= tolerance &&
          outcome.at(side + ".residuals.least_gap") >= -tolerance)) {
      return differ(side + ", complementarity and least gap",
                    outcome.at(side + ".residuals.complementarity"),
                    outcome.at(side + ".residuals.least_gap"));
    }
  }
  return "";
}

std::string check_mirror(const DrawnScene& scene, const Outcome& outcome) {
  const Outcome mirrored = solved(scene.mirrored());
  if (mirrored.status != outcome.status) {
    return differ("mirrored status", mirrored.status, outcome.status);
  }
  for (const auto& [name, value] : outcome.numbers) {
    const std::string partner = name == "roll" || name == "vertical" ? name : other_side(name);
    if (!mirrored.has(partner)) {
      return "mirrored scene has no " + partner;
    }
    const double sign = turns(name) ? -1.0 : 1.0;
    // Residuals are sums over the elements, in another order.
    const bool same = name.find(".residuals.") == std::string::npos
                          ? sign * mirrored.at(partner) == value
                          : std::abs(mirrored.at(partner) - value) <= summation;
    if (!same) {
      return differ("mirrored " + name, sign * mirrored.at(partner), value);
    }
  }
  return "";
}

std::string check_units(const DrawnScene& scene) {
  DrawnScene same = scene;
  wrcontact::Scene in_si = same.made_in_si();
  const wrc_status status = status_of(in_si);
  const Outcome si(in_si, status);
  const Outcome mm = solved(same);
  if (si.status != mm.status) {
    return differ("status in SI", si.status, mm.status);
  }
  for (const auto& [name, value] : mm.numbers) {
    const std::string in_mm = wrcontact::Scene().number_unit(name);
    std::string expected = in_mm; // the same without prefixes
    std::erase_if(expected, [](char letter) { return letter == 'M'; });
    for (std::size_t at = expected.find("mm"); at != std::string::npos; at = expected.find("mm")) {
      expected.erase(at, 1);
    }
    if (in_si.number_unit(name) != expected) {
      return name + " is told in " + in_si.number_unit(name) + " in place of " + in_mm;
    }
    const double unit = size_of(in_mm);
    if (!si.has(name) || !near(si.at(name), unit * value, conversion)) {
      return differ(name + " in SI", si.has(name) ? si.at(name) : std::nan(""), unit * value);
    }
  }
  return "";
}

std::string check_stiffness(const DrawnScene& scene, const Outcome& outcome) {
  constexpr double factor = 8.0;
  const Outcome stiff = solved(scene.stiffer(factor));
  if (stiff.status != outcome.status) {
    return differ("status with other moduli", stiff.status, outcome.status);
  }
  for (const auto& [name, value] : outcome.numbers) {
    const bool force = is_force(name) || is_moment(name) || is_stress(name);
    if (name.ends_with("warning_count") ||
        name.ends_with("grade")) { // what steel carries does not grow with its modulus
      continue;
    }
    if (!stiff.has(name) || !near(stiff.at(name), (force ? factor : 1.0) * value, conversion)) {
      return differ(name + " with other moduli", stiff.has(name) ? stiff.at(name) : std::nan(""),
                    (force ? factor : 1.0) * value);
    }
  }
  return "";
}

std::string check_monotony(const DrawnScene& scene, const Outcome& outcome) {
  DrawnScene more = scene;
  const bool positioned = scene.has("pose.vertical");
  if (positioned) {
    constexpr double lower = 0.01; // mm
    more.set("pose.vertical", scene.number("pose.vertical") - lower);
  } else {
    constexpr double heavier = 1.2;
    for (const char* key : {"load.left", "load.right", "load.both"}) {
      more.multiply(key, heavier);
    }
  }
  const Outcome outcome_of_more = solved(more);
  if (outcome_of_more.status != outcome.status) {
    return ""; // told by its status, and checked where such a scene is drawn
  }
  const std::string name = positioned ? ".vertical_force" : ".depth";
  for (const std::string& side : outcome.sides()) {
    const double before = outcome.at(side + name);
    const double after = outcome_of_more.at(side + name);
    const auto accuracy_before = told_accuracy(scene, outcome, side);
    const auto accuracy_after = told_accuracy(more, outcome_of_more, side);
    if (accuracy_before && accuracy_after &&
        !(after >= before * (1.0 - *accuracy_before - *accuracy_after))) {
      return differ(side + name + " before and after", before, after);
    }
  }
  return "";
}

std::string check_solver(const DrawnScene& scene, const Outcome& outcome) {
  DrawnScene before = scene;
  before.set("pose.lateral", 0.97 * scene.number("pose.lateral") + 0.1);
  for (const char* key : {"load.left", "load.right", "load.both"}) {
    before.multiply(key, 0.9);
  }
  const wrcontact::Solver solver;
  const wrcontact::Scene first = before.made();
  wrc_solver_solve(solver.handle(), first.handle());
  const wrcontact::Scene second = scene.made();
  const wrc_status status = wrc_solver_solve(solver.handle(), second.handle());
  const Outcome found(second, status);
  const std::string name = found.difference_to(outcome);
  return name.empty() ? "" : "through a solver another " + name;
}

std::string check_batch(const DrawnScene& scene, const Outcome& outcome) {
  std::array<wrcontact::Scene, 3> scenes{scene.made(), scene.mirrored().made(), scene.made()};
  constexpr std::int32_t threads = 2;
  const std::vector<wrc_status> statuses =
      wrcontact::solve_batch({&scenes[0], &scenes[1], &scenes[2]}, threads);
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    const std::string name = Outcome(scenes[i], statuses[i]).difference_to(outcome);
    if (!name.empty()) {
      return "in a batch another " + name;
    }
  }
  return "";
}

} // namespace properties
