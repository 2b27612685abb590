/// Options of profiles in scene files, studies and on the command line of programs.
#include "run_driver.hpp"

#include "support/csv_table.hpp"

namespace profile_options_test {
namespace {

class OptionsOfProfiles : public Driver {
protected:
  OptionsOfProfiles() : Driver(WRC_SWEEP_PROGRAM) {}
  void SetUp() override {
    Driver::SetUp();
    EXPECT_EQ(run(WRC_PROFILE_PROGRAM, "S1002 --convert '" + std::string(wheel) + "'").exit_code,
              0);
    write("s.toml", "[wheelset]\nwheel = {file = \"" + std::string(wheel) +
                        "\", origin = \"tape\", smoothing = [0.0, 8.0]}\n[load]\nboth = 0\n"
                        "[study]\nresults = [\"left.rigid_contact.angle\"]\n");
  }
  /// The table of the study with these assignments.
  [[nodiscard]] driver::CsvTable table(const std::string& assignments) const {
    const Outcome outcome =
        run("s.toml --restart --out o" + (assignments.empty() ? "" : " --set " + assignments));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return driver::CsvTable(folder() / "o/s.csv");
  }
  using Texts = std::vector<std::string>;
  static constexpr const char* wheel = "my, wheel = 1.txt";
};

TEST_F(OptionsOfProfiles, VaryInAStudy) {
  EXPECT_EQ(table("").numbers("wheelset.wheel.smoothing"), (std::vector<double>{0.0, 8.0}));
  EXPECT_EQ(table("'wheelset.wheel=[\"S1002\", \"my, wheel = 1.txt; smoothing = 3\"]'")
                .texts("wheelset.wheel"),
            (Texts{"S1002", "my, wheel = 1.txt; smoothing = 3"}))
      << "another profile has no options of the file";
  const driver::CsvTable crossed =
      table("'wheelset.wheel={file = [\"S1002\", \"my, wheel = 1.txt\"], smoothing = 0}' "
            "'wheelset.wheel.smoothing={from = 0, to = 4, count = 2}'");
  EXPECT_EQ(crossed.texts("status"), (Texts{"ok", "invalid argument", "ok", "ok"}))
      << "built-in profiles are not smoothed";
  EXPECT_EQ(table("wheelset.wheel.smoothing=3").row_count(), 1U);
}

TEST_F(OptionsOfProfiles, AreAxesOfPictures) {
  if (!gnuplot_is_there()) {
    GTEST_SKIP() << "no gnuplot";
  }
  write("s.toml", read("s.toml") +
                      "[[picture]]\nfile = \"a.svg\"\nx = \"wheelset.wheel.smoothing\"\n"
                      "title = \"{wheelset.wheel}\"\n[[picture.panels]]\n"
                      "lines = [{result = \"left.rigid_contact.angle\"}]\n");
  (void)table("");
  EXPECT_NE(read("o/a.svg").find(wheel), std::string::npos);
}

TEST_F(OptionsOfProfiles, OfBothSidesBelongToTheProfileOfEach) {
  write("t.toml", "[wheelset]\nwheel.smoothing = 3\nleft.wheel = \"" + std::string(wheel) +
                      "\"\nright.wheel = {file = \"" + wheel +
                      "\", align_to = \"S1002\"}\n[load]\nboth = 0\n");
  ASSERT_EQ(run(WRC_CASE_PROGRAM, "t.toml --save u.toml").exit_code, 0);
  const std::string saved = read("u.toml");
  for (const char* text :
       {"1.txt; smoothing = 3\"\n", "1.txt; smoothing = 3; align_to = S1002\"\n"}) {
    EXPECT_NE(saved.find(text), std::string::npos) << saved;
  }
  ASSERT_EQ(run(WRC_CASE_PROGRAM, "u.toml --save v.toml").exit_code, 0);
  EXPECT_EQ(read("v.toml"), saved);
}

TEST_F(OptionsOfProfiles, SayWhatTheyMustBe) {
  run("s.toml --set wheelset.wheel.smoothing=500")
      .expect_refusal({"wheelset.wheel.smoothing = \"500\"", "0 to 100 mm"});
  write("wrong.toml", "[wheelset]\nwheel.file = \"S1002\"\nwheel.slip = 2\n");
  for (const char* program : {WRC_SWEEP_PROGRAM, WRC_CASE_PROGRAM}) {
    run(program, "wrong.toml").expect_refusal({"line 3", "unknown option wheelset.wheel.slip"});
  }
  run(WRC_CASE_PROGRAM, "--set 'wheelset.wheel={file = \"S1002\", smoothing = [1, 2]}'")
      .expect_refusal({"wheelset.wheel.smoothing", "must be one number or a text"});
  run(WRC_CASE_PROGRAM, "--set 'wheelset.wheel=a; smoothing = 1; smoothing = 2'")
      .expect_refusal({"wheelset.wheel.smoothing = \"2\"", "must be there once"});
  run(WRC_WEAR_PROGRAM, "--set wheelset.wheel.smoothing=3").expect_refusal({"--wheel"});
  run(WRC_REPORT_PROGRAM, "S1002 60E1 --set track.rail.origin=750")
      .expect_refusal({"the report sets track.rail.origin itself"});
}

} // namespace
} // namespace profile_options_test
