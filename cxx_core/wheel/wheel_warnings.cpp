#include "wheel/wheel_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "patches/constants.hpp"
#include "wheel/constants.hpp"
#include "wheel/depth_checks.hpp"

namespace wrc {
namespace {

/// As of_patch, of the patch at `index` of a solution, whose planes are the patches of the result.
std::string of_solved_patch(const WheelSolution& result, std::size_t index) {
  const std::vector<Patch>& patches = result.patches;
  const std::size_t plane = patches[index].plane;
  const auto shares_plane = [plane](const Patch& patch) { return patch.plane == plane; };
  if (patches.size() == 1) {
    return {};
  }
  const auto first = std::find_if(patches.begin(), patches.end(), shares_plane);
  const auto part = index - static_cast<std::size_t>(first - patches.begin());
  const bool has_parts = std::count_if(first, patches.end(), shares_plane) > 1;
  return "patch " + std::to_string(plane) +
         (has_parts ? ", part " + std::to_string(part) : std::string()) + ": ";
}

std::string edge_text(const Patch& patch) {
  return reaches_neighbour(patch) ? "contact reaches the boundary to the neighbouring patch"
                                  : "contact reaches the edge of the grid: elements are too large, "
                                    "or the patch has just formed";
}

/// How to reduce the error of a plane. "auto" does not see kinks.
std::string way_to_reduce(CurvedChoice curved, bool has_kink) {
  if (curved == CurvedChoice::yes || (curved == CurvedChoice::by_accuracy && !has_kink)) {
    return {};
  }
  return "; solve.curved = \"" + std::string(has_kink ? "yes" : "auto") + "\" reduces it";
}

/// Estimated error of the wheel over the accuracy; on a grid by hand that of the model alone.
double excess_of(const WheelRequest& request, const WheelSolution& result) {
  const std::optional<double> error = request.grid ? result.model_error : result.error_estimate();
  return error.value_or(std::numeric_limits<double>::infinity()) / request.accuracy;
}

/// Where the model is too rough for the accuracy, the warning is that of its cause.
void warn_of_accuracy(const WheelRequest& request, WheelSolution& result) {
  const double accuracy = request.accuracy;
  const double of_model = result.model_error.value_or(0.0);
  const std::optional<double> all = result.error_estimate();
  const bool elements_suffice = result.discretisation_error.value_or(2.0) <= accuracy;
  if (all && elements_suffice && (*all <= accuracy || of_model > accuracy)) {
    return;
  }
  std::string text = "accuracy " + text_of(accuracy) + " not reached";
  if (all) {
    text += ": estimated error " + short_text_of(*all);
    if (of_model > least_share_said * *all) {
      text += " (model " + short_text_of(of_model) + ')';
    }
  }
  if (request.elements == Elements::constant && !elements_suffice) {
    text += "; solve.method = \"paper\" has elements of constant pressure, which are less accurate";
  }
  result.warnings.push_back({WarningClass::accuracy, text, excess_of(request, result)});
}

void warn_of_interaction(const WheelRequest& request, double error, WheelSolution& result) {
  if (!(error > request.accuracy)) {
    return;
  }
  const std::string cause =
      request.interaction == Interaction::near
          ? "what patches displace at each other is left out unless they are close"
          : "the patches lie in different planes, so their effect on each other is known in part";
  result.warnings.push_back({WarningClass::no_interaction,
                             cause + ": estimated error " + short_text_of(error),
                             excess_of(request, result)});
}

} // namespace

bool reaches_neighbour(const Patch& patch) {
  const ContactPatch& penetration = patch.penetration;
  const EdgeContact& edge = patch.contact.touches_edge;
  const double room = penetration_margin * (penetration.y_last - penetration.y_first);
  return (edge.lateral_first && penetration.y_first - penetration.limit_first <= room) ||
         (edge.lateral_last && penetration.limit_last - penetration.y_last <= room);
}

void warn_of_solution(const GridSolution& solution, const WheelRequest& request,
                      double wheel_radius, const SolutionErrors& errors, WheelSolution& result) {
  Warnings& warnings = result.warnings;
  warn_of_rounding(solution, request, wheel_radius, warnings);
  if (solution.stop_reason != StopReason::tolerance_met) {
    warnings.push_back({WarningClass::not_converged,
                        "not converged: " + std::string(name_of(solution.stop_reason)) +
                            ", error of the pressures " + short_text_of(solution.pressure_error)});
  }
  if (errors.ridge > request.accuracy) {
    warnings.push_back(
        {WarningClass::ridge,
         "a profile has a kink of " + short_text_of(solution.sharpest_ridge()) +
             " rad inside the contact: pressures are unbounded there, and forces converge slowly",
         errors.ridge / request.accuracy});
  }
  if (!request.grid) {
    warn_of_accuracy(request, result);
  }
  warn_of_interaction(request, errors.interaction, result);
  if (solution.left_out_s) {
    warnings.push_back(
        {WarningClass::patch_left_out,
         "wheel and rail also meet at s_wheel = " + short_text_of(*solution.left_out_s) +
             " mm at another angle; that patch is left out, since distances are vertical"});
  }
}

void warn_of_patches(const WheelRequest& request, WheelSolution& result) {
  for (std::size_t i = 0; i < result.patches.size(); ++i) {
    const Patch& patch = result.patches[i];
    const auto warn = [&](WarningClass kind, const std::string& text,
                          std::optional<double> excess = std::nullopt) {
      result.warnings.push_back({kind, of_solved_patch(result, i) + text, excess});
    };
    if (patch.contact.touches_edge.any()) {
      warn(WarningClass::grid_edge, edge_text(patch));
    }
    if (request.gap == GapConvention::vertical) {
      if (std::abs(patch.penetration.angle_unturned) > vertical_convention_limit) {
        warn(WarningClass::vertical_angle,
             "vertical distances at a contact angle of " +
                 short_text_of(patch.penetration.angle_unturned) + " rad (valid up to " +
                 text_of(vertical_convention_limit) + "): use solve.method = \"auto\"");
      }
    } else if (patch.plane_error > request.accuracy) {
      const bool has_kink = patch.ridge > patch.turn.range();
      warn(WarningClass::patch_turn,
           (has_kink ? "a profile turns by " : "the rail turns by ") +
               short_text_of(has_kink ? patch.ridge : patch.turn.range()) +
               " rad within a patch that is solved " +
               (patch.frame.curve ? "along a curve" : "as a plane") + ": estimated error " +
               short_text_of(patch.plane_error) + ", more than solve.accuracy = " +
               text_of(request.accuracy) + way_to_reduce(request.curved, has_kink),
           excess_of(request, result));
    }
  }
}

} // namespace wrc
