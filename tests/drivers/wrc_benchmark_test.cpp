/// wrc_benchmark as a process: the rows are complete and each time stands beside an error. Times
/// themselves are not judged.
#include "run_driver.hpp"

namespace {

using nlohmann::json;

class WrcBenchmark : public Driver {};

TEST_F(WrcBenchmark, EveryRowHasTimesAndTheirErrors) {
  const Outcome outcome = run(WRC_BENCHMARK_PROGRAM, "--grid 24x16 --repetitions 1 --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const json result = json::parse(outcome.out);
  for (const char* key : {"cpu", "compiler", "flags", "threads", "commit"}) {
    EXPECT_TRUE(result.at("machine").contains(key)) << key;
  }
  EXPECT_EQ(result.at("paper_total_ms"), 8250.0);
  ASSERT_EQ(result.at("rows").size(), 4U); // two cases, cold and warm
  for (const json& row : result.at("rows")) {
    EXPECT_EQ(row.at("grid"), json({24, 16}));
    for (const char* stage : {"setup_ms", "geometry_ms", "remesh_ms", "mechanics_ms"}) {
      EXPECT_GT(row.at(stage).get<double>(), 0.0) << stage;
      EXPECT_LT(row.at(stage).get<double>(), row.at("total_ms").get<double>()) << stage;
    }
    EXPECT_GT(row.at("error_pmax").get<double>(), 0.0);
    EXPECT_LT(row.at("error_p").get<double>(), 1e-3); // of the iteration at tolerance 1e-6
    EXPECT_GT(row.at("fill").get<double>(), 0.2);
  }
}

TEST_F(WrcBenchmark, TableNamesMachineAndErrors) {
  const Outcome outcome = run(WRC_BENCHMARK_PROGRAM, "--case table1 --grid 24x16 --repetitions 1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  for (const char* part : {"commit", "error pmax", "8250 ms", "table1"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
}

TEST_F(WrcBenchmark, RefusesWhatItDoesNotKnow) {
  run(WRC_BENCHMARK_PROGRAM, "--case nothing").expect_refusal({"--case nothing", "table1"});
  for (const char* grid : {"3", "0x4", "4x", "axb", "4x4x4", "5000x4", "-1x4"}) {
    run(WRC_BENCHMARK_PROGRAM, std::string("--grid=") + grid).expect_refusal({"--grid", "NxM"});
  }
  run(WRC_BENCHMARK_PROGRAM, "--method fast").expect_refusal({"--method", "paper"});
}

} // namespace
