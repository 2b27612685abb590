/// wrc_profile as a process: measures, conversion, comparison, refusals.
#include <cmath>
#include <sstream>

#include "run_driver.hpp"

namespace wrc_profile_test {
namespace {

using nlohmann::json;

/// Dimensions of the standard's drawings are met to the rounding of its coefficients (gaps of
/// 1.2e-4 mm are known).
constexpr double drawing = 2e-4;
/// What is computed from exact input and only rounds.
constexpr double rounding = 1e-9;

class WrcProfile : public Driver {
protected:
  WrcProfile() : Driver(WRC_PROFILE_PROGRAM) {}
};

TEST_F(WrcProfile, MeasuresTheStandardWheel) {
  const json wheel = run_json("S1002");
  EXPECT_EQ(wheel.at("name"), "S1002");
  EXPECT_EQ(wheel.at("kind"), "wheel");
  for (const char* key : {"title", "source", "confidence"}) {
    EXPECT_NE(wheel.at(key), "") << key;
  }
  EXPECT_EQ(wheel.at("corrections").size(), 0U);
  const auto dimension = [&wheel](const char* key) {
    return wheel.at("dimensions").at(key).get<double>();
  };
  // EN 13715: h 28, e 32.5, qR 10.794; slope of the polynomial of zone A at the taping line.
  EXPECT_NEAR(dimension("flange_height"), 28.0, drawing);
  EXPECT_NEAR(dimension("flange_thickness"), 32.5, drawing);
  EXPECT_NEAR(dimension("qr"), 10.794, drawing + 0.5e-3);
  EXPECT_NEAR(dimension("slope"), -3.358537058e-2, rounding);
  EXPECT_EQ(dimension("conicity"), -dimension("slope"));
  EXPECT_NEAR(wheel.at("extents").at("lateral").at(0).get<double>(), -70.0, rounding);
  EXPECT_NEAR(wheel.at("extents").at("height").at(1).get<double>(), 28.0, rounding);
  const json& checks = wheel.at("checks");
  EXPECT_NEAR(checks.at("smallest_radius").get<double>(), 12.0, 1e-6);
  EXPECT_NEAR(checks.at("largest_step").get<double>(), 1.19e-4, 0.01e-4); // told by its source
  // The chamfer of 45 degrees at the outer edge meets the 1:15 line.
  EXPECT_NEAR(checks.at("largest_kink").get<double>(), std::atan(1.0) - std::atan(1.0 / 15.0),
              1e-4);
  EXPECT_NEAR(checks.at("largest_kink_at").at("lateral").get<double>(), 60.0, rounding);
  EXPECT_EQ(checks.at("steep_parts").size(), 1U); // the flange back
}

TEST_F(WrcProfile, MeasuresTheStandardRail) {
  const json rail = run_json("60E1");
  EXPECT_EQ(rail.at("kind"), "rail");
  const json& dimensions = rail.at("dimensions");
  EXPECT_NEAR(dimensions.at("crown_radius").get<double>(), 300.0, 1e-6);
  // Sides of 1:20 widen the head by 0.1 mm a mm of depth, except for the rest of the R13 corner.
  EXPECT_NEAR(dimensions.at("head_width_14").get<double>(), 72.0, 0.05);
  EXPECT_NEAR(dimensions.at("head_width_16").get<double>() -
                  dimensions.at("head_width_14").get<double>(),
              0.2, 0.01);
  EXPECT_NEAR(rail.at("checks").at("smallest_radius").get<double>(), 13.0, 1e-6);
  const json& steep = rail.at("checks").at("steep_parts");
  ASSERT_EQ(steep.size(), 2U);
  EXPECT_NEAR(steep.at(0).at("steepest_angle").get<double>(), std::atan(20.0), 1e-6);
  EXPECT_FALSE(steep.at(0).at("overhangs").get<bool>());
}

/// S1002 with waves of 5 mm, which may be steel or noise that an instrument has filtered.
TEST_F(WrcProfile, SaysWhatDependsOnTheSmoothing) {
  EXPECT_EQ(run("S1002 --convert plain.txt").exit_code, 0);
  std::istringstream plain(read("plain.txt"));
  std::ostringstream wavy;
  for (std::string line; std::getline(plain, line);) {
    std::istringstream row(line);
    if (double y = 0.0, z = 0.0; row >> y >> z) {
      wavy << y << ' ' << z + 0.006 * std::cos(2.0 * 3.14159 * y / 5.0) << '\n';
    }
  }
  write("wavy.wheel", wavy.str());
  const std::string file = "wavy.wheel --kind wheel --origin tape ";
  const json contact = run_json(file).at("contact");
  EXPECT_EQ(contact.at("with"), "60E1");
  const double pmax = contact.at("pmax").get<double>();
  EXPECT_NEAR(contact.at("smoothed_0mm.pmax").get<double>(), pmax, 0.01 * pmax);
  EXPECT_GT(pmax, 1.2 * contact.at("smoothed_15mm.pmax").get<double>());
  EXPECT_NEAR(contact.at("smoothed_15mm.pmax").get<double>(), 898.0, 0.1 * 898.0);
  EXPECT_EQ(contact.at("spread.grade"), 2);
  EXPECT_NE(run(file).out.find("Do not use: left: uncertain by noise or short waves"),
            std::string::npos);
  EXPECT_FALSE(run_json("S1002").contains("contact"));
  EXPECT_EQ(run("S1002 --convert sparse.txt --spacing 3").exit_code, 0);
  const std::string sparse = run("sparse.txt --kind wheel --origin tape").out;
  EXPECT_NE(sparse.find("Note: left: how far noise moves pmax and area is not known"),
            std::string::npos)
      << sparse;
  run(file + "--strict").expect_refusal({"uncertain by noise", "state the smoothing"});
  EXPECT_EQ(run(file + "--strict --smooth 0").exit_code, 0);
  const Outcome scene = run(WRC_CASE_PROGRAM, "--set 'wheelset.wheel=wavy.wheel; origin = tape'");
  for (const char* part :
       {"Profiles smoothed, mm", "right area", "Do not use: right: uncertain by noise"}) {
    EXPECT_NE(scene.out.find(part), std::string::npos) << part;
  }
}

TEST_F(WrcProfile, FindsKinksAndOverhangs) {
  // A rail head whose sides lean in below the widest place.
  write("head.rail", "-28 -40\n-34 -30\n-36 -20\n-34 -10\n-20 -2\n0 0\n20 -2\n34 -10\n36 -20\n"
                     "34 -30\n28 -40\n");
  const json steep = run_json("head.rail").at("checks").at("steep_parts");
  ASSERT_EQ(steep.size(), 2U);
  EXPECT_TRUE(steep.at(0).at("overhangs").get<bool>());
  EXPECT_TRUE(steep.at(1).at("overhangs").get<bool>());
}

TEST_F(WrcProfile, MissingDimensionsAreNull) {
  write("crown.rail", "-4 -0.1\n-2 -0.02\n0 0\n2 -0.02\n4 -0.1\n");
  const json dimensions = run_json("crown.rail --scale 1").at("dimensions");
  for (const char* key : {"head_width_14", "head_width_16", "crown_radius"}) {
    EXPECT_TRUE(dimensions.at(key).is_null()) << key;
  }
  EXPECT_NE(run("crown.rail --scale 1").out.find("does not reach"), std::string::npos);
}

TEST_F(WrcProfile, TheTableListsCorrections) {
  std::ostringstream points;
  for (int y = -60; y <= 60; y += 2) {
    points << y << ' ' << 20.0 * y * y / 3600.0 << '\n';
  }
  write("upside_down.rail", points.str());
  const Outcome outcome = run("upside_down.rail");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("height mirrored"), std::string::npos);
  run("upside_down.rail --strict").expect_refusal({"upside_down.rail", "mirror_height"});
  const json asked = run_json("upside_down.rail --strict --mirror-height yes --scale 0.5");
  EXPECT_NEAR(asked.at("extents").at("height").at(0).get<double>(), -10.0, rounding);
  EXPECT_EQ(asked.at("corrections").size(), 2U);
  const json kept = run_json("upside_down.rail --mirror-height no --mirror-lateral yes");
  EXPECT_NEAR(kept.at("extents").at("height").at(1).get<double>(), 20.0, rounding);
}

/// A wheel measured with a tilt of one degree, by a nominal profile or a stated angle.
TEST_F(WrcProfile, TurnsATiltedWheel) {
  std::ostringstream points;
  std::ostringstream straight_points;
  const json wheel = run_json("S1002 --points --spacing 0.5");
  const double tilt = std::acos(-1.0) / 180.0;
  for (const json& point : wheel.at("points")) {
    const double y = point.at("lateral");
    const double z = point.at("height");
    straight_points << y << ' ' << z << '\n';
    points << std::cos(tilt) * y - std::sin(tilt) * z << ' '
           << std::sin(tilt) * y + std::cos(tilt) * z << '\n';
  }
  write("tilted.wheel", points.str());
  write("straight.wheel", straight_points.str());
  EXPECT_EQ(run_json("tilted.wheel").at("warnings").size(), 1U);
  EXPECT_EQ(run_json("tilted.wheel --rotate 0").at("warnings").size(), 0U);
  run("tilted.wheel --strict").expect_refusal({"turned by -1.00 degrees", "rotation"});
  for (const char* how : {"--align S1002", "--rotate -1"}) {
    const json straight =
        run_json(std::string("tilted.wheel --strict --compare straight.wheel ") + how);
    EXPECT_LT(std::abs(straight.at("comparison").at("largest").get<double>()), 5e-3) << how;
  }
  run("tilted.wheel --align nowhere")
      .expect_refusal({"align_to = nowhere", "must be a built-in profile"});
  run("tilted.wheel --rotate 30").expect_refusal({"--rotate", "30"});
  run("S1002 --align S1002").expect_refusal({"--align", "built in"});
}

TEST_F(WrcProfile, ListsTheProfilesOfAProjectFile) {
  std::ostringstream project;
  for (int profile = 1; profile <= 2; ++profile) {
    project << "[Profile" << profile << "Points]\n";
    for (int y = -30; y <= 30; ++y) {
      project << y << ',' << -0.02 * y * y - profile << '\n';
    }
  }
  write("project.ban", project.str());
  run("project.ban")
      .expect_refusal({"1 [Profile1Points] of 61 points", "2 [Profile2Points] of 61 points"});
  EXPECT_NEAR(run_json("project.ban --slice 2").at("extents").at("height").at(1).get<double>(),
              -2.0, 0.01);
}

TEST_F(WrcProfile, JoinsTheSlicesOfAFileToASurface) {
  std::ostringstream rows;
  for (int y = -30; y <= 30; ++y) {
    rows << y << ' ' << -y * y / 600.0 << '\n';
  }
  write("a.txt", rows.str());
  write("rail.slcs", "0 10\n3\n2\n1\n0 'a.txt'\n1 'a.txt'\n2 'a.txt'\n"
                     "0 -1 -1\n1 0 999\n2 0 999\n");
  const json lines = run_json("rail.slcs --plot rail.svg").at("surface");
  EXPECT_EQ(lines.at(0), "rail with 3 slices along the track, 0 to 20 mm, 10 mm apart");
  EXPECT_EQ(lines.at(3), "features 1 to 2 absent from slice 1");
  EXPECT_EQ(run_json("rail.slcs --slice 2").at("kind"), "rail");
  ASSERT_EQ(run("rail.slcs --slice 2 --convert one.prr").exit_code, 0);
  run("one.prr --slice 3").expect_refusal({"one.prr: slice = 3, allowed with a slices file"});
  run("rail.slcs --points").expect_refusal({"--points", "--slice N"});
  write("one.slcs", "0 10\n1\n0\n1\n0 'a.txt'\n");
  run("one.slcs").expect_refusal({"number of slices = 1: at least 2", "--slice N"});
  EXPECT_EQ(run_json("one.slcs --slice 1").at("kind"), "rail");
  run("S1002 --smooth-along 3").expect_refusal({"--smooth-along", ".slcs"});
}

TEST_F(WrcProfile, ComparesInTheDirectionOfTheNormal) {
  // 60E1 moved up by 0.1 mm: at the crown the normal distance is 0.1, on the 1:20 sides less.
  const json points = run_json("60E1 --points --spacing 0.1").at("points");
  std::ostringstream moved;
  moved.precision(17);
  for (const json& point : points) {
    moved << point.at("lateral").get<double>() << ' ' << point.at("height").get<double>() + 0.1
          << '\n';
  }
  write("moved.rail", moved.str());
  const json difference = run_json("60E1 --compare moved.rail").at("comparison");
  constexpr double interpolation = 1e-4; // of points 0.1 mm apart
  EXPECT_NEAR(difference.at("largest").get<double>(), 0.1, interpolation);
  EXPECT_LT(difference.at("rms").get<double>(), 0.1);
  EXPECT_GT(difference.at("rms").get<double>(), 0.05);
  const json same = run_json("60E1 --compare 60E1").at("comparison");
  EXPECT_NEAR(same.at("largest").get<double>(), 0.0, rounding);
  EXPECT_NEAR(same.at("compared_length").get<double>(), run_json("60E1").at("length"), rounding);
}

/// A wheel whose flange is 1 mm thinner: the flank is missing, nothing else.
TEST_F(WrcProfile, ComparesDimensionsAndAreas) {
  const json points = run_json("S1002 --points --spacing 0.1").at("points");
  std::ostringstream thinner;
  thinner.precision(17);
  for (const json& point : points) {
    const double lateral = point.at("lateral").get<double>();
    const double share = std::clamp((-25.0 - lateral) / 10.0, 0.0, 1.0);
    thinner << lateral - share << ' ' << point.at("height").get<double>() << '\n';
  }
  write("thinner.wheel", thinner.str());
  const std::string compare = "thinner.wheel --kind wheel --origin tape --compare S1002";
  const json comparison = run_json(compare).at("comparison");
  constexpr double interpolation = 1e-3; // of points 0.1 mm apart
  const json& differences = comparison.at("differences");
  EXPECT_NEAR(differences.at("flange_height").get<double>(), 0.0, interpolation);
  EXPECT_NEAR(differences.at("flange_thickness").get<double>(), -1.0, interpolation);
  EXPECT_NEAR(differences.at("qr").get<double>(), 0.0, interpolation);
  EXPECT_GT(comparison.at("missing_area").get<double>(), 10.0); // 28 mm high, less at the root
  EXPECT_LT(comparison.at("missing_area").get<double>(), 28.0);
  // At each point on request: 1 mm across is less along the normal, and nothing on the tread.
  const json shown = run_json(compare + " --points --spacing 1").at("points");
  double most = 0.0;
  for (const json& point : shown) {
    if (point.at("distance").is_null()) {
      continue;
    }
    const double distance = point.at("distance").get<double>();
    most = std::max(most, distance);
    if (point.at("lateral").get<double>() > -20.0) {
      EXPECT_NEAR(distance, 0.0, interpolation) << point;
    }
  }
  EXPECT_GT(most, 0.9);
  EXPECT_LT(most, 1.0);
  const std::string table = run(compare + " --points --spacing 10").out;
  expect_parts(table,
               {"area missing", "alignment", "Dimensions less those of S1002", "distance, mm"});
}

TEST_F(WrcProfile, ConvertsAndReadsBack) {
  for (const auto& [name, file] : {std::pair{"S1002", "a.txt"}, std::pair{"S1002", "a.prw"},
                                   std::pair{"60E1", "b.txt"}, std::pair{"60E1", "b.prr"}}) {
    SCOPED_TRACE(file);
    const std::string arguments = std::string(name) + " --spacing 0.1 --convert " + file;
    const json conversion = run_json(arguments).at("conversion");
    EXPECT_EQ(conversion.at("spacing"), 0.1);
    EXPECT_TRUE(exists(file));
    // A spline rounds the chamfer of the wheel off by a part of the spacing; rails have no kink.
    const double allowed = std::string(name) == "60E1" ? 1e-3 : 0.02;
    EXPECT_LT(std::abs(conversion.at("largest").get<double>()), allowed);
    EXPECT_LT(conversion.at("rms").get<double>(), 1e-3);
  }
  EXPECT_EQ(file_count(), 4);
}

TEST_F(WrcProfile, PointsLieOnTheCurve) {
  const json wheel = run_json("S1002 --points --spacing 40");
  const json& points = wheel.at("points");
  ASSERT_EQ(points.size(), 6U); // 160.45 mm in 5 equal parts of at most 40 mm
  EXPECT_EQ(points.front().at("arc"), 0.0);
  EXPECT_EQ(points.back().at("arc"), wheel.at("length"));
  EXPECT_FALSE(run_json("S1002").contains("points"));
  EXPECT_NE(run("S1002 --points --spacing 40").out.find("curvature, 1/mm"), std::string::npos);
}

TEST_F(WrcProfile, PlotDrawsBothKindsOfFile) {
  NEEDS_GNUPLOT();
  ASSERT_EQ(run("S1002 --plot a.png --compare LMA").exit_code, 0);
  EXPECT_TRUE(is_png("a.png"));
  ASSERT_EQ(run("60E1 --plot a.svg").exit_code, 0);
  EXPECT_TRUE(is_svg("a.svg"));
  EXPECT_EQ(file_count(), 2);
}

TEST_F(WrcProfile, ListsAllBuiltInProfiles) {
  const json list = run_json("--list");
  EXPECT_EQ(list.size(), 14U);
  EXPECT_EQ(list.front().at("name"), "S1002");
  EXPECT_EQ(line_count(run("--list").out), 14);
}

TEST_F(WrcProfile, RefusesBadArguments) {
  run("").expect_refusal({"no profile", "--list"});
  run("nowhere.txt").expect_refusal({"nowhere.txt", "S1002", "60E1"});
  run("S1002 --compare nowhere.txt").expect_refusal({"--compare nowhere.txt", "S1002"});
  run("S1002 --compare 60E1").expect_refusal({"--compare 60E1", "rail", "wheel"});
  run("S1002 --kind wheel").expect_refusal({"--kind", "built in"});
  run("S1002 --smooth 3").expect_refusal({"--smooth", "built in"});
  run("a.txt --kind tram").expect_refusal({"--kind", "tram", "wheel", "rail"});
  run("a.txt --mirror-height maybe").expect_refusal({"--mirror-height", "maybe", "yes"});
  run("a.txt --scale 0").expect_refusal({"--scale", "0", "positive"});
  run("a.txt --smooth nan").expect_refusal({"--smooth", "nan", "auto", "not negative"});
  run("S1002 --spacing x").expect_refusal({"--spacing", "x", "positive"});
  run("S1002 --points --spacing 1e-9").expect_refusal({"--spacing 1e-09", "must be at least"});
  run("S1002 --plot a.pdf").expect_refusal({"--plot a.pdf", ".png"});
  run("S1002 --convert a.prr").expect_refusal({"--convert a.prr", ".prw"});
  run("S1002 --convert no/a.txt")
      .expect_refusal({"cannot write no/a.txt", "does the folder exist"});
  run("S1002 --colour").expect_refusal({"--colour"});
  write("bad.txt", "1 2\n3 oops\n");
  run("bad.txt").expect_refusal({"bad.txt:2", "oops"});
  EXPECT_EQ(file_count(), 1);
}

TEST_F(WrcProfile, ReadsTheManchesterBenchmark) {
  const json wheel =
      run_json("--compare S1002 '" WRCONTACT_REFERENCE_DIR "/profiles/S1002-Manchester.txt'");
  EXPECT_NEAR(wheel.at("dimensions").at("flange_height").get<double>(), 28.0, drawing);
  // Points of the same standard, joined by a spline across its jumps of curvature.
  EXPECT_LT(std::abs(wheel.at("comparison").at("largest").get<double>()), 1e-3);
}

} // namespace
} // namespace wrc_profile_test
