/// Profiles that wrc_case writes less the groove of steel that yields.
#include <string>

#include "run_driver.hpp"

namespace grooved_profiles_test {
namespace {

using nlohmann::json;

class GroovedProfiles : public Driver {
protected:
  GroovedProfiles() : Driver(WRC_CASE_PROGRAM) {}
};

/// Of new, grooved and yielding profiles (docs/damage.md): 1885, 1477 and 1214 MPa.
TEST_F(GroovedProfiles, RelieveTheContact) {
  const std::string scene = "--json --set pose.lateral=6.2 solve.side=left ";
  const auto pmax = [&](const std::string& options) {
    const Outcome outcome = run(scene + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return json::parse(outcome.out).at("left").at("pmax").get<double>();
  };
  const double fresh = pmax("");
  const double yielded =
      pmax("material.wheel.yield_stress=500 material.rail.yield_stress=500 solve.results=groove "
           "--grooved-wheel worn.prw --grooved-rail worn.prr");
  const double grooved = pmax("wheelset.wheel=worn.prw wheelset.wheel.smoothing=0 "
                              "wheelset.wheel.origin=tape track.rail=worn.prr "
                              "track.rail.smoothing=0");
  EXPECT_LT(yielded, 0.9 * grooved);
  EXPECT_LT(grooved, 0.85 * fresh);
  run("--grooved-rail worn.prr --set solve.side=left")
      .expect_refusal({"--grooved-rail worn.prr", "solve.results=groove"});
  const Outcome elastic = run("--grooved-rail new.prr --set solve.side=left solve.results=groove");
  EXPECT_GT(elastic.exit_code, 0);
  EXPECT_NE(elastic.error.find("--grooved-rail new.prr: no groove"), std::string::npos)
      << elastic.error;
}

} // namespace
} // namespace grooved_profiles_test
