/// Results of studies by name: removed names, loads of the file and of the command line.
#include <algorithm>
#include <sstream>

#include "run_driver.hpp"

namespace study_results_test {
namespace {

std::vector<std::string> parts_of(const std::string& text, char end) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, end);) {
    parts.push_back(part);
  }
  return parts;
}

class StudyResults : public Driver {
protected:
  StudyResults() : Driver(WRC_SWEEP_PROGRAM) {}
  void solve(const std::string& arguments, const std::string& folder) const {
    const Outcome outcome = run(arguments + " --out " + folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  }
  /// An entry of a table by line (0: names) and column name.
  [[nodiscard]] std::string entry(const std::string& file, std::size_t line,
                                  const std::string& column) const {
    const auto lines = parts_of(read(file), '\n');
    const auto names = parts_of(lines.at(0), ',');
    const auto found = std::find(names.begin(), names.end(), column);
    EXPECT_NE(found, names.end()) << column;
    return parts_of(lines.at(line), ',').at(static_cast<std::size_t>(found - names.begin()));
  }
};

/// A study of an earlier version: the error says what its results are called now.
TEST_F(StudyResults, RemovedResultsNameTheirSuccessors) {
  write("s.toml", "[study]\nresults = [\"left.pmax\", \"right.patches.0.semi_axes.1\"]\n");
  Outcome refused = run("s.toml --out o");
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_NE(refused.error.find("\"right.patches.0.semi_axes.1\" is unknown; use "
                               "right.patches.0.semi_axes.lateral"),
            std::string::npos)
      << refused.error;
  write("s.toml", "[study]\nresults = [\"left.grid.2\"]\n");
  refused = run("s.toml --out o");
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_NE(refused.error.find("\"left.grid.2\" is unknown; nearest"), std::string::npos)
      << refused.error;
  write("s.toml", "[study]\nresults = [\"left.regrown\"]\n");
  refused = run("s.toml --out o");
  EXPECT_NE(refused.error.find("\"left.regrown\" is unknown; grids no longer grow"),
            std::string::npos)
      << refused.error;
}

/// A key of the command line replaces that of the file, whatever its case.
TEST_F(StudyResults, CaseOfKeysDoesNotMatter) {
  write("s.toml", "[POSE]\nLateral = [0.0, 1.0]\n[solve]\ngrid = [24, 20]\n[study]\nresults = "
                  "[\"left.pmax\"]\n");
  solve("s.toml --set 'Pose.lateral=[2, 3]' 'Load.Both=7e4'", "o");
  EXPECT_EQ(std::stod(entry("o/s.csv", 1, "pose.lateral")), 2.0);
}

/// What carries the load in the file, and other loads on the command line.
TEST_F(StudyResults, AssignedLoadsKeepWhatCarriesThem) {
  write("s.toml",
        "[load]\nleft = 50000.0\nof = \"total\"\n[motion]\nspeed = 20000.0\n[pose]\nyaw = 0.002\n"
        "lateral = 3.0\n[solve]\naccuracy = 1e-2\n[study]\nresults = "
        "[\"left.vertical_force\", \"left.pressure_force.z\"]\n");
  solve("s.toml", "o");
  EXPECT_NEAR(std::stod(entry("o/s.csv", 1, "left.vertical_force")), 50000.0, 0.05);
  solve("s.toml --set 'load.both=[60000,70000]'", "p");
  EXPECT_NEAR(std::stod(entry("p/s.csv", 1, "left.vertical_force")), 60000.0, 0.06);
  EXPECT_NEAR(std::stod(entry("p/s.csv", 2, "left.vertical_force")), 70000.0, 0.07);
  solve("s.toml --set 'load.both=[60000,70000]' load.of=pressures", "q");
  EXPECT_NEAR(std::stod(entry("q/s.csv", 2, "left.pressure_force.z")), 70000.0, 1e-3);
}

/// Keys that a study does not set have their defaults.
TEST_F(StudyResults, TitlesShowValuesOfDefaultKeys) {
  write("s.toml", "[pose]\nlateral = [-1.0, 2.0]\n[solve]\nuntil = \"geometry\"\n[study]\n"
                  "title = \"{wheelset.wheel} on {track.rail}, gauge {track.gauge}, p_{max}\"\n");
  ASSERT_EQ(run("s.toml --page p.html").exit_code, 0);
  EXPECT_NE(read("p.html").find("S1002 on 60E1, gauge 1435, p_{max}"), std::string::npos);
}

/// Results have the digits that are asked for, keys as many as they need.
TEST_F(StudyResults, KeysAreExactInTables) {
  write("s.toml", "[load]\nboth = [100000, 100000.1]\n[solve]\nuntil = \"geometry\"\n[study]\n"
                  "results = [\"left.rigid_contact.y\"]\n");
  solve("s.toml --digits 4", "o");
  EXPECT_EQ(entry("o/s.csv", 2, "load.both"), "100000.1");
  EXPECT_LE(entry("o/s.csv", 2, "left.rigid_contact.y").size(), 6);
}

TEST_F(StudyResults, APageWithoutAnyResultIsAFailure) {
  write("s.toml", "[pose]\nlateral = [99, 100]\n");
  const Outcome none = run("s.toml --page p.html");
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_NE(none.error.find("no scene has the status ok; ./s.csv has the message of each"),
            std::string::npos)
      << none.error;
  EXPECT_NE(read("p.html").find("wheel off the rail"), std::string::npos);
  write("s.toml", "[pose]\nlateral = [0, 100]\n[load]\nboth = 0\n");
  EXPECT_EQ(run("s.toml --page p.html").exit_code, 0);
}

} // namespace
} // namespace study_results_test
