#include "scene/solve_scene.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <mutex>
#include <type_traits>

#include "error.hpp"
#include "profile/readers.hpp"
#include "scene/model_choice.hpp"

namespace wrc {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return 1e3 * std::chrono::duration<double>(Clock::now() - start).count();
}

/// A profile given by hand, or else a built-in one by name, or else a file of that name.
Profile load_profile(const std::shared_ptr<const Profile>& given, const std::string& name,
                     ProfileKind kind, double smoothing, const std::string& key,
                     std::vector<std::string>& corrections) {
  if (given) {
    if (smoothing > 0.0) {
      throw_invalid_argument(key + "_smoothing", smoothing,
                             "allowed is 0 with a profile given by the program");
    }
    return *given;
  }
  const auto names = standard_profile_names(kind);
  if (std::find(names.begin(), names.end(), name) != names.end()) {
    if (smoothing > 0.0) {
      throw_invalid_argument(key + "_smoothing", smoothing,
                             "allowed is 0 with a built-in profile, which is exact");
    }
    return standard_profile(name);
  }
  try {
    ReadOptions options;
    options.kind = kind;
    options.smoothing_wavelength = smoothing;
    ReadResult read = read_profile(name, options);
    for (const std::string& correction : read.corrections) {
      corrections.push_back(name);
      corrections.back().append(": ").append(correction);
    }
    return std::move(read.profile);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::file_unreadable) {
      throw;
    }
    std::string text = key + " = \"" + name + "\": allowed is a profile file or one of";
    for (const auto known : names) {
      text += ' ';
      text += known;
    }
    throw Error(ErrorCode::unknown_name, text + " (" + error.what() + ")");
  }
}

/// What a profile was made from.
template <class Dimensions> struct SurfaceKey {
  std::shared_ptr<const Profile> given;
  std::string name;
  double smoothing = 0.0;
  Dimensions dimensions;

  bool operator==(const SurfaceKey&) const = default;
};

/// The surfaces last used, with the corrections their files needed. Any number of threads.
template <class Surface, class Dimensions> class SurfaceCache {
public:
  struct Entry {
    SurfaceKey<Dimensions> key;
    std::shared_ptr<const Surface> surface;
    std::vector<std::string> corrections;
  };

  template <class Make> Entry get(const SurfaceKey<Dimensions>& key, Make&& make) {
    const std::lock_guard<std::mutex> guard(mutex_); // the others wait for what one makes
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&key](const Entry& entry) { return entry.key == key; });
    if (found != entries_.end()) {
      std::rotate(entries_.begin(), found, found + 1);
    } else {
      entries_.insert(entries_.begin(), make());
      entries_.resize(std::min(entries_.size(), kept_surfaces));
    }
    return entries_.front();
  }

private:
  static constexpr std::size_t kept_surfaces = 8;
  std::mutex mutex_;
  std::vector<Entry> entries_; ///< last used first
};

/// What one wheel keeps.
struct SideState {
  std::optional<NormalSolver> solver;
  SideMemory memory;
  struct Touch {
    double s;       ///< on the wheel
    double lateral; ///< of the wheelset
  };
  std::optional<Touch> touch; ///< the last rigid contact
};

/// How far the rigid contact has jumped along the wheel; 0 if it has moved there. It has jumped if
/// the distance rises on the way there from the last place, or if the place moves much faster than
/// the wheelset (a least distance has vanished).
double jump_of(const ContactScan& scan, const SideState::Touch& last, double lateral) {
  constexpr double least_rise = 1e-7; // mm; above the rounding of distances
  constexpr double standing = 0.5;    // mm; about the distance of the scan's nodes
  constexpr double fastest = 20.0;    // times the wheelset's displacement
  const double s = scan.candidates.front().wheel.lateral;
  const double moved = s - last.s;
  if (std::abs(moved) > standing + fastest * std::abs(lateral - last.lateral)) {
    return moved;
  }
  // The profile of distances between both places, seen from the new one, must not fall.
  double highest = scan.candidates.front().distance;
  bool falls = false;
  const auto look_at = [&](const DistanceSample& sample) {
    const double at = sample.wheel.lateral;
    if ((at - s) * (at - last.s) < 0.0) {
      falls = falls || sample.distance < highest - least_rise;
      highest = std::max(highest, sample.distance);
    }
  };
  if (moved < 0.0) {
    std::for_each(scan.samples.begin(), scan.samples.end(), look_at);
  } else {
    std::for_each(scan.samples.rbegin(), scan.samples.rend(), look_at);
  }
  return falls ? moved : 0.0;
}

/// Whether the last contact says anything about the next one.
bool is_comparable(const Scene& one, const Scene& other) {
  return one.wheel == other.wheel && one.rail == other.rail &&
         one.wheel_profile == other.wheel_profile && one.rail_profile == other.rail_profile &&
         one.until == other.until && one.wheel_smoothing == other.wheel_smoothing &&
         one.rail_smoothing == other.rail_smoothing && one.wheelset == other.wheelset &&
         one.track == other.track && one.wheel_material == other.wheel_material &&
         one.rail_material == other.rail_material && one.gap == other.gap &&
         one.elements == other.elements && one.interaction == other.interaction &&
         one.joining_distance == other.joining_distance &&
         one.vertical.has_value() == other.vertical.has_value() &&
         one.normal_load.has_value() == other.normal_load.has_value();
}

} // namespace

/// What changes no bit of a result.
struct SceneSolver::Shared {
  SurfaceCache<WheelSurface, WheelsetDimensions> wheels;
  SurfaceCache<RailSurface, TrackDimensions> rails;
  InfluenceCache estimated;
  InfluenceCache measured{PlannerRigor::measure};
};

struct SceneSolver::State {
  std::shared_ptr<Shared> shared = std::make_shared<Shared>();
  SideState left;
  SideState right;
  std::optional<Scene> last; ///< whose solvers and positions these are

  SceneResult solve(const Scene& scene);
};

SceneResult SceneSolver::State::solve(const Scene& scene) {
  const auto start = Clock::now();
  SceneResult result;
  // Loads a profile and makes a surface of it; the time goes to the stage it belongs to.
  const auto make_entry = [&](auto* cache, const auto& key, ProfileKind kind,
                              const std::string& scene_key) {
    using Entry = typename std::remove_pointer_t<decltype(cache)>::Entry;
    return cache->get(key, [&] {
      const auto profile_start = Clock::now();
      Entry entry{key, nullptr, {}};
      const Profile profile =
          load_profile(key.given, key.name, kind, key.smoothing, scene_key, entry.corrections);
      const auto surface_start = Clock::now();
      result.time.profile +=
          1e3 * std::chrono::duration<double>(surface_start - profile_start).count();
      using Surface = typename decltype(entry.surface)::element_type;
      entry.surface = std::make_shared<Surface>(profile, key.dimensions);
      return entry;
    });
  };
  const auto wheel_entry =
      make_entry(&shared->wheels,
                 SurfaceKey<WheelsetDimensions>{scene.wheel_profile, scene.wheel,
                                                scene.wheel_smoothing, scene.wheelset},
                 ProfileKind::wheel, "wheelset.wheel");
  const auto rail_entry = make_entry(&shared->rails,
                                     SurfaceKey<TrackDimensions>{scene.rail_profile, scene.rail,
                                                                 scene.rail_smoothing, scene.track},
                                     ProfileKind::rail, "track.rail");
  const std::shared_ptr<const WheelSurface> wheel = wheel_entry.surface;
  const std::shared_ptr<const RailSurface> rail = rail_entry.surface;
  result.corrections = wheel_entry.corrections;
  result.corrections.insert(result.corrections.end(), rail_entry.corrections.begin(),
                            rail_entry.corrections.end());

  const double modulus = combined_modulus(scene.wheel_material, scene.rail_material);
  const bool new_solver =
      !last || last->planner != scene.planner || last->precision != scene.precision;
  const bool comparable = last && is_comparable(*last, scene);
  last.reset(); // until the solvers are those of this scene, which may fail after all
  for (SideState* side : {&left, &right}) {
    if (new_solver || !side->solver) {
      InfluenceCache* cache =
          scene.planner == PlannerRigor::measure ? &shared->measured : &shared->estimated;
      side->solver.emplace(std::shared_ptr<InfluenceCache>(shared, cache), scene.precision);
    }
    if (!comparable) {
      side->memory.valid = false;
      side->touch.reset();
    }
  }
  last = scene;
  result.time.setup = milliseconds_since(start) - result.time.profile;

  const auto geometry_start = Clock::now();
  EquilibriumRequest request;
  request.lateral = scene.lateral;
  request.yaw = scene.yaw;
  request.roll = scene.roll;
  request.left = scene.side != SideChoice::right;
  request.right = scene.side != SideChoice::left;
  request.near_tolerance = scene.near_tolerance;
  const WheelsetEquilibrium equilibrium = find_equilibrium(*wheel, *rail, request);
  result.roll = equilibrium.roll;
  result.vertical = equilibrium.vertical;
  result.time.geometry = milliseconds_since(geometry_start);

  const ModelChoice choice = choose_model(scene);
  result.model = choice.name;
  result.solver = scene.solver == "paper" ? "paper" : "default";
  const auto solve_one = [&](const SideEquilibrium& equilibrium_of_side, double load,
                             SideState& side) {
    SideRequest side_request;
    side_request.gap = scene.gap;
    side_request.combined_modulus = modulus;
    if (scene.vertical) {
      side_request.vertical = scene.vertical;
    } else if (scene.normal_load) {
      side_request.normal_load = scene.normal_load;
    } else {
      side_request.vertical_load = load;
    }
    side_request.accuracy = scene.accuracy;
    side_request.grid = scene.grid;
    side_request.tolerance = scene.tolerance;
    side_request.interaction = scene.interaction;
    side_request.joining_distance = scene.joining_distance;
    side_request.solver = scene.solver == "paper" ? SolverChoice::paper : SolverChoice::standard;
    side_request.elements = scene.elements.value_or(
        side_request.solver == SolverChoice::paper ? Elements::constant : Elements::smooth);
    side_request.until = scene.until;
    if (choice.approximate && scene.until == Module::mechanics) {
      return solve_side_approximately(*wheel, *rail, equilibrium_of_side, side_request,
                                      *choice.approximate);
    }
    return solve_side(*wheel, *rail, equilibrium_of_side, side_request, *side.solver, side.memory);
  };
  const auto complete = [&](SideResult& result_of_side, const SideEquilibrium& found, double mirror,
                            SideState& side) {
    result_of_side.model = choice.name;
    result_of_side.model_reason = choice.reason;
    const double lateral = mirror * scene.lateral;
    if (side.touch) {
      result_of_side.jump = jump_of(found.scan, *side.touch, lateral);
    }
    side.touch = SideState::Touch{found.scan.candidates.front().wheel.lateral, lateral};
    if (result_of_side.jump != 0.0) {
      result_of_side.warnings.push_back("the rigid contact has jumped by " +
                                        short_text_of(result_of_side.jump) +
                                        " mm along the wheel since the last solution");
    }
  };
  std::future<SideSolution> other;
  if (equilibrium.right) {
    const bool beside = scene.threads > 1 && equilibrium.left;
    other = std::async(beside ? std::launch::async : std::launch::deferred, solve_one,
                       std::cref(*equilibrium.right), scene.right_load, std::ref(right));
  }
  const auto add_times = [&result](const SideSolution& solution) {
    result.time.remesh += 1e3 * solution.times.remesh;
    result.time.mechanics += 1e3 * solution.times.mechanics;
  };
  if (equilibrium.left) {
    SideSolution solution = solve_one(*equilibrium.left, scene.left_load, left);
    add_times(solution);
    result.left = make_side_result(std::move(solution), wheel, rail, *equilibrium.left, 1.0);
    complete(*result.left, *equilibrium.left, 1.0, left);
  }
  if (equilibrium.right) {
    SideSolution solution = other.get();
    add_times(solution);
    result.right = make_side_result(std::move(solution), wheel, rail, *equilibrium.right, -1.0);
    complete(*result.right, *equilibrium.right, -1.0, right);
  }
  if (result.left && result.right) {
    result.rolling_radius_difference =
        result.left->rigid_contact.rolling_radius - result.right->rigid_contact.rolling_radius;
  }
  result.time.total = milliseconds_since(start);
  return result;
}

SceneSolver::SceneSolver() : state_(new State) {}
SceneSolver::~SceneSolver() = default;
SceneSolver::SceneSolver(SceneSolver&&) noexcept = default;
SceneSolver& SceneSolver::operator=(SceneSolver&&) noexcept = default;

SceneResult SceneSolver::solve(const Scene& scene) {
  try {
    return state_->solve(scene);
  } catch (...) {
    forget_positions(); // which may be those of half a solution
    throw;
  }
}

void SceneSolver::forget_positions() {
  for (SideState* side : {&state_->left, &state_->right}) {
    side->memory.valid = false;
    side->touch.reset();
  }
}

void SceneSolver::forget() {
  *this = SceneSolver();
}

SceneSolver SceneSolver::beside() const {
  SceneSolver other;
  other.state_->shared = state_->shared;
  return other;
}

SceneResult solve_scene(const Scene& scene) {
  return SceneSolver().solve(scene);
}

} // namespace wrc
