/// wrc_sweep as a process: the same rows however they are computed, after an interrupt too.
#include <array>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <map>
#include <set>
#include <sstream>
#include <sys/file.h>
#include <thread>

#include "run_driver.hpp"

namespace wrc_sweep_test {
namespace {

/// 35 scenes that are solved in a second.
const std::string study = "[pose]\nlateral = {from = -3, to = 3, step = 1}\n"
                          "yaw = [0.0, 0.01, 0.02, 0.03, 0.04]\n[solve]\ngrid = [24, 20]\n"
                          "[study]\nfields = [\"pressure\", \"y\"]\n";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> entries_of(const std::string& line) {
  std::vector<std::string> entries;
  std::istringstream in(line);
  for (std::string entry; std::getline(in, entry, ',');) {
    entries.push_back(entry);
  }
  return entries;
}

class WrcSweep : public Driver {
protected:
  WrcSweep() : Driver(WRC_SWEEP_PROGRAM) {}
  /// Table and NetCDF file of a study that must succeed, and say nothing but what is expected.
  [[nodiscard]] std::array<std::string, 2> files(const std::string& arguments,
                                                 const std::string& folder,
                                                 const std::string& warning = "") const {
    const Outcome outcome = run(arguments + " --out " + folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.error.empty(), warning.empty()) << outcome.error;
    EXPECT_NE(outcome.error.find(warning), std::string::npos) << outcome.error;
    return {read(folder + "/s.csv"), read(folder + "/s.nc")};
  }
  /// An entry of a table by row (0 first) and column name.
  [[nodiscard]] std::string entry(const std::string& file, std::size_t row,
                                  const std::string& column) const {
    const auto lines = lines_of(read(file));
    const auto names = entries_of(lines.at(0));
    const auto found = std::find(names.begin(), names.end(), column);
    EXPECT_NE(found, names.end()) << column;
    return entries_of(lines.at(row + 1)).at(static_cast<std::size_t>(found - names.begin()));
  }
};

TEST_F(WrcSweep, CombinesAllValuesAndVariesTheLastKeyFastest) {
  write("s.toml", "[track]\ninclination = [\"1:20\", \"1:40\"]\n[pose]\n"
                  "lateral = {from = 0, to = 0.3, step = 0.1}\n[load]\nboth = 0\n");
  (void)files("s.toml", "o");
  const auto lines = lines_of(read("o/s.csv"));
  ASSERT_EQ(lines.size(), 9U);
  EXPECT_TRUE(lines[0].starts_with("scene,track.inclination,pose.lateral,roll,"));
  EXPECT_TRUE(lines[0].ends_with(",grade,warning_count,status,message,warnings")) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("0,1:20,0,"));
  EXPECT_TRUE(lines[4].starts_with("3,1:20,0.3,")) << lines[4];
  EXPECT_TRUE(lines[4].ends_with(",0,0,ok,,")) << lines[4];
  EXPECT_TRUE(lines[5].starts_with("4,1:40,0,"));
  for (const std::string& line : lines) {
    EXPECT_EQ(line.find("time"), std::string::npos);
  }
}

TEST_F(WrcSweep, RowsEqualResultsOfWrcCase) {
  write("s.toml", "[pose]\nlateral = [-2, 3]\n[solve]\naccuracy = 1e-2\n[study]\nresults = "
                  "[\"left.pmax\", \"left.patches.0.centroid.y\", \"left.patch_count\"]\n");
  (void)files("s.toml --digits 17", "o");
  const auto left =
      run_json(WRC_CASE_PROGRAM, "--set pose.lateral=3 --set solve.accuracy=1e-2").at("left");
  EXPECT_EQ(std::stod(entry("o/s.csv", 1, "left.pmax")), left.at("pmax").get<double>());
  EXPECT_EQ(std::stod(entry("o/s.csv", 1, "left.patches.0.centroid.y")),
            left.at("patches").at(0).at("centroid").at("y").get<double>());
  EXPECT_EQ(entry("o/s.csv", 1, "left.patch_count"), "1");
  (void)files("s.toml", "people");
  std::array<char, 32> six{};
  (void)std::snprintf(six.data(), six.size(), "%.6g", left.at("pmax").get<double>());
  EXPECT_EQ(entry("people/s.csv", 1, "left.pmax"), six.data());
  EXPECT_NE(entry("people/s.csv", 1, "left.pmax"), entry("o/s.csv", 1, "left.pmax"));
}

TEST_F(WrcSweep, ThreadsDoNotChangeABit) {
  write("s.toml", study);
  const auto one = files("s.toml --threads 1", "one");
  EXPECT_GT(one[1].size(), 100000U) << "fields are missing";
  for (const char* threads : {"2", "5"}) {
    EXPECT_EQ(files(std::string("s.toml --threads ") + threads, threads), one) << threads;
  }
}

TEST_F(WrcSweep, RanksDoNotChangeABit) {
  if (std::string(WRC_MPIEXEC).empty()) {
    GTEST_SKIP() << "built without MPI";
  }
  write("s.toml", study);
  // Leaks of the MPI library are not ours to find.
  const std::string in_mpi = std::string("ASAN_OPTIONS=detect_leaks=0 '") + WRC_MPIEXEC + "'";
  const auto alone = files("s.toml", "alone");
  for (const char* ranks : some_of({"2", "1", "3"}, 1)) {
    for (const char* threads : some_of({"2", "1"}, 1)) {
      const std::string folder = std::string("ranks") + ranks + threads;
      const Outcome outcome = run(
          "env", in_mpi + " -n " + ranks + " --allow-run-as-root --oversubscribe '" +
                     WRC_SWEEP_MPI_PROGRAM + "' s.toml --threads " + threads + " --out " + folder);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
      EXPECT_EQ(read(folder + "/s.csv"), alone[0]) << ranks << threads;
      EXPECT_EQ(read(folder + "/s.nc"), alone[1]) << ranks << threads;
    }
  }
  const Outcome refused = run("env", in_mpi + " -n 2 --allow-run-as-root --oversubscribe '" +
                                         WRC_SWEEP_MPI_PROGRAM + "' missing.toml");
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_NE(refused.error.find("missing.toml"), std::string::npos) << refused.error;
}

/// Runs the program until its journal has grown to some rows, then sends a signal; the exit status.
int interrupt_when_begun(const std::filesystem::path& folder, const std::string& journal,
                         std::uintmax_t bytes, int signal) {
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) {
      execl(WRC_SWEEP_PROGRAM, WRC_SWEEP_PROGRAM, "s.toml", "--out", "o",
            static_cast<char*>(nullptr));
    }
    _exit(127);
  }
  const auto size = [&] {
    std::error_code none;
    const auto now = std::filesystem::file_size(folder / journal, none);
    return none ? 0 : now;
  };
  int status = 0;
  while (size() < bytes && waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(child, signal);
  waitpid(child, &status, 0);
  return status;
}

TEST_F(WrcSweep, ResumesAfterAnInterruptOrAKill) {
  // Finer than needed, so that the signal comes before the end.
  write("s.toml", "[pose]\nlateral = {from = 2, to = 6, count = 60}\n[solve]\ngrid = [128, 128]\n"
                  "[study]\nfields = [\"pressure\"]\n");
  constexpr const char* warned = " of 60 scenes"; // with their grades, kept in the rows, too
  const auto whole = files("s.toml", "whole", warned);
  for (const int signal : some_of({SIGINT, SIGKILL}, 1)) {
    SCOPED_TRACE(signal);
    std::filesystem::remove_all(folder() / "o");
    constexpr std::uintmax_t some_rows = 1 << 20;
    const int status = interrupt_when_begun(folder(), "o/s.rows", some_rows, signal);
    if (signal == SIGKILL) {
      EXPECT_TRUE(WIFSIGNALED(status));
    } else {
      ASSERT_TRUE(WIFEXITED(status));
      EXPECT_EQ(WEXITSTATUS(status), 130);
    }
    EXPECT_FALSE(exists("o/s.csv"));
    ASSERT_TRUE(exists("o/s.rows"));
    run("s.toml --out o").expect_refusal({"o/s.rows", "--resume", "--restart"});
    // A row that was being written.
    write("o/s.rows", read("o/s.rows") + std::string(50, 'x'));
    run("s.toml --set pose.yaw=0.01 --out o --resume").expect_refusal({"another study"});
    EXPECT_EQ(files("s.toml --resume", "o", warned), whole);
    EXPECT_FALSE(exists("o/s.rows"));
  }
  EXPECT_EQ(files("s.toml --resume", "fresh", warned), whole) << "nothing to resume is no failure";
}

TEST_F(WrcSweep, TwoRunsDoNotWriteTheSameResults) {
  write("s.toml", study);
  write("o/s.rows", "");
  const int other = open((folder() / "o/s.rows").c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  run("s.toml --out o --restart").expect_refusal({"o/s.rows", "another run"});
  close(other);
  (void)files("s.toml --restart", "o");
}

TEST_F(WrcSweep, FailedScenesHaveRows) {
  write("s.toml", "[pose]\nlateral = [0, 100]\n[track]\nrail = [\"60E1\", \"nowhere.prr\"]\n"
                  "[study]\nresults = [\"left.pmax\"]\n");
  (void)files("s.toml --set solve.accuracy=1e-2", "o");
  EXPECT_EQ(entry("o/s.csv", 0, "status"), "ok");
  EXPECT_GT(std::stod(entry("o/s.csv", 0, "left.pmax")), 100.0);
  const auto lines = lines_of(read("o/s.csv"));
  ASSERT_EQ(lines.size(), 5U);
  for (const std::size_t row : {1U, 2U, 3U}) {
    EXPECT_EQ(lines[row + 1].find(",ok,"), std::string::npos) << lines[row + 1];
    EXPECT_TRUE(lines[row + 1].ends_with(",")) << "a failed scene has no results";
  }
  EXPECT_NE(lines[2].find("nowhere.prr"), std::string::npos) << lines[2];
  const Outcome none = run("s.toml --set pose.lateral=100 --out none");
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_TRUE(none.out.starts_with("2 scenes: 2 not solved; no warnings\n")) << none.out;
  EXPECT_NE(none.error.find("no scene has the status ok; none/s.csv"), std::string::npos)
      << none.error;
}

TEST_F(WrcSweep, AssignmentsOverrideTheFile) {
  write("s.toml", "[pose]\nlateral = [0, 1, 2]\nyaw = 0.01\n[load]\nboth = 0\n");
  (void)files("s.toml --set pose.lateral=2 --set 'pose.yaw=[0, 0.02]' --set track.rail=54E3", "o");
  const auto lines = lines_of(read("o/s.csv"));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_TRUE(lines[0].starts_with("scene,pose.yaw,roll,"));
  EXPECT_TRUE(lines[2].starts_with("1,0.02,"));
}

/// Of one wheel in the file, of both on the command line.
TEST_F(WrcSweep, AnAssignmentOfBothWheelsOverridesOneWheelInTheFile) {
  write("s.toml", "[load]\nleft = 50000.0\n[study]\nresults = [\"left.vertical_force\"]\n");
  (void)files("s.toml --set 'load.both=[60000,70000]'", "o");
  EXPECT_NEAR(std::stod(entry("o/s.csv", 0, "left.vertical_force")), 60000.0, 1e-3);
  EXPECT_NEAR(std::stod(entry("o/s.csv", 1, "left.vertical_force")), 70000.0, 1e-3);
}

TEST_F(WrcSweep, AListOfOneValueDoesNotVary) {
  write("s.toml", "[solve]\ngrid = [24, 20]\n[pose]\nlateral = [0, 1]\n");
  (void)files("s.toml", "o");
  EXPECT_EQ(line_count(read("o/s.csv")), 3);
  write("s.toml", "[solve]\ngrid = [[24, 20], [30, 20], [40, 30]]\n");
  (void)files("s.toml", "two");
  EXPECT_EQ(line_count(read("two/s.csv")), 4);
}

TEST_F(WrcSweep, ProgressIsShownOnRequest) {
  write("s.toml", "[pose]\nlateral = [0, 1]\n[load]\nboth = 0\n");
  EXPECT_EQ(run("s.toml").error, "") << "stderr is no terminal";
  const Outcome outcome = run("s.toml --progress");
  EXPECT_NE(outcome.error.find("2 of 2"), std::string::npos) << outcome.error;
}

TEST_F(WrcSweep, MapsHaveColoursAndContours) {
  NEEDS_GNUPLOT();
  write("s.toml", "[pose]\nyaw = [0.0, 0.01, 0.02]\nlateral = {from = -6, to = 6, step = 1}\n"
                  "[load]\nboth = 0\n[[picture]]\nkind = \"map\"\nfile = \"map.svg\"\nx = "
                  "\"pose.lateral\"\nseries = \"pose.yaw\"\nseries_label = \"yaw, mrad\"\n"
                  "series_factor = 1000.0\npanels = [{y_label = \"place\", lines = [{result = "
                  "\"left.rigid_contact.y\"}]}]\n");
  (void)files("s.toml", "o");
  const std::string map = read("o/map.svg");
  const auto label = map.find("yaw, mrad");
  ASSERT_NE(label, std::string::npos);
  constexpr double letter = 10.0; // pixels, upright: it is not cut off
  EXPECT_GT(std::stod(map.substr(map.rfind("translate(", label) + 10)), letter);
  EXPECT_NE(map.find("<path"), std::string::npos); // contours
  std::set<std::string> colours;
  for (auto at = map.find("rgb("); at != std::string::npos; at = map.find("rgb(", at + 1)) {
    colours.insert(map.substr(at, map.find(')', at) - at));
  }
  constexpr std::size_t many = 20; // of a palette over a field that varies
  EXPECT_GT(colours.size(), many);
}

TEST_F(WrcSweep, PicturesDistinguishManyLinesAndNumberConnections) {
  NEEDS_GNUPLOT();
  write("s.toml", "[pose]\nyaw = [0.0, 0.01]\nlateral = {from = -6, to = 6, step = 1}\n[load]\n"
                  "both = 0\n[[picture]]\nfile = \"lines.svg\"\nx = \"pose.yaw\"\nseries = "
                  "\"pose.lateral\"\npanels = [{lines = [{result = \"left.rigid_contact.y\"}]}]\n");
  (void)files("s.toml", "o");
  const std::string lines = read("o/lines.svg");
  std::set<std::string> colours;
  for (auto at = lines.find("rgb("); at != std::string::npos; at = lines.find("rgb(", at + 1)) {
    colours.insert(lines.substr(at, lines.find(')', at) - at));
  }
  EXPECT_GE(colours.size(), 13U);
  std::ifstream shipped(std::filesystem::path(WRC_STUDIES) / "connections.toml");
  std::string text{std::istreambuf_iterator<char>(shipped), {}};
  const auto at = text.find("connections.png");
  write("s.toml", text.replace(at, 15, "connections.svg"));
  (void)files("s.toml", "o");
  const std::string connections = read("o/connections.svg");
  for (const char* label : {">-6.5<", ">-5.5<", ">-4<", ">-3.5<", ">-2.5<", ">2<", ">4.5<"}) {
    EXPECT_NE(connections.find(label), std::string::npos) << label;
  }
  // No label meets another.
  std::vector<std::array<double, 2>> places;
  for (auto at_label = connections.find("font-size=\"8.00\""); at_label != std::string::npos;
       at_label = connections.find("font-size=\"8.00\"", at_label + 1)) {
    const auto place = connections.rfind("translate(", at_label) + 10;
    std::istringstream numbers(connections.substr(place, connections.find(')', place) - place));
    char comma = 0;
    std::array<double, 2> read{};
    ASSERT_TRUE(numbers >> read[0] >> comma >> read[1]);
    for (const auto& other : places) {
      constexpr std::array size{25.0, 14.0}; // of a label
      EXPECT_TRUE(std::abs(read[0] - other[0]) > size[0] || std::abs(read[1] - other[1]) > size[1])
          << read[0] << ' ' << read[1];
    }
    places.push_back(read);
  }
  EXPECT_EQ(places.size(), 2U * 29U);
}

TEST_F(WrcSweep, EveryShippedStudyRunsAndDraws) {
  NEEDS_GNUPLOT();
  std::set<std::string> pictures;
  const std::set<std::string> few{"creep_curves", "fig05", "fig12", "connections"};
  for (const auto& file : std::filesystem::directory_iterator(WRC_STUDIES)) {
    if (file.is_directory() || !by_extent(true, few.contains(file.path().stem()))) {
      continue;
    }
    // Coarse: what matters is that all keys, results and pictures fit each other.
    const std::string coarse =
        file.path().stem() == "fig05" ? "--set 'solve.grid=[32, 16]'" : "--set solve.accuracy=0.1";
    const Outcome outcome =
        run(file.path().stem().string() + ' ' + coarse + " --threads 2 --out o");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_NE(outcome.out.find(" all solved; "), std::string::npos) << file.path() << outcome.out;
    for (const std::string& line : lines_of(outcome.out)) {
      if (line.ends_with(".png")) {
        EXPECT_TRUE(is_png(line)) << line;
        EXPECT_TRUE(pictures.insert(line).second) << line << " is drawn by two studies";
      }
    }
  }
  EXPECT_GE(pictures.size(), by_extent(16U, 4U));
  // Creep curves end in full sliding: all of 0.3 x 80 kN, in the direction of the slip.
  constexpr double bound = 0.3 * 80e3;
  std::map<std::string, double> last; // of each model without spin
  const std::string curves = "o/creep_curves.csv";
  const auto rows = lines_of(read(curves)).size() - 1;
  for (std::size_t row = 0; row < rows; ++row) {
    if (entry(curves, row, "creepage.spin") == "0") {
      last[entry(curves, row, "solve.creep")] =
          std::stod(entry(curves, row, "left.patches.0.creep_force.longitudinal"));
    }
  }
  EXPECT_EQ(last.size(), 3U);
  for (const auto& [model, force] : last) {
    EXPECT_NEAR(force, -bound, 0.005 * bound) << model; // Polach's law only tends to it
  }
}

TEST_F(WrcSweep, RefusesBadStudies) {
  run("crosing").expect_refusal({"crosing: no such file", "shipped studies are", " crossing "});
  const auto refuse = [&](const std::string& text, std::initializer_list<std::string> parts) {
    write("s.toml", text);
    run("s.toml --out o").expect_refusal(parts);
    EXPECT_FALSE(exists("o/s.rows")) << text;
  };
  refuse("[pose]\nsideways = [1, 2]\n",
         {"s.toml, line 2: unknown key pose.sideways", "pose.lateral"});
  refuse("[pose]\nlateral = [1, 20000]\n", {"pose.lateral = 20000", "between -1e4 and 1e4"});
  refuse("[pose]\nlateral = []\n", {"pose.lateral"});
  refuse("[pose]\nlateral = {from = 1, to = 2}\n", {"pose.lateral", "{from, to, step}"});
  refuse("[pose]\nlateral = {from = 1, to = 2, step = -1}\n", {"pose.lateral", "step"});
  refuse("[pose]\nlateral = {from = 1, to = 2, step = 0}\n", {"pose.lateral", "step"});
  refuse("[pose]\nlateral = {from = 0, to = 1, step = 0.3}\n",
         {"a step that ends at `to`, such as step = 0.333333333333, or to = 0.9"});
  refuse("[pose]\nlateral = {from = 0, to = 1, step = 0.999}\n",
         {"such as step = 1, or to = 0.999"});
  refuse("[pose]\nlateral = {from = 1, to = 2, count = 1.5}\n", {"pose.lateral", "count"});
  refuse("[pose]\nlateral = {from = 1, to = 2, steps = 3}\n", {"pose.lateral", "steps"});
  refuse("[pose]\nlateral = {from = 0, to = 9, count = 9000}\nyaw = {from = 0, to = 0.1, count = "
         "9000}\n[load]\nboth = {from = 0, to = 1, count = 90}\n",
         {"scenes", "must be at most 1e7"});
  refuse("[study]\nresults = [\"left.pmx\"]\n",
         {"left.pmx", "nearest: left.pmax;", "--list-results"});
  refuse("[study]\nresults = \"left.pmax\"\n", {"study.results", "list of texts"});
  refuse("[study]\nresults = [\"roll\", \"roll\"]\n", {"study.results", "\"roll\"", "once"});
  refuse("[study]\nfields = [\"x\", \"x\"]\n", {"study.fields", "\"x\"", "once"});
  refuse("[study]\nfields = [\"heat\"]\n", {"heat", "pressure"});
  refuse("[study]\nresult = []\n", {"study.result", "results"});
  refuse("[study]\nname = \"a/b\"\n", {"a/b", "without folder"});
  const std::string axis = "[pose]\nlateral = [0, 1]\n";
  refuse(axis + "[[picture]]\nkind = \"pie\"\n", {"picture.kind", "pie", "lines"});
  refuse(axis + "[[picture]]\nx = \"pose.yaw\"\n", {"picture.x", "pose.yaw"});
  refuse(axis + "[[picture]]\nfile = \"a.pdf\"\n", {"a.pdf", ".png"});
  refuse(axis + "[[picture]]\nfile = \"a/b.png\"\n", {"a/b.png", "without folder"});
  refuse(axis + "[[picture]]\nkind = \"patches\"\n", {"needs", "study.fields"});
  refuse(axis + "[[picture]]\n", {"picture.panels", "one panel or more"});
  refuse(axis + "[[picture]]\npanels = [{y_label = \"y\"}]\n", {"picture.panels.lines"});
  const std::string lines = "panels = [{lines = [{result = \"left.pmax\"}]}]\n";
  refuse(axis + "[[picture]]\nkind = \"map\"\n" + lines, {"picture.series", "varies"});
  refuse(axis + "[track]\nrail = [\"60E1\", \"54E1\"]\n[[picture]]\nkind = \"map\"\n" + lines +
             "x = \"pose.lateral\"\nseries = \"track.rail\"\n",
         {"picture.series", "track.rail", "numbers"});
  refuse(axis + "[[picture]]\nx_values = [0, 2]\n" + lines,
         {"picture.x_values = 2", "a value of pose.lateral: 0, 1"});
  refuse("[track]\nrail = [\"60E1\", \"54E3\"]\n" + axis +
             "[[picture]]\nwhere = {\"track.rail\" = "
             "\"54E1\"}\n" +
             lines,
         {"picture.where = 54E1", "a value of track.rail: 60E1, 54E3"});
  refuse("[track]\nrail = [\"60E1\", \"54E3\"]\n[[picture]]\n" + lines,
         {"picture.x", "track.rail", "numbers"});
  const std::string picture = "[[picture]]\nfile = \"p.png\"\n" + lines;
  if (gnuplot_is_there()) {
    refuse(axis + picture + picture, {"o/p.png", "twice"});
  }
  refuse(axis + "[[picture]]\npanels = [{lines = [{result = \"left.area2\"}]}]\n",
         {"picture.panels.lines.result", "left.area2"});
  refuse(axis + "[[picture]]\ncolour = 3\n", {"picture.colour", "must be one of"});
  refuse("[pose]\nlateral = = 1\n", {"s.toml", "line 2"});
}

TEST_F(WrcSweep, APageHoldsTheScenes) {
  write("s.toml", "[pose]\nlateral = [3, 100]\n[track]\nrail = [\"60E1\", \"54E1\"]\n[creepage]\n"
                  "longitudinal = 0.001\n[solve]\ncreep = \"full\"\naccuracy = 1e-2\n[study]\n"
                  "title = \"</script><b>\"\n");
  EXPECT_TRUE(run("s.toml --page p.html").out.ends_with("./s.csv\n./s.nc\np.html\n"));
  EXPECT_TRUE(exists("s.csv") && exists("s.nc")) << "of the same solution";
  const std::string page = read("p.html");
  for (const char* loaded : {"src=\"", "href=", "http:", "https:", "import", "url(", "fetch",
                             "</script><b>", "innerHTML"}) {
    EXPECT_EQ(page.find(loaded), std::string::npos) << loaded;
  }
  ASSERT_EQ(run("s.toml --page q.html --threads 3").exit_code, 0);
  EXPECT_EQ(read("q.html"), page);
  const std::string begin = "const data = ";
  const std::size_t start = page.find(begin) + begin.size();
  const auto data = nlohmann::json::parse(page.substr(start, page.find(";\n", start) - start));
  EXPECT_EQ(data["title"], "</script><b>");
  EXPECT_EQ(data["axes"][0]["values"], nlohmann::json({3.0, 100.0}));
  ASSERT_EQ(data["scenes"].size(), 4U);
  const std::string scene = "--set pose.lateral=3 --set track.rail=54E1 --set "
                            "creepage.longitudinal=0.001 --set solve.creep=full --set "
                            "solve.accuracy=1e-2";
  const auto left = data["scenes"][1]["left"];
  const auto expected = run_json(WRC_CASE_PROGRAM, scene)["left"];
  EXPECT_EQ(left["pmax"], expected["pmax"]);
  EXPECT_EQ(left["total.force.x"], expected["total"]["force"]["x"]);
  const auto normal = left["patches"][0]["normal"];
  EXPECT_EQ(normal["pressure"].size(), normal["x"].size() * normal["y"].size());
  EXPECT_NEAR(*std::max_element(normal["pressure"].begin(), normal["pressure"].end()),
              expected["patches"][0]["pmax_element"].get<double>(), 0.5); // whole MPa
  EXPECT_EQ(left["patches"][0]["creep"]["traction_x"].size(),
            left["patches"][0]["creep"]["x"].size() * left["patches"][0]["creep"]["y"].size());
  EXPECT_NE(data["scenes"][2]["message"].get<std::string>().find("wheel off the rail"),
            std::string::npos);
  run("s.toml --page s.toml").expect_refusal({"s.toml"});
  run("s.toml --set 'pose.yaw={from = 0, to = 0.01, count = 501}' --page p.html")
      .expect_refusal({"--page", "2004", "2000"});
}

TEST_F(WrcSweep, RefusesBadArguments) {
  write("s.toml", study);
  run("").expect_refusal({"no study given"});
  run("missing.toml").expect_refusal({"missing.toml"});
  run("s.toml --threads 0").expect_refusal({"--threads"});
  run("s.toml --resume --restart").expect_refusal({"--resume", "--restart"});
  run("s.toml --set pose.lateral").expect_refusal({"--set pose.lateral", "key=value"});
  run("s.toml --out s.toml/x").expect_refusal({"--out s.toml/x"});
  const Outcome help = run("--help");
  expect_parts(help.out, {"{from = -6, to = 6", "--resume", "mpirun", "[[picture]]"});
  const std::string listed = run("--list-results").out;
  for (const char* name : {"left.patches.0.parts.0.pmax\n", "right.patches.0.parts.0.centroid.y\n",
                           "left.near_contacts.0.y\n", "left.patches.0.creep_force.longitudinal\n",
                           "left.smoothed_3mm.pmax\n", "left.patches.0.kalker.c11\n"}) {
    EXPECT_NE(listed.find(name), std::string::npos) << name;
  }
}

TEST_F(WrcSweep, MapsOfPatchesLeaveRoomForTheLabelsOfTheirRows) {
  NEEDS_GNUPLOT();
  const std::string label = "pose.yaw 0.005123456789";
  write("s.toml", "[pose]\nyaw = [0.0, 0.005123456789]\nlateral = [0.0, 5.0, 6.0, 6.5]\n[solve]\n"
                  "accuracy = 0.1\n[study]\nresults = [\"left.pmax\"]\n"
                  "fields = [\"x\", \"y\", \"z\", \"pressure\"]\n[[picture]]\nkind = \"patches\"\n"
                  "file = \"p.svg\"\nx = \"pose.lateral\"\nseries = \"pose.yaw\"\n"
                  "sides = [\"left\"]\n");
  const Outcome outcome = run("s.toml --out o");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const std::string picture = read("o/p.svg");
  const auto number_behind = [&picture](const std::string& mark, std::size_t from) {
    return std::stod(picture.substr(from + mark.size()));
  };
  const std::string group = "translate(";
  const double begin = number_behind(group, picture.rfind(group, picture.find(label + '<')));
  constexpr double letter = 6.5; // pixels, DejaVu Sans 10
  EXPECT_GE(number_behind("<image x='", picture.find("<image x='")),
            begin + letter * static_cast<double>(label.size()));
}

} // namespace
} // namespace wrc_sweep_test
