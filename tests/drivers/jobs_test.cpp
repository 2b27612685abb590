/// Each job of docs/jobs.md with a pair of measured files: studies by name, wear, report.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "run_driver.hpp"
#include "support/csv_table.hpp"
#include "support/html.hpp"

namespace jobs_test {
namespace {

using driver::CsvTable;

const std::string wheel = WRCONTACT_REFERENCE_DIR "/profiles/avg_wheel.txt";
const std::string rail = WRCONTACT_REFERENCE_DIR "/profiles/UIC60-Manchester.txt";

class Jobs : public Driver {
protected:
  Jobs() : Driver(WRC_SWEEP_PROGRAM) {}

  void SetUp() override {
    Driver::SetUp();
    std::filesystem::create_directories(folder() / "measured");
    std::filesystem::copy_file(wheel, folder() / "measured/wheel.txt");
    std::filesystem::copy_file(rail, folder() / "measured/rail.txt");
  }
  [[nodiscard]] std::string succeed(const std::string& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return outcome.out;
  }
  [[nodiscard]] CsvTable table(const std::string& name) const { return CsvTable(folder() / name); }
};

TEST_F(Jobs, ShippedStudiesAreListed) {
  const std::string list = succeed("--list-studies");
  expect_parts(list, {"conicity ", "fleet ", "contact_map ", "contact_table ", "EN 15302"});
  run("fleat").expect_refusal({"fleat"});
}

/// A folder of the study's name, for example of its results, does not hide it; a file does.
TEST_F(Jobs, AFileComesBeforeAShippedStudy) {
  (void)succeed("conicity --no-pictures --set 'pose.lateral=[0, 1]' --out conicity");
  EXPECT_EQ(line_count(read("conicity/conicity.csv")), 3);
  (void)succeed("conicity --no-pictures --set 'pose.lateral=[0, 1, 2]' --out conicity");
  EXPECT_EQ(line_count(read("conicity/conicity.csv")), 4);
  write("contact_map", "[load]\nboth = 0\n");
  (void)succeed("contact_map --no-pictures --out o");
  EXPECT_EQ(line_count(read("o/contact_map.csv")), 2);
}

TEST_F(Jobs, ConicityOfOneRailIsInWords) {
  NEEDS_GNUPLOT();
  const std::string out =
      succeed("conicity --wheels S1002 measured/wheel.txt --rails 60E1 --out o");
  // EN 15302, S1002 on 60E1 1:40: 0.175 in the literature.
  constexpr double literature = 0.005;
  const CsvTable amplitudes = table("o/conicity_by_amplitude.csv");
  EXPECT_NEAR(amplitudes.where("series", "S1002").at("amplitude", 3.0, "equivalent_conicity"),
              0.175, literature);
  EXPECT_GT(
      amplitudes.where("series", "measured/wheel.txt").at("amplitude", 3.0, "equivalent_conicity"),
      0.0);
  expect_parts(out, {"S1002: equivalent conicity 0.17", "wheel.txt: equivalent conicity 0.",
                     "at an amplitude of 3 mm"});
  EXPECT_EQ(out.find("measured/wheel.txt: "), std::string::npos) << "files by their names";
  expect_parts(out, {" +- 0.", "nonlinearity parameter "});
  for (const double amplitude : {1.0, 3.0, 6.0}) {
    EXPECT_EQ(amplitudes.where("series", "S1002").at("amplitude", amplitude, "spread"), 0.0);
    EXPECT_GT(amplitudes.where("series", "measured/wheel.txt").at("amplitude", amplitude, "spread"),
              0.0);
  }
  EXPECT_TRUE(is_png("o/conicity.png"));
  // One wheel on one rail has no series. This rail was measured as it is inclined.
  EXPECT_TRUE(succeed("conicity --rails measured/rail.txt --set track.inclination=0.0 --out one")
                  .starts_with("equivalent conicity 0.18"));
  expect_parts(succeed("conicity --wheels S1002 --rails 60E1 UIC60-Manchester --out two"),
               {"60E1: equivalent", "UIC60-Manchester: equivalent conicity 0.18"});
}

TEST_F(Jobs, AFleetIsRanked) {
  NEEDS_GNUPLOT();
  const std::string out =
      succeed("fleet --wheels S1002 measured/wheel.txt nowhere.whl LMA --rails "
              "60E1 --set 'pose.lateral=[-3, 0, 3]' --threads 2 --digits 17 --out o");
  const CsvTable ranking = table("o/fleet_ranking.csv");
  const CsvTable scenes = table("o/fleet.csv");
  ASSERT_EQ(ranking.row_count(), 4U);
  ASSERT_EQ(scenes.row_count(), 12U);
  const auto names = ranking.texts("series");
  const auto largest = ranking.numbers("max of left.pmax");
  EXPECT_TRUE(std::is_sorted(largest.begin(), largest.begin() + 3, std::greater<>()));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto pmax = scenes.where("wheelset.wheel", names[i]).numbers("left.pmax");
    EXPECT_EQ(largest[i], *std::max_element(pmax.begin(), pmax.end())) << names[i];
    EXPECT_NEAR(ranking.numbers("mean of left.pmax")[i], (pmax[0] + pmax[1] + pmax[2]) / 3.0, 1e-9);
  }
  // What could not be solved stands last, without a number.
  EXPECT_EQ(names[3], "nowhere.whl");
  EXPECT_TRUE(std::isnan(largest[3]));
  EXPECT_EQ(ranking.numbers("not_solved")[3], 3.0);
  EXPECT_LT(out.find("wheel.txt"), out.find("nowhere.whl")) << out;
  EXPECT_TRUE(is_png("o/fleet.png"));
  EXPECT_TRUE(is_png("o/fleet_ranking.png"));
}

TEST_F(Jobs, RefusesAWrongRanking) {
  const std::string study = "[pose]\nlateral = [0, 1]\n[[picture]]\nkind = \"ranking\"\n";
  write("s.toml", study + "panels = [{statistic = \"median\", lines = [{result = \"roll\"}]}]\n");
  run("s.toml").expect_refusal({"statistic", "median", "mean"});
  write("s.toml", study);
  run("s.toml").expect_refusal({"picture.panels"});
  write("s.toml",
        study + "series = [\"pose.sideways\"]\npanels = [{lines = [{result = \"roll\"}]}]\n");
  run("s.toml").expect_refusal({"picture.series", "pose.sideways"});
}

TEST_F(Jobs, MapAndTableTakeMeasuredPairs) {
  NEEDS_GNUPLOT();
  const std::string pair = " --wheels measured/wheel.txt --rails measured/rail.txt --out o ";
  (void)succeed("contact_map" + pair + "--set 'pose.yaw=[-0.01, 0.01]' 'pose.lateral=[-2, 0, 2]'");
  EXPECT_EQ(table("o/contact_map.csv").row_count(), 6U);
  EXPECT_TRUE(is_png("o/contact_map.png"));
  const Outcome two = run("contact_map --no-pictures --quiet --rails 60E1 54E1 --out two --set "
                          "'pose.yaw=[0, 0.01]' 'pose.lateral=[0, 2]' load.both=0");
  EXPECT_EQ(two.error, "");
  const Outcome drawn = run("contact_map --quiet --rails 60E1 54E1 --out two --restart --set "
                            "'pose.yaw=[0, 0.01]' 'pose.lateral=[0, 2]' load.both=0");
  EXPECT_EQ(drawn.error,
            "wrc_sweep: contact_map.png shows track.rail = 60E1, the first of 2 values; where = "
            "{...} of the picture selects others, and --set one value\n");
  (void)succeed("contact_table" + pair + "--set 'pose.yaw=[0.0]' 'pose.lateral=[-2, 0, 2]'");
  const CsvTable contact = table("o/contact_table.csv");
  ASSERT_EQ(contact.row_count(), 9U);
  for (const double force : contact.where("load.both", "80000").numbers("left.total.force.z")) {
    EXPECT_NEAR(force, 80000.0, 800.0); // the accuracy
  }
  EXPECT_TRUE(is_png("o/contact_table.png"));
}

TEST_F(Jobs, WearTakesOwnWheelRailAndMission) {
  write("line.toml", "wander = 2.0\n[[curve]]\nradius = 0.0\nspeed = 30.0\nshare = 0.5\n"
                     "[[curve]]\nradius = 500.0\nspeed = 20.0\nshare = 0.5\n");
  const std::string pair = "--wheel measured/wheel.txt --rail measured/rail.txt --distance 500 ";
  const Outcome outcome = run(WRC_WEAR_PROGRAM, pair + "--mission line.toml --save later.prw");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_FALSE(read("later.prw").empty());
  // The mission matters.
  const Outcome usual = run(WRC_WEAR_PROGRAM, pair);
  EXPECT_NE(outcome.out, usual.out);
  const auto refuse = [&](const std::string& text, std::initializer_list<std::string> parts) {
    write("bad.toml", text);
    run(WRC_WEAR_PROGRAM, "--mission bad.toml").expect_refusal(parts);
  };
  refuse("[[curve]]\nradius = 0\nspeed = 30\nshare = 0.5\n", {"bad.toml", "0.5", "1"});
  refuse("[[curve]]\nradius = 3\nspeed = 30\nshare = 1\n", {"curve.radius = 3"});
  refuse("[[curve]]\nradius = 0\nshare = 1\n", {"curve.speed"});
  refuse("wheelbas = 3\n[[curve]]\nradius = 0\nspeed = 30\nshare = 1\n", {"mission.wheelbas"});
  run(WRC_WEAR_PROGRAM, "--wheel 60E1").expect_refusal({"60E1", "wheel"});
  run(WRC_WEAR_PROGRAM, "--set wheelset.wheel=LMA").expect_refusal({"wheelset.wheel", "--wheel"});
}

TEST_F(Jobs, AReportIsOnePage) {
  NEEDS_GNUPLOT();
  const Outcome outcome =
      run(WRC_REPORT_PROGRAM, "measured/wheel.txt measured/rail.txt --threads 2 "
                              "--set solve.accuracy=0.1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.out, "report.html\n");
  const std::string page = read("report.html");
  expect_parts(page, {"<h1>wheel.txt on rail.txt</h1>", "equivalent conicity 0.", "(Sh)", "(Sd)",
                      "<td>qR</td>", "Contact band on the wheel: s = -", "Largest pressure centred",
                      "<h2>Warnings</h2>", "data:image/svg+xml;base64,", "data:image/png;base64,"});
  // Nothing is loaded, and no folder is shown.
  EXPECT_EQ(page.find("http:"), std::string::npos);
  EXPECT_EQ(page.find("https:"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("measured/"), std::string::npos);
  EXPECT_LT(page.size(), std::size_t{1} << 20U);
  EXPECT_EQ(file_count(), 2) << "the page and the folder of the profiles";
}

/// The numbers of the page are those of wrc_case.
TEST_F(Jobs, AReportShowsThePressuresOfWrcCase) {
  NEEDS_GNUPLOT();
  ASSERT_EQ(run(WRC_REPORT_PROGRAM, "S1002 60E1 --page a.html --threads 2").exit_code, 0);
  const std::string page = read("a.html");
  const auto scene = run_json(WRC_CASE_PROGRAM, "--set solve.accuracy=1e-2 pose.lateral=3");
  const auto pmax = std::to_string(std::lround(scene.at("left").at("pmax").get<double>()));
  EXPECT_NE(page.find("<td class=\"number\">3</td><td class=\"number\">" + pmax + "</td>"),
            std::string::npos)
      << pmax;
  ASSERT_EQ(run(WRC_REPORT_PROGRAM, "S1002 60E1 --page b.html --quiet").exit_code, 0);
  const auto without_origin = [](const std::string& text) {
    return text.substr(0, text.find("<p>")) + text.substr(text.find("<h2>"));
  };
  EXPECT_EQ(without_origin(page), without_origin(read("b.html"))) << "threads do not change a bit";
}

TEST_F(Jobs, AReportRefusesMistakes) {
  NEEDS_GNUPLOT();
  run(WRC_REPORT_PROGRAM, "60E1 S1002").expect_refusal({"60E1", "wheel"});
  run(WRC_REPORT_PROGRAM, "S1002 nowhere.prr").expect_refusal({"nowhere.prr", "no such file"});
  run(WRC_REPORT_PROGRAM, "S1002 60E1 --set pose.lateral=3").expect_refusal({"pose.lateral"});
  run(WRC_REPORT_PROGRAM, "S1002 measured/rail.txt --page measured/rail.txt")
      .expect_refusal({"measured/rail.txt"});
  write("rail.slcs", "0 10\n3\n2\n1\n0 'a.txt'\n1 'a.txt'\n2 'a.txt'\n");
  run(WRC_REPORT_PROGRAM, "S1002 rail.slcs")
      .expect_refusal({"rail.slcs: must be a file of one profile here, not one of slices along "
                       "the track"});
  run(WRC_REPORT_PROGRAM, "S1002 60E1 --set track.left.rail=54E3")
      .expect_refusal({"track.left.rail", "WHEEL and RAIL"});
  run(WRC_REPORT_PROGRAM, "S1002 60E1 --set wheelset.harmonics=[1,5,0]")
      .expect_refusal({"wheelset.harmonics = [1, 5, 0]", "in a report"});
  EXPECT_FALSE(exists("report.html"));
}

TEST_F(Jobs, NamesOfElementsAreTextsOfAReport) {
  NEEDS_GNUPLOT();
  const std::string hostile = "x<img src=y onerror=alert(1)>&amp;\"'.txt";
  std::filesystem::copy_file(wheel, folder() / hostile);
  const Outcome outcome =
      run(WRC_REPORT_PROGRAM, "\"x<img src=y onerror=alert(1)>&amp;\\\"'.txt\" 60E1 --set "
                              "solve.accuracy=0.1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const std::string page = read("report.html");
  EXPECT_NE(
      page.find("<h1>x&lt;img src=y onerror=alert(1)&gt;&amp;amp;&quot;&#39;.txt on 60E1</h1>"),
      std::string::npos)
      << page.substr(0, 2000);
  EXPECT_EQ(page.find("<img src=y"), std::string::npos);
  EXPECT_EQ(driver::html_text("<&>\"'\n\x01"), "&lt;&amp;&gt;&quot;&#39;  ");
}

} // namespace
} // namespace jobs_test
