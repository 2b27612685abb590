#include "wrc_sweep/result_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string_view>

#include "support/numbers.hpp"

namespace driver {
namespace {

constexpr std::array field_names{"x",         "y",        "z",           "undeformed_distance",
                                 "row_scale", "pressure", "displacement"};

/// Entries of lists as entry 0.
std::string with_first_entry(const std::string& name) {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (i > 0 && name[i - 1] == '.' && std::isdigit(static_cast<unsigned char>(name[i])) != 0) {
      std::size_t end = i;
      while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])) != 0) {
        ++end;
      }
      if (end < name.size()) {
        out += '0';
        i = end - 1;
        continue;
      }
    }
    out += name[i];
  }
  return out;
}

struct Unit {
  std::string_view part; ///< of a name
  const char* unit;
};

/// Units of keys and fields; the first part that a name contains decides.
constexpr std::array units{
    Unit{"solve.near_tolerance", "mm"},
    Unit{"solve.joining_distance", "mm"},
    Unit{"solve.", "1"},
    Unit{"stress.", "1"},
    Unit{"wear.energy_coefficient", "mm2/N"},
    Unit{"wear.hardness", "MPa"},
    Unit{"wear.", "1"},
    Unit{"fatigue.shear_yield", "MPa"},
    Unit{"friction.decay", "s/mm"},
    Unit{"friction", "1"},
    Unit{"creepage.spin", "1/mm"},
    Unit{"creepage.", "1"},
    Unit{"motion.curvature", "1/mm"},
    Unit{"motion.torque", "N mm"},
    Unit{"motion.roll", "rad/s"},
    Unit{"motion.pitch", "rad/s"},
    Unit{"motion.yaw", "rad/s"},
    Unit{"motion.", "mm/s"},
    Unit{"pitch", "rad"},
    Unit{"load.", "N"},
    Unit{"pressure", "MPa"},
    Unit{"modulus", "MPa"},
    Unit{"poisson", "1"},
    Unit{"roll", "rad"},
    Unit{"yaw", "rad"},
    Unit{"inclination", "rad"},
};

} // namespace

namespace {

/// Each name is a variable of the NetCDF file.
void refuse_doubled(const char* list, const std::vector<std::string>& names) {
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::find(names.begin(), name, *name) != name) {
      throw Failure(std::string(list) + ": \"" + *name +
                    "\" occurs twice; each name is allowed once");
    }
  }
}

} // namespace

std::vector<std::string> default_results() {
  std::vector<std::string> names = words("roll vertical rolling_radius_difference");
  for (const char* side : {"left.", "right."}) {
    for (const std::string& name :
         words("rigid_contact.y rigid_contact.z rigid_contact.s_wheel rigid_contact.t_rail "
               "rigid_contact.angle rigid_contact.rolling_radius pmax area normal_force "
               "vertical_force lateral_force approach depth patch_count error_estimate")) {
      names.push_back(side + name);
    }
  }
  return names;
}

std::vector<std::string> all_results() {
  // Scenes that have whatever there is: both sides, creep forces, damage, contacts that almost
  // touch, a contact of several parts on the one or the other side, and a wheel of points.
  Profile exact;
  exact.load_standard("S1002");
  Profile::Points points;
  for (double arc = 0.0; arc < exact.length(); arc += 1.0) {
    points.lateral.push_back(exact.at(arc).lateral);
    points.height.push_back(exact.at(arc).height);
  }
  Profile wheel;
  wheel.set_points("points", WRC_WHEEL, points.lateral, points.height, 0.0);
  Scene scene;
  scene.set("wheelset.wheel", wheel);
  scene.set("solve.accuracy", 0.1);
  scene.set("solve.near_tolerance", 10.0);
  scene.set("track.rail", "UIC60-Manchester");
  scene.set("load.both", 1e4);
  scene.set("creepage.longitudinal", 1e-3);
  scene.set("solve.results", "stress wear fatigue");
  std::vector<std::string> names;
  for (const double lateral : {-5.0, 5.0}) {
    scene.set("pose.lateral", lateral);
    scene.solve();
    for (const std::string& name : scene.number_names()) {
      const std::string first = with_first_entry(name);
      if (std::find(names.begin(), names.end(), first) == names.end()) {
        names.push_back(first);
      }
    }
  }
  return names;
}

namespace {

/// What the library says of a name that it does not know: its successor or "nearest: left.pmax";
/// else nothing.
std::string hint_for(const std::string& name) {
  try {
    (void)Scene().number_id(name);
  } catch (const wrcontact::Error& error) {
    const std::string text = error.what();
    for (const char* hint : {"use ", "nearest: "}) {
      if (const std::size_t at = text.rfind(hint); at != std::string::npos) {
        return "; " + text.substr(at);
      }
    }
  }
  return "";
}

} // namespace

void check_results(const std::vector<std::string>& names) {
  refuse_doubled("study.results", names);
  const std::vector<std::string> known = all_results();
  const auto is_known = [&known](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  for (const std::string& name : names) {
    if (!is_known(with_first_entry(name))) {
      throw Failure("study.results: \"" + name + "\" is unknown" + hint_for(name) +
                    "; must be a name that wrc_sweep --list-results prints");
    }
  }
}

void check_fields(const std::vector<std::string>& names) {
  refuse_doubled("study.fields", names);
  for (const std::string& name : names) {
    if (std::find(field_names.begin(), field_names.end(), name) == field_names.end()) {
      std::string allowed;
      for (const char* field : field_names) {
        allowed += (allowed.empty() ? "" : ", ") + std::string(field);
      }
      throw Failure("study.fields: \"" + name + "\" is unknown; must be one of " + allowed);
    }
  }
}

double result_of(const Scene& scene, const std::string& name) {
  return scene.number_or(name, std::numeric_limits<double>::quiet_NaN());
}

std::string unit_of(const Scene& scene, const std::string& name) {
  const auto* found = std::find_if(units.begin(), units.end(), [&name](const Unit& unit) {
    return name.find(unit.part) != std::string::npos;
  });
  std::string unit = found == units.end() ? "mm" : found->unit;
  if (scene.get_text("convention.units") == "SI") { // without the prefixes
    for (const char* prefixed : {"mm", "MPa"}) {
      if (const std::size_t at = unit.find(prefixed); at != std::string::npos) {
        unit.erase(at, 1);
      }
    }
  }
  return unit;
}

std::string long_name_of(const std::string& name) {
  for (const wrcontact::SceneKey& key : wrcontact::scene_keys()) {
    if (name == key.name) {
      return key.meaning;
    }
  }
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool before_index = name[i] == '.' && i + 1 < name.size() &&
                              std::isdigit(static_cast<unsigned char>(name[i + 1]));
    text += before_index ? " " : name[i] == '.' ? ", " : name[i] == '_' ? " " : name.substr(i, 1);
  }
  return text;
}

} // namespace driver
