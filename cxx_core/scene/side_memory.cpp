#include "scene/side_memory.hpp"

#include <algorithm>
#include <cmath>

namespace wrc {
namespace {

/// Share of the accuracy that estimates aim at when the number of elements is chosen.
constexpr double aimed_share = 0.95;

/// Ends of penetration that have moved by no more than this share of its width since errors were
/// estimated leave the estimate in force.
constexpr double estimate_reach = 0.1;
/// So does a largest pressure that has changed by no more than this share.
constexpr double estimate_pressure_reach = 0.05;
/// The depth follows its last rate over moves up to this many times the last one, and by no more
/// than this share of itself.
constexpr double longest_move = 2.0;
constexpr double largest_change = 0.2;

} // namespace

double SideMemory::depth_under(double other_load) const {
  const double ratio = other_load / load;
  return depth * std::cbrt(ratio * ratio);
}

double SideMemory::expected_depth(double other_load, double other_lateral) const {
  const double here = depth_under(other_load);
  const double move = other_lateral - lateral;
  const double change = depth_rate * move;
  const bool goes_on = std::abs(move) <= longest_move * std::abs(last_move) &&
                       std::abs(change) <= largest_change * here;
  return goes_on ? here + change : here;
}

void SideMemory::remember(const RailSurface& rail, const SideRequest& request, double at,
                          const Trial& trial, const std::optional<TrialError>& estimated,
                          bool as_before, double grid_accuracy) {
  last_move = valid ? at - lateral : 0.0;
  depth_rate =
      last_move != 0.0 ? (trial.next_depth - depth_under(request.load())) / last_move : 0.0;
  lateral = at;
  const bool complete = std::none_of(trial.patches.begin(), trial.patches.end(),
                                     [](const PatchTrial& patch) { return patch.no_contact(); });
  valid = complete && !request.position_is_prescribed();
  if (!valid) {
    return;
  }
  depth = trial.next_depth;
  load = request.load();
  accuracy = request.accuracy;
  double factor = 1.0;
  if (estimated) {
    // As many elements as are enough, by the second order of the error: what the elements along the
    // rail leave of the accuracy.
    const double left = aimed_share * grid_accuracy - (estimated->total - estimated->lateral);
    factor = left > 0.0 ? std::clamp(std::sqrt(estimated->lateral / left), 0.5, 1.0) : 1.0;
    const double error = estimated->total + estimated->lateral * (1.0 / (factor * factor) - 1.0);
    // A grid given by hand says nothing of those that an accuracy chooses.
    error_estimate =
        error <= request.accuracy && !request.grid ? std::optional(error) : std::nullopt;
  } else if (!as_before) {
    error_estimate.reset();
  }
  slid = slid && as_before;
  patches.resize(trial.patches.size());
  for (std::size_t k = 0; k < trial.patches.size(); ++k) {
    const PatchTrial& patch = trial.patches[k];
    SideMemory::Patch& kept = patches[k];
    if (!as_before) {
      kept.resolution = {factor * patch.rows(), patch.columns()};
      kept.y_first = patch.place.y_first;
      kept.y_last = patch.place.y_last;
      kept.peak_pressure = patch.contact.peak_pressure;
    }
    if (error_estimate) {
      kept.grid = patch.grid;
      kept.pressure = patch.pressure;
    }
    const PlaneArea penetrated = area_of(patch.place, rail, patch.frame);
    const PlaneArea contact = patch.contact_area(0.0);
    kept.lateral_first = (contact.lateral_first - penetrated.lateral_first) / penetrated.width();
    kept.lateral_last = (contact.lateral_last - penetrated.lateral_first) / penetrated.width();
    kept.longitudinal_first =
        (contact.longitudinal_first - penetrated.longitudinal_first) / penetrated.length();
    kept.longitudinal_last =
        (contact.longitudinal_last - penetrated.longitudinal_first) / penetrated.length();
  }
}

bool SideMemory::places_are_near(std::span<const PatchPlan> plans) const {
  if (plans.size() != patches.size()) {
    return false;
  }
  for (std::size_t k = 0; k < plans.size(); ++k) {
    const ContactPatch& place = plans[k].place;
    const double reach = estimate_reach * (place.y_last - place.y_first);
    if (std::abs(place.y_first - patches[k].y_first) > reach ||
        std::abs(place.y_last - patches[k].y_last) > reach) {
      return false;
    }
  }
  return true;
}

bool SideMemory::estimate_holds(const Trial& trial) const {
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const PatchTrial& now = trial.patches[k];
    const Patch& last = patches[k];
    if (std::abs(now.contact.peak_pressure - last.peak_pressure) >
            estimate_pressure_reach * last.peak_pressure ||
        now.rows() < (1.0 - estimate_reach) * last.resolution.lateral - 1.0 ||
        now.columns() < (1.0 - estimate_reach) * last.resolution.longitudinal - 1.0) {
      return false;
    }
  }
  return true;
}

std::vector<std::optional<StartPressure>> SideMemory::starts() const {
  std::vector<std::optional<StartPressure>> starts;
  for (const Patch& patch : patches) {
    starts.push_back(StartPressure{patch.grid, patch.pressure});
  }
  return starts;
}

} // namespace wrc
