/// wrc_case as a process: what it prints, writes and refuses.
#include <array>
#include <sstream>
#include <vector>

#include "run_driver.hpp"

namespace wrc_case_test {
namespace {

using nlohmann::json;

/// A grid that is solved in milliseconds.
const std::string small = "--set solve.grid=[24,20] ";
/// A left wheel on tread and flange at once: two patches; the right wheel has one.
const std::string two_patches = "--set track.rail=56E1 --set pose.lateral=6.15 ";

class WrcCase : public Driver {
protected:
  WrcCase() : Driver(WRC_CASE_PROGRAM) {}
};

TEST_F(WrcCase, DefaultIsTable1) {
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.error, "");
  expect_parts(outcome.out, {"pmax", "area", "normal force", "approach", "left", "right"});
  EXPECT_EQ(file_count(), 0) << "files appeared unasked";
}

TEST_F(WrcCase, ASavedSceneIsReplayedBitForBit) {
  json first = run_json(two_patches + "--set pose.yaw=0.003 --set load.left=71234.567 "
                                      "--save saved.toml");
  json again = run_json("saved.toml");
  first.erase("time_ms");
  again.erase("time_ms");
  EXPECT_EQ(first, again);
}

TEST_F(WrcCase, UnitsAndFrameFollowTheConvention) {
  const json usual = run_json(small + "--set pose.lateral=3");
  const json asked = run_json(small + "--set convention.units=SI --set "
                                      "convention.frame=right-down --set pose.lateral=-0.003");
  EXPECT_EQ(asked.at("units"), "m, N, Pa, rad");
  const double lateral = usual.at("left").at("rigid_contact").at("y");
  EXPECT_DOUBLE_EQ(asked.at("left").at("rigid_contact").at("y"), -1e-3 * lateral);
  const Outcome table = run(small + "--set convention.units=SI --set pose.lateral=0.003");
  const Outcome usual_table = run(small + "--set pose.lateral=3");
  const auto without_times = [](const std::string& text) {
    return text.substr(0, text.find("Time"));
  };
  EXPECT_EQ(without_times(table.out), without_times(usual_table.out));
}

TEST_F(WrcCase, StopsAfterTheRequestedModule) {
  const json geometry = run_json(small + "--set solve.until=geometry");
  EXPECT_TRUE(geometry.at("left").at("rigid_contact").at("y").is_number());
  const json remesh = run_json(small + "--set solve.until=remesh");
  EXPECT_EQ(remesh.at("left").at("patches").size(), 1U);
  for (const char* module : {"geometry", "remesh"}) {
    const Outcome table = run(small + "--set solve.until=" + module + " --plot picture.png");
    EXPECT_EQ(table.exit_code, 0) << table.error;
    EXPECT_NE(table.out.find("rolling radius"), std::string::npos);
  }
}

TEST_F(WrcCase, JsonHasEveryKey) {
  const json result = run_json("");
  for (const char* key : {"roll", "vertical"}) {
    EXPECT_TRUE(result.at(key).is_number()) << key;
  }
  EXPECT_TRUE(result.at("model").is_string());
  EXPECT_EQ(result.at("units"), "mm, N, MPa, rad");
  for (const char* name : {"left", "right"}) {
    SCOPED_TRACE(name);
    const json& side = result.at(name);
    for (const char* key : {"s_wheel", "t_rail", "y", "z", "angle"}) {
      EXPECT_TRUE(side.at("rigid_contact").at(key).is_number()) << key;
    }
    for (const char* key : {"pmax", "area", "normal_force", "vertical_force", "lateral_force",
                            "approach", "error_estimate"}) {
      EXPECT_TRUE(side.at(key).is_number()) << key;
    }
    EXPECT_TRUE(side.at("iterations").is_number_integer());
    EXPECT_TRUE(side.at("patch_count").is_number_integer());
    EXPECT_TRUE(side.at("grid").at("lateral").is_number_integer());
    EXPECT_TRUE(side.at("grid").at("longitudinal").is_number_integer());
    EXPECT_TRUE(side.at("warnings").is_array());
    ASSERT_EQ(side.at("patches").size(), 1U);
    const json& patch = side.at("patches").at(0);
    for (const char* key :
         {"pmax", "area", "normal_force", "approach", "angle", "x", "y", "z", "s_wheel"}) {
      EXPECT_TRUE(patch.at(key).is_number()) << key;
    }
    EXPECT_EQ(patch.at("semi_axes").size(), 2U);
  }
  for (const char* key : {"profile", "setup", "geometry", "remesh", "mechanics", "total"}) {
    EXPECT_TRUE(result.at("time_ms").at(key).is_number()) << key;
  }
}

TEST_F(WrcCase, JsonListsEveryPatch) {
  const json result = run_json(small + two_patches);
  const json& side = result.at("left");
  ASSERT_EQ(side.at("patches").size(), 2U);
  ASSERT_EQ(result.at("right").at("patches").size(), 1U);
  double force = 0.0;
  for (const json& patch : side.at("patches")) {
    force += patch.at("normal_force").get<double>();
    for (const char* key :
         {"pmax", "pmax_element", "area", "vertical_force", "lateral_force", "longitudinal_force",
          "approach", "angle", "coupling_weight", "fill", "x", "y", "z", "s_wheel", "w_wheel",
          "t_rail", "v_rail", "rolling_radius"}) {
      EXPECT_TRUE(patch.at(key).is_number_float()) << key;
    }
    for (const char* key : {"x", "y", "z", "s_wheel", "angle"}) {
      EXPECT_TRUE(patch.at("centroid").at(key).is_number_float()) << key;
    }
    for (const char* key : {"x", "y", "z"}) {
      EXPECT_TRUE(patch.at("pressure_moment").at(key).is_number_float()) << key;
    }
    EXPECT_EQ(patch.at("radii").size(), 2U);
    EXPECT_EQ(patch.at("element_size").size(), 2U);
    EXPECT_TRUE(patch.at("regions").is_number_integer());
    EXPECT_EQ(patch.at("grid"), json({{"lateral", 24}, {"longitudinal", 20}}));
    EXPECT_TRUE(patch.at("grid").at("lateral").is_number_integer());
  }
  EXPECT_DOUBLE_EQ(side.at("normal_force").get<double>(), force);
  for (const char* key : {"iterations", "convolutions", "solutions"}) {
    EXPECT_TRUE(side.at(key).is_number_integer()) << key;
  }
  EXPECT_TRUE(side.at("centroid").at("y").is_number_float());
  EXPECT_TRUE(side.at("pressure_moment").at("x").is_number_float());
}

/// Forces are totals; those by pressures are printed as well where they differ.
TEST_F(WrcCase, TotalForcesAndForcesOfPressuresArePrinted) {
  const std::string moving = "--set solve.accuracy=1e-2 pose.lateral=3 pose.yaw=0.001 ";
  const json side = run_json(moving + "motion.speed=20000").at("left");
  EXPECT_EQ(side.at("lateral_force"), side.at("total").at("force").at("y"));
  EXPECT_GT(side.at("lateral_force").get<double>(), 5e3);
  EXPECT_LT(side.at("pressure_force").at("y").get<double>(), -5e3);
  const Outcome outcome = run(moving + "motion.speed=20000");
  expect_parts(outcome.out, {"lateral force, total", "lateral, by pressures",
                             "vertical force, total", "vertical, by pressures", "N, total"});
  const Outcome still = run(moving);
  EXPECT_EQ(still.out.find("total  "), std::string::npos) << still.out;
  EXPECT_EQ(still.out.find("by pressures"), std::string::npos);
  const Outcome csv = run(moving + "motion.speed=20000 --csv");
  expect_parts(csv.out, {"pressure_force.y", "pressure_moment.x", "grid.lateral"});
}

TEST_F(WrcCase, TheTableListsEveryPatch) {
  const Outcome outcome = run(small + two_patches);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  expect_parts(outcome.out, {"\nPatches ", "\nPositions ", "  left    0 ", "  left    1 ",
                             "  right   0 ", "approach", "centroid", "convolutions", "solutions"});
  // Columns that say nothing are left out.
  EXPECT_EQ(outcome.out.find("regions"), std::string::npos);
  EXPECT_NE(outcome.out.find("coupling"), std::string::npos);
  EXPECT_NE(run(small + "--set pose.lateral=5").out.find("regions"), std::string::npos);
  EXPECT_EQ(run(small + two_patches + "--set solve.interaction=near").out.find("coupling"),
            std::string::npos);
  EXPECT_EQ(outcome.out.find(" \n"), std::string::npos) << "blanks at the end of a line";
}

TEST_F(WrcCase, KalkerCoefficientsArePrintedOnRequest) {
  const std::string kalker = small + two_patches + "solve.results=kalker ";
  const Outcome table = run(kalker);
  const std::size_t begin = table.out.find("\nKalker ");
  ASSERT_NE(begin, std::string::npos) << table.out;
  const std::string rows = table.out.substr(begin, table.out.find("\nPositions", begin) - begin);
  expect_parts(rows, {"c11", "c23", "  left    1 ", "  right   0 "});
  expect_parts(run(kalker + "--csv").out, {",patches.1.kalker.c33,", ",patches.0.kalker.c11,"});
  EXPECT_EQ(run(small + two_patches).out.find("Kalker"), std::string::npos);
}

TEST_F(WrcCase, JsonNumbersKeepAllDigits) {
  const json result = run_json(small + "--set pose.lateral=0.1 --set pose.roll=0.0123456789012345");
  EXPECT_EQ(result.at("roll").get<double>(), 0.0123456789012345);
}

TEST_F(WrcCase, OneSideOnly) {
  const json result = run_json(small + "--set solve.side=left");
  EXPECT_TRUE(result.contains("left"));
  EXPECT_FALSE(result.contains("right"));
}

TEST_F(WrcCase, PrescribedPositionWithoutTouchIsAResult) {
  const json result = run_json("--set pose.vertical=500");
  EXPECT_EQ(result.at("left").at("pmax"), 0.0);
  EXPECT_EQ(result.at("left").at("patches").size(), 0U);
  EXPECT_EQ(result.at("left").at("warnings").size(), 1U);
  EXPECT_TRUE(result.at("left").at("error_estimate").is_null());
}

TEST_F(WrcCase, CsvHasOneLinePerSide) {
  const Outcome outcome = run(small + "--csv");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  std::istringstream lines(outcome.out);
  std::string head;
  std::string left;
  std::string right;
  std::getline(lines, head);
  std::getline(lines, left);
  std::getline(lines, right);
  EXPECT_EQ(line_count(outcome.out), 3);
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_TRUE(head.starts_with("side,roll,vertical,patches,"));
  EXPECT_TRUE(head.ends_with(",grade,warning_count,warnings")) << "texts stand last";
  const double roll = run_json(small + "pose.lateral=2").at("roll").get<double>();
  const auto roll_of = [](const std::string& text) {
    return std::stod(text.substr(text.find("\nleft,") + 6));
  };
  EXPECT_EQ(roll_of(run(small + "pose.lateral=2 --csv --digits 17").out), roll);
  const double rounded = roll_of(run(small + "pose.lateral=2 --csv").out);
  EXPECT_NE(rounded, roll);
  EXPECT_NEAR(rounded, roll, 1e-5 * std::abs(roll));
  for (const char* column : {"centroid.y", "pressure_moment.x", "convolutions", "solutions"}) {
    EXPECT_NE((head + ',').find(',' + std::string(column) + ','), std::string::npos) << column;
  }
  EXPECT_TRUE(left.starts_with("left,"));
  EXPECT_TRUE(right.starts_with("right,"));
  EXPECT_EQ(commas(left), commas(head));
  EXPECT_EQ(commas(right), commas(head));
}

TEST_F(WrcCase, FieldFilesHaveOneLinePerElement) {
  const Outcome outcome = run(small + two_patches + "--field out.csv");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const std::string field = read("out.csv");
  EXPECT_TRUE(
      field.starts_with("side,patch,x,y,z,undeformed_distance,row_scale,pressure,displacement\n"));
  EXPECT_EQ(line_count(field), 1 + 3 * 24 * 20);
  for (const char* start : {"\nleft,0,", "\nleft,1,", "\nright,0,"}) {
    EXPECT_NE(field.find(start), std::string::npos) << start;
  }
  EXPECT_EQ(file_count(), 1) << "a file written aside was left";
}

TEST_F(WrcCase, VtkHasOneCellPerElement) {
  const Outcome outcome = run(small + two_patches + "--vtk out.vtk");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const std::string vtk = read("out.vtk");
  EXPECT_TRUE(vtk.starts_with("# vtk DataFile Version 3.0\n"));
  EXPECT_NE(vtk.find("\nPOINTS 1575 double\n"), std::string::npos); // 3 * 25 * 21 corners
  EXPECT_NE(vtk.find("\nCELLS 1440 7200\n"), std::string::npos);    // 3 * 24 * 20 elements
  EXPECT_NE(vtk.find("\nCELL_DATA 1440\nSCALARS undeformed_distance double 1\n"),
            std::string::npos);
  for (const char* name :
       {"row_scale double", "pressure double", "displacement double", "patch int", "side int"}) {
    EXPECT_NE(vtk.find(std::string("\nSCALARS ") + name + " 1\n"), std::string::npos) << name;
  }
}

/// Corners of the elements, from the vtk file; places of their centres, from the csv file.
TEST_F(WrcCase, VtkElementsLieAroundTheirCentres) {
  constexpr double rounding = 1e-9; // mm
  for (const std::string grid : {"[6,4]", "[1,1]"}) {
    const Outcome outcome =
        run("--set pose.yaw=0.01 --set solve.side=right --set solve.method=paper --set "
            "solve.grid=" +
            grid + " --vtk out.vtk --field out.csv");
    std::istringstream vtk(read("out.vtk"));
    std::string word;
    while (word != "POINTS" && vtk >> word) {
    }
    std::size_t count = 0;
    ASSERT_TRUE(vtk >> count >> word) << outcome.error;
    std::vector<std::array<double, 3>> points(count);
    for (auto& point : points) {
      vtk >> point[0] >> point[1] >> point[2];
    }
    std::size_t elements = 0;
    vtk >> word >> elements >> word;
    std::istringstream field(read("out.csv"));
    std::string line;
    std::getline(field, line);
    for (std::size_t element = 0; element < elements; ++element) {
      std::array<std::size_t, 4> corners{};
      vtk >> word >> corners[0] >> corners[1] >> corners[2] >> corners[3];
      std::getline(field, line, ',');
      std::getline(field, line, ',');
      for (std::size_t i = 0; i < 3; ++i) {
        std::getline(field, line, ',');
        double mean = 0.0;
        for (const std::size_t corner : corners) {
          mean += 0.25 * points.at(corner)[i];
        }
        EXPECT_NEAR(mean, std::stod(line), rounding) << grid << ' ' << element << ' ' << i;
      }
      std::getline(field, line);
    }
  }
}

TEST_F(WrcCase, PlotDrawsBothKindsOfFile) {
  NEEDS_GNUPLOT();
  ASSERT_EQ(run(small + "--plot a.png").exit_code, 0);
  EXPECT_TRUE(is_png("a.png"));
  ASSERT_EQ(run(small + two_patches + "--plot a.svg").exit_code, 0);
  EXPECT_TRUE(is_svg("a.svg"));
  expect_parts(read("a.svg"), {"patch 0: ", "patch 1: ", "kN", "mrad", "pressure, MPa"});
  ASSERT_EQ(run("--set pose.vertical=500 --plot none.png").exit_code, 0);
  EXPECT_TRUE(is_png("none.png"));
  EXPECT_EQ(file_count(), 3);
}

TEST_F(WrcCase, SceneFileWithTables) {
  write("scene.toml", "[track]\ngauge = 1437.5\ninclination = \"1:20\"\n"
                      "[material.wheel]\nyoungs_modulus = 200000.0\n"
                      "[pose]\nlateral = 2.0\n[load]\nleft = 50000.0\nboth = 60000\n"
                      "[solve]\ngrid = [24, 20]\n");
  const json from_file = run_json("scene.toml");
  const json from_arguments =
      run_json(small + "--set track.gauge=1437.5 --set track.inclination=1:20 --set "
                       "material.wheel.youngs_modulus=200000 --set pose.lateral=2 --set "
                       "load.both=60000 --set load.left=50000");
  for (const char* side : {"left", "right"}) {
    for (const char* key : {"pmax", "approach", "vertical_force"}) {
      EXPECT_EQ(from_file.at(side).at(key), from_arguments.at(side).at(key)) << side << key;
    }
  }
  // General before special, whatever the order in the file.
  constexpr double load_balance = 1e-4; // N, rounding of the balance
  EXPECT_NEAR(from_file.at("left").at("vertical_force").get<double>(), 50000.0, load_balance);
  EXPECT_NEAR(from_file.at("right").at("vertical_force").get<double>(), 60000.0, load_balance);
}

/// In files and in assignments, which programs order by name: the general before the special.
TEST_F(WrcCase, KeysMayHaveCapitals) {
  write("scene.toml", "[LOAD]\nLEFT = 50000.0\nboth = 60000\n[Solve]\nGrid = [24, 20]\n");
  const json result = run_json("scene.toml --set Pose.LATERAL=2");
  constexpr double load_balance = 1e-4; // N, rounding of the balance
  EXPECT_NEAR(result.at("left").at("vertical_force").get<double>(), 50000.0, load_balance);
  EXPECT_NEAR(result.at("right").at("vertical_force").get<double>(), 60000.0, load_balance);
  EXPECT_EQ(result.at("left").at("pmax"),
            run_json(small + "--set pose.lateral=2 load.both=60000 load.left=50000")
                .at("left")
                .at("pmax"));
  EXPECT_NEAR(run_json(small + "--set LOAD.left=50000 load.both=60000")
                  .at("left")
                  .at("vertical_force")
                  .get<double>(),
              50000.0, load_balance);
  write("twice.toml", "[load]\nleft = 50000.0\nLeft = 60000\n");
  run("twice.toml").expect_refusal({"twice.toml, line ", "occurs twice"});
}

TEST_F(WrcCase, SetOverridesTheSceneFile) {
  write("scene.toml", "[pose]\nlateral = 2.0\nroll = 0.001\n[solve]\ngrid = [24, 20]\n");
  EXPECT_EQ(run_json("scene.toml --set pose.roll=0.002").at("roll"), 0.002);
  EXPECT_EQ(run_json("scene.toml --set pose.roll=0.003 --set pose.roll=0.004").at("roll"), 0.004);
}

TEST_F(WrcCase, OneSetTakesSeveralKeys) {
  write("scene.toml", "[pose]\nlateral = 2.0\n[solve]\ngrid = [24, 20]\n");
  const std::string keys = "--set pose.roll=0.003 'solve.grid=[20,16]' track.rail=54E3 ";
  for (const std::string& arguments : {keys + "scene.toml", "scene.toml " + keys}) {
    const json result = run_json(arguments + " --set pose.yaw=0.01");
    EXPECT_EQ(result.at("roll"), 0.003);
    EXPECT_EQ(result.at("left").at("grid"), json({{"lateral", 20}, {"longitudinal", 16}}));
  }
  run("--set pose.roll=0.003 pose.sideways=1").expect_refusal({"pose.sideways"});
  run("--set pose.roll=0.003 --json pose.yaw=1").expect_refusal({"scene file pose.yaw=1"});
}

TEST_F(WrcCase, SetTakesNamesThatLookLikeNumbers) {
  // 60E1 and its kin are floating-point numbers to TOML.
  const json bare = run_json(small + "--set track.rail=54E3");
  const json quoted = run_json(small + "--set 'track.rail=\"54E3\"'");
  const json other = run_json(small + "--set track.rail=60E1");
  EXPECT_EQ(bare.at("left").at("pmax"), quoted.at("left").at("pmax"));
  EXPECT_NE(bare.at("left").at("pmax"), other.at("left").at("pmax"));
  EXPECT_EQ(other.at("left").at("pmax"), run_json(small).at("left").at("pmax"));
}

TEST_F(WrcCase, ProfilePathsAreRelativeToTheSceneFile) {
  ASSERT_EQ(run(WRC_PROFILE_PROGRAM, "54E3 --convert 54E3.prr").exit_code, 0);
  write("scenes/scene.toml", "[track]\nrail = \"my.prr\"\n[solve]\ngrid = [24, 20]\n");
  write("scenes/my.prr", read("54E3.prr"));
  constexpr double conversion_error = 1e-3; // of points 0.25 mm apart, relative in pmax
  const double pmax = run_json("scenes/scene.toml").at("left").at("pmax");
  const double exact = run_json(small + "--set track.rail=54E3").at("left").at("pmax");
  EXPECT_NEAR(pmax, exact, conversion_error * exact);
}

TEST_F(WrcCase, RefusesUnknownKeysAndBadValues) {
  run("--set pose.sideways=1").expect_refusal({"pose.sideways", "pose.lateral"});
  run("--set pose.lateral=20000").expect_refusal({"pose.lateral = 20000", "between -1e4 and 1e4"});
  run("--set solve.results=[stress,wear]").expect_refusal({"blanks between them"});
  run("--set pose.lateral=5mm").expect_refusal({"pose.lateral = \"5mm\": not a number"});
  run("--set pose.lateral=far").expect_refusal({"pose.lateral = \"far\"", "between -1e4 and 1e4"});
  run("--set solve.side=middle").expect_refusal({"solve.side", "middle", "\"left\""});
  run("--set solve.grid=[0,8]").expect_refusal({"solve.grid = [0, 8]", "1 to 8192"});
  run("--set 'solve.grid=[\"a\",8]'").expect_refusal({"solve.grid", "numbers"});
  run("--set solve.threads=true").expect_refusal({"solve.threads = \"true\""});
  run("--set pose.lateral").expect_refusal({"--set pose.lateral", "key=value"});
  run("--set =3").expect_refusal({"--set =3", "key=value"});
  run("--set track.rail=nowhere.txt").expect_refusal({"track.rail", "nowhere.txt", "60E1"});
  run("--set pose.lateral=100").expect_refusal({"pose.lateral"});
}

TEST_F(WrcCase, KeysWithoutEffectAreWarnedOf) {
  const Outcome outcome =
      run(small + "--set load.both=70000 pose.vertical=459.9 --save saved.toml");
  EXPECT_NE(outcome.out.find("Note: load.both is not used: pose.vertical is set\n"),
            std::string::npos)
      << outcome.out;
  const json plain = run_json(small + "--set load.both=80000 load.of=normal --save plain.toml");
  EXPECT_EQ(plain.at("warning_count"), run_json("plain.toml").at("warning_count"));
}

TEST_F(WrcCase, RefusesBadArguments) {
  run("--json --csv").expect_refusal({"--json", "--csv"});
  run("--jason").expect_refusal({"--jason"});
  run("one.toml two.toml").expect_refusal({"two.toml"});
  run("--plot").expect_refusal({"--plot"});
}

TEST_F(WrcCase, RefusesMistakesBeforeItSolves) {
  run("--set pose.lateral 5").expect_refusal({"--set pose.lateral", "key=value"});
  for (const char* options : {"--plot a.pdf", "--stress a.vtk"}) {
    run(options).expect_refusal({options});
  }
  run("--stress a.vtk").expect_refusal({"solve.results=stress"});
  write("range.toml", "[pose]\nlateral = {from = 0, to = 5, step = 1}\n");
  run("range.toml").expect_refusal({"pose.lateral", "one value", "wrc_sweep"});
}

TEST_F(WrcCase, RefusesBadSceneFiles) {
  run("missing.toml").expect_refusal({"missing.toml"});
  write("bad.toml", "[pose]\nlateral = 1.0\nyaw = = 2\n");
  run("bad.toml").expect_refusal({"bad.toml", "line 3"});
  write("unknown.toml", "[pose]\nsideways = 1.0\n");
  run("unknown.toml")
      .expect_refusal({"scene file unknown.toml, line 2: unknown key pose.sideways"});
  write("type.toml", "[solve]\nside = 2\n");
  run("type.toml").expect_refusal({"solve.side = 2"});
  write("profile.toml", "[track]\nrail = \"bad.prr\"\n");
  write("bad.prr", "no profile at all\n");
  run("profile.toml").expect_refusal({"track.rail: bad.prr"});
  write("empty.txt", "");
  run("--set track.left.rail=empty.txt").expect_refusal({"track.left.rail: empty.txt: is empty"});
  const Outcome slices = run("--set track.rail=miss.slcs");
  slices.expect_refusal({"track.rail = \"miss.slcs\": ", "miss.slcs"});
  EXPECT_EQ(slices.error.find("60E1"), std::string::npos) << slices.error;
  run(".").expect_refusal({"scene file ."});
}

TEST_F(WrcCase, RefusesFilesThatCannotBeWritten) {
  for (const char* option : {"--vtk", "--field"}) {
    const Outcome outcome = run(small + option + " nowhere/out");
    EXPECT_GT(outcome.exit_code, 0);
    EXPECT_NE(outcome.error.find("nowhere/out"), std::string::npos) << outcome.error;
  }
  const Outcome outcome = run(small + "--plot a.pdf");
  EXPECT_GT(outcome.exit_code, 0);
  EXPECT_NE(outcome.error.find("--plot a.pdf"), std::string::npos) << outcome.error;
}

TEST_F(WrcCase, NotConvergedPrintsResultsAndHasItsOwnExitCode) {
  const Outcome outcome = run("--set solve.grid=[256,128] --set "
                              "solve.tolerance=1e-13 --set solve.method=paper --json");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.error.find("not converged"), std::string::npos);
  EXPECT_GT(json::parse(outcome.out).at("left").at("pmax").get<double>(), 0.0);
}

TEST_F(WrcCase, HelpListsEveryKeyWithItsMeaning) {
  const Outcome outcome = run("--help");
  EXPECT_EQ(outcome.exit_code, 0);
  expect_parts(outcome.out, {"pose.lateral", "solve.accuracy", "S1002", "Examples"});
  EXPECT_EQ(run("--version").out, std::string("wrcontact ") + WRCONTACT_EXPECTED_VERSION + "\n");
}

TEST_F(WrcCase, WritesAndDrawsStressesBelowTheSurface) {
  NEEDS_GNUPLOT();
  const Outcome outcome = run("--set solve.results=stress,fatigue solve.accuracy=1e-2 "
                              "creepage.left=[0.001,0,0] --stress s.vtk --plot s.png --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const json whole = json::parse(outcome.out);
  EXPECT_GT(whole.at("left").at("stress").at("von_mises_max"), 100.0);
  EXPECT_GT(whole.at("left").at("fatigue").at("shakedown_limit"), 1.0);
  EXPECT_TRUE(is_png("s.png"));
  EXPECT_NE(read("s.vtk").find("SCALARS von_mises double 1"), std::string::npos);
  EXPECT_NE(read("s.vtk").find("POINTS 12000 double"), std::string::npos);
  write("list.toml", "[solve]\nresults = [\"stress\", \"wear\"]\n");
  EXPECT_EQ(run("list.toml --csv").exit_code, 0);
  const Outcome none = run("--stress s.vtk");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_NE(none.error.find("solve.results=stress"), std::string::npos) << none.error;
}

} // namespace
} // namespace wrc_case_test
