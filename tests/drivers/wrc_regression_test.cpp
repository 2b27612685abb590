/// wrc_regression as a process: it passes, it fails, and it updates nothing but baselines.
#include "run_driver.hpp"

namespace wrc_regression_test {
namespace {

class WrcRegression : public Driver {
protected:
  WrcRegression() : Driver(WRC_REGRESSION_PROGRAM) {}
  static constexpr const char* small_cases =
      "[tolerance.drift]\nrelative = 1e-4\nreason = \"none\"\n[[case]]\ngroup = \"own\"\nname = "
      "\"coarse\"\ntolerance = \"drift\"\nscene = {solve.grid = [24, 20]}\nresults = "
      "[\"left.pmax\", \"roll\"]\n";
};

TEST_F(WrcRegression, StoredCasesPass) {
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_NE(outcome.error.find("--contact"), std::string::npos) << "what is left out is told";
  expect_parts(outcome.out, {"Table 2, y = 5 mm", "drift", " 0 failed"});
}

TEST_F(WrcRegression, ContactCasesPass) {
  const Outcome outcome = run("--contact '" WRCONTACT_REFERENCE_DIR "/contact_cases.json'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_NE(outcome.out.find("manchester-034"), std::string::npos);
  EXPECT_EQ(outcome.error, "");
}

TEST_F(WrcRegression, DeviationsFailUntilTheBaselineIsUpdated) {
  write("c/cases.toml", small_cases);
  const Outcome without = run("--cases c");
  EXPECT_EQ(without.exit_code, 4);
  EXPECT_NE(without.out.find("no stored result yet"), std::string::npos) << without.out;
  const Outcome first = run("--cases c --update");
  EXPECT_EQ(first.exit_code, 0) << first.error;
  EXPECT_NE(first.out.find("left.pmax: new"), std::string::npos) << first.out;
  EXPECT_EQ(run("--cases c").exit_code, 0);

  const std::string good = read("c/baselines.toml");
  const auto place = good.find("left.pmax\" = ") + std::string("left.pmax\" = ").size();
  write("c/baselines.toml", std::string(good).insert(place, 1, '1'));
  const Outcome off = run("--cases c");
  EXPECT_EQ(off.exit_code, 4);
  EXPECT_NE(off.out.find("1 failed"), std::string::npos) << off.out;

  const Outcome update = run("--cases c --update");
  EXPECT_NE(update.out.find("left.pmax: was "), std::string::npos) << update.out;
  EXPECT_EQ(update.out.find("roll"), std::string::npos) << "unchanged values are not told";
  EXPECT_EQ(read("c/baselines.toml"), good);
  EXPECT_EQ(read("c/cases.toml"), small_cases);
}

TEST_F(WrcRegression, RefusesFilesItDoesNotUnderstand) {
  run("--cases nowhere").expect_refusal({"nowhere"});
  write("a/cases.toml", "[[case]]\n");
  run("--cases a").expect_refusal({"a/cases.toml", "[tolerance.NAME]"});
  write("b/cases.toml", "[tolerance.x]\nrelative = 1\n[[case]]\n");
  run("--cases b").expect_refusal({"tolerance.x", "reason"});
  write("d/cases.toml", "[tolerance.x]\nrelative = 1\nreason = \"r\"\n[[case]]\nname = \"n\"\n");
  run("--cases d").expect_refusal({"case n", "tolerance"});
  run("--contact nowhere.json").expect_refusal({"nowhere.json"});
  write("bad.json", "{}");
  run("--contact bad.json").expect_refusal({"bad.json"});
  // A case that cannot be solved is a failed check, and no baseline is written for it.
  write("e/cases.toml", std::string(small_cases) + "[[case]]\ngroup = \"own\"\nname = \"far\"\n"
                                                   "tolerance = \"drift\"\nscene = {pose.lateral = "
                                                   "100.0}\nresults = [\"roll\"]\n");
  EXPECT_EQ(run("--cases e").exit_code, 4);
  run("--cases e --update").expect_refusal({"--update", "far"});
  EXPECT_FALSE(exists("e/baselines.toml"));
}

} // namespace
} // namespace wrc_regression_test
