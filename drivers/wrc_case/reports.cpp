#include "wrc_case/reports.hpp"

#include <algorithm>
#include <array>
#include <iomanip>
#include <limits>
#include <sstream>

#include <nlohmann/json.hpp>

#include "support/output_file.hpp"
#include "wrc_case/patches.hpp"

namespace driver {
namespace {

constexpr std::array<const char*, 6> element_fields{
    "x", "y", "z", "undeformed_distance", "pressure", "displacement"};

/// One line of the table: a value for each side.
class TablePrinter {
public:
  TablePrinter(const Scene& scene, std::ostream& out)
      : scene_(scene), out_(out), sides_(scene.sides()) {}

  void head(const std::string& title) const {
    out_ << '\n' << std::left << std::setw(36) << title;
    for (const std::string& side : sides_) {
      out_ << std::right << std::setw(14) << side;
    }
    out_ << '\n';
  }

  void line(const std::string& label, const std::string& unit, const std::string& name,
            int decimals, double factor = 1.0) const {
    out_ << "  " << std::left << std::setw(28) << label << std::setw(6) << unit << std::right
         << std::fixed << std::setprecision(decimals);
    for (const std::string& side : sides_) {
      const std::string full = side + '.' + name;
      if (scene_.has_number(full)) {
        out_ << std::setw(14) << factor * scene_.number(full);
      } else {
        out_ << std::setw(14) << "-";
      }
    }
    out_ << std::defaultfloat << '\n';
  }

  void count(const std::string& label, const std::string& list) const {
    out_ << "  " << std::left << std::setw(34) << label << std::right;
    for (const std::string& side : sides_) {
      out_ << std::setw(14) << scene_.count_of(side + '.' + list);
    }
    out_ << '\n';
  }

  void scientific(const std::string& label, const std::string& name) const {
    out_ << "  " << std::left << std::setw(34) << label << std::right << std::scientific
         << std::setprecision(1);
    for (const std::string& side : sides_) {
      const std::string full = side + '.' + name;
      if (scene_.has_number(full)) {
        out_ << std::setw(14) << scene_.number(full);
      } else {
        out_ << std::setw(14) << "-";
      }
    }
    out_ << std::defaultfloat << '\n';
  }

private:
  const Scene& scene_;
  std::ostream& out_;
  std::vector<std::string> sides_;
};

/// A table with one line per patch.
class PatchPrinter {
public:
  struct Column {
    std::string title;
    std::string unit;
    std::string name;
    int width;
    int decimals;
    double factor = 1.0;
  };

  PatchPrinter(const Scene& scene, std::ostream& out) : scene_(scene), out_(out) {
    for (const PatchName& patch : all_patches(scene)) {
      const std::string index = std::to_string(patch.index);
      lines_.push_back({patch.side, index, patch.prefix});
      const int parts = scene.count_of(patch.prefix + "parts");
      for (int part = 0; part < parts; ++part) {
        const std::string of_part = std::to_string(part);
        lines_.push_back({"", index + '.' + of_part, patch.prefix + "parts." + of_part + '.'});
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
    std::ostringstream titles;
    std::ostringstream units;
    titles << std::left << std::setw(label_width) << title << std::right;
    units << std::setw(label_width) << "";
    for (const Column& column : columns) {
      titles << std::setw(column.width) << column.title;
      units << std::setw(column.width) << column.unit;
    }
    out_ << '\n' << without_end_blanks(titles.str()) << '\n' << without_end_blanks(units.str());
    out_ << '\n' << std::fixed;
    for (const Line& line : lines_) {
      out_ << "  " << std::left << std::setw(6) << line.side << std::right
           << std::setw(label_width - 8) << line.label;
      for (const Column& column : columns) {
        out_ << std::setprecision(column.decimals) << std::setw(column.width)
             << column.factor * scene_.number(line.prefix + column.name);
      }
      out_ << '\n';
    }
    out_ << std::defaultfloat;
  }

private:
  static std::string without_end_blanks(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
  }
  /// Of a patch, or of a part of one ("0.1").
  struct Line {
    std::string side;
    std::string label;
    std::string prefix;
  };
  static constexpr int label_width = 11;
  const Scene& scene_;
  std::ostream& out_;
  std::vector<Line> lines_;
};

void print_patch_forces(const Scene& scene, std::ostream& out) {
  const PatchPrinter table(scene, out);
  std::vector<PatchPrinter::Column> forces{{"pmax", "MPa", "pmax", 10, 1},
                                           {"area", "mm2", "area", 9, 2},
                                           {"approach", "um", "approach", 10, 3, 1e3},
                                           {"normal", "N", "normal_force", 11, 1},
                                           {"vertical", "N", "vertical_force", 11, 1},
                                           {"lateral", "N", "lateral_force", 11, 1},
                                           {"angle", "mrad", "angle", 9, 2, 1e3},
                                           {"semi-axes", "x, mm", "semi_axes.0", 11, 2},
                                           {"", "y, mm", "semi_axes.1", 7, 2}};
  if (table.any_above("closeness", 0.0)) {
    forces.push_back({"closeness", "", "closeness", 11, 3});
  }
  if (table.any_above("regions", 1.0)) {
    forces.push_back({"regions", "", "regions", 9, 0});
  }
  table.print("Patches", forces);
}

void print_patch_places(const Scene& scene, std::ostream& out) {
  const PatchPrinter table(scene, out);
  table.print("Places", {{"reference", "y, mm", "y", 11, 3},
                         {"", "z, mm", "z", 9, 3},
                         {"", "s_wheel", "s_wheel", 9, 3},
                         {"centroid", "y, mm", "centroid.y", 11, 3},
                         {"", "z, mm", "centroid.z", 9, 3},
                         {"", "s_wheel", "centroid.s_wheel", 9, 3},
                         {"elements", "across", "grid.0", 10, 0},
                         {"", "along", "grid.1", 7, 0},
                         {"of size", "y, mm", "element_size.0", 9, 4},
                         {"", "x, mm", "element_size.1", 8, 4},
                         {"filled", "%", "fill", 8, 1, 1e2}});
}

void print_near_contacts(const Scene& scene, std::ostream& out) {
  for (const std::string& side : scene.sides()) {
    const int count = scene.count_of(side + ".near_contacts");
    for (int i = 0; i < count; ++i) {
      const std::string prefix = side + ".near_contacts." + std::to_string(i) + '.';
      out << "Near contact, " << side << ": " << std::fixed << std::setprecision(4)
          << scene.number(prefix + "distance") << " mm apart at s_wheel " << std::setprecision(2)
          << scene.number(prefix + "s_wheel") << " mm, angle " << std::setprecision(1)
          << 1e3 * scene.number(prefix + "angle") << " mrad\n"
          << std::defaultfloat;
    }
  }
}

void print_texts(const Scene& scene, std::ostream& out) {
  for (int i = 0; i < scene.count_of("corrections"); ++i) {
    out << "Corrected: " << scene.text("corrections." + std::to_string(i)) << '\n';
  }
  for (const std::string& side : scene.sides()) {
    for (int i = 0; i < scene.count_of(side + ".warnings"); ++i) {
      out << "Warning, " << side << ": " << scene.text(side + ".warnings." + std::to_string(i))
          << '\n';
    }
  }
}

/// Whether a result is a whole number.
bool is_count(const std::string& name) {
  constexpr std::array<const char*, 7> counts{
      ".iterations", ".convolutions", ".solutions", ".regions", ".lobes", ".grid.0", ".grid.1"};
  return std::any_of(counts.begin(), counts.end(),
                     [&name](const char* count) { return name.ends_with(count); });
}

void print_solution(const Scene& scene, const TablePrinter& table) {
  table.head("Contact, all patches");
  table.count("patches", "patches");
  table.line("pmax", "MPa", "pmax", 2);
  table.line("area", "mm2", "area", 2);
  table.line("normal force", "N", "normal_force", 1);
  table.line("vertical force", "N", "vertical_force", 1);
  table.line("lateral force on wheel", "N", "lateral_force", 1);
  table.line("centroid of forces, track y", "mm", "centroid.y", 4);
  table.line("sinks vertically by", "um", "depth", 3, 1e3);
  table.head("How it was solved");
  table.line("solutions of all patches", "", "solutions", 0);
  table.line("iterations", "", "iterations", 0);
  table.line("convolutions", "", "convolutions", 0);
  table.scientific("estimated relative error", "error_estimate");
  const std::vector<std::string> sides = scene.sides();
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
  out << std::fixed << std::setprecision(6) << "Wheelset: roll " << 1e3 * scene.number("roll")
      << " mrad, centre " << std::setprecision(4) << scene.number("vertical")
      << " mm above the rail tops";
  if (scene.has_number("rolling_radius_difference")) {
    out << ", rolling radius difference " << scene.number("rolling_radius_difference") << " mm";
  }
  out << "\nModel: " << scene.text("model") << ", solver " << scene.text("solver") << '\n'
      << std::defaultfloat;
  const TablePrinter table(scene, out);
  table.head("Rigid contact");
  table.line("on wheel, from taping line", "mm", "rigid_contact.s_wheel", 4);
  table.line("on rail, from its axis", "mm", "rigid_contact.t_rail", 4);
  table.line("track y", "mm", "rigid_contact.y", 4);
  table.line("track z", "mm", "rigid_contact.z", 4);
  table.line("contact angle", "mrad", "rigid_contact.angle", 3, 1e3);
  table.line("rolling radius", "mm", "rigid_contact.rolling_radius", 4);
  const std::string until = scene.input_text("solve.until");
  if (until == "mechanics") {
    print_solution(scene, table);
    print_patch_forces(scene, out);
  }
  if (until != "geometry") {
    print_patch_places(scene, out);
  }
  out << '\n';
  print_near_contacts(scene, out);
  print_texts(scene, out);
  out << std::fixed << std::setprecision(2) << "Time in ms:";
  for (const char* stage : {"profile", "setup", "geometry", "remesh", "mechanics", "total"}) {
    out << ' ' << stage << ' ' << scene.number(std::string("time_ms.") + stage);
  }
  out << std::defaultfloat << '\n';
}

void print_json(const Scene& scene, std::ostream& out) {
  // Names such as left.patches.0.pmax become objects and lists.
  nlohmann::json flat = nlohmann::json::object();
  const auto pointer_of = [](std::string name) {
    for (char& letter : name) {
      letter = letter == '.' ? '/' : letter;
    }
    return '/' + name;
  };
  for (const std::string& name : scene.number_names()) {
    const double value = scene.number(name);
    if (is_count(name)) {
      flat[pointer_of(name)] = static_cast<std::int64_t>(value);
    } else {
      flat[pointer_of(name)] = value;
    }
  }
  for (const std::string& name : scene.text_names()) {
    flat[pointer_of(name)] = scene.text(name);
  }
  nlohmann::json object = flat.unflatten();
  for (const std::string& side : scene.sides()) {
    for (const char* list : {"patches", "near_contacts", "warnings"}) {
      if (!object[side].contains(list)) {
        object[side][list] = nlohmann::json::array();
      }
    }
    if (!object[side].contains("error_estimate")) {
      object[side]["error_estimate"] = nullptr;
    }
  }
  out << object.dump(2) << '\n';
}

void print_csv(const Scene& scene, std::ostream& out) {
  constexpr std::array columns{"rigid_contact.s_wheel",
                               "rigid_contact.t_rail",
                               "rigid_contact.y",
                               "rigid_contact.z",
                               "rigid_contact.angle",
                               "rigid_contact.rolling_radius",
                               "pmax",
                               "pmax_element",
                               "area",
                               "normal_force",
                               "vertical_force",
                               "lateral_force",
                               "longitudinal_force",
                               "moment.x",
                               "moment.y",
                               "moment.z",
                               "centroid.x",
                               "centroid.y",
                               "centroid.z",
                               "centroid.s_wheel",
                               "centroid.rolling_radius",
                               "centroid.angle",
                               "approach",
                               "depth",
                               "angle",
                               "error_estimate",
                               "iterations",
                               "convolutions",
                               "solutions",
                               "fill",
                               "grid.0",
                               "grid.1",
                               "element_size.0",
                               "element_size.1"};
  out << "side,roll,vertical,patches";
  for (const char* column : columns) {
    out << ',' << column;
  }
  out << '\n' << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const std::string& side : scene.sides()) {
    out << side << ',' << scene.number("roll") << ',' << scene.number("vertical") << ','
        << scene.count_of(side + ".patches");
    for (const char* column : columns) {
      out << ',';
      if (const std::string name = side + '.' + column; scene.has_number(name)) {
        out << scene.number(name);
      }
    }
    out << '\n';
  }
}

void write_field(const Scene& scene, const std::filesystem::path& path) {
  OutputFile file(path);
  std::ofstream& out = file.stream();
  out << "side,patch";
  for (const char* name : element_fields) {
    out << ',' << name;
  }
  out << '\n';
  for (const PatchName& patch : all_patches(scene)) {
    std::array<std::vector<double>, element_fields.size()> columns;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      columns[i] = scene.field(patch.prefix + element_fields[i]);
    }
    for (std::size_t element = 0; element < columns[0].size(); ++element) {
      out << patch.side << ',' << patch.index;
      for (const auto& column : columns) {
        out << ',' << column[element];
      }
      out << '\n';
    }
  }
  file.commit();
}

} // namespace driver
