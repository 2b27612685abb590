#include "wrc_case/reports.hpp"

#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numbers>

#include <nlohmann/json.hpp>

#include "support/output_file.hpp"

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
    out_ << '\n' << std::left << std::setw(34) << title;
    for (const std::string& side : sides_) {
      out_ << std::right << std::setw(14) << side;
    }
    out_ << '\n';
  }

  void line(const std::string& label, const std::string& unit, const std::string& name,
            int decimals, double factor = 1.0) const {
    out_ << "  " << std::left << std::setw(27) << label << std::setw(5) << unit << std::right
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

  void scientific(const std::string& label, const std::string& name) const {
    out_ << "  " << std::left << std::setw(32) << label << std::right << std::scientific
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

void print_patches(const Scene& scene, std::ostream& out) {
  out << "\nPatches           pmax      area  normal force     angle   semi-axes x, y     at y, z "
         "of "
         "track   s_wheel\n"
         "                   MPa       mm2             N      mrad               mm               "
         "   mm        mm\n";
  for (const std::string& side : scene.sides()) {
    const int count = scene.count_of(side + ".patches");
    for (int i = 0; i < count; ++i) {
      const std::string prefix = side + ".patches." + std::to_string(i) + '.';
      const auto value = [&](const char* name) { return scene.number(prefix + name); };
      out << "  " << std::left << std::setw(6) << side << std::right << std::setw(2) << i + 1
          << std::fixed << std::setprecision(1) << std::setw(12) << value("pmax") << std::setw(10)
          << value("area") << std::setw(14) << value("normal_force") << std::setw(10)
          << 1e3 * value("angle") << std::setprecision(2) << std::setw(10) << value("semi_axes.0")
          << std::setw(7) << value("semi_axes.1") << std::setw(11) << value("y") << std::setw(8)
          << value("z") << std::setw(10) << value("s_wheel") << std::defaultfloat << '\n';
    }
  }
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
  table.head("Contact");
  table.line("pmax", "MPa", "pmax", 2);
  table.line("area", "mm2", "area", 2);
  table.line("normal force", "N", "normal_force", 1);
  table.line("vertical force", "N", "vertical_force", 1);
  table.line("lateral force on wheel", "N", "lateral_force", 1);
  table.line("approach", "um", "approach", 3, 1e3);
  table.line("angle of the patch", "mrad", "angle", 3, 1e3);
  table.head("How it was solved");
  table.line("elements across, along", "", "grid.0", 0);
  table.line("", "", "grid.1", 0);
  table.line("element across, along", "mm", "element_size.0", 4);
  table.line("", "mm", "element_size.1", 4);
  table.line("in contact", "%", "fill", 1, 100.0);
  table.line("iterations", "", "iterations", 0);
  table.scientific("estimated relative error", "error_estimate");
  table.scientific("load balance", "residuals.load_balance");
  table.scientific("least gap / displacement", "residuals.least_gap");
  table.scientific("complementarity", "residuals.complementarity");
  print_patches(scene, out);
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
    const bool is_count = name.ends_with(".iterations") || name.ends_with(".regrown") ||
                          name.find(".grid.") != std::string::npos;
    if (is_count) {
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
  constexpr std::array<const char*, 22> columns{"rigid_contact.s_wheel",
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
                                                "approach",
                                                "depth",
                                                "angle",
                                                "error_estimate",
                                                "iterations",
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
  out << "side";
  for (const char* name : element_fields) {
    out << ',' << name;
  }
  out << '\n';
  for (const std::string& side : scene.sides()) {
    std::array<std::vector<double>, element_fields.size()> columns;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      columns[i] = scene.field(side + '.' + element_fields[i]);
    }
    for (std::size_t element = 0; element < columns[0].size(); ++element) {
      out << side;
      for (const auto& column : columns) {
        out << ',' << column[element];
      }
      out << '\n';
    }
  }
  file.commit();
}

void write_vtk(const Scene& scene, const std::filesystem::path& path) {
  std::array<std::vector<double>, element_fields.size()> columns;
  std::vector<std::array<std::size_t, 4>> quads;
  for (const std::string& side : scene.sides()) {
    const std::size_t offset = columns[0].size();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto values = scene.field(side + '.' + element_fields[i]);
      columns[i].insert(columns[i].end(), values.begin(), values.end());
    }
    const auto rows = static_cast<std::size_t>(scene.number(side + ".grid.0"));
    const auto length = static_cast<std::size_t>(scene.number(side + ".grid.1"));
    for (std::size_t row = 0; row + 1 < rows; ++row) {
      for (std::size_t column = 0; column + 1 < length; ++column) {
        const std::size_t corner = offset + row * length + column;
        quads.push_back({corner, corner + 1, corner + length + 1, corner + length});
      }
    }
  }
  OutputFile file(path);
  std::ofstream& out = file.stream();
  out << "# vtk DataFile Version 3.0\nwrcontact: x y z in mm (track frame), pressure in MPa\n"
         "ASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS "
      << columns[0].size() << " double\n";
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    out << columns[0][i] << ' ' << columns[1][i] << ' ' << columns[2][i] << '\n';
  }
  out << "CELLS " << quads.size() << ' ' << 5 * quads.size() << '\n';
  for (const auto& quad : quads) {
    out << "4 " << quad[0] << ' ' << quad[1] << ' ' << quad[2] << ' ' << quad[3] << '\n';
  }
  out << "CELL_TYPES " << quads.size() << '\n';
  for (std::size_t i = 0; i < quads.size(); ++i) {
    out << "9\n";
  }
  out << "POINT_DATA " << columns[0].size() << '\n';
  for (std::size_t field = 3; field < element_fields.size(); ++field) {
    out << "SCALARS " << element_fields[field] << " double 1\nLOOKUP_TABLE default\n";
    for (const double value : columns[field]) {
      out << value << '\n';
    }
  }
  file.commit();
}

} // namespace driver
