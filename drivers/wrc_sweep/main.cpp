// wrc_sweep: solves all scenes of a study, on threads or MPI ranks, and writes tables and pictures.
#include <filesystem>
#include <iostream>
#include <unistd.h>

#include "support/gnuplot.hpp"
#include "support/output_file.hpp"
#include "support/program.hpp"
#include "support/text_table.hpp"
#include "wrc_sweep/page.hpp"
#include "wrc_sweep/pictures.hpp"
#include "wrc_sweep/ranks.hpp"
#include "wrc_sweep/result_names.hpp"
#include "wrc_sweep/run.hpp"
#include "wrc_sweep/study_file.hpp"

namespace {

namespace fs = std::filesystem;

struct Options {
  std::string study_file;
  driver::StudyChanges changes;
  std::string folder = ".";
  std::string page;
  int threads = 1;
  int digits = 6;
  bool resume = false;
  bool restart = false;
  bool progress = false;
  bool quiet = false;
  bool no_pictures = false;
  bool list_results = false;
  bool list_studies = false;
};

constexpr int interrupted_code = 130; // exit code of shells for Ctrl-C
constexpr int unsolved_code = 3;      // not a single scene

const char* const footer = R"(
A study is a scene file (wrc_case --help lists the keys) in which a key may have many values:

  [pose]
  lateral = {from = -6, to = 6, step = 0.5}      # or {from, to, count}
  yaw = [0.0, 0.005]                             # or a list
  [wheelset]
  wheel = ["S1002", "my_wheel.prw"]
  [study]                                        # optional
  title = "Measured against new wheels"
  results = ["left.pmax", "right.pmax", "roll"]  # --list-results prints all names
  fields = ["x", "y", "z", "pressure"]           # of every patch, into the NetCDF file
  [[picture]]
  kind = "lines"                                 # or map, patches, connections, conicity, ranking
  x = "pose.lateral"
  series = "wheelset.wheel"
  panels = [{y_label = "p_{max}, MPa", lines = [{result = "left.pmax", title = "left"}]}]

All combinations are solved; the first key varies slowest. NAME.csv (for people) and NAME.nc
(NetCDF-4, all digits) hold one row per scene with its status and warnings; if a scene cannot be solved, its row says why. The
files are identical to the last bit for any number of threads and ranks. Ctrl-C or a crash loses no
finished scene: NAME.rows keeps them, and --resume continues. Exit code: 0, or 3 if no scene
has the status ok, 130 after an interruption, another one if the study could not be run.

Examples:
  wrc_sweep --list-studies
  wrc_sweep fleet --wheels S1002 wheels/*.whl --rails 60E1 --out fleet
  wrc_sweep conicity --wheels worn.prw --rails 60E1 --out conicity
  wrc_sweep study.toml --out results --threads 4
  wrc_sweep study.toml --set 'pose.lateral=[0, 3, 6]' --set track.rail=54E3
  wrc_sweep study.toml --out results --resume
  wrc_sweep study.toml --page study.html --threads 4
  mpirun -n 16 wrc_sweep_mpi study.toml --out results
See docs/studies.md.
)";

/// The files of results: the tables, then pictures.
std::vector<fs::path> files_of(const driver::Study& study, const fs::path& folder) {
  std::vector<fs::path> files{folder / (study.name + ".csv"), folder / (study.name + ".nc")};
  for (const driver::PictureRequest& picture : study.pictures) {
    for (fs::path& file : driver::files_of(picture, folder)) {
      files.push_back(std::move(file));
    }
  }
  return files;
}

driver::Study study_of(const Options& options) {
  driver::Study study = driver::read_study(options.study_file, options.changes);
  study.digits = options.digits;
  study.for_page = !options.page.empty();
  return study;
}

/// What rank 0 does before the first scene.
void begin(const Options& options, std::optional<driver::Study>& study,
           std::optional<driver::Journal>& journal) {
  study = study_of(options);
  if (options.no_pictures) { // those with a table are that
    std::erase_if(study->pictures, [](driver::PictureRequest& picture) {
      picture.is_drawn = false;
      return files_of(picture, {}).empty();
    });
  } else if (!study->pictures.empty()) {
    driver::require_gnuplot();
  }
  const fs::path folder = options.folder;
  driver::make_folder("--out", folder);
  const fs::path rows = folder / (study->name + ".rows");
  const std::vector<fs::path> files = files_of(*study, folder);
  std::vector<fs::path> outputs = files;
  outputs.push_back(rows);
  if (!options.page.empty()) {
    driver::refuse_large_page(*study);
    outputs.emplace_back(options.page);
  }
  std::vector<fs::path> inputs;
  for (const driver::InputFile& input : study->inputs) {
    inputs.emplace_back(input.path);
  }
  driver::refuse_overwriting(outputs, inputs);
  using Old = driver::Journal::Old;
  journal.emplace(rows, *study,
                  options.resume    ? Old::resume
                  : options.restart ? Old::restart
                                    : Old::refuse);
  for (const fs::path& file : files) { // nobody else writes them now
    driver::remove_leftovers(file, driver::Runs::all);
  }
}

/// How many scenes were solved, and the grades of those.
std::string summary_of(std::int64_t scenes, const driver::Journal& journal) {
  const std::int64_t failed = journal.failed();
  const std::string grades = journal.warnings().brief(scenes);
  return std::to_string(scenes) + (scenes == 1 ? " scene: " : " scenes: ") +
         (failed > 0    ? std::to_string(failed) + " not solved"
          : scenes == 1 ? "solved"
                        : "all solved") +
         "; " + (grades.empty() ? "no warnings" : grades);
}

/// What rank 0 does; the exit code.
int lead(const Options& options, const driver::Study& study, const driver::Ranks& ranks,
         driver::Journal& journal) {
  const bool shown = options.progress || (!options.quiet && isatty(STDERR_FILENO) != 0);
  driver::Progress progress(shown, journal.count(), study.scene_count());
  driver::run_study(study, options.threads, ranks, journal, progress);
  const fs::path folder = options.folder;
  if (journal.count() < study.scene_count()) {
    std::cerr << driver::Ranks::program() << ": interrupted, " << journal.count() << " of "
              << study.scene_count() << " scenes are kept in "
              << (folder / (study.name + ".rows")).string() << "; --resume goes on\n";
    return interrupted_code;
  }
  study.refuse_changed_inputs();
  const std::vector<fs::path> files = files_of(study, folder);
  driver::write_csv(study, journal, files[0]);
  driver::write_netcdf(study, journal, files[1]);
  if (!options.page.empty()) {
    driver::write_page(study, journal, options.page);
  }
  const driver::PictureData data(study, journal);
  std::ostringstream findings;
  for (const driver::PictureRequest& picture : study.pictures) {
    driver::draw_picture(picture, data, folder, findings);
    if (const std::string note = driver::note_of_scenes_left_out(picture, study); !note.empty()) {
      std::cerr << driver::Ranks::program() << ": " << note << '\n';
    }
  }
  if (!options.quiet) {
    std::cout << findings.str();
    std::cout << summary_of(study.scene_count(), journal) << '\n';
    for (const fs::path& path : files) {
      std::cout << path.string() << '\n';
    }
    std::cout << options.page << (options.page.empty() ? "" : "\n");
  }
  std::cerr << journal.warnings().text(driver::Ranks::program(), study.scene_count(),
                                       files[0].string());
  const bool none_solved = journal.failed() == study.scene_count();
  journal.remove();
  if (none_solved) {
    std::cerr << driver::Ranks::program() << ": no scene has the status ok; " << files[0].string()
              << " has the message of each\n";
    return unsolved_code;
  }
  return 0;
}

/// `started`: all ranks have begun, so that a failure is of this one.
int sweep(const Options& options, const driver::Ranks& ranks, bool& started) {
  if (options.list_results) {
    for (std::int64_t i = 0; const char* name = wrc_result_name(i); ++i) {
      std::cout << name << '\n';
    }
    return 0;
  }
  if (options.list_studies) {
    driver::TextTable table("l");
    for (const auto& [name, purpose] : driver::shipped_studies()) {
      table.add({name, purpose});
    }
    table.print(std::cout);
    return 0;
  }
  if (options.study_file.empty()) {
    throw driver::Failure("no study given: must be a study file in TOML (wrc_sweep --help shows "
                          "one) or the name of a shipped study (wrc_sweep --list-studies)");
  }
  if (options.resume && options.restart) {
    throw driver::Failure("--resume --restart: must be one of them");
  }
  driver::catch_interrupts();
  if (ranks.rank() > 0) {
    if (!ranks.agree(true)) {
      return 1;
    }
    started = true;
    const driver::Study study = study_of(options);
    driver::serve_study(study, options.threads, ranks);
    return 0;
  }
  std::optional<driver::Study> study;
  std::optional<driver::Journal> journal;
  try {
    begin(options, study, journal);
  } catch (...) {
    (void)ranks.agree(false); // the others end too
    throw;
  }
  (void)ranks.agree(true);
  return lead(options, *study, ranks, *journal);
}

} // namespace

int main(int argc, char** argv) {
  driver::Program app(driver::Ranks::program(),
                      "Solves a study: a wheel/rail scene for every combination of the values "
                      "listed for its keys.");
  Options options;
  app.add("STUDY", options.study_file, "study file in TOML, or the name of a shipped study")
      .type("FILE|NAME");
  app.add("--out", options.folder, "folder of the results; created if it does not exist")
      .type("DIR")
      .show_default();
  app.add("--threads", options.threads, "threads of each rank; results do not depend on it")
      .within(1, 1024)
      .show_default();
  app.add("--wheels", options.changes.wheels,
          "wheels to study, built-in names and files, instead of those of the study")
      .type("NAME|FILE");
  app.add("--rails", options.changes.rails,
          "rails to study, built-in names and files, instead of those of the study")
      .type("NAME|FILE");
  app.add("--set", options.changes.assignments,
          "set one or more keys, overriding the study file; lists and ranges as in the file")
      .type("KEY=VALUE")
      .one_value_each();
  app.add("--page", options.page, "write a page for a browser as well, with a slider for each key")
      .type("FILE");
  app.add("--digits", options.digits, "digits of numbers in CSV files; 17: all that there are")
      .within(1, 17)
      .show_default();
  app.flag("--resume", options.resume, "continue an interrupted run, if there is one");
  app.flag("--restart", options.restart, "drop the rows of an interrupted run");
  app.flag("--progress", options.progress, "show progress even if stderr is not a terminal");
  app.flag("--quiet", options.quiet, "show warnings only, neither progress nor files written");
  app.flag("--no-pictures", options.no_pictures, "draw no pictures");
  app.flag("--list-results", options.list_results, "print the names of all results");
  app.flag("--list-studies", options.list_studies, "print the shipped studies");
  app.footer(footer);
  return app.run(argc, argv, [&] {
    const driver::Ranks ranks;
    bool started = ranks.rank() == 0;
    try {
      return sweep(options, ranks, started);
    } catch (const std::exception& error) {
      if (ranks.size() == 1) {
        throw;
      }
      if (started) {
        std::cerr << driver::Ranks::program() << ", rank " << ranks.rank() << ": " << error.what()
                  << '\n';
      }
      ranks.abort(1);
    }
  });
}
