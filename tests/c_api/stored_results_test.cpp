/// Results as they were: only to notice changes. Closed forms, the paper and CONTACT judge them
/// elsewhere. A change that is meant puts the new values here.
#include <vector>

#include "owned_handles.hpp"

namespace {

/// More than compilers and processors change, a tenth of the requested accuracy.
constexpr double drift = 1e-4;
/// Of the area of lobes: rounding may decide on a row of elements more or less, which changes it by
/// 2e-4 to 1.1e-3.
constexpr double rows = 2e-3;

struct Stored {
  const char* name;
  double area_tolerance;
  std::vector<std::pair<const char*, Value>> keys;
  /// Of stored_names.
  std::vector<double> values;
};

constexpr const char* stored_names[] = {
    "roll",        "left.rigid_contact.s_wheel",
    "left.pmax",   "left.area",
    "left.depth",  "right.pmax",
    "right.depth", "left.lateral_force",
};

void PrintTo(const Stored& stored, std::ostream* out) {
  *out << stored.name;
}

class StoredResults : public testing::TestWithParam<Stored> {};

TEST_P(StoredResults, AreTheSame) {
  const ScenePointer scene = make_scene();
  for (const auto& [key, value] : GetParam().keys) {
    set(scene.get(), {{key, value}});
  }
  solve(scene.get());
  for (std::size_t i = 0; i < std::size(stored_names); ++i) {
    const std::string name = stored_names[i];
    const double value = GetParam().values.at(i);
    const double tolerance = name == "left.area" ? GetParam().area_tolerance : drift;
    EXPECT_NEAR(number_of(scene.get(), stored_names[i]), value,
                tolerance * (value == 0.0 ? 1.0 : std::abs(value)))
        << name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    , StoredResults,
    testing::Values(Stored{"Centred",
                           rows,
                           {},
                           {0.0, 3.2261744, 898.31943, 166.4929, 0.063942101, 898.31943,
                            0.063942101, -2752.811}},
                    Stored{"Lateral3",
                           drift,
                           {{"pose.lateral", 3.0}},
                           {0.00017967573, -12.718267, 1453.6709, 88.919494, 0.098711314, 1005.0922,
                            0.083788741, -7210.4974}},
                    Stored{"Lateral5",
                           rows,
                           {{"pose.lateral", 5.0}},
                           {0.00034064832, -28.599894, 2360.1339, 101.77617, 0.077383192, 1112.6459,
                            0.088131225, -14184.248}},
                    Stored{"Yaw",
                           drift,
                           {{"pose.lateral", 2.0}, {"pose.yaw", 0.02}},
                           {0.00010749748, -10.558862, 1411.706, 120.31918, 0.093967135, 947.65382,
                            0.081086496, -5772.5684}},
                    Stored{"Flange",
                           drift,
                           {{"pose.lateral", 6.5}},
                           {0.0041664558, -40.099059, 6048.3001, 52.088524, 0.52800407, 1277.3103,
                            0.093582672, -191033.72}},
                    Stored{"TwoPatches",
                           rows,
                           {{"track.rail", "56E1"}, {"pose.lateral", 6.15}},
                           {0.00038135897, -15.326942, 1406.4442, 107.10242, 0.07036154, 1465.8042,
                            0.091928099, -23043.236}},
                    Stored{"LmaOnChn60",
                           drift,
                           {{"wheelset.wheel", "LMA"},
                            {"track.rail", "CHN60"},
                            {"track.gauge_height", 16.0},
                            {"wheelset.back_to_back", 1353.0},
                            {"wheelset.radius", 430.0},
                            {"pose.lateral", 3.0}},
                           {0.00010480195, 0.40757819, 839.44056, 136.70563, 0.076676635, 1173.8395,
                            0.090889997, -2786.1479}},
                    Stored{"Manchester",
                           drift,
                           {{"track.rail", "UIC60-Manchester"}, {"pose.lateral", -2.0}},
                           {-0.00011620772, 8.7342307, 938.18279, 133.49542, 0.080626995, 1429.2929,
                            0.095806508, -1233.3542}},
                    Stored{"GridGiven",
                           drift,
                           {{"pose.lateral", 1.0}, {"solve.grid", std::vector{64.0, 48.0}}},
                           {5.2864368e-05, -9.034923, 1236.9704, 152.20775, 0.079589172, 844.90886,
                            0.07504039, -4395.8528}}),
    [](const auto& each) { return std::string(each.param.name); });

} // namespace
