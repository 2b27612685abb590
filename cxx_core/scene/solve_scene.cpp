#include "scene/solve_scene.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <mutex>

#include "base/error.hpp"
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

WheelRequest request_of(const Scene& scene, double load) {
  WheelRequest request;
  request.gap = scene.gap;
  request.combined_modulus = combined_modulus(scene.wheel_material, scene.rail_material);
  if (scene.vertical) {
    request.vertical = scene.vertical;
  } else if (scene.normal_load) {
    request.normal_load = scene.normal_load;
  } else {
    request.vertical_load = load;
  }
  request.accuracy_of = scene.accuracy_of;
  request.accuracy = scene.accuracy;
  request.grid = scene.grid;
  request.tolerance = scene.tolerance;
  request.interaction = scene.interaction;
  request.joining_distance = scene.joining_distance;
  request.solver = scene.solver == "paper" ? SolverChoice::paper : SolverChoice::standard;
  request.elements = scene.elements.value_or(
      request.solver == SolverChoice::paper ? Elements::constant : Elements::smooth);
  request.until = scene.until;
  return request;
}

/// What patches displace at each other is interpolated, which boxes nearly in touch spoil.
void warn_of_residuals(WheelResult& side, double accuracy) {
  if (!side.details.interaction || side.patches.empty()) {
    return;
  }
  const Residuals& residuals = residuals_of(side);
  const double worst = std::max(-residuals.least_gap, residuals.complementarity);
  if (worst > accuracy) {
    side.warnings.push_back("patches nearly in touch: what they displace at each other is off by " +
                            short_text_of(worst) +
                            " of the largest displacement, more than the "
                            "accuracy of " +
                            text_of(accuracy));
  }
}

EquilibriumRequest equilibrium_request_of(const Scene& scene) {
  EquilibriumRequest request;
  request.lateral = scene.lateral;
  request.yaw = scene.yaw;
  request.roll = scene.roll;
  request.left = scene.side != SideChoice::right;
  request.right = scene.side != SideChoice::left;
  request.near_tolerance = scene.near_tolerance;
  return request;
}

} // namespace

/// Kept, and shared between threads.
struct SceneSolver::Shared {
  SurfaceCache<WheelSurface, WheelsetDimensions> wheels;
  SurfaceCache<RailSurface, TrackDimensions> rails;
  LinePlans estimated;
  LinePlans measured{PlannerRigor::measure};
};

struct SceneSolver::State {
  std::shared_ptr<Shared> shared = std::make_shared<Shared>();
  std::optional<NormalSolver> left;
  std::optional<NormalSolver> right;
  PlannerRigor planner = PlannerRigor::estimate; ///< of the solvers
  Precision precision = Precision::mixed;

  template <class Surface, class Dimensions>
  typename SurfaceCache<Surface, Dimensions>::Entry
  surface(SurfaceCache<Surface, Dimensions>& cache, const SurfaceKey<Dimensions>& key,
          ProfileKind kind, const std::string& scene_key, SceneResult& result);
  void prepare_solvers(const Scene& scene);
  SceneResult solve(const Scene& scene);
};

/// Loads a profile and makes a surface of it; the time goes to the stage it belongs to.
template <class Surface, class Dimensions>
typename SurfaceCache<Surface, Dimensions>::Entry
SceneSolver::State::surface(SurfaceCache<Surface, Dimensions>& cache,
                            const SurfaceKey<Dimensions>& key, ProfileKind kind,
                            const std::string& scene_key, SceneResult& result) {
  auto found = cache.get(key, [&] {
    const auto start = Clock::now();
    typename SurfaceCache<Surface, Dimensions>::Entry entry{key, nullptr, {}};
    const Profile profile =
        load_profile(key.given, key.name, kind, key.smoothing, scene_key, entry.corrections);
    result.time.profile += milliseconds_since(start);
    entry.surface = std::make_shared<Surface>(profile, key.dimensions);
    return entry;
  });
  result.corrections.insert(result.corrections.end(), found.corrections.begin(),
                            found.corrections.end());
  return found;
}

void SceneSolver::State::prepare_solvers(const Scene& scene) {
  const bool others = planner != scene.planner || precision != scene.precision;
  LinePlans* plans =
      scene.planner == PlannerRigor::measure ? &shared->measured : &shared->estimated;
  for (std::optional<NormalSolver>* solver : {&left, &right}) {
    if (others || !*solver) {
      solver->emplace(std::shared_ptr<LinePlans>(shared, plans), scene.precision);
    }
  }
  planner = scene.planner;
  precision = scene.precision;
}

SceneResult SceneSolver::State::solve(const Scene& scene) {
  const auto start = Clock::now();
  SceneResult result;
  const auto wheel =
      surface(shared->wheels,
              {scene.wheel_profile, scene.wheel, scene.wheel_smoothing, scene.wheelset},
              ProfileKind::wheel, "wheelset.wheel", result)
          .surface;
  const auto rail =
      surface(shared->rails, {scene.rail_profile, scene.rail, scene.rail_smoothing, scene.track},
              ProfileKind::rail, "track.rail", result)
          .surface;
  prepare_solvers(scene);
  result.time.setup = milliseconds_since(start) - result.time.profile;

  const auto geometry_start = Clock::now();
  const WheelsetEquilibrium equilibrium =
      find_equilibrium(*wheel, *rail, equilibrium_request_of(scene));
  result.roll = equilibrium.roll;
  result.vertical = equilibrium.vertical;
  result.time.geometry = milliseconds_since(geometry_start);

  const ModelChoice choice = choose_model(scene);
  result.model = choice.name;
  result.solver = scene.solver == "paper" ? "paper" : "default";
  const auto solve_one = [&](const SideEquilibrium& side, double load, NormalSolver& solver) {
    const WheelRequest request = request_of(scene, load);
    return choice.approximate && scene.until == Module::mechanics
               ? solve_wheel_approximately(*wheel, *rail, side, request, *choice.approximate)
               : solve_wheel(*wheel, *rail, side, request, solver);
  };
  const auto complete = [&](WheelSolution solution, const SideEquilibrium& side, double mirror) {
    result.time.remesh += 1e3 * solution.times.remesh;
    result.time.mechanics += 1e3 * solution.times.mechanics;
    WheelResult made = make_wheel_result(std::move(solution), wheel, rail, side, mirror);
    made.model = choice.name;
    made.model_reason = choice.reason;
    warn_of_residuals(made, scene.accuracy);
    return made;
  };
  std::future<WheelSolution> other;
  if (equilibrium.right) {
    const bool beside = scene.threads > 1 && equilibrium.left;
    other = std::async(beside ? std::launch::async : std::launch::deferred, solve_one,
                       std::cref(*equilibrium.right), scene.right_load, std::ref(*right));
  }
  if (equilibrium.left) {
    result.left =
        complete(solve_one(*equilibrium.left, scene.left_load, *left), *equilibrium.left, 1.0);
  }
  if (equilibrium.right) {
    result.right = complete(other.get(), *equilibrium.right, -1.0);
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
  return state_->solve(scene);
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
