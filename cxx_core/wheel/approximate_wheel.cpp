#include "wheel/approximate_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/root_bracket.hpp"
#include "base/stopwatch.hpp"
#include "models/hertz.hpp"
#include "models/patch_model.hpp"
#include "patches/depth_estimate.hpp"
#include "wheel/depth_checks.hpp"
#include "wheel/grid_plan.hpp"

namespace wrc {
namespace {

/// Elements of the grid on which pressures are sampled, and the room around the contact in shares
/// of it.
constexpr std::size_t sampled_count = 32;
constexpr double sampled_margin = 1.0 / 32.0;
/// Share of the load to which the depth is found.
constexpr double load_accuracy = 1e-10;
constexpr int load_steps = 80;
/// Change of the depth that leaves patches and planes as they are: planes turn by less than its
/// share of the contact angles' spread.
constexpr double settled_share = 1e-3;
constexpr int settling_steps = 20;
/// Validity below which a warning is due: from there on errors of pmax reach tens of per cent in
/// both models (docs/accuracy.md).
constexpr double good_validity = 0.8;
/// The least of Hertz's lateral curvature, in longitudinal ones, that a first depth is taken from.
constexpr double min_curvature_share = 1e-3;

class ApproximateWheel {
public:
  ApproximateWheel(const WheelSurface& wheel, const RailSurface& rail,
                   const SideEquilibrium& equilibrium, const WheelRequest& request,
                   ApproximateModel model)
      : wheel_(wheel), rail_(rail), equilibrium_(equilibrium), request_(request), model_(model),
        strips_(wheel, rail, equilibrium.pose), side_{equilibrium.scan, strips_,
                                                      equilibrium.vertical,
                                                      request.combined_modulus} {}

  WheelSolution solve();

private:
  [[nodiscard]] double first_depth() const;
  /// Patches at a depth, each with a model.
  void find_patches(double depth);
  [[nodiscard]] double load_at(double depth) const;
  /// Depth at which the patches found carry the load.
  [[nodiscard]] double depth_of_load(double start) const;
  void settle_depth();
  void take_patches();
  [[nodiscard]] PatchSolution taken(std::size_t patch, const ModelledPatch& modelled) const;

  const WheelSurface& wheel_;
  const RailSurface& rail_;
  const SideEquilibrium& equilibrium_;
  const WheelRequest& request_;
  ApproximateModel model_;
  ContactStrips strips_;
  ModelWheel side_;
  double depth_ = 0.0;
  ContactPatches found_;
  std::vector<std::unique_ptr<PatchModel>> models_;
  std::vector<double> shares_; ///< of the normal force in the load
  WheelSolution result_;
};

double ApproximateWheel::first_depth() const {
  if (request_.position_is_prescribed()) {
    return equilibrium_.vertical - *request_.vertical;
  }
  if (!(request_.load() > 0.0)) {
    return 0.0;
  }
  const ContactCandidate& touch = equilibrium_.scan.candidates.front();
  const auto strip = strips_.at(touch.wheel.lateral);
  if (strip && strip->lateral_curvature > min_curvature_share * strip->longitudinal_curvature) {
    const double cosine = std::cos(touch.rail_angle);
    const double normal_load = request_.load() / (request_.normal_load ? 1.0 : cosine);
    return solve_hertz(strip->longitudinal_curvature, strip->lateral_curvature,
                       request_.combined_modulus, normal_load)
               .approach /
           cosine;
  }
  return estimate_depth(equilibrium_.scan, request_.combined_modulus, request_.load(),
                        request_.normal_load ? LoadDirection::main_normal
                                             : LoadDirection::vertical);
}

void ApproximateWheel::find_patches(double depth) {
  const GridPlan plan = GridPlanner(rail_, equilibrium_, request_).plan(depth);
  found_ = plan.found;
  models_.clear();
  shares_.clear();
  for (const PlannedPatch& patch : plan.patches) {
    models_.push_back(model_ == ApproximateModel::hertz
                          ? make_hertz_patch(side_, patch.place)
                          : make_kik_piotrowski_patch(side_, patch.place, patch.frame));
  }
  const Vector3 main_normal = models_[found_.main]->frame().normal;
  for (const auto& patch : models_) {
    const Vector3 normal = patch->frame().normal;
    shares_.push_back(request_.normal_load ? std::min(dot(normal, main_normal), 1.0) : normal.z);
  }
}

double ApproximateWheel::load_at(double depth) const {
  double load = 0.0;
  for (std::size_t k = 0; k < models_.size(); ++k) {
    load += shares_[k] * models_[k]->load(depth);
  }
  return load;
}

/// The load goes about with the power 3/2 of the depth, so its power 2/3 is nearly linear: secants
/// until the load is bracketed, then within the bracket.
double ApproximateWheel::depth_of_load(double start) const {
  const double requested = request_.load();
  const double target = std::cbrt(requested * requested);
  const auto excess_at = [&](double depth) {
    const double load = load_at(depth);
    const double excess = std::cbrt(load * load) - target;
    return std::abs(excess) <= load_accuracy * target ? 0.0 : excess;
  };
  RootBracket::Point low{0.0, -target};
  RootBracket::Point high{start, excess_at(start)};
  for (int step = 1; step <= load_steps && high.value < 0.0; ++step) {
    const double drawn =
        high.place - high.value * (high.place - low.place) / (high.value - low.value);
    low = high;
    high.place = drawn > low.place && std::isfinite(drawn) ? drawn : 2.0 * low.place;
    high.value = excess_at(high.place);
  }
  if (high.value <= 0.0) {
    return high.place;
  }
  RootBracket bracket(low, high);
  bracket.narrow(load_accuracy * high.place, excess_at);
  return bracket.middle();
}

void ApproximateWheel::settle_depth() {
  find_patches(depth_);
  if (request_.position_is_prescribed()) {
    return;
  }
  for (int step = 0; step < settling_steps; ++step) {
    const double next = depth_of_load(depth_);
    const double change = std::abs(next - depth_);
    depth_ = next;
    if (change <= settled_share * depth_) {
      return;
    }
    find_patches(depth_);
  }
  depth_ = depth_of_load(depth_);
  result_.warnings.emplace_back("patches and depth do not settle: the load is that of patches "
                                "found at another depth");
}

PatchSolution ApproximateWheel::taken(std::size_t patch, const ModelledPatch& modelled) const {
  PatchSolution taken;
  taken.place = found_.patches[patch];
  taken.frame = models_[patch]->frame();
  taken.share = shares_[patch];
  for (std::size_t other = 0; other < models_.size(); ++other) {
    if (other != patch) {
      taken.coupling_weight = std::max(taken.coupling_weight, found_.coupling_weight(patch, other));
    }
  }
  const auto counts = request_.grid.value_or(std::array{sampled_count, sampled_count});
  taken.grid = grid_over(modelled.extent.widened(sampled_margin), counts[0], counts[1]);
  taken.pressure = models_[patch]->sample(taken.grid);
  const PosedPair pair{wheel_, rail_, equilibrium_.pose, equilibrium_.vertical - depth_};
  taken.undeformed_distance = sample_undeformed_distance(pair, taken.frame, taken.grid);
  taken.normal_force = modelled.normal_force;
  taken.approach = modelled.approach;
  taken.area = modelled.area;
  taken.contact.peak_pressure = modelled.peak_pressure;
  for (const double pressure : taken.pressure) {
    taken.contact.largest_element_pressure =
        std::max(taken.contact.largest_element_pressure, pressure);
    taken.contact.element_count += pressure > 0.0 ? 1 : 0;
  }
  taken.contact.normal_force = modelled.normal_force;
  taken.contact.centroid_longitudinal = modelled.centroid_longitudinal;
  taken.contact.centroid_lateral = modelled.centroid_lateral;
  taken.contact.semi_axis_longitudinal = modelled.semi_axis_longitudinal;
  taken.contact.semi_axis_lateral = modelled.semi_axis_lateral;
  return taken;
}

void ApproximateWheel::take_patches() {
  double validity = 1.0;
  for (std::size_t k = 0; k < models_.size(); ++k) {
    const ModelledPatch modelled = models_[k]->solve(depth_);
    if (!(modelled.normal_force > 0.0)) {
      continue;
    }
    result_.patches.push_back(taken(k, modelled));
    result_.peak_pressure = std::max(result_.peak_pressure, modelled.peak_pressure);
    validity =
        std::min(validity, modelled.validity * (1.0 - result_.patches.back().coupling_weight));
  }
  std::stable_sort(result_.patches.begin(), result_.patches.end(),
                   [](const PatchSolution& one, const PatchSolution& other) {
                     return one.normal_force > other.normal_force;
                   });
  for (std::size_t k = 0; k < result_.patches.size(); ++k) {
    result_.patches[k].plane = k; // models do not couple patches
  }
  result_.in_contact = !result_.patches.empty();
  result_.validity = validity;
  if (validity < good_validity) {
    result_.warnings.push_back("validity " + short_text_of(validity) + " (good from " +
                               text_of(good_validity) +
                               " on): pmax may be off by tens of per cent");
  }
  if (request_.interaction && result_.patches.size() > 1) {
    result_.warnings.emplace_back("patches do not feel each other in this model");
  }
}

WheelSolution ApproximateWheel::solve() {
  result_.solved = true;
  const Stopwatch stopwatch;
  if (equilibrium_.scan.candidates.front().at_profile_end) {
    result_.warnings.emplace_back(
        "contact at the end of a profile, or where the rail turns upright");
  }
  result_.vertical = equilibrium_.vertical;
  depth_ = first_depth();
  if (!is_in_contact(request_, depth_, result_.warnings)) {
    return std::move(result_);
  }
  settle_depth();
  result_.depth = depth_;
  result_.depth_found = depth_;
  result_.vertical = equilibrium_.vertical - depth_;
  result_.combined_modulus = request_.combined_modulus;
  result_.gap = request_.gap;
  if (!request_.position_is_prescribed()) {
    result_.load = request_.load();
  }
  take_patches();
  result_.times.mechanics = stopwatch.seconds();
  return std::move(result_);
}

} // namespace

WheelSolution solve_wheel_approximately(const WheelSurface& wheel, const RailSurface& rail,
                                        const SideEquilibrium& equilibrium,
                                        const WheelRequest& request, ApproximateModel model) {
  if (request.gap == GapConvention::vertical) {
    throw_invalid_argument("solve.gap", "\"vertical\"",
                           "allowed with this model is \"tangent\"; solve.model = \"half-space\" "
                           "knows both");
  }
  return ApproximateWheel(wheel, rail, equilibrium, request, model).solve();
}

} // namespace wrc
