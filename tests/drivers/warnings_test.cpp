/// Warnings in what the programs print and write; tests/warnings has every class of them.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "run_driver.hpp"

namespace warnings_test {
namespace {

class WrcSweepWarnings : public Driver {
protected:
  WrcSweepWarnings() : Driver(WRC_SWEEP_PROGRAM) {}
};

TEST_F(WrcSweepWarnings, EachKindIsPrintedOnceWithTheNumberOfScenes) {
  write("s.toml",
        "[pose]\nlateral = [0, 5, 5.05, 6.5]\n[solve]\naccuracy = 0.004\n[study]\nresults = "
        "[\"left.pmax\"]\n");
  const Outcome outcome = run("s.toml --out o --threads 2 --quiet");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "");
  const auto has = [&outcome](const char* text) {
    return outcome.error.find(text) != std::string::npos;
  };
  EXPECT_TRUE(outcome.error.starts_with("wrc_sweep: 1 of 4 scenes: do not use; 2 a little over the "
                                        "accuracy. All warnings are in o/s.csv\n"))
      << outcome.error;
  EXPECT_TRUE(has("\n  A little over: 2 scenes: left: the rail turns by 0.")) << outcome.error;
  EXPECT_TRUE(has("\n  Do not use: 1 scene: left: the largest pressure, 61")) << outcome.error;
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 3) << outcome.error;
  const Outcome loud = run("s.toml --out o1 --threads 1");
  EXPECT_TRUE(
      loud.out.starts_with("4 scenes: all solved; 1 of 4 scenes: do not use; 2 a little over "
                           "the accuracy\n"))
      << loud.out;
  const std::string& again = loud.error;
  EXPECT_EQ(again.substr(again.find('\n')), outcome.error.substr(outcome.error.find('\n')))
      << "whatever scene ends first";
  const std::string table = read("o/s.csv");
  EXPECT_TRUE(table.starts_with("scene,pose.lateral,left.")) << table;
  EXPECT_NE(table.find(",grade,warning_count,status,message,warnings\n0,0,8"), std::string::npos)
      << table;
  EXPECT_NE(table.find(",1,1,ok,,\"left: the rail turns by"), std::string::npos) << table;
}

TEST_F(WrcSweepWarnings, AResultOfTheSameNameIsWrittenOnce) {
  write("s.toml", "[pose]\nlateral = [0, 6.5]\n[solve]\naccuracy = 0.004\n[study]\nresults = "
                  "[\"left.pmax\", \"warning_count\", \"grade\"]\n");
  EXPECT_EQ(run("s.toml --out o").exit_code, 0);
  const std::string table = read("o/s.csv");
  EXPECT_TRUE(table.starts_with(
      "scene,pose.lateral,left.pmax,warning_count,grade,status,message,warnings\n"))
      << table;
}

class WrcProfileWarnings : public Driver {
protected:
  WrcProfileWarnings() : Driver(WRC_PROFILE_PROGRAM) {}
};

TEST_F(WrcProfileWarnings, ConfidenceIsThatOfTheFileIfNothingWasGuessed) {
  const Outcome rail = run("60E1 --convert r.txt");
  ASSERT_EQ(rail.exit_code, 0) << rail.error;
  EXPECT_NE(run("r.txt --kind rail").out.find("confidence           as the file\n"),
            std::string::npos);
  const std::string guessed = run("r.txt").out;
  EXPECT_NE(guessed.find("as the file, except for one guess (corrected)\n"), std::string::npos)
      << guessed;
}

class WrcCaseWarnings : public Driver {
protected:
  WrcCaseWarnings() : Driver(WRC_CASE_PROGRAM) {}
};

TEST_F(WrcCaseWarnings, ThreeNearContactsArePrintedAndTheRestCounted) {
  // Waves of 0.05 mm, 3 mm long: a touch on each crest.
  std::string wheel;
  for (double y = -30.0; y <= 60.0; y += 0.25) {
    wheel += std::to_string(y) + ' ' + std::to_string(0.02 * std::cos(2.0 * y)) + '\n';
  }
  write("waves.wheel", wheel);
  const Outcome outcome =
      run("--set wheelset.wheel=waves.wheel solve.until=geometry solve.side=left "
          "solve.near_tolerance=10");
  std::size_t lines = 0;
  for (std::size_t at = outcome.out.find("Near contact, left: "); at != std::string::npos;
       at = outcome.out.find("Near contact, left: ", at + 1)) {
    ++lines;
  }
  EXPECT_EQ(lines, 4U) << outcome.out << outcome.error;
  EXPECT_NE(outcome.out.find(" more within 10 mm\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(": left wheel profile waves.wheel: "), std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.out.find("Corrected: waves.wheel: warning"), std::string::npos);
}

/// Of the scenes of a study those a little over the accuracy have full marks, and the note is grey.
TEST_F(WrcSweepWarnings, OnlyScenesThatAreNotToBeUsedAreMarkedInPictures) {
  NEEDS_GNUPLOT();
  const std::string picture = "\n[[picture]]\nkind = \"lines\"\nfile = \"s.svg\"\n"
                              "x = \"pose.lateral\"\npanels = [{y_label = \"pmax\", lines = "
                              "[{result = \"left.pmax\", title = \"left\"}]}]\n";
  const auto drawn = [&](const std::string& lateral) {
    write("s.toml", "[pose]\nlateral = " + lateral + "\n[solve]\naccuracy = 0.004\n[study]\n" +
                        "results = [\"left.pmax\"]" + picture);
    EXPECT_EQ(run("s.toml --restart --out p --quiet").exit_code, 0);
    return read("p/s.svg");
  };
  const std::string quiet = drawn("[0, 5, 5.05]");
  EXPECT_NE(quiet.find("2 of 3 scenes a little over the accuracy"), std::string::npos);
  EXPECT_EQ(quiet.find("hollow"), std::string::npos);
  const std::string loud = drawn("[0, 5, 6.5]");
  EXPECT_NE(loud.find("1 of 3 scenes: do not use, shown hollow; 1 a little over the accuracy"),
            std::string::npos);
}

TEST_F(WrcCaseWarnings, ALittleOverTheAccuracyIsOneLine) {
  const Outcome quiet = run("--set pose.lateral=5 solve.accuracy=0.004");
  EXPECT_NE(quiet.out.find("\nA little over: left: the rail turns by"), std::string::npos);
  EXPECT_EQ(quiet.out.find("Do not use: "), std::string::npos);
  const Outcome loud = run("--set pose.lateral=5 solve.accuracy=0.001");
  EXPECT_NE(loud.out.find("\nDo not use: left: the rail turns by"), std::string::npos);
}

/// Below stresses too, and whole where the picture is wide enough.
TEST_F(WrcCaseWarnings, AppearInPicturesOfEveryKind) {
  NEEDS_GNUPLOT();
  const std::string assigned = "--set pose.lateral=6.5 solve.accuracy=0.1 ";
  const std::string text = "left: the largest pressure, 61";
  ASSERT_EQ(run(assigned + "solve.results=stress --plot stress.svg").exit_code, 0);
  EXPECT_NE(read("stress.svg").find(text), std::string::npos);
  ASSERT_EQ(run(assigned + "solve.side=left --plot one.svg").exit_code, 0);
  const std::string picture = read("one.svg");
  const std::size_t begin = picture.find(text);
  ASSERT_NE(begin, std::string::npos);
  const std::string shown = picture.substr(begin, picture.find('<', begin) - begin);
  EXPECT_TRUE(shown.ends_with("the contact is larger")) << shown; // two panels are as wide as that
}

} // namespace
} // namespace warnings_test
