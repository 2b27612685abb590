/// wrc_benchmark as a process: the rows are complete and each time stands beside an error. Times
/// themselves are not judged.
#include <algorithm>

#include "run_driver.hpp"

namespace wrc_benchmark_test {
namespace {

using nlohmann::json;

class WrcBenchmark : public Driver {
protected:
  WrcBenchmark() : Driver(WRC_BENCHMARK_PROGRAM) {}
};

const char* const row_keys[] = {
    "case",         "grid",        "method",     "state",       "accuracy",    "fill",
    "iterations",   "error_p",     "error_pmax", "setup_ms",    "geometry_ms", "remesh_ms",
    "mechanics_ms", "total_ms",    "min_ms",     "fft_pair_ms", "memory_mb",   "tolerance",
    "pairs",        "total_pairs", "wheels",     "threads",     "repeats"};

void expect_complete(const json& result) {
  for (const char* key : {"cpu", "compiler", "flags", "threads", "commit"}) {
    EXPECT_TRUE(result.at("machine").contains(key)) << key;
  }
  EXPECT_EQ(result.at("paper_total_ms"), 8250.0);
  for (const json& row : result.at("rows")) {
    for (const char* key : row_keys) {
      EXPECT_TRUE(row.contains(key)) << key;
    }
    for (const char* key : {"total_ms", "min_ms", "mechanics_ms", "fft_pair_ms", "fill"}) {
      EXPECT_GT(row.at(key).get<double>(), 0.0) << key;
    }
    EXPECT_LE(row.at("min_ms"), row.at("total_ms"));
    EXPECT_DOUBLE_EQ(row.at("pairs").get<double>(),
                     row.at("mechanics_ms").get<double>() / row.at("fft_pair_ms").get<double>());
  }
}

/// Rows are three states of each method, in the order of the help.
void expect_states(const json& rows) {
  const char* const states[] = {"cold-process", "cold", "warm"};
  const char* const methods[] = {"default", "paper"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows.at(i).at("state"), states[i % 3]);
    EXPECT_EQ(rows.at(i).at("method"), methods[i / 3 % 2]);
  }
}

TEST_F(WrcBenchmark, GapsAreSolvedToTheRequestedAccuracy) {
  const json result =
      run_json("--case hertz-circle --case hertz-ellipse --case two-lobes --grid 48x32 --repeat 2");
  expect_complete(result);
  const json& rows = result.at("rows");
  ASSERT_EQ(rows.size(), 18U);
  expect_states(rows);
  for (const json& row : rows) {
    EXPECT_EQ(row.at("grid"), json({48, 32}));
    EXPECT_EQ(row.at("accuracy"), 1e-4);
    EXPECT_EQ(row.at("wheels"), 0);
    EXPECT_GT(row.at("error_p").get<double>(), 0.0);
    EXPECT_LE(row.at("error_p").get<double>(), 1e-4) << row.at("case") << row.at("method");
    EXPECT_GT(row.at("error_pmax").get<double>(), 0.0);
    EXPECT_LT(row.at("error_pmax").get<double>(), 5e-3); // 20 elements across the contact
    EXPECT_GT(row.at("memory_mb").get<double>(), 0.0);
    // Ellipses of 0.6 of both sides; two lobes leave a space.
    const double ellipse = 0.25 * 3.14159 * 0.36;
    EXPECT_NEAR(row.at("fill").get<double>(), row.at("case") == "two-lobes" ? 0.19 : ellipse, 0.02);
  }
  EXPECT_EQ(result.at("paper_over_default").size(), 3U);
}

TEST_F(WrcBenchmark, ScenesShowTheTimeOfEachStage) {
  const json result =
      run_json("--case table1 --case manchester-5 --grid 24x16 --repeat 1 --method default");
  expect_complete(result);
  const json& rows = result.at("rows");
  ASSERT_EQ(rows.size(), 9U); // table1 with one wheel and with both
  EXPECT_EQ(rows.at(0).at("wheels"), 1);
  EXPECT_EQ(rows.at(3).at("wheels"), 2);
  for (const json& row : rows) {
    for (const char* stage : {"setup_ms", "geometry_ms", "remesh_ms", "mechanics_ms"}) {
      EXPECT_GT(row.at(stage).get<double>(), 0.0) << stage;
      EXPECT_LT(row.at(stage).get<double>(), row.at("total_ms").get<double>()) << stage;
    }
    EXPECT_LT(row.at("error_p").get<double>(), 2e-4); // the accuracy asked is 1e-4
    EXPECT_GT(row.at("error_pmax").get<double>(), 0.0);
  }
  EXPECT_TRUE(result.at("paper_over_default").empty());
}

TEST_F(WrcBenchmark, VehicleStepPrintsTheSpreadOfItsSteps) {
  const json result = run_json("--case vehicle-step --steps 4 --accuracy 1e-2");
  expect_complete(result);
  const json& rows = result.at("rows");
  ASSERT_EQ(rows.size(), 4U); // three motions, and paper in the hunting
  EXPECT_EQ(rows.at(0).at("motion"), "hunting");
  EXPECT_EQ(rows.at(1).at("method"), "paper");
  EXPECT_EQ(rows.at(2).at("motion"), "1 %");
  EXPECT_EQ(rows.at(3).at("motion"), "0.1 %");
  for (const json& row : rows) {
    EXPECT_EQ(row.at("wheels"), 2);
    EXPECT_EQ(row.at("accuracy"), 1e-2);
    EXPECT_LE(row.at("total_ms"), row.at("percentile_90_ms"));
    EXPECT_LE(row.at("percentile_90_ms"), row.at("worst_ms"));
    if (row.at("method") == "paper") {
      EXPECT_TRUE(row.at("error_pmax").is_null()); // vertical gaps are another problem
    } else {
      EXPECT_GT(row.at("error_pmax").get<double>(), 0.0);
      EXPECT_LT(row.at("error_pmax").get<double>(), 2e-2);
    }
  }
}

/// Rows are accuracies of forces and of pressures, loads and positions, for each pair of profiles,
/// without and with creep forces.
TEST_F(WrcBenchmark, ServicePrintsTheSpreadOfItsSteps) {
  const int steps = by_extent(4, 2);
  const json result =
      run_json("--case service --steps " + std::to_string(steps) + " --accuracy 1e-2 --creep");
  const json& rows = result.at("rows");
  ASSERT_EQ(rows.size(), 36U);
  const char* const wheels[] = {"S1002", "LMA", "S1002"};
  const char* const rails[] = {"60E1", "CHN60", "56E1"};
  const char* const creep[] = {"none", "creepages", "motion"};
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const json& row = rows.at(index);
    const std::size_t i = index / 3;
    const bool loads = i % 2 == 0;
    EXPECT_EQ(row.at("case"), "service");
    EXPECT_EQ(row.at("creep"), creep[index % 3]);
    EXPECT_EQ(row.at("wheel"), wheels[i / 4]);
    EXPECT_EQ(row.at("rail"), rails[i / 4]);
    EXPECT_EQ(row.at("accuracy"), 1e-2);
    EXPECT_EQ(row.at("accuracy_of"), i % 4 < 2 ? "forces" : "pressures");
    EXPECT_EQ(row.at("prescribed"), loads ? "load" : "position");
    EXPECT_EQ(row.at("steps"), steps);
    // What is prescribed has no error.
    EXPECT_EQ(row.at("error_depth").is_null(), !loads);
    EXPECT_EQ(row.at("error_normal_force").is_null(), loads);
    const double force = row.at("error_force");
    EXPECT_EQ(force, loads ? row.at("error_lateral_force").get<double>()
                           : std::max(row.at("error_normal_force").get<double>(),
                                      row.at("error_lateral_force").get<double>()));
    // Steps near the centre, where contact is smooth.
    constexpr double bound = 2e-2; // twice what is asked
    EXPECT_GT(force, 0.0);
    EXPECT_LT(force, bound);
    EXPECT_LT(row.at(loads ? "error_depth" : "error_normal_force").get<double>(), bound);
    EXPECT_GT(row.at("error_pmax").get<double>(), 0.0);
    EXPECT_GE(row.at("solutions_mean").get<double>(), 1.0);
    EXPECT_LE(row.at("solutions_mean"), row.at("solutions_max"));
    EXPECT_GT(row.at("median_pairs").get<double>(), 0.0);
    EXPECT_LE(row.at("median_pairs"), row.at("p99_pairs"));
    EXPECT_LE(row.at("p99_pairs"), row.at("p999_pairs"));
    EXPECT_LE(row.at("p999_pairs"), row.at("max_pairs"));
    EXPECT_LE(row.at("mean_pairs"), row.at("max_pairs"));
    EXPECT_DOUBLE_EQ(row.at("mean_pairs").get<double>(),
                     row.at("mean_ms").get<double>() / row.at("fft_pair_ms").get<double>());
  }
}

TEST_F(WrcBenchmark, ABatchIsEqualOnAnyNumberOfThreads) {
  const json result = run_json("--case batch --repeat 1");
  expect_complete(result);
  EXPECT_EQ(result.at("rows").size(), 2U);
  EXPECT_EQ(result.at("batch").at("bitwise_equal"), true);
  EXPECT_GT(result.at("batch").at("speedup").get<double>(), 0.0);
  EXPECT_GT(result.at("batch").at("machine_speedup").get<double>(), 0.0);
}

TEST_F(WrcBenchmark, FirstSolveRunsOnceInItsOwnProcess) {
  const Outcome outcome = run("--first-solve --case two-lobes --grid 24x16 --accuracy 1e-3");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const json result = json::parse(outcome.out);
  for (const char* key : {"setup", "mechanics", "total", "memory_mb"}) {
    EXPECT_GT(result.at(key).get<double>(), 0.0) << key;
  }
  run("--first-solve").expect_refusal({"--first-solve", "one --case"});
  run("--first-solve --case batch").expect_refusal({"--first-solve"});
}

TEST_F(WrcBenchmark, TableNamesMachineErrorsAndColumns) {
  const Outcome outcome = run("--case hertz-circle --case table1 --grid 24x16 --repeat 1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  expect_parts(outcome.out, {"commit", "error pmax", "cold-process", "table1, both", "24x16",
                             "pairs: ", "MB: ", "Times of paper over default"});
}

TEST_F(WrcBenchmark, HelpTeaches) {
  const Outcome outcome = run("--help");
  EXPECT_EQ(outcome.exit_code, 0);
  expect_parts(outcome.out,
               {"hertz-circle", "hertz-ellipse", "two-lobes", "table1", "manchester-5",
                "vehicle-step", "batch", "service", "256x128", "Examples", "--repeat", "--json"});
}

TEST_F(WrcBenchmark, RefusesUnknownNamesAndGrids) {
  run("--case nothing").expect_refusal({"--case nothing", "table1"});
  for (const char* grid : {"3", "0x4", "4x", "axb", "4x4x4", "9000x4", "-1x4"}) {
    run(std::string("--grid=") + grid).expect_refusal({"--grid", "NxM"});
  }
  run("--case table1 --grid all").expect_refusal({"--grid", "2048"});
  run("--method fast").expect_refusal({"--method", "paper"});
  run("--accuracy 2").expect_refusal({"--accuracy"});
  run("--repeat 0").expect_refusal({"--repeat"});
  run("--steps 0").expect_refusal({"--steps"});
}

} // namespace
} // namespace wrc_benchmark_test
