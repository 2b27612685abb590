#include "wrc_case/reports.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "reports/patches.hpp"
#include "reports/smoothing.hpp"
#include "reports/warning_summary.hpp"
#include "support/csv_table.hpp"
#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/text_table.hpp"

namespace driver {
namespace {

constexpr std::array<const char*, 7> element_fields{
    "x", "y", "z", "undeformed_distance", "row_scale", "pressure", "displacement"};

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

/// A value for each side.
class SideTable {
public:
  explicit SideTable(const Scene& scene) : scene_(scene), sides_(sides_of(scene)) {}

  void head(const std::string& title) {
    std::vector<std::string> row{title};
    row.insert(row.end(), sides_.begin(), sides_.end());
    table_.add({});
    table_.add(std::move(row));
  }
  void line(const std::string& label, const std::string& unit, const std::string& name,
            int decimals, double factor = 1.0) {
    add(label, unit, name, [=](double value) { return fixed(factor * value, decimals); });
  }
  void scientific(const std::string& label, const std::string& name) {
    add(label, "", name, [](double value) { return power(value, 1); });
  }
  void count(const std::string& label, const std::string& list) {
    std::vector<std::string> row{"  " + label};
    for (const std::string& side : sides_) {
      row.push_back(std::to_string(scene_.count_of(side + '.' + list)));
    }
    table_.add(std::move(row));
  }
  void print(std::ostream& out) const { table_.print(out); }

private:
  template <class Text>
  void add(const std::string& label, const std::string& unit, const std::string& name, Text text) {
    std::vector<std::string> row{"  " + padded(label, 28) + unit};
    for (const std::string& side : sides_) {
      const std::string full = side + '.' + name;
      const double value = scene_.number_or(full, std::numeric_limits<double>::quiet_NaN());
      row.push_back(std::isnan(value) ? "-" : text(value));
    }
    table_.add(std::move(row));
  }

  const Scene& scene_;
  std::vector<std::string> sides_;
  TextTable table_{"lr", {36, 14, 14}};
};

/// A line for each patch.
class PatchPrinter {
public:
  struct Column {
    std::string title;
    std::string unit;
    std::string name;
    std::size_t width;
    int decimals;
    double factor = 1.0;
  };

  /// Prints patches and parts that have the result `needed`.
  PatchPrinter(const Scene& scene, std::ostream& out, const char* needed = "pmax")
      : scene_(scene), out_(out) {
    const auto add = [&](const std::string& side, const std::string& index,
                         const std::string& prefix) {
      if (scene.has_number(prefix + needed)) {
        lines_.push_back({padded(side, 8) + padded_left(index), prefix});
      }
    };
    for (const PatchName& patch : all_patches(scene)) {
      const std::string index = std::to_string(patch.index);
      add("  " + patch.side, index, patch.prefix);
      const bool titled = scene.has_number(patch.prefix + needed);
      const int parts = scene.count_of(patch.prefix + "parts");
      for (int part = 0; part < parts; ++part) {
        const std::string of_part = std::to_string(part);
        add(titled ? "" : "  " + patch.side, index + '.' + of_part,
            patch.prefix + "parts." + of_part + '.');
      }
    }
  }

  /// Whether a value of any patch exceeds a limit.
  [[nodiscard]] bool any_above(const char* name, double limit) const {
    return std::any_of(lines_.begin(), lines_.end(),
                       [&](const Line& line) { return scene_.number(line.prefix + name) > limit; });
  }

  void print(const std::string& title, const std::vector<Column>& columns) const {
    if (lines_.empty()) {
      return;
    }
    std::vector<std::size_t> widths{11};
    std::vector<std::string> titles{title};
    std::vector<std::string> units{""};
    for (const Column& column : columns) {
      widths.push_back(column.width);
      titles.push_back(column.title);
      units.push_back(column.unit);
    }
    TextTable table("lr", widths);
    table.add({});
    table.add(titles);
    table.add(units);
    for (const Line& line : lines_) {
      std::vector<std::string> row{line.label};
      for (const Column& column : columns) {
        const double value = column.factor * scene_.number(line.prefix + column.name);
        row.push_back(std::isnan(value) ? "-" : fixed(value, column.decimals));
      }
      table.add(std::move(row));
    }
    table.print(out_);
  }

private:
  /// Line of a patch, or of a part of one ("0.1").
  struct Line {
    std::string label;
    std::string prefix;
  };
  static std::string padded_left(const std::string& index) {
    return std::string(3 - std::min<std::size_t>(3, index.size()), ' ') + index;
  }
  const Scene& scene_;
  std::ostream& out_;
  std::vector<Line> lines_;
};

/// Whether forces are more than those of pressures.
bool has_creep_forces(const Scene& scene) {
  const auto patches = all_patches(scene);
  return std::any_of(patches.begin(), patches.end(), [&scene](const PatchName& patch) {
    return scene.has_number(patch.prefix + creep_result);
  });
}

bool is_of_steel(const Scene& scene) {
  const auto sides = sides_of(scene);
  return !sides.empty() && scene.text(sides.front() + ".steels") != "elastic";
}

void print_patch_forces(const Scene& scene, std::ostream& out) {
  const PatchPrinter table(scene, out);
  const char* unit = has_creep_forces(scene) ? "N, total" : "N";
  std::vector<PatchPrinter::Column> forces{{"pmax", "MPa", "pmax", 10, 1},
                                           {"area", "mm2", "area", 9, 2},
                                           {"approach", "um", "approach", 10, 3, 1e3},
                                           {"normal", "N", "normal_force", 11, 1},
                                           {"vertical", unit, "vertical_force", 11, 1},
                                           {"lateral", unit, "lateral_force", 11, 1},
                                           {"angle", "mrad", "angle", 9, 2, 1e3},
                                           {"semi-axes", "x, mm", "semi_axes.longitudinal", 11, 2},
                                           {"", "y, mm", "semi_axes.lateral", 7, 2}};
  if (is_of_steel(scene)) {
    forces.insert(forces.begin() + 1, {"elastic", "MPa", "pmax_elastic", 10, 1});
  }
  if (table.any_above("coupling_weight", 0.0)) {
    forces.push_back({"coupling", "weight", "coupling_weight", 11, 3});
  }
  if (table.any_above("regions", 1.0)) {
    forces.push_back({"regions", "", "regions", 9, 0});
  }
  table.print("Patches", forces);
}

void print_creep_forces(const Scene& scene, std::ostream& out) {
  const PatchPrinter table(scene, out, creep_result);
  table.print("Creep", {{"creepage", "x, 1e-3", "creepage.longitudinal", 10, 3, 1e3},
                        {"", "y, 1e-3", "creepage.lateral", 9, 3, 1e3},
                        {"spin", "1e-3/mm", "creepage.spin", 9, 3, 1e3},
                        {"force", "x, N", "creep_force.longitudinal", 11, 1},
                        {"", "y, N", "creep_force.lateral", 11, 1},
                        {"moment", "N mm", "spin_moment", 11, 0},
                        {"slip", "mm2", "slip_area", 9, 2},
                        {"adhesion", "mm2", "adhesion_area", 10, 2},
                        {"traction", "max, MPa", "traction_max", 10, 1},
                        {"T-gamma", "N", "wear_number", 9, 3}});
}

void print_kalker(const Scene& scene, std::ostream& out) {
  const PatchPrinter table(scene, out, "kalker.c11");
  table.print("Kalker", {{"c11", "", "kalker.c11", 10, 4},
                         {"c22", "", "kalker.c22", 9, 4},
                         {"c23", "", "kalker.c23", 9, 4},
                         {"c33", "", "kalker.c33", 9, 4}});
}

void print_patch_places(const Scene& scene, std::ostream& out) {
  const PatchPrinter table(scene, out);
  table.print("Positions", {{"reference", "y, mm", "y", 11, 3},
                            {"", "z, mm", "z", 9, 3},
                            {"", "s_wheel", "s_wheel", 9, 3},
                            {"centroid", "y, mm", "centroid.y", 11, 3},
                            {"", "z, mm", "centroid.z", 9, 3},
                            {"", "s_wheel", "centroid.s_wheel", 9, 3},
                            {"elements", "across", "grid.lateral", 10, 0},
                            {"", "along", "grid.longitudinal", 7, 0},
                            {"size", "y, mm", "element_size.lateral", 9, 4},
                            {"", "x, mm", "element_size.longitudinal", 8, 4},
                            {"fill", "%", "fill", 8, 1, 1e2}});
}

/// What pmax and area would be, were profiles of points smoothed otherwise.
void print_smoothing(const Scene& scene, std::ostream& out) {
  TextTable table("llr", {22, 4, 10});
  for (std::vector<std::string>& row : smoothing_rows(scene)) {
    if (table.row_count() == 0) {
      table.add({});
    }
    table.add(std::move(row));
  }
  table.print(out);
}

void print_texts(const Scene& scene, std::ostream& out) {
  if (is_of_steel(scene)) {
    out << "Steel: " << scene.text(sides_of(scene).front() + ".steels") << '\n';
  }
  for (const std::string& correction : texts_of(scene, "corrections")) {
    out << "Corrected: " << one_line(correction) << '\n';
  }
  std::vector<Warning> warnings = warnings_of(scene);
  for (Warning& warning : spread_warnings(scene)) {
    warnings.push_back(std::move(warning));
  }
  for (const std::string& line : lines_of(warnings)) {
    out << line << '\n';
  }
}

/// Whether a result is a whole number.
bool is_count(const std::string& name) {
  constexpr std::array counts{"iterations",    "convolutions", "solutions",    "patch_count",
                              "regions",       "lobes",        "grid.lateral", "grid.longitudinal",
                              "warning_count", "grade"};
  return std::any_of(counts.begin(), counts.end(),
                     [&name](const char* count) { return name.ends_with(count); });
}

/// Whether what is measured of profiles leaves results uncertain.
bool is_noisy(const Scene& scene) {
  const auto sides = sides_of(scene);
  return std::any_of(sides.begin(), sides.end(), [&scene](const std::string& side) {
    return scene.number_or(side + ".spread.pmax", 0.0) > 0.0;
  });
}

void add_solution(const Scene& scene, SideTable& table) {
  table.head("Contact, all patches");
  table.count("patches", "patches");
  table.line("pmax", "MPa", "pmax", 2);
  if (is_of_steel(scene)) {
    table.line("  without yielding", "MPa", "pmax_elastic", 2);
  }
  if (is_noisy(scene)) {
    table.line("  uncertain by profile, +-", "MPa", "spread.pmax", 2);
  }
  table.line("area", "mm2", "area", 2);
  if (is_noisy(scene)) {
    table.line("  uncertain by profile, +-", "mm2", "spread.area", 2);
  }
  table.line("normal force", "N", "normal_force", 1);
  if (has_creep_forces(scene)) {
    table.line("vertical force, total", "N", "vertical_force", 1);
    table.line("vertical, by pressures", "N", "pressure_force.z", 1);
    table.line("lateral force, total", "N", "lateral_force", 1);
    table.line("lateral, by pressures", "N", "pressure_force.y", 1);
  } else {
    table.line("vertical force", "N", "vertical_force", 1);
    table.line("lateral force on wheel", "N", "lateral_force", 1);
  }
  table.line("centroid of forces, track y", "mm", "centroid.y", 4);
  table.line("vertical approach", "um", "depth", 3, 1e3);
  table.head("Solution");
  table.line("solutions", "", "solutions", 0);
  table.line("iterations", "", "iterations", 0);
  table.line("convolutions", "", "convolutions", 0);
  table.scientific("estimated relative error", "error_estimate");
  const std::vector<std::string> sides = sides_of(scene);
  if (std::all_of(sides.begin(), sides.end(),
                  [&](const auto& side) { return scene.has_number(side + ".validity"); })) {
    table.line("validity of the model", "", "validity", 3);
  }
  table.scientific("load balance", "residuals.load_balance");
  table.scientific("least gap / displacement", "residuals.least_gap");
  table.scientific("complementarity", "residuals.complementarity");
}

} // namespace

void print_table(const Scene& scene, std::ostream& out) {
  out << "Wheelset: roll " << fixed(1e3 * scene.number("roll"), 6) << " mrad, first touch at "
      << fixed(scene.number("vertical"), 4) << " mm above the rail tops";
  if (scene.has_number("rolling_radius_difference")) {
    out << ", rolling radius difference " << fixed(scene.number("rolling_radius_difference"), 4)
        << " mm";
  }
  out << "\nModel: " << scene.text("model") << ", solver " << scene.text("solver") << '\n';
  SideTable table(scene);
  table.head("Rigid contact");
  table.line("on wheel, from taping line", "mm", "rigid_contact.s_wheel", 4);
  table.line("on rail, from its axis", "mm", "rigid_contact.t_rail", 4);
  table.line("track y", "mm", "rigid_contact.y", 4);
  table.line("track z", "mm", "rigid_contact.z", 4);
  table.line("contact angle", "mrad", "rigid_contact.angle", 3, 1e3);
  table.line("rolling radius", "mm", "rigid_contact.rolling_radius", 4);
  const std::string until = scene.get_text("solve.until");
  if (until == "mechanics") {
    add_solution(scene, table);
  }
  table.print(out);
  if (until == "mechanics") {
    print_smoothing(scene, out);
    print_patch_forces(scene, out);
    print_creep_forces(scene, out);
    print_kalker(scene, out);
  }
  if (until != "geometry") {
    print_patch_places(scene, out);
  }
  out << '\n';
  print_near_contacts(scene, out);
  print_texts(scene, out);
  out << "Time in ms:";
  for (const std::string stage :
       {"profile", "setup", "geometry", "remesh", "mechanics", "rolling", "total"}) {
    const double time = scene.number("time_ms." + stage);
    if (stage != "rolling" || time > 0.0) {
      out << ' ' << stage << ' ' << fixed(time, 2);
    }
  }
  out << '\n';
}

void print_json(const Scene& scene, std::ostream& out) {
  // Names such as left.patches.0.pmax become objects and lists. Derivatives, as in force.y.by.yaw,
  // are beside their result, which is a number: in the object "y.by".
  json flat = json::object();
  const auto pointer_of = [](std::string name) {
    std::replace(name.begin(), name.end(), '.', '/');
    if (const std::size_t by = name.find("/by/"); by != std::string::npos) {
      name[by] = '.';
    }
    return '/' + name;
  };
  for (const std::string& name : scene.number_names()) {
    const double value = scene.number(name);
    flat[pointer_of(name)] = is_count(name) ? json(static_cast<std::int64_t>(value)) : json(value);
  }
  for (const std::string& name : scene.text_names()) {
    flat[pointer_of(name)] = scene.text(name);
  }
  json object = flat.unflatten();
  for (const char* list : {"warnings", "warning_classes", "warning_grades"}) {
    object.emplace(list, json::array());
  }
  for (const std::string& side : sides_of(scene)) {
    for (const char* list : {"patches", "near_contacts", "warnings"}) {
      object[side].emplace(list, json::array());
    }
    object[side].emplace("error_estimate", nullptr);
  }
  print_json(object, out);
}

void print_csv(const Scene& scene, int digits, std::ostream& out) {
  std::vector<std::string> columns = words(
      "rigid_contact.s_wheel rigid_contact.t_rail rigid_contact.y rigid_contact.z "
      "rigid_contact.angle rigid_contact.rolling_radius pmax pmax_element area normal_force "
      "vertical_force lateral_force longitudinal_force pressure_force.x pressure_force.y "
      "pressure_force.z pressure_moment.x pressure_moment.y pressure_moment.z centroid.x "
      "centroid.y centroid.z centroid.s_wheel centroid.rolling_radius centroid.angle approach "
      "depth angle error_estimate iterations convolutions solutions fill grid.lateral "
      "grid.longitudinal element_size.lateral element_size.longitudinal");
  for (const std::string& name : scene.number_names()) { // of the patches, if requested
    const std::string column = name.substr(name.find('.') + 1);
    if (name.find(".kalker.") != std::string::npos &&
        std::find(columns.begin(), columns.end(), column) == columns.end()) {
      columns.push_back(column);
    }
  }
  CsvLine(out)
      .add(words("side roll vertical patches"))
      .add(columns)
      .add(words("grade warning_count warnings"));
  out.precision(digits);
  for (const std::string& side : sides_of(scene)) {
    CsvLine line(out);
    line << side << scene.number("roll") << scene.number("vertical")
         << scene.count_of(side + ".patches");
    for (const std::string& column : columns) {
      const std::string name = side + '.' + column;
      const double value = scene.number_or(name, std::nan(""));
      line << (std::isnan(value) ? std::nullopt : std::optional(value));
    }
    std::vector<Warning> warnings = warnings_of(scene);
    std::erase_if(warnings, [&side](const Warning& one) { return is_of_other_wheel(one, side); });
    for (Warning& warning : warnings) {
      if (warning.text.starts_with(side + ": ")) {
        warning.text.erase(0, side.size() + 2);
      }
    }
    line << grade_of(warnings) << warnings.size() << joined_warnings(warnings);
  }
}

namespace {

template <class Names>
void write_fields(const Scene& scene, const std::vector<PatchName>& patches, const Names& names,
                  const std::filesystem::path& path) {
  OutputFile file(path);
  std::ofstream& out = file.stream();
  CsvLine(out).add(words("side patch")).add(names);
  for (const PatchName& patch : patches) {
    std::array<std::vector<double>, std::tuple_size_v<Names>> columns;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      columns[i] = scene.field(patch.prefix + names[i]);
    }
    for (std::size_t element = 0; element < columns[0].size(); ++element) {
      CsvLine line(out);
      line << patch.side << patch.index;
      for (const auto& column : columns) {
        line << column[element];
      }
    }
  }
  file.commit();
}

} // namespace

void write_field(const Scene& scene, const std::filesystem::path& path) {
  write_fields(scene, all_patches(scene), element_fields, path);
}

void write_creep_field(const Scene& scene, const std::filesystem::path& path) {
  constexpr std::array names{"creep_x",    "creep_y",    "creep_z", "creep_pressure",
                             "traction_x", "traction_y", "slip_x",  "slip_y"};
  const auto patches = parts_with(scene, all_patches(scene), creep_result);
  if (patches.empty()) {
    throw Failure("--creep-field " + path.string() +
                  ": there are no creep forces; set creepages (creepage.*) or a motion (motion.*)");
  }
  write_fields(scene, patches, names, path);
}

} // namespace driver
