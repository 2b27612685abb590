#include "wrc_sweep/result_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string_view>

#include "support/numbers.hpp"

namespace driver {
namespace {

struct Field {
  std::string_view name;
  const char* like; ///< a result of the same unit
};

constexpr std::array fields{Field{"x", "left.patches.0.x"},
                            Field{"y", "left.patches.0.y"},
                            Field{"z", "left.patches.0.z"},
                            Field{"undeformed_distance", "left.patches.0.approach"},
                            Field{"row_scale", "left.fill"},
                            Field{"pressure", "left.pmax"},
                            Field{"displacement", "left.patches.0.approach"}};

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

namespace {

/// What the library says of a name that it does not know: its successor or "nearest: left.pmax";
/// else nothing.
std::string hint_of(const std::string& error) {
  constexpr std::string_view removed = "any more: ";
  if (const std::size_t at = error.rfind(removed); at != std::string::npos) {
    return "; " + error.substr(at + removed.size());
  }
  const std::size_t at = error.rfind("nearest: ");
  return at == std::string::npos ? "" : "; " + error.substr(at);
}

} // namespace

void check_results(const std::vector<std::string>& names) {
  refuse_doubled("study.results", names);
  const Scene scene;
  for (const std::string& name : names) {
    try {
      (void)scene.number_id(name);
    } catch (const wrcontact::Error& error) {
      throw Failure("study.results: \"" + name + "\" is unknown" + hint_of(error.what()) +
                    "; must be a name that wrc_sweep --list-results prints");
    }
  }
}

void check_fields(const std::vector<std::string>& names) {
  refuse_doubled("study.fields", names);
  for (const std::string& name : names) {
    const auto has_name = [&name](const Field& field) { return field.name == name; };
    if (std::none_of(fields.begin(), fields.end(), has_name)) {
      std::string allowed;
      for (const Field& field : fields) {
        allowed += (allowed.empty() ? "" : ", ") + std::string(field.name);
      }
      throw Failure("study.fields: \"" + name + "\" is unknown; must be one of " + allowed);
    }
  }
}

double result_of(const Scene& scene, const std::string& name) {
  return scene.number_or(name, std::numeric_limits<double>::quiet_NaN());
}

std::string unit_of(const Scene& scene, const std::string& name) {
  for (const Field& field : fields) {
    if (field.name == name) {
      return scene.number_unit(field.like);
    }
  }
  const std::string unit = scene.key_unit(name);
  return unit.empty() ? "1" : unit;
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
