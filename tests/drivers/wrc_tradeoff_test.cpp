/// wrc_tradeoff as a process: few scenes, all files; errors are what they are said to be. Times are
/// not judged.
#include "run_driver.hpp"

namespace {

using nlohmann::json;

class WrcTradeoff : public Driver {};

TEST_F(WrcTradeoff, WritesTableCsvJsonAndPictures) {
  if (!gnuplot_is_there()) {
    GTEST_SKIP() << "gnuplot is missing";
  }
  const Outcome outcome =
      run(WRC_TRADEOFF_PROGRAM, "--scenes 2 --steps 1 --threads 2 --csv t.csv --json t.json "
                                "--pictures .");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("2 scenes, 0 of them without a solution"), std::string::npos)
      << outcome.out;
  // Progress with the time that remains.
  EXPECT_NE(outcome.error.find("2 of 2 scenes, 0 s left"), std::string::npos) << outcome.error;
  for (const char* name : {"work_precision", "asked", "estimate", "models"}) {
    EXPECT_TRUE(is_png(std::string("tradeoff_") + name + ".png")) << name;
  }
  const json whole = json::parse(read("t.json"));
  ASSERT_EQ(whole.at("scenes").size(), 2U);
  std::size_t runs = 0;
  for (const json& scene : whole.at("scenes")) {
    // Truth must be much better than what is measured against it.
    EXPECT_LT(scene.at("truth").at("uncertainty").at(0), 1e-3);
    for (const json& each : scene.at("runs")) {
      ++runs;
      const bool models = each.at("way") == "hertz" || each.at("way") == "kik-piotrowski";
      const json& error = each.at("cold").at(0);
      EXPECT_EQ(error.contains("validity"), models);
      EXPECT_EQ(error.contains("estimate"), !models);
      EXPECT_GT(each.at("warm_ms"), 0.0);
      if (each.at("way") == "auto") {
        EXPECT_LT(error.at("pmax"), 3.0 * each.at("accuracy").get<double>());
      }
    }
  }
  // A line for each wheel, cold and warm, and one of names.
  EXPECT_EQ(static_cast<std::size_t>(line_count(read("t.csv"))), 4 * runs + 1);
  for (const json& row : whole.at("asked")) {
    EXPECT_EQ(row.at("wheels"), 8);
  }
}

TEST_F(WrcTradeoff, RefusesWhatIsNotAllowed) {
  run(WRC_TRADEOFF_PROGRAM, "--scenes 0").expect_refusal({"--scenes"});
  run(WRC_TRADEOFF_PROGRAM, "--pictures nowhere").expect_refusal({"nowhere"});
}

} // namespace
