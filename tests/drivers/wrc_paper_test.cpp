/// wrc_paper as a process: verdicts follow from the results, whatever these are.
#include "run_driver.hpp"

namespace wrc_paper_test {
namespace {

class WrcPaper : public Driver {
protected:
  WrcPaper() : Driver(WRC_PAPER_PROGRAM) {}
  /// One study, coarse, into a folder.
  void sweep(const std::string& name, const std::string& folder,
             const std::string& options = "--set solve.accuracy=0.1") const {
    const Outcome outcome = run(WRC_SWEEP_PROGRAM, std::string("'") + WRC_STUDIES + "/" + name +
                                                       ".toml' --digits 17 --threads 2 " + options +
                                                       " --out " + folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  }
  /// The line of the report about a statement.
  [[nodiscard]] std::string line_with(const std::string& part) const {
    const std::string report = read("report.md");
    const auto at = report.find(part);
    return at == std::string::npos ? "" : report.substr(at, report.find('\n', at) - at);
  }
};

TEST_F(WrcPaper, JudgesGivenResults) {
  NEEDS_GNUPLOT();
  sweep("fig05", "S1002", "--set 'solve.grid=[32, 16]'");
  sweep("connections", "S1002");
  sweep("conicity", "S1002",
        "--rails 60E1 UIC60-Manchester --set 'pose.roll=[\"en15302\", \"solve\"]'");
  for (const std::string wheel : {"LM", "LMA"}) {
    for (const char* study : {"fig06_07", "fig08", "fig09_10", "fig11", "fig12", "fig13"}) {
      sweep(study, wheel, "--set solve.accuracy=0.1 --set wheelset.wheel=" + wheel);
    }
  }
  run(".").expect_refusal({"timing.json", "scripts/paper.sh"});
  EXPECT_FALSE(exists("report.md"));
  write(
      "timing.json",
      R"({"machine": {"cpu": "c", "compiler": "g"}, "paper_total_ms": 8250.0, "rows": [)"
      R"({"wheels": 1, "method": "default", "state": "cold", "setup_ms": 1.0, "geometry_ms": 1.0,)"
      R"("remesh_ms": 1.0, "mechanics_ms": 7.0, "total_ms": 10.0, "iterations": 20,)"
      R"("error_p": 1e-5, "error_pmax": 1e-4}]})");
  ASSERT_EQ(run(".").exit_code, 0);
  EXPECT_NE(line_with("Its magnitude grows with that of y").find("| **confirmed**"),
            std::string::npos);
  EXPECT_NE(line_with("Roll is positive for negative y").find("| **confirmed**"),
            std::string::npos);
  EXPECT_NE(line_with("Off the centre the roll depends on the sign").find("| **refuted** by proof"),
            std::string::npos);
  for (const char* statement : {"In the centre yaw makes the wheelset roll", "the sign matters"}) {
    EXPECT_NE(line_with(statement).find("| **refuted** by proof"), std::string::npos) << statement;
  }
  // As printed, and a thousand times as much.
  const std::string printed = line_with("These are effects of a yaw of 0.05 mrad");
  EXPECT_NE(printed.find("| **refuted**: 0.05 mrad change the roll"), std::string::npos) << printed;
  EXPECT_NE(line_with("(a) From -9 to 9 mm").find("| **confirmed**"), std::string::npos);
  EXPECT_NE(line_with("(b) Below 3 mm").find("**undecidable**"), std::string::npos);
  EXPECT_NE(line_with("which the paper calls validation").find("up to 5.6 %"), std::string::npos);
  const std::string counts = line_with("The paper's statements on figures 6 to 13");
  EXPECT_NE(counts.find("5 refuted (3 of them by proof)"), std::string::npos) << counts;
  EXPECT_NE(line_with("| default | cold").find("1/825"), std::string::npos);
  EXPECT_TRUE(is_png("timing.png"));

  // A wheelset that does not roll as it should.
  sweep("fig06_07", "LM", "--set wheelset.wheel=LM --set pose.roll=0.001");
  ASSERT_EQ(run(".").exit_code, 0);
  EXPECT_NE(line_with("Its magnitude grows with that of y").find("| **undecidable**"),
            std::string::npos);
  EXPECT_EQ(line_with("Roll is positive for negative y")
                .find("y (the paper's sign, opposite to "
                      "ours) | **confirmed**"),
            std::string::npos);
}

TEST_F(WrcPaper, RefusesAFolderWithoutResults) {
  run(".").expect_refusal({"fig05.csv"});
  run("").expect_refusal({"DIR"});
  EXPECT_EQ(file_count(), 0);
}

} // namespace
} // namespace wrc_paper_test
