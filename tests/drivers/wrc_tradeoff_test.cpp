/// wrc_tradeoff as a process: few scenes, all files; errors are what they are said to be. Times are
/// not judged.
#include "run_driver.hpp"

namespace wrc_tradeoff_test {
namespace {

using nlohmann::json;

class WrcTradeoff : public Driver {
protected:
  WrcTradeoff() : Driver(WRC_TRADEOFF_PROGRAM) {}
};

TEST_F(WrcTradeoff, WritesTableJsonAndPictures) {
  NEEDS_GNUPLOT();
  const Outcome outcome = run("--scenes 2 --repeats 1 --threads 2 --json t.json "
                              "--pictures .");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("2 scenes, 0 without a solution"), std::string::npos) << outcome.out;
  // Progress with the time that remains.
  EXPECT_NE(outcome.error.find("2 of 2 scenes, 0 s left"), std::string::npos) << outcome.error;
  for (const char* name : {"work_precision", "asked", "estimate", "models"}) {
    EXPECT_TRUE(is_png(std::string("tradeoff_") + name + ".png")) << name;
  }
  const json whole = json::parse(read("t.json"));
  ASSERT_EQ(whole.at("scenes").size(), 2U);
  for (const json& scene : whole.at("scenes")) {
    // Truth must be much better than what is measured against it.
    EXPECT_LT(scene.at("truth").at("uncertainty").at(0).at("pmax"), 1e-3);
    for (const json& each : scene.at("runs")) {
      const bool models = each.at("way") == "hertz" || each.at("way") == "kik-piotrowski";
      const json& error = each.at("errors").at(0);
      EXPECT_EQ(error.contains("validity"), models);
      EXPECT_EQ(error.contains("estimate"), !models);
      EXPECT_GT(each.at("ms"), 0.0);
      if (each.at("way") == "pressures" || each.at("way") == "forces") {
        for (const char* name : {"depth", "normal_force", "lateral_force", "centre_lateral",
                                 "centre_longitudinal", "moment"}) {
          EXPECT_LT(error.at(name), 3.0 * each.at("accuracy").get<double>()) << name;
        }
      }
      if (each.at("way") == "pressures") {
        EXPECT_LT(error.at("pmax"), 3.0 * each.at("accuracy").get<double>());
      }
    }
  }
  for (const json& row : whole.at("asked")) {
    EXPECT_EQ(row.at("wheels"), 4);
  }
}

TEST_F(WrcTradeoff, RandomScenesAreSolvedForOneKindOfAccuracy) {
  const Outcome outcome = run("--random 2 --accuracy-of forces --repeats 1 --json t.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const json whole = json::parse(read("t.json"));
  ASSERT_EQ(whole.at("scenes").size(), 2U);
  EXPECT_EQ(whole.at("asked").size(), 6U);
  for (const json& scene : whole.at("scenes")) {
    EXPECT_TRUE(scene.at("options").get<std::string>().starts_with("--set wheelset.wheel="));
    for (const json& each : scene.at("runs")) {
      EXPECT_EQ(each.at("way"), "forces");
    }
  }
}

/// Then the depth is given, and forces are off instead.
TEST_F(WrcTradeoff, PrescribesPositions) {
  const Outcome outcome =
      run("--scenes 2 --position --accuracy-of forces --repeats 1 --json t.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  for (const json& scene : json::parse(read("t.json")).at("scenes")) {
    for (const json& each : scene.at("runs")) {
      if (each.at("way") == "forces") {
        for (const json& error : each.at("errors")) {
          EXPECT_LT(error.at("depth"), 1e-12);
          EXPECT_GT(error.at("normal_force"), 1e-6);
          EXPECT_LT(error.at("normal_force"), each.at("accuracy").get<double>());
        }
      }
    }
  }
}

TEST_F(WrcTradeoff, JudgesCreepForcesOfAWheelsetInMotion) {
  const Outcome outcome = run("--creep 1 --motion --repeats 1 --json m.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  expect_parts(outcome.out, {"1 scenes, 0 without a solution"});
  const json whole = json::parse(read("m.json"));
  const json& last = whole.at("creep").back();
  EXPECT_EQ(last.at("creep"), "full");
  EXPECT_GE(last.at("patches"), 2);
  EXPECT_NE(read("m.json").find("motion.yaw"), std::string::npos);
  EXPECT_EQ(read("m.json").find("creepage.spin"), std::string::npos);
}

TEST_F(WrcTradeoff, ComparesModelsOfCreepForces) {
  NEEDS_GNUPLOT();
  const Outcome outcome = run("--creep 2 --repeats 1 --threads 2 --json t.json "
                              "--pictures .");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  expect_parts(outcome.out,
               {"2 scenes, 0 without a solution", "\nlinear ", "\nshen-hedrick-elkins ",
                "\npolach ", "\nfastsim ", "\nfull ", "missed by the full theory"});
  EXPECT_NE(outcome.error.find("2 of 2 scenes, 0 s left"), std::string::npos) << outcome.error;
  EXPECT_TRUE(is_png("tradeoff_creep.png"));
  const json whole = json::parse(read("t.json"));
  double before = 1.0;
  for (const json& row : whole.at("creep")) {
    EXPECT_GE(row.at("patches"), 4) << row;
    EXPECT_GT(row.at("us"), 0.0) << row;
    const bool full = row.at("creep") == "full";
    for (const char* name : {"met", "estimate_bounds", "estimate_over_error"}) {
      EXPECT_EQ(row.contains(name), full) << row;
    }
    const std::vector<double> rms = row.at("rms");
    const double largest = *std::max_element(rms.begin(), rms.end());
    if (full) {
      // 1e-1 and 3e-2 have the fewest elements, both.
      EXPECT_LT(largest, 1.1 * before) << "no less than with the accuracy before: " << row;
      before = largest;
    }
  }
  // What a scene says of itself replays it.
  const json replayed =
      run_json(WRC_CASE_PROGRAM, whole.at("scenes").at(0).at("options").get<std::string>() +
                                     " --set solve.creep=linear --set solve.accuracy=0.1");
  EXPECT_TRUE(replayed.at("left").at("patches").at(0).contains("creep_force"));
  EXPECT_NE(run("--help").out.find("--creep"), std::string::npos);
}

/// What one run has found the next one reads.
TEST_F(WrcTradeoff, JudgesByTruthAlongCurves) {
  const Outcome outcome = run("--truth 10 --threads 2 --truths truths --json t.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  expect_parts(outcome.out, {"\n| flats | 0.01 | forces | spin moment | ", "\n| crossings | ",
                             "\n| creep | ", "\n| wheels | 0.001 | pressures | pmax | ",
                             "errors above their estimate, worst first"});
  const json whole = json::parse(read("t.json"));
  ASSERT_EQ(whole.at("scenes").size(), 10U);
  const json& last = whole.at("scenes").back();
  const json& first_run = last.at("runs").at(0); // the left wheel at 1e-2, of forces
  EXPECT_LT(first_run.at("uncertainty").at(0), 1e-4);
  // What a scene says of itself replays it.
  const json replayed =
      run_json(WRC_CASE_PROGRAM, last.at("options").get<std::string>() +
                                     " --set solve.accuracy=0.01 --set solve.accuracy_of=forces");
  EXPECT_EQ(replayed.at("left").at("error_estimate"), first_run.at("estimates").at(0));
  const std::string truths = read("truths");
  EXPECT_EQ(std::count(truths.begin(), truths.end(), '{'), 10);
  const Outcome again = run("--truth 10 --truths truths");
  EXPECT_EQ(again.out, outcome.out);
  EXPECT_EQ(std::count(truths.begin(), truths.end(), '{'), 10);
}

TEST_F(WrcTradeoff, RefusesWhatIsNotAllowed) {
  run("--scenes 0").expect_refusal({"--scenes"});
  run("--random 2 --scenes 2").expect_refusal({"--random"});
  run("--creep 0").expect_refusal({"--creep"});
  run("--creep 2 --random 2").expect_refusal({"--creep"});
  run("--creep 2 --position").expect_refusal({"--creep"});
  run("--truth 20 --random 2").expect_refusal({"--truth"});
  run("--truths file").expect_refusal({"--truths"});
  run("--accuracy-of area").expect_refusal({"--accuracy-of"});
  run("--pictures nowhere").expect_refusal({"nowhere"});
}

TEST_F(WrcTradeoff, LeavesNoPartOfAFileOnAFullDisk) {
  const Outcome outcome =
      run_limited(1, WRC_TRADEOFF_PROGRAM, "--scenes 1 --repeats 1 --json b.json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.error.find("b.json"), std::string::npos) << outcome.error;
  EXPECT_EQ(file_count(), 0);
}

} // namespace
} // namespace wrc_tradeoff_test
