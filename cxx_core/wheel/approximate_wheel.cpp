#include "wheel/approximate_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/root_bracket.hpp"
#include "base/stopwatch.hpp"
#include "models/constants.hpp"
#include "models/hertz.hpp"
#include "models/patch_model.hpp"
#include "patches/depth_estimate.hpp"
#include "wheel/constants.hpp"
#include "wheel/depth_checks.hpp"
#include "wheel/grid_plan.hpp"

namespace wrc {
namespace {

/// Of a vertical load: z of the track frame (a unit vector, not a tuning constant).
constexpr Vector3 upwards{0.0, 0.0, 1.0};

class ApproximateWheel {
public:
  ApproximateWheel(const WheelSurface& wheel, const RailSurface& rail,
                   const SideEquilibrium& equilibrium, const WheelRequest& request,
                   ApproximateModel model)
      : wheel_(wheel), rail_(rail), equilibrium_(equilibrium), request_(request), model_(model) {
    result_.request = request;
    result_.request.elements = Elements::constant; // models give pressures at points
    for (const ContactScan* scan : equilibrium.scans()) {
      scans_.push_back({*scan,
                        {wheel, rail, equilibrium.pose, scan->samples},
                        equilibrium.vertical,
                        request.combined_modulus});
    }
  }

  WheelSolution solve();

private:
  [[nodiscard]] double first_depth() const;
  /// Patches at a depth, each with a model.
  void find_patches(double depth);
  /// How close two patches of different scans are, which have no links, by their distance alone.
  [[nodiscard]] double weight_across_scans(const ContactPatch& one,
                                           const ContactPatch& other) const;
  /// Of all patches, N.
  [[nodiscard]] double force_along(const Vector3& direction, double depth) const;
  [[nodiscard]] double load_at(double depth) const;
  /// Depth at which the patches found carry the load.
  [[nodiscard]] double depth_of_load(double start) const;
  void settle_depth();
  void publish_patches();
  void sample(Patch& patch, const PatchModel& model, const ModelledPatch& modelled) const;

  const WheelSurface& wheel_;
  const RailSurface& rail_;
  const SideEquilibrium& equilibrium_;
  const WheelRequest& request_;
  ApproximateModel model_;
  std::vector<ModelWheel> scans_;
  double depth_ = 0.0;
  GridSolution planned_;
  std::vector<std::unique_ptr<PatchModel>> models_;
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
  const auto strip = scans_.front().strips.at(touch.wheel.lateral);
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
  WheelRequest near_only = request_;
  // Models do not couple patches, but lose validity beside others.
  near_only.interaction = Interaction::near;
  const auto counts = request_.grid.value_or(std::array{sampled_count, sampled_count});
  planned_ = plan_patches(rail_, equilibrium_, near_only, depth);
  set_grids(planned_, rail_, GridChoice(ElementCounts{counts[0], counts[1]}),
            request_.element_limit.value_or(default_element_limit));
  models_.clear();
  for (const Patch& patch : planned_.patches) {
    const ModelWheel& scan = scans_[patch.penetration.scan];
    models_.push_back(model_ == ApproximateModel::hertz
                          ? make_hertz_patch(scan, patch.penetration)
                          : make_kik_piotrowski_patch(scan, patch.penetration, patch.frame));
  }
  for (std::size_t k = 0; k < models_.size(); ++k) {
    Patch& patch = planned_.patches[k];
    patch.frame = models_[k]->frame();
    for (const Patch& other : planned_.patches) {
      patch.coupling_weight = std::max(patch.coupling_weight,
                                       weight_across_scans(patch.penetration, other.penetration));
    }
  }
}

double ApproximateWheel::weight_across_scans(const ContactPatch& one,
                                             const ContactPatch& other) const {
  const double joining = request_.joining_distance;
  if (one.scan == other.scan || !(joining > 0.0)) {
    return 0.0;
  }
  const double along = std::max(one.x_first - other.x_last, other.x_first - one.x_last);
  const double across = std::max(one.y_first - other.y_last, other.y_first - one.y_last);
  const double apart = std::hypot(std::max(along, 0.0), std::max(across, 0.0));
  return std::clamp(2.0 - apart / joining, 0.0, 1.0);
}

double ApproximateWheel::force_along(const Vector3& direction, double depth) const {
  double force = 0.0;
  for (const auto& model : models_) {
    force += dot(model->frame().normal, direction) * model->load(depth);
  }
  return force;
}

double ApproximateWheel::load_at(double depth) const {
  return force_along(request_.normal_load ? models_[planned_.main]->frame().normal : upwards,
                     depth);
}

/// The load goes about with the power 3/2 of the depth, so its power 2/3 is nearly linear: secants
/// until the load is bracketed, then within the bracket.
double ApproximateWheel::depth_of_load(double start) const {
  const double sought = request_.load();
  const double target = std::cbrt(sought * sought);
  const auto excess_at = [&](double depth) {
    const double load = load_at(depth);
    const double excess = std::cbrt(load * load) - target;
    return std::abs(excess) <= model_search_accuracy * target ? 0.0 : excess;
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
  bracket.narrow(model_search_accuracy * high.place, excess_at);
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
  result_.warnings.push_back({WarningClass::not_settled,
                              "not settled: the load is that of patches found at another depth"});
}

void ApproximateWheel::sample(Patch& patch, const PatchModel& model,
                              const ModelledPatch& modelled) const {
  patch.grid = grid_over(modelled.extent.widened(sampled_margin), patch.grid.lateral_count,
                         patch.grid.longitudinal_count);
  patch.pressure = model.sample(patch.grid);
  const PosedPair pair{wheel_, rail_, equilibrium_.pose, equilibrium_.vertical - depth_};
  patch.undeformed_distance = sample_undeformed_distance(pair, patch.frame, patch.grid);
  patch.normal_force = modelled.normal_force;
  // Along the normal of its plane: a model has no pressures at single points.
  patch.contact_force.force = modelled.normal_force * patch.frame.normal;
  patch.contact_force.moment = cross(modelled.centroid_longitudinal * patch.frame.longitudinal +
                                         modelled.centroid_lateral * patch.frame.lateral,
                                     patch.contact_force.force);
  patch.approach = modelled.approach;
  patch.area = modelled.area;
  patch.contact.peak_pressure = modelled.peak_pressure;
  for (const double pressure : patch.pressure) {
    patch.contact.largest_element_pressure =
        std::max(patch.contact.largest_element_pressure, pressure);
    patch.contact.element_count += pressure > 0.0 ? 1 : 0;
  }
  patch.contact.normal_force = modelled.normal_force;
  patch.contact.centroid_longitudinal = modelled.centroid_longitudinal;
  patch.contact.centroid_lateral = modelled.centroid_lateral;
  patch.contact.semi_axis_longitudinal = modelled.semi_axis_longitudinal;
  patch.contact.semi_axis_lateral = modelled.semi_axis_lateral;
}

void ApproximateWheel::publish_patches() {
  double validity = 1.0;
  for (std::size_t k = 0; k < models_.size(); ++k) {
    const ModelledPatch modelled = models_[k]->solve(depth_);
    if (!(modelled.normal_force > 0.0)) {
      continue;
    }
    Patch& patch = result_.patches.emplace_back(std::move(planned_.patches[k]));
    sample(patch, *models_[k], modelled);
    result_.peak_pressure = std::max(result_.peak_pressure, modelled.peak_pressure);
    validity = std::min(validity, patch.penetration.joins_scans
                                      ? 0.0
                                      : modelled.validity * (1.0 - patch.coupling_weight));
  }
  std::stable_sort(
      result_.patches.begin(), result_.patches.end(),
      [](const Patch& one, const Patch& other) { return one.normal_force > other.normal_force; });
  for (std::size_t k = 0; k < result_.patches.size(); ++k) {
    result_.patches[k].plane = k; // models do not couple patches
  }
  result_.in_contact = !result_.patches.empty();
  result_.validity = validity;
  if (validity < good_validity) {
    result_.warnings.push_back(
        {WarningClass::model_validity, "validity " + short_text_of(validity) + " (good from " +
                                           text_of(good_validity) +
                                           " on): pmax may be off by tens of per cent"});
  }
  if (request_.interaction == Interaction::all && result_.patches.size() > 1) {
    result_.warnings.push_back(
        {WarningClass::no_interaction, "patches do not interact in this model"});
  }
}

WheelSolution ApproximateWheel::solve() {
  if (request_.curved == CurvedChoice::yes) {
    throw_invalid_argument("solve.curved", "\"yes\"",
                           "must be \"no\" or \"auto\" with an approximate model");
  }
  result_.solved = true;
  const Stopwatch watch;
  result_.vertical = equilibrium_.vertical;
  depth_ = first_depth();
  if (!is_in_contact(request_, depth_, result_.warnings)) {
    return std::move(result_);
  }
  settle_depth();
  result_.depth = depth_;
  result_.vertical = equilibrium_.vertical - depth_;
  if (!request_.position_is_prescribed()) {
    result_.load = request_.load() * (force_along(upwards, depth_) / load_at(depth_));
  }
  publish_patches();
  result_.times.mechanics = watch.seconds();
  return std::move(result_);
}

} // namespace

WheelSolution solve_wheel_approximately(const WheelSurface& wheel, const RailSurface& rail,
                                        const SideEquilibrium& equilibrium,
                                        const WheelRequest& request, ApproximateModel model) {
  if (request.gap == GapConvention::vertical) {
    throw_invalid_argument(
        "solve.method", "\"paper\"",
        "must be \"auto\" with this model; solve.model = \"half-space\" has both");
  }
  return ApproximateWheel(wheel, rail, equilibrium, request, model).solve();
}

} // namespace wrc
