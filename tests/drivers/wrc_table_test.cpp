/// wrc_table as a process: what it makes is what it shows.
#include "run_driver.hpp"

namespace wrc_table_test {
namespace {

class WrcTable : public Driver {
protected:
  WrcTable() : Driver(WRC_TABLE_PROGRAM) {}
};

TEST_F(WrcTable, ShowsTheTableThatItMakes) {
  const Outcome made = run(
      "small.table --lateral 1 --roll 0.003 --yaw 0.01 --load 1.2e5 --fineness 0.2 --threads 2");
  ASSERT_EQ(made.exit_code, 0) << made.error;
  EXPECT_NE(made.error.find("50 %"), std::string::npos) << made.error;
  EXPECT_NE(made.out.find("beyond the error returned with them"), std::string::npos) << made.out;
  EXPECT_NE(
      made.out.find("over its vertical force, or over half of the largest load if that is more"),
      std::string::npos)
      << made.out;
  const Outcome shown = run("small.table --show");
  ASSERT_EQ(shown.exit_code, 0) << shown.error;
  EXPECT_EQ(shown.out, made.out.substr(0, made.out.find("made in")));
  for (const char* line :
       {"wheelset.wheel = S1002\n", "track.rail = 60E1\n", "wheelset.radius = 460 mm\n",
        "material.wheel.youngs_modulus = 210000 MPa\n",
        "mm, N, MPa, rad; x forward, y left, z up\n",
        "reaches to lateral 1 mm, roll 0.003 rad, yaw 0.01 rad, load 120000 N\n"}) {
    EXPECT_NE(shown.out.find(line), std::string::npos) << line << " is not in:\n" << shown.out;
  }
}

/// What is left of a build that was stopped is read, or the reason said why not.
TEST_F(WrcTable, GoesOnFromWhatIsFinished) {
  write("a.table.unfinished", "of something else");
  const Outcome outcome = run("a.table --lateral 1 --load 1.2e5 --fineness 0.2");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.error.find("remove it to begin again"), std::string::npos) << outcome.error;
  EXPECT_EQ(outcome.error.find("going on"), std::string::npos) << outcome.error;
  EXPECT_EQ(read("a.table.unfinished"), "of something else");
}

/// The ranges that --help states are those that are checked.
TEST_F(WrcTable, HelpStatesTheRangesOfItsOptions) {
  const std::string help = run("--help").out;
  struct Case {
    const char* option;
    const char* range;
    const char* beyond;
  };
  for (const auto& [option, range, beyond] :
       {Case{"lateral", "0.5 to 30 mm", "31"}, Case{"roll", "0.001 to 0.1 rad", "0.11"},
        Case{"yaw", "0.001 to 0.1 rad", "0.11"}, Case{"load", "1000 to 1e6 N", "1.1e6"},
        Case{"tolerance", "0 to 1", "1.1"}, Case{"fineness", "0.2 to 4", "4.1"},
        Case{"threads", "1 to 1024", "1025"}}) {
    const std::size_t line = help.find(std::string("  --") + option + ' ');
    ASSERT_NE(line, std::string::npos) << help;
    const std::string text = help.substr(line, help.find("\n  --", line + 1) - line);
    EXPECT_NE(text.find(range), std::string::npos) << text;
    run(std::string("a.table --") + option + ' ' + beyond)
        .expect_refusal({option, "must be between "});
  }
}

TEST_F(WrcTable, RefusesMistakes) {
  run("a.table --fineness 9").expect_refusal({"fineness = 9", "between 0.2 and 4"});
  run("none.table --show").expect_refusal({"none.table"});
  write("scene.toml", "[pose]\nyaw = 0.001\n");
  run("scene.toml").expect_refusal({"scene.toml", "is no table", "--scene"});
  EXPECT_EQ(read("scene.toml"), "[pose]\nyaw = 0.001\n");
  run("nowhere/a.table").expect_refusal({"nowhere/a.table", "does the folder exist"});
}

} // namespace
} // namespace wrc_table_test
