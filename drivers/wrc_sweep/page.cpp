// The scenes of a study as JSON in the page of page.html.
#include "wrc_sweep/page.hpp"

#include <algorithm>
#include <cmath>

#include "support/json.hpp"
#include "support/output_file.hpp"
#include "wrc_sweep/page_html.hpp"
#include "wrc_sweep/result_names.hpp"

namespace driver {
namespace {

/// A page holds about 20 kB for each.
constexpr std::int64_t most_scenes_of_page = 2000;

/// Digits that can be seen: 0.001 mm, 0.1 MPa.
json rounded(const std::vector<double>& values, double unit) {
  json numbers = json::array();
  for (const double value : values) {
    const double units = std::round(value / unit);
    numbers.push_back(unit >= 1.0 ? json(static_cast<std::int64_t>(units * unit))
                                  : json(units / std::round(1.0 / unit)));
  }
  return numbers;
}

/// About 200 points of an outline, its ends included.
json outline(const Scene& scene, const std::string& name) {
  const std::vector<double> y = scene.field(name + "_y");
  const std::vector<double> z = scene.field(name + "_z");
  const std::size_t step = std::max<std::size_t>(1, y.size() / 200);
  std::vector<double> points;
  for (std::size_t i = 0; i < y.size();
       i = i + 1 < y.size() ? std::min(i + step, y.size() - 1) : y.size()) {
    points.insert(points.end(), {y[i], z[i]});
  }
  return rounded(points, 0.01);
}

/// Elements of a grid: the position of each row along the patch's plane and of each column along x,
/// then fields. Rows that a patch's plane unrolls begin at the y of the first one.
json grid(const Scene& scene, const std::string& patch, const std::string& place, bool left,
          std::size_t columns, const std::vector<std::string>& fields) {
  const std::vector<double> x = scene.field(patch + place + 'x');
  const std::vector<double> y = scene.field(patch + place + 'y');
  const std::vector<double> z = scene.field(patch + place + 'z');
  const std::size_t rows = x.size() / columns;
  // The plane is turned down about the middle of the patch, where y stays.
  const std::size_t middle = rows / 2 * columns;
  std::vector<double> across;
  for (std::size_t row = 0; row < rows; ++row) {
    const double dy = y[row * columns] - y[middle];
    const double distance = std::hypot(dy, z[row * columns] - z[middle]);
    const bool to_field_side = row * columns > middle; // rows go there
    across.push_back(y[middle] + (to_field_side == left ? distance : -distance));
  }
  json made{{"y", rounded(across, 0.001)},
            {"x", rounded({x.begin(), x.begin() + static_cast<std::ptrdiff_t>(columns)}, 0.001)}};
  for (const std::string& field : fields) {
    made[field] = rounded(scene.field(patch + field), 1.0);
  }
  return made;
}

json patch(const Scene& scene, const std::string& prefix, bool left) {
  json made{{"normal", grid(scene, prefix, "", left,
                            static_cast<std::size_t>(scene.number(prefix + "grid.longitudinal")),
                            {"pressure"})}};
  if (scene.has_number(prefix + "creep_grid.longitudinal") &&
      scene.number(prefix + "creep_grid.longitudinal") > 0.0) {
    made["creep"] = grid(scene, prefix, "creep_", left,
                         static_cast<std::size_t>(scene.number(prefix + "creep_grid.longitudinal")),
                         {"traction_x", "traction_y"});
  }
  return made;
}

json side(const Scene& scene, const std::string& name) {
  json made{{"rail", outline(scene, name + ".rail")}, {"wheel", outline(scene, name + ".wheel")}};
  if (scene.has_number(name + ".depth")) { // none without contact
    made["height"] = scene.number(name + ".vertical") - scene.number(name + ".depth");
  }
  for (const char* number :
       {"pmax", "area", "patch_count", "normal_force", "total.force.x", "total.force.y",
        "total.force.z", "total.moment.z", "angle", "rigid_contact.y", "rigid_contact.z",
        "rigid_contact.rolling_radius"}) {
    if (scene.has_number(name + '.' + number) &&
        std::isfinite(scene.number(name + '.' + number))) { // no pmax of a contact that is cut
      made[number] = scene.number(name + '.' + number);
    }
  }
  json& patches = made["patches"] = json::array();
  for (int i = 0;; ++i) {
    const std::string prefix = name + ".patches." + std::to_string(i) + '.';
    if (!scene.has_number(prefix + "pmax")) {
      return made;
    }
    const int parts = scene.count_of(prefix + "parts");
    for (int part = 0; part < parts; ++part) {
      patches.push_back(
          patch(scene, prefix + "parts." + std::to_string(part) + '.', name == "left"));
    }
    if (parts == 0) {
      patches.push_back(patch(scene, prefix, name == "left"));
    }
  }
}

/// JSON for a script inside HTML, where < in a text could begin a comment or element or end the
/// script, and the separators U+2028 and U+2029 ended a line before ECMAScript 2019. In JSON all
/// three occur in texts only.
std::string within_script(const json& data) {
  const std::string text = data.dump(-1, ' ', false, json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = std::string_view(text).substr(at);
    const bool separates = rest.starts_with("\u2028") || rest.starts_with("\u2029");
    if (separates) {
      out += rest.starts_with("\u2028") ? "\\u2028" : "\\u2029";
    } else if (rest[0] == '<') {
      out += "\\u003c";
    } else {
      out += rest[0];
    }
    at += separates ? 3 : 1;
  }
  return out;
}

json json_of(const Value& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? json(*number) : json(text_of(value));
}

} // namespace

std::string page_text(Scene& scene) {
  const std::string units = scene.get_text("convention.units");
  const std::string frame = scene.get_text("convention.frame");
  scene.set("convention.units", "mm"); // those of the page, whatever those of the study
  scene.set("convention.frame", "left-up");
  json made = json::object();
  for (const std::string& name : sides_of(scene)) {
    made[name] = side(scene, name);
  }
  scene.set("convention.units", units);
  scene.set("convention.frame", frame);
  return made.dump(-1, ' ', false, json::error_handler_t::replace);
}

void refuse_large_page(const Study& study) {
  const std::int64_t count = study.scene_count();
  if (count > most_scenes_of_page) {
    throw Failure("--page: the study has " + std::to_string(count) +
                  " scenes; a page holds at most " + std::to_string(most_scenes_of_page));
  }
}

void write_page(const Study& study, Journal& journal, const std::filesystem::path& path) {
  json scenes = json::array();
  for (std::int64_t index = 0; index < study.scene_count(); ++index) {
    const Row row = journal.read(index);
    json& scene = scenes.emplace_back(row.page.empty() ? json::object() : json::parse(row.page));
    if (!row.message.empty()) {
      scene["message"] = row.message;
    }
    if (!row.page.empty()) {
      scene["warnings"] = scene["grades"] = json::array();
      for (const Warning& warning : row.warnings) {
        scene["warnings"].push_back(warning.text);
        scene["grades"].push_back(warning.grade);
      }
    }
  }
  json data{{"title", study.title.empty() ? study.name : study.title},
            {"version", wrc_version()},
            {"axes", json::array()},
            {"scenes", std::move(scenes)}};
  Scene scene; // for its units
  study.apply(0, scene);
  for (const Axis& axis : study.axes) {
    json values = json::array();
    for (const Value& value : axis.values) {
      values.push_back(json_of(value));
    }
    data["axes"].push_back({{"key", axis.key},
                            {"unit", unit_of(scene, axis.key)},
                            {"meaning", long_name_of(axis.key)},
                            {"values", std::move(values)}});
  }
  std::string page = page_html;
  const std::string mark = "/* scenes */ null";
  page.replace(page.find(mark), mark.size(), within_script(data));
  write_whole(path, [&](std::ostream& out) { out << page; });
}

} // namespace driver
