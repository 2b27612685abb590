/// wrc_extremes as a process: few points of each quantity, all files, the same numbers for any
/// number of threads; what it calls held is what it says.
#include <map>
#include <set>

#include "run_driver.hpp"

namespace wrc_extremes_test {
namespace {

using nlohmann::json;

class WrcExtremes : public Driver {
protected:
  WrcExtremes() : Driver(WRC_EXTREMES_PROGRAM) {}
};

TEST_F(WrcExtremes, QuickStudyFindsNothingWrongAndNothingFaded) {
  NEEDS_GNUPLOT();
  const Outcome outcome = run("--quick --threads 2 --out study");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.error;
  EXPECT_NE(outcome.out.find(" 0 faded, 0 wrong"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.error.find("points, "), std::string::npos) << outcome.error;
  const json whole = json::parse(read("study/extremes.json"));
  EXPECT_EQ(whole.at("seed"), 1);
  std::map<std::string, std::set<std::string>> verdicts;
  for (const json& row : whole.at("rows")) {
    const std::string verdict = row.at("verdict");
    verdicts[row.at("quantity")].insert(verdict);
    SCOPED_TRACE(row.dump());
    if (verdict == "refused") {
      EXPECT_NE(row.at("status"), "ok");
      EXPECT_GT(row.at("message").get<std::string>().size(), 20U);
      EXPECT_FALSE(row.contains("pmax"));
    } else {
      EXPECT_EQ(row.at("status"), "ok");
    }
    if (verdict == "held") {
      EXPECT_GT(row.at("pmax"), 0.0);
      EXPECT_LE(row.at("load_balance"), 1e-9);
      EXPECT_LE(row.at("overlap"), 1e-3);
    }
    if (verdict == "held" && row.contains("pressure_error")) {
      // Scenes at the floor of the tolerance, gaps at the one asked.
      EXPECT_LE(row.at("pressure_error"), std::max(1e-12, row.at("asked").get<double>()));
    }
  }
  EXPECT_EQ(verdicts.size(), 23U);
  for (const char* quantity : {"load", "modulus", "poisson", "radius", "yaw", "lateral",
                               "inclination", "gauge", "accuracy", "scene-grid", "grid", "aspect",
                               "tolerance", "gap", "points", "profile", "state"}) {
    EXPECT_TRUE(verdicts[quantity].contains("held")) << quantity;
    EXPECT_TRUE(verdicts[quantity].contains("refused")) << quantity;
  }
  for (const auto& [quantity, found] : verdicts) {
    EXPECT_TRUE(is_png("study/extremes_" + quantity + ".png")) << quantity;
  }
}

TEST_F(WrcExtremes, ThreadsChangeNoBitAndTheSeedTheNoise) {
  const std::string only = "--quick --only gap --only noise --out ";
  ASSERT_EQ(run(only + "one --seed 7").exit_code, 0);
  ASSERT_EQ(run(only + "two --seed 7 --threads 3").exit_code, 0);
  ASSERT_EQ(run(only + "other --seed 8").exit_code, 0);
  const std::string rows = read("one/extremes.json");
  EXPECT_NE(rows.find("white noise"), std::string::npos);
  EXPECT_EQ(rows, read("two/extremes.json"));
  EXPECT_NE(json::parse(rows).at("rows"), json::parse(read("other/extremes.json")).at("rows"));
}

TEST_F(WrcExtremes, RefusesWhatIsNotAllowed) {
  run("--only colour").expect_refusal({"--only", "colour"});
  run("--threads 0").expect_refusal({"--threads"});
  write("file", "");
  run("--quick --only poisson --out file/there").expect_refusal({"--out"});
}

} // namespace
} // namespace wrc_extremes_test
