#include "scene/total_load.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "scene/constants.hpp"

namespace wrc {
namespace {

constexpr std::array<const char*, 2> total_keys{"load.left", "load.right"};

/// Permitted error of a total after this number of solutions, as a fraction of it.
double permitted_share(int solutions, double accuracy) {
  return solutions <= usual_total_solutions
             ? std::min(total_load_tolerance, load_share_of_accuracy * accuracy)
         : solutions < most_total_solutions ? load_share_of_accuracy * accuracy
                                            : accuracy;
}

[[noreturn]] void refuse(const char* key, double total, double load, double carried) {
  throw_invalid_argument(key, total,
                         "no load on the normal pressures gives this total: with " + text_of(load) +
                             " N on them, all contact forces together carry " +
                             short_text_of(carried) + " N");
}

} // namespace

bool LoadSearch::is_met_by(double total, double accuracy, const char* key) {
  const Point found{load_, total - total_};
  ++solutions_;
  if (total == 0.0) { // a load so small that it is treated as none, with a warning
    return true;
  }
  if (std::abs(found.excess) <= permitted_share(solutions_, accuracy) * total_) {
    return true;
  }
  if (solutions_ >= most_total_solutions ||
      (found.excess < 0.0 && load_ >= largest_total_ratio * total_)) {
    refuse(key, total_, load_, total);
  }
  (found.excess < 0.0 ? low_ : high_.emplace()) = found;
  load_ = next_after(found);
  last_ = found;
  return false;
}

/// By a secant, between loads that are too small and too large.
double LoadSearch::next_after(const Point& found) const {
  const double slope = (found.excess - last_.excess) / (found.load - last_.load);
  const double drawn = found.load - found.excess / slope;
  if (high_) {
    return slope > 0.0 && drawn > low_.load && drawn < high_->load
               ? drawn
               : 0.5 * (low_.load + high_->load);
  }
  const double most = std::min(largest_load_growth * found.load, largest_total_ratio * total_);
  return slope > 0.0 && drawn > found.load ? std::min(drawn, most) : most;
}

bool JointLoadSearch::are_met_by(const WheelNumbers& totals, double accuracy) {
  ++solutions_;
  const double share = permitted_share(solutions_, accuracy);
  WheelNumbers excess{};
  bool met = true;
  for (std::size_t i = 0; i < excess.size(); ++i) {
    excess[i] = totals[i] == 0.0 ? 0.0 : totals[i] - totals_[i]; // as with one load
    met = met && std::abs(excess[i]) <= share * totals_[i];
  }
  if (met) {
    return true;
  }
  for (std::size_t i = 0; i < excess.size(); ++i) {
    const bool stuck = excess[i] < 0.0 && loads_[i] >= largest_total_ratio * totals_[i];
    if (stuck ||
        (solutions_ >= most_total_solutions && !(std::abs(excess[i]) <= share * totals_[i]))) {
      refuse(total_keys[i], totals_[i], loads_[i], totals[i]);
    }
  }
  take_slopes(excess);
  step(excess);
  return false;
}

/// Broyden's update; at first the totals are taken to be proportional to their own loads.
void JointLoadSearch::take_slopes(const WheelNumbers& excess) {
  if (solutions_ == 1) {
    for (std::size_t i = 0; i < 2; ++i) {
      const double ratio = loads_[i] > 0.0 ? (totals_[i] + excess[i]) / loads_[i] : 1.0;
      slopes_[i][i] = std::max(ratio, 1.0 / largest_load_growth);
    }
    return;
  }
  const WheelNumbers moved{loads_[0] - last_loads_[0], loads_[1] - last_loads_[1]};
  const double square = moved[0] * moved[0] + moved[1] * moved[1];
  for (std::size_t i = 0; i < 2 && square > 0.0; ++i) {
    const double expected = slopes_[i][0] * moved[0] + slopes_[i][1] * moved[1];
    const double missed = (excess[i] - last_excess_[i] - expected) / square;
    slopes_[i][0] += missed * moved[0];
    slopes_[i][1] += missed * moved[1];
  }
}

void JointLoadSearch::step(const WheelNumbers& excess) {
  const auto& [left, right] = slopes_;
  const double determinant = left[0] * right[1] - left[1] * right[0];
  const WheelNumbers change{(left[1] * excess[1] - right[1] * excess[0]) / determinant,
                            (right[0] * excess[0] - left[0] * excess[1]) / determinant};
  last_loads_ = loads_;
  last_excess_ = excess;
  for (std::size_t i = 0; i < 2; ++i) {
    const double most = std::min(largest_load_growth * loads_[i], largest_total_ratio * totals_[i]);
    // A step that is no number leaves the load to the other wheel's.
    const double next = std::isfinite(change[i]) ? loads_[i] + change[i] : loads_[i];
    loads_[i] = std::clamp(next, loads_[i] / largest_load_growth, most);
  }
}

WheelLoads::WheelLoads(const Scene& scene, bool left, bool right)
    : scene_(scene), open_{left, right} {
  if (scene.load_of != LoadOf::total || scene.vertical || scene.until != Module::mechanics) {
    return;
  }
  const WheelNumbers totals{scene.left.load, scene.right.load};
  const bool coupled = scene.pitch_is_free && !scene.has_creepages();
  if (coupled && left && right) {
    joint_.emplace(totals);
    return;
  }
  for (std::size_t i = 0; i < totals.size(); ++i) {
    if (open_[i]) {
      single_[i].emplace(totals[i]);
    }
  }
}

double WheelLoads::load(std::size_t wheel) const {
  if (joint_) {
    return joint_->loads()[wheel];
  }
  const SceneSide& side = wheel == 0 ? scene_.left : scene_.right;
  return single_[wheel] ? single_[wheel]->load() : side.load;
}

void WheelLoads::take(const WheelNumbers& totals) {
  if (joint_) {
    open_.fill(!joint_->are_met_by(totals, scene_.accuracy));
    return;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    open_[i] =
        open_[i] && single_[i] && !single_[i]->is_met_by(totals[i], scene_.accuracy, total_keys[i]);
  }
}

} // namespace wrc
