#include "keys/key_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "keys/constants.hpp"
#include "keys/scene_keys.hpp"
#include "profile/profile.hpp"
#include "rolling/constants.hpp"

namespace wrc {
namespace {

bool solves_elastic_bodies(const Scene& s) {
  return s.model == ModelRequest::hertz || s.model == ModelRequest::kik_piotrowski ||
         s.solver == SolverChoice::paper;
}

bool keeps_no_groove(const Scene& s) {
  return yielding_bodies_of(s).empty() || solves_elastic_bodies(s);
}

using Condition = bool (*)(const Scene&);
using Names = std::initializer_list<std::string_view>;

/// A key to warn of where the condition holds.
struct Row {
  WarningClass kind = WarningClass::unused_key;
  std::int32_t key = 0;
  std::vector<std::int32_t> causes; ///< of which one took its place; none: the reason says why
  std::string_view reason;          ///< if there are no causes
  Condition holds = nullptr;
};

bool wants_wear(const Scene& scene) {
  return scene.damage.wear || scene.damage.fatigue;
}

/// Whether it is no load that a wheel carries, and not none.
bool is_light(double load) {
  return load > 0.0 && load < least_load;
}

/// Whether creepages of a motion are made smaller where wheels roll.
bool slips_while_rolling(const Scene& scene) {
  const double speed = scene.motion ? std::abs(scene.motion->speed) : 0.0;
  return scene.standstill_speed > slow_speed ||
         (speed >= slow_speed && scene.standstill_speed > greatest_standstill_share * speed);
}

const Names loads{"load.both", "load.left", "load.right", "load.of"};

/// Adds rows of one class of warnings.
class Rows {
public:
  Rows(WarningClass kind, std::vector<Row>& rows) : kind_(kind), rows_(rows) {}

  void operator()(Names keys, Names causes, Condition holds, std::string_view reason = {}) {
    for (const std::string_view key : keys) {
      Row row{kind_, key_id(key), {}, reason, holds};
      for (const std::string_view cause : causes) {
        row.causes.push_back(key_id(cause));
      }
      rows_.push_back(row);
    }
  }

private:
  WarningClass kind_;
  std::vector<Row>& rows_;
};

void add_unused(std::vector<Row>& rows) {
  Rows add(WarningClass::unused_key, rows);
  add(loads, {"pose.vertical"}, [](const Scene& s) { return s.vertical.has_value(); });

  add({"motion.pitch", "motion.torque", "motion.lateral", "motion.vertical", "motion.roll",
       "motion.yaw", "motion.curvature", "motion.acceleration", "motion.standstill_speed"},
      {"creepage.longitudinal", "creepage.lateral", "creepage.spin", "creepage.left",
       "creepage.right"},
      [](const Scene& s) { return s.has_creepages(); });
  add(
      {"motion.torque"}, {}, [](const Scene& s) { return s.torque != 0.0 && !s.pitch_is_free; },
      " is not used: motion.pitch is not \"free\"");

  add({"friction.coefficient"},
      {"friction.places", "friction.left_places", "friction.right_places"}, [](const Scene& s) {
        return !s.left.friction.places.empty() && !s.right.friction.places.empty();
      });
  add({"friction.left"}, {"friction.left_places", "friction.places"},
      [](const Scene& s) { return !s.left.friction.places.empty(); });
  add({"friction.right"}, {"friction.right_places", "friction.places"},
      [](const Scene& s) { return !s.right.friction.places.empty(); });
  add({"friction.places"}, {"friction.coefficient"}, [](const Scene& s) {
    return s.left.friction.places.empty() && s.right.friction.places.empty();
  });
  add({"friction.left_places"}, {"friction.left", "friction.coefficient"},
      [](const Scene& s) { return s.left.friction.places.empty(); });
  add({"friction.right_places"}, {"friction.right", "friction.coefficient"},
      [](const Scene& s) { return s.right.friction.places.empty(); });

  add(
      {"friction.decay"}, {}, [](const Scene& s) { return s.left.friction.limit_ratio == 1.0; },
      " is not used: friction.limit_ratio is 1");
  add(
      {"friction.limit_ratio"}, {}, [](const Scene& s) { return s.left.friction.decay == 0.0; },
      " is not used: friction.decay is 0");
  add({"pose.longitudinal"}, {}, has_prismatic_rails,
      " is not used: no rail varies along the track");
  add({"pose.pitch"}, {}, has_round_wheels, " is not used: no wheel varies around its axle");

  add({"material.wheel.yield_stress", "material.rail.yield_stress"}, {}, solves_elastic_bodies,
      " changes states and fatigue alone: only the half-space yields, with solve.method = "
      "\"auto\"");
  add({"solve.passes"}, {}, keeps_no_groove,
      " is not used: only steel with a yield stress keeps a groove, in the half-space with "
      "solve.method = \"auto\"");
  add(
      {"solve.results"}, {}, [](const Scene& s) { return s.damage.groove && keeps_no_groove(s); },
      ": no groove: only steel with a yield stress keeps one, in the half-space with "
      "solve.method = \"auto\"");
  add({"solve.grid"}, {"solve.accuracy"}, [](const Scene& s) { return !s.grid; });
  add(
      {"solve.results"}, {},
      [](const Scene& s) { return wants_wear(s) && s.creep == CreepModel::none; },
      ": no wear or fatigue without creep forces, which solve.creep = \"none\" leaves out");
  add(
      {"solve.results"}, {},
      [](const Scene& s) { return wants_wear(s) && !s.has_creepages() && !s.motion; },
      ": no wear or fatigue without creep forces, which keys of creepage.* or motion.* request");
  add(
      {"solve.results"}, {},
      [](const Scene& s) { return s.kalker && s.until != Module::mechanics; },
      ": no Kalker coefficients without pressures, which solve.until = \"mechanics\" computes");
}

void add_implausible(std::vector<Row>& rows) {
  Rows add(WarningClass::implausible_input, rows);
  constexpr std::string_view light = " is below 1 kN, which hardly any wheel carries: it is in N";
  add(
      {"load.both"}, {},
      [](const Scene& s) { return is_light(s.left.load) && is_light(s.right.load); }, light);
  add(
      {"load.left"}, {}, [](const Scene& s) { return is_light(s.left.load); }, light);
  add(
      {"load.right"}, {}, [](const Scene& s) { return is_light(s.right.load); }, light);
  add(
      {"motion.standstill_speed"}, {}, [](const Scene& s) { return slips_while_rolling(s); },
      " is above 1 m/s or a tenth of the speed, so that creep forces are too small: it is in m/s "
      "if convention.units is \"SI\", else in mm/s");
  add(
      {"track.inclination"}, {},
      [](const Scene& s) { return std::abs(s.track.inclination) > steepest_inclination; },
      " is more than 1:15, rails have 1:20 to 1:40: it is the inclination of each rail, not the "
      "cant of the track");
}

void add_inaccurate(std::vector<Row>& rows) {
  Rows add(WarningClass::creep_accuracy, rows);
  add(
      {"solve.results"}, {},
      [](const Scene& s) { return s.kalker && s.accuracy > coarsest_for_coefficients; },
      ": Kalker's coefficients need solve.accuracy 1e-3 or less: at 1e-2, c33 is up to 40 % and "
      "the others are up to 15 % off, at coarser ones more");
}

std::vector<Row> make_rows() {
  std::vector<Row> rows;
  add_inaccurate(rows);
  add_unused(rows);
  add_implausible(rows);
  return rows;
}

struct Table {
  std::vector<Row> rows = make_rows();
  KeySet keys; ///< of the rows
  KeySet overruled_by_steps;

  Table() {
    for (const Row& row : rows) {
      keys.set(static_cast<std::size_t>(row.key));
    }
    for (const std::string_view load : loads) {
      overruled_by_steps.set(static_cast<std::size_t>(key_id(load)));
    }
    overruled_by_steps.set(static_cast<std::size_t>(key_id("motion.torque")));
  }
};

const Table& table() {
  static const Table made;
  return made;
}

bool is_given(const KeySet& given, std::int32_t key) {
  return given[static_cast<std::size_t>(key)];
}

std::string name_of_key(std::int32_t key) {
  return std::string(scene_keys()[static_cast<std::size_t>(key)].name);
}

} // namespace

KeyWarnings::KeyWarnings(const Scene& scene) : given_(scene.given) {
  if ((scene.given & table().keys).none()) {
    return;
  }
  KeySet told; // by the first row that applies
  std::size_t place = 0;
  for (const Row& row : table().rows) {
    if (!is_given(told, row.key) && is_given(scene.given, row.key) && row.holds(scene)) {
      told.set(static_cast<std::size_t>(row.key));
      found_.set(place);
    }
    ++place;
  }
}

void KeyWarnings::append_to(Warnings& all) const {
  for (std::size_t place = 0; place < table().rows.size(); ++place) {
    if (!found_[place]) {
      continue;
    }
    const Row& row = table().rows[place];
    // One that was set to its default is not among those given: the first one then stands for it.
    const auto given = std::find_if(row.causes.begin(), row.causes.end(),
                                    [&](std::int32_t key) { return is_given(given_, key); });
    const auto cause = given == row.causes.end() ? row.causes.begin() : given;
    const std::string reason = row.causes.empty()
                                   ? std::string(row.reason)
                                   : " is not used: " + name_of_key(*cause) + " is set";
    all.push_back({row.kind, name_of_key(row.key) + reason});
  }
}

const KeySet& keys_overruled_by_steps() {
  return table().overruled_by_steps;
}

} // namespace wrc
