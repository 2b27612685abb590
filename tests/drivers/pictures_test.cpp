/// What pictures of scenes and studies show, read from their texts in SVG.
#include <iomanip>
#include <sstream>

#include "run_driver.hpp"

namespace pictures_test {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

/// The number of times that a picture has a number at a tick.
std::size_t ticks_of(const std::string& svg, const std::string& number) {
  return count_of(svg, "> " + number + '<') + count_of(svg, '>' + number + '<');
}

class CasePictures : public Driver {
protected:
  CasePictures() : Driver(WRC_CASE_PROGRAM) {}

  [[nodiscard]] std::string drawn(const std::string& arguments) const {
    const Outcome outcome = run("--set solve.accuracy=1e-2 " + arguments + " --plot p.svg");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return read("p.svg");
  }
};

/// Two lobes, so that the force does not point along the normal of the plane.
TEST_F(CasePictures, TheAngleIsThatOfTheForceAsInTheTable) {
  NEEDS_GNUPLOT();
  const std::string svg = drawn("--set pose.lateral=5");
  const nlohmann::json patch =
      run_json("--set solve.accuracy=1e-2 pose.lateral=5")["left"]["patches"][0];
  const auto text_of_angle = [&patch](const char* name) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << 1e3 * patch[name].get<double>() << " mrad";
    return text.str();
  };
  ASSERT_NE(text_of_angle("angle"), text_of_angle("plane_angle"));
  EXPECT_NE(svg.find(text_of_angle("angle")), std::string::npos);
  EXPECT_EQ(svg.find(text_of_angle("plane_angle")), std::string::npos);
}

/// The first touch is on the wing at y = 803 mm, the second patch on the nose at y = 725 mm.
TEST_F(CasePictures, ThePatchesOnWingAndNoseAreInTheFrame) {
  NEEDS_GNUPLOT();
  const std::string svg =
      drawn("--set track.left.rail=" + std::string(WRC_CROSSING) + " pose.longitudinal=180");
  expect_parts(svg, {"patch 0: ", "patch 1: "});
  for (const char* tick : {"820", "800", "740", "720"}) {
    EXPECT_GE(ticks_of(svg, tick), 1U) << tick;
  }
  // Their pressures beside each other: of the 73 mm between them most are left out.
  EXPECT_NE(svg.find(" mm left out"), std::string::npos);
  EXPECT_EQ(ticks_of(svg, "-40"), 0U);
  EXPECT_GE(ticks_of(svg, "-80"), 1U);
}

TEST_F(CasePictures, AWheelWithoutTractionsHasNoPanelForThem) {
  NEEDS_GNUPLOT();
  const std::string svg = drawn("--set creepage.left=[0.001,0,0]");
  EXPECT_NE(svg.find("tractions on the left wheel: "), std::string::npos);
  EXPECT_EQ(svg.find("tractions on the right wheel: "), std::string::npos);
  EXPECT_EQ(svg.find("no tractions"), std::string::npos);
}

TEST_F(CasePictures, OneLegendServesBothWheelsAndArrowsHaveAScale) {
  NEEDS_GNUPLOT();
  const std::string both = drawn("--set creepage.longitudinal=0.001");
  const std::string one = drawn("--set creepage.longitudinal=0.001 solve.side=left");
  for (const char* text : {">rail<", ">wheel<", ">first touch<"}) {
    EXPECT_GE(count_of(one, text), 1U) << text;
    EXPECT_EQ(count_of(both, text), count_of(one, text)) << text;
  }
  EXPECT_EQ(count_of(both, ">100 MPa<"), 2U) << "beside an arrow of this length, on each wheel";
}

TEST_F(CasePictures, ANearContactUnderLoadIsReportedAsClosed) {
  const std::string place = "mm apart at first touch at s_wheel -17.73 mm";
  const Outcome loaded = run("--set pose.lateral=5 solve.accuracy=1e-2 solve.side=left");
  EXPECT_NE(loaded.out.find("Closed by the load, left: 0.0017 " + place), std::string::npos)
      << loaded.out;
  EXPECT_EQ(loaded.out.find("Near contact"), std::string::npos) << loaded.out;
  const Outcome light =
      run("--set pose.lateral=5 solve.accuracy=1e-2 solve.side=left load.both=10");
  EXPECT_NE(light.out.find("Near contact, left: 0.0017 mm apart at s_wheel -17.73"),
            std::string::npos)
      << light.out;
}

class StudyPictures : public Driver {
protected:
  StudyPictures() : Driver(WRC_SWEEP_PROGRAM) {}

  /// Of the study with one panel of a result.
  [[nodiscard]] std::string drawn(const std::string& panel) const {
    write("s.toml", "[track]\nrail = \"56E1\"\n[pose]\nlateral = [5, 6.15]\n"
                    "[solve]\naccuracy = 0.05\nside = \"left\"\n"
                    "[study]\nresults = [\"left.patch_count\"]\n[[picture]]\nfile = \"p.svg\"\n"
                    "x = \"pose.lateral\"\n[[picture.panels]]\n" +
                        panel + "lines = [{result = \"left.patch_count\"}]\n");
    const Outcome outcome = run("s.toml --restart");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return read("p.svg");
  }
};

TEST_F(StudyPictures, NumbersOfPatchesHaveWholeTicks) {
  NEEDS_GNUPLOT();
  const std::string svg = drawn("");
  EXPECT_GE(ticks_of(svg, "1"), 1U);
  EXPECT_GE(ticks_of(svg, "2"), 1U);
  EXPECT_EQ(ticks_of(svg, "1.2"), 0U);
  EXPECT_EQ(ticks_of(svg, "1.5"), 0U);
}

TEST_F(StudyPictures, PointsAreNotJoinedOnRequest) {
  NEEDS_GNUPLOT();
  const std::string joined = drawn("");
  const std::string apart = drawn("style = \"points\"\n");
  const std::string first_colour = "<path stroke='rgb(  0,  96, 173)'";
  EXPECT_EQ(count_of(joined, first_colour), 1U);
  EXPECT_EQ(count_of(apart, first_colour), 0U);
  const std::string mark = "<use xlink:href='#gpPt4'";
  EXPECT_EQ(count_of(apart, mark), count_of(joined, mark));
  write("bad.toml", "[pose]\nlateral = [0, 1]\n[study]\nresults = [\"roll\"]\n[[picture]]\nfile = "
                    "\"p.svg\"\nx = \"pose.lateral\"\n[[picture.panels]]\nstyle = \"dots\"\n"
                    "lines = [{result = \"roll\"}]\n");
  run("bad.toml").expect_refusal({"style", "dots", "\"lines\" or \"points\""});
}

TEST_F(StudyPictures, TheProgramOfManyProcessesSaysItsOwnName) {
  if (std::string(WRC_MPIEXEC).empty()) {
    GTEST_SKIP() << "built without MPI";
  }
  const Outcome help = run(WRC_SWEEP_MPI_PROGRAM, "--help");
  EXPECT_NE(help.out.find("Usage: wrc_sweep_mpi "), std::string::npos) << help.out;
}

} // namespace
} // namespace pictures_test
