// wrc_case: solves one scene and prints, writes or draws what came out.
#include <iostream>

#include "reports/scene_picture.hpp"
#include "support/gnuplot.hpp"
#include "support/output_file.hpp"
#include "support/program.hpp"
#include "support/scene_file.hpp"
#include "wrc_case/reports.hpp"

namespace {

constexpr const char* purpose =
    "Solves a wheel/rail contact scene: contact patches, pressures and forces of both wheels.\n"
    "Without a scene file it solves Table 1 of the paper: S1002 on 60E1, 80 kN per wheel, "
    "centred.";

constexpr const char* examples =
    "\nExamples:\n"
    "  wrc_case --set pose.lateral=5 --plot picture.png\n"
    "  wrc_case --set track.rail=CHN60 wheelset.wheel=LMA track.gauge_height=16 --json\n"
    "  wrc_case scene.toml --set solve.grid=[256,128] --field field.csv\n"
    "  wrc_case --set creepage.left=[0.001,0.0005,0.0002] --plot tractions.png\n"
    "  wrc_case --set solve.results=stress --plot stress.png --stress stress.vtk\n";

/// Sets the keys of the file, if there is one, and of the assignments.
void set_keys(driver::Scene& scene, const std::string& scene_file,
              const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) {
    (void)driver::split_assignment(assignment); // before a mistake here is taken as a file
  }
  if (!scene_file.empty()) {
    driver::apply_scene_file(scene, scene_file);
  }
  driver::apply_assignments(scene, assignments);
}

/// Files for profiles less the groove.
struct GroovedFiles {
  std::string wheel;
  std::string rail;

  void add_to(driver::Program& app) {
    app.add("--grooved-wheel", wheel,
            "write the wheel's profile less the groove that steel keeps where it yields; with one "
            "solve.side and solve.results=groove")
        .type("FILE");
    app.add("--grooved-rail", rail, "likewise the rail's").type("FILE");
  }
  void check(const driver::Scene& scene) const {
    const bool known = scene.get_text("solve.results").find("groove") != std::string::npos &&
                       scene.get_text("solve.side") != "both";
    if (!known && !(wheel.empty() && rail.empty())) {
      throw driver::Failure(
          (wheel.empty() ? "--grooved-rail " + rail : "--grooved-wheel " + wheel) +
          ": needs the groove of one wheel; add --set solve.results=groove "
          "solve.side=left");
    }
    if (!wheel.empty()) {
      driver::require_one_profile(scene, true);
    }
    if (!rail.empty()) {
      driver::require_one_profile(scene, false);
    }
  }
  void write(const driver::Scene& scene) const {
    if (!wheel.empty()) {
      driver::write_grooved_profile(scene, true, wheel);
    }
    if (!rail.empty()) {
      driver::write_grooved_profile(scene, false, rail);
    }
  }
};

/// Mistakes that show before the scene is solved.
void check(const driver::Scene& scene, const std::string& plot, const std::string& stress,
           const GroovedFiles& grooved) {
  grooved.check(scene);
  if (!plot.empty()) {
    driver::require_picture_name(plot);
  }
  if (!stress.empty() && scene.get_text("solve.results").find("stress") == std::string::npos) {
    throw driver::Failure("--stress " + stress +
                          ": no stresses are computed; add --set solve.results=stress");
  }
}

std::string keys_text() {
  std::ostringstream text;
  text << "Keys of a scene (mm, N, MPa, rad, y left, z up unless convention says otherwise):\n";
  for (const wrcontact::SceneKey& key : wrcontact::scene_keys()) {
    text << "  " << std::left << std::setw(31) << key.name << key.meaning << "\n"
         << std::string(33, ' ') << "default " << key.default_value << "; allowed: " << key.allowed
         << '\n';
  }
  return text.str();
}

/// The scene file, if there is one, and profiles that are files.
std::vector<std::filesystem::path> inputs_of(const driver::Scene& scene,
                                             const std::string& scene_file) {
  std::vector<std::filesystem::path> inputs{scene_file};
  for (const std::string& file : driver::profile_files(scene)) {
    inputs.emplace_back(file);
  }
  return inputs;
}

} // namespace

int main(int argc, char** argv) {
  driver::Program app("wrc_case", purpose);
  std::string scene_file;
  std::vector<std::string> assignments;
  bool json = false;
  bool csv = false;
  int digits = 6;
  std::string vtk, plot, field, creep_field, stress, save;
  GroovedFiles grooved;
  app.add("SCENE", scene_file, "scene file in TOML; every key is optional");
  app.add("--set", assignments,
          "set one or more keys of the scene, such as pose.lateral=5 track.rail=CHN60; may be "
          "repeated. Words need no quotes, lists are [a,b]")
      .type("KEY=VALUE")
      .one_value_each();
  app.flag("--json", json, "print one JSON object instead of the table");
  app.flag("--csv", csv, "print CSV, one line per side, instead of the table");
  app.add("--digits", digits, "digits of numbers of --csv; 17 prints full precision")
      .within(1, 17)
      .show_default();
  app.add("--vtk", vtk, "write the fields of all patches as legacy VTK, for ParaView").type("FILE");
  app.add("--plot", plot, "draw profiles, patches, pressures and tractions").type("FILE.png|svg");
  app.add("--field", field, "write the fields of all patches as CSV, one line per element")
      .type("FILE.csv");
  app.add("--creep-field", creep_field, "write tractions and slips as CSV, one line per element")
      .type("FILE.csv");
  app.add("--stress", stress, "write sections of the stresses below the surface as legacy VTK")
      .type("FILE.vtk");
  grooved.add_to(app);
  app.add("--save", save, "write all keys of the scene, to solve it again").type("FILE.toml");
  app.footer("\n" + keys_text() + driver::standard_names_text() + examples);
  return app.run(argc, argv, [&] {
    if (json && csv) {
      throw driver::Failure("--json --csv: must be one of them");
    }
    driver::Scene scene;
    set_keys(scene, scene_file, assignments);
    driver::refuse_overwriting(
        {save, field, creep_field, vtk, stress, plot, grooved.wheel, grooved.rail},
        inputs_of(scene, scene_file));
    check(scene, plot, stress, grooved);
    const bool converged = scene.solve();
    if (!save.empty()) {
      scene.write(save);
    }
    // Numbers for programs are in the requested units and frame ...
    if (json) {
      driver::print_json(scene, std::cout);
    } else if (csv) {
      driver::print_csv(scene, digits, std::cout);
    }
    if (!field.empty()) {
      driver::write_field(scene, field);
    }
    if (!creep_field.empty()) {
      driver::write_creep_field(scene, creep_field);
    }
    // ... what people look at says its units.
    scene.set("convention.units", "mm");
    scene.set("convention.frame", "left-up");
    if (!json && !csv) {
      driver::print_table(scene, std::cout);
    }
    if (!vtk.empty()) {
      driver::write_vtk(scene, vtk);
    }
    if (!stress.empty()) {
      driver::write_stress_vtk(scene, stress);
    }
    grooved.write(scene);
    if (!plot.empty()) {
      driver::draw_scene(scene, plot, driver::warnings_of(scene));
    }
    if (!converged) {
      std::cerr << "wrc_case: not converged: the printed results are approximate\n";
      return 3;
    }
    return 0;
  });
}
