/// wrc_wear as a process: what the profile loses is what was worn.
#include <cmath>
#include <sstream>

#include "run_driver.hpp"

namespace wrc_wear_test {
namespace {

class WrcWear : public Driver {
protected:
  WrcWear() : Driver(WRC_WEAR_PROGRAM) {}
};

TEST_F(WrcWear, TheProfileLosesTheWornArea) {
  NEEDS_GNUPLOT();
  const Outcome outcome = run("--distance 2500 --threads 2 --plot wear.png --save worn.prw");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line); // heading
  double last_distance = 0.0;
  while (std::getline(lines, line)) {
    std::istringstream numbers(line);
    double distance = 0.0, depth = 0.0, missing = 0.0, worn = 0.0, difference = 1.0;
    ASSERT_TRUE(numbers >> distance >> depth >> missing >> worn >> difference) << line;
    EXPECT_GT(distance, last_distance);
    EXPECT_GT(worn, 1.0);
    EXPECT_GT(depth, 0.05);
    EXPECT_LT(std::abs(difference), 1e-12) << line;
    last_distance = distance;
  }
  EXPECT_EQ(last_distance, 2500.0);
  EXPECT_TRUE(is_png("wear.png"));
  EXPECT_FALSE(read("worn.prw").empty());
}

TEST_F(WrcWear, RefusesMistakesBeforeItSolves) {
  run("--distance 1 --wheel S1003").expect_refusal({"S1003", "no such file", "built-in"});
  run("--distance 1 --plot a.pdf").expect_refusal({"--plot a.pdf", ".png"});
  write("flat.SLCW", "not read\n");
  run("--distance 1 --wheel flat.SLCW")
      .expect_refusal({"flat.SLCW: must be a file of one profile here, not one of slices around "
                       "the wheel"});
  run("--distance 1 --rail rail.SLCS").expect_refusal({".rail = rail.SLCS", "in a mission"});
  run("--distance 1 --set track.left.rail=rail.slcs")
      .expect_refusal({"track.left.rail = rail.slcs", "in a mission"});
  run("--distance 1 --set wheelset.harmonics=[20,0.5,0]")
      .expect_refusal({"wheelset.harmonics = [20, 0.5, 0]", "in a mission"});
}

/// Thrown on another thread, it ended the program by a signal.
/// Not after hours.
TEST_F(WrcWear, SaysAtOnceWhatItCannotWrite) {
  run("--distance 20 --save no_such_folder/worn.prw")
      .expect_refusal({"cannot write no_such_folder/worn.prw"});
  run(WRC_REPORT_PROGRAM, "none.prw 60E1 --page no_such_folder/page.html")
      .expect_refusal({"cannot write no_such_folder/page.html"});
}

TEST_F(WrcWear, ReportsAFailureOfAPassage) {
  const Outcome outcome = run("--distance 10 --threads 2 --set load.both=1e9");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.error.find("load of a wheel = 1e+09"), std::string::npos) << outcome.error;
}

TEST_F(WrcWear, TurnsAWheelAsItsOptionsSay) {
  run("--distance 1 --wheel '" WRCONTACT_REFERENCE_DIR "/profiles/avg_wheel.txt; align_to = 60E1'")
      .expect_refusal({"align_to", "60E1 is a rail"});
}

TEST_F(WrcWear, RefusesAnUnknownKey) {
  const Outcome outcome = run("--distance 1 --set wear.lore=usfd");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.error.find("wear.lore"), std::string::npos) << outcome.error;
}

} // namespace
} // namespace wrc_wear_test
