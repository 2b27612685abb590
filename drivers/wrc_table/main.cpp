// wrc_table: makes a table of contact forces for real time, or says what one holds.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string_view>
#include <system_error>
#include <utility>

#include "reports/warning_summary.hpp"
#include "support/output_file.hpp"
#include "support/program.hpp"
#include "support/scene_file.hpp"

namespace {

constexpr const char* purpose =
    "Makes a table of the contact forces of a wheel on its rail, which a vehicle simulation\n"
    "evaluates in microseconds (wrc_table_step, docs/table.md), and measures its error.\n"
    "Without a scene file the table is of S1002 on 60E1.";

constexpr const char* explanation =
    "\nA table is of one wheel profile on one rail profile, with the radius, gauge, inclination "
    "and\n"
    "materials of the scene; left and right wheels share it. It reaches over lateral position, "
    "load,\n"
    "roll and yaw against the rail; friction, velocities, curvature and track irregularities are\n"
    "free. The errors that come with each evaluation are those of random states nearby.\n"
    "\nTABLE.unfinished keeps what is done. If the program is stopped, the same command goes on "
    "from\nthere, at most 20 s back.\n"
    "\nExamples:\n"
    "  wrc_table s1002.table --threads 2\n"
    "  wrc_table lma.table --set wheelset.wheel=LMA track.rail=CHN60 track.gauge_height=16\n"
    "  wrc_table coarse.table --fineness 0.4 --lateral 5      about a tenth of the time\n"
    "  wrc_table blend.table --tolerance 0.03                 exact solution where it errs more\n"
    "  wrc_table s1002.table --show                           what a file holds\n";

std::string percent(double share) {
  std::ostringstream text;
  text << std::setprecision(3) << 100.0 * share << " %";
  return text.str();
}

/// What is doubtful of the scene, on stderr: of its profiles above all, since the table has loads
/// and positions of its own. What cannot be solved is left to the table, which may be able to.
void print_warnings(driver::Scene& scene) {
  try {
    scene.solve();
  } catch (const wrcontact::Error&) {
    return;
  }
  for (const std::string& line : driver::lines_of(driver::warnings_of(scene))) {
    std::cerr << line << '\n';
  }
}

void print_facts(const wrcontact::Table& table) {
  for (const std::string& line : table.lines()) {
    std::cout << line << '\n';
  }
  const wrc_table_facts facts = table.facts();
  std::cout
      << "memory         " << std::setprecision(3) << facts.bytes / 1e6 << " MB\n"
      << "error of a wheel's force over its vertical force, or over half of the largest load if "
         "that is more, in "
      << std::setprecision(6) << facts.states << " random states\n"
      << "  median       " << percent(facts.median_error) << '\n'
      << "  99 %         " << percent(facts.error_99) << '\n'
      << "  worst        " << percent(facts.worst_error) << '\n'
      << "  beyond the error returned with them: " << facts.beyond
      << " (in all, with 95 % certainty, at most " << percent(facts.beyond_at_most) << ")\n";
  std::cout << "  beyond the likely error: " << percent(facts.beyond_likely / facts.states) << '\n'
            << "likely error of derivatives, median over the table: "
            << percent(facts.derivatives_error) << '\n';
  if (facts.tolerance > 0.0) {
    std::cout << "exact solution beyond " << percent(facts.tolerance) << ", in "
              << percent(facts.exact_share) << " of the table\n";
  }
}

/// One line that grows, on a terminal and in a file alike.
class Tenths {
public:
  /// `resumed`: the file of an unfinished table, named once it has been read; empty: none.
  explicit Tenths(std::string resumed) : resumed_(std::move(resumed)) {}

  bool operator()(double fraction) {
    if (!resumed_.empty()) {
      std::cerr << "going on from " << resumed_ << '\n';
      resumed_.clear();
    }
    const int tenths = static_cast<int>(std::floor(10.0 * fraction + 1e-9));
    for (; shown_ < tenths; ++shown_) {
      std::cerr << 10 * (shown_ + 1) << (shown_ == 9 ? " %\n" : " % ") << std::flush;
    }
    return true;
  }

private:
  std::string resumed_;
  int shown_ = 0;
};

/// Throws before another file is replaced.
void check_path(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr std::string_view first_words = "wrcontact table";
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored) && fs::file_size(path, ignored) > 0) {
    std::string start(first_words.size(), '\0');
    std::ifstream(path, std::ios::binary).read(start.data(), first_words.size());
    if (start != first_words) {
      throw driver::Failure("TABLE = " + path +
                            ": exists and is no table; a scene file comes after --scene");
    }
  }
}

} // namespace

int main(int argc, char** argv) {
  driver::Program app("wrc_table", purpose);
  std::string path;
  std::string scene_file;
  std::vector<std::string> assignments;
  wrc_table_options options{};
  bool show = false;
  app.add("TABLE", path, "the file of the table").required();
  app.add("--scene", scene_file, "scene file in TOML").type("FILE");
  app.add("--set", assignments, "set keys of the scene, as in wrc_case")
      .type("KEY=VALUE")
      .one_value_each();
  app.add("--lateral", options.lateral,
          "reach in lateral position, to both sides, 0.5 to 30 mm [10]");
  app.add("--roll", options.roll, "reach in roll against the rail, 0.001 to 0.1 rad [0.01]");
  app.add("--yaw", options.yaw, "reach in yaw, 0.001 to 0.1 rad [0.02]");
  app.add("--load", options.load, "largest load of a wheel, 1000 to 1e6 N [150000]");
  app.add("--tolerance", options.tolerance,
          "likely error over load beyond which steps with a solver take the exact solution, 0 to 1 "
          "[none]");
  app.add("--fineness", options.fineness, "of the nodes, 0.2 to 4 [1]");
  app.add("--threads", options.threads, "threads, 1 to 1024; the table does not depend on it [1]");
  app.flag("--show", show, "print what the file holds, and make nothing");
  app.footer(explanation);
  return app.run(argc, argv, [&] {
    wrcontact::Table table;
    if (show) {
      table.load(path);
      print_facts(table);
      return 0;
    }
    driver::Scene scene;
    if (!scene_file.empty()) {
      driver::apply_scene_file(scene, scene_file);
    }
    driver::apply_assignments(scene, assignments);
    check_path(path);
    driver::refuse_overwriting({path}, {scene_file});
    const auto start = std::chrono::steady_clock::now();
    print_warnings(scene);
    const std::string unfinished =
        path + ".unfinished"; // also tells early that nothing can be written
    const bool resumes = std::filesystem::exists(unfinished);
    options.resume_file = unfinished.c_str();
    table.build(scene, options, Tenths(resumes ? unfinished : ""));
    table.save(path);
    std::filesystem::remove(unfinished);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    print_facts(table);
    std::cout << "made in " << std::setprecision(3) << time.count() << " s\n";
    return 0;
  });
}
