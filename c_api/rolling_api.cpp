#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "grid_contact.hpp"
#include "half_space/material.hpp"
#include "keys/removed_names.hpp"
#include "rolling/fastsim.hpp"

namespace {

using wrc::RollingObject;
using wrc::RollingProblem;
using wrc::RollingSolution;

constexpr const char* rolling_contact = "rolling contact";
/// MPa; forces on any grid, and their power, remain finite numbers.
constexpr double largest_pressure = 1e30;
constexpr double largest_slip = 1e30;

constexpr auto rolling_number_keys = std::to_array<wrc::NumberKey<RollingProblem>>({
    {"shear_modulus", 1e-30, 1e30, "must be between 1e-30 and 1e30 MPa",
     [](RollingProblem& problem, double value) { problem.shear_modulus = value; }},
    {"poisson", 0.0, 0.5, "must be between 0 and 0.5",
     [](RollingProblem& problem, double value) { problem.poisson = value; }},
    {"difference_parameter", -0.5, 0.5, "must be between -0.5 and 0.5",
     [](RollingProblem& problem, double value) { problem.difference_parameter = value; }},
    {"friction", 0.0, 1e3, "must be between 0 and 1e3",
     [](RollingProblem& problem, double value) { problem.friction = value; }},
    {"longitudinal_creepage", -1e30, 1e30, "must be between -1e30 and 1e30",
     [](RollingProblem& problem, double value) { problem.creepages.longitudinal = value; }},
    {"lateral_creepage", -1e30, 1e30, "must be between -1e30 and 1e30",
     [](RollingProblem& problem, double value) { problem.creepages.lateral = value; }},
    {"spin_creepage", -1e30, 1e30, "must be between -1e30 and 1e30 1/mm",
     [](RollingProblem& problem, double value) { problem.creepages.spin = value; }},
    {"tolerance", 1e-10, 0.1, "must be between 1e-10 and 0.1",
     [](RollingProblem& problem, double value) { problem.tolerance = value; }},
    {"derivatives", 0.0, 1.0, "must be 0 or 1",
     [](RollingProblem& problem, double value) { problem.derivatives = value != 0.0; }, true},
    {"maximum_iterations", 1.0, wrc::most_iterations, "must be a whole number, 1 to 1e9",
     [](RollingProblem& problem, double value) {
       problem.maximum_iterations = static_cast<int>(value);
     },
     true},
});

constexpr auto rolling_text_keys = std::to_array<wrc::TextKey<RollingObject>>({
    {"model",
     [](RollingObject& object, const char* key, const char* value) {
       object.fastsim = wrc::chosen<bool>(key, value, {{"full", false}, {"fastsim", true}});
     }},
    {"contact",
     [](RollingObject& object, const char* key, const char* value) {
       using Motion = wrc::TangentialMotion;
       object.problem.motion = wrc::chosen<Motion>(key, value,
                                                   {{"rolling", Motion::rolling},
                                                    {"transient", Motion::transient},
                                                    {"shift", Motion::shift}});
     }},
    {"difference",
     [](RollingObject& object, const char* key, const char* value) {
       using Difference = wrc::SlipDifference;
       object.problem.difference = wrc::chosen<Difference>(
           key, value, {{"biased", Difference::biased}, {"first-order", Difference::first_order}});
     }},
});

struct RollingNumber {
  const char* name;
  double (*of)(const RollingSolution&);
};

constexpr auto rolling_numbers = std::to_array<RollingNumber>({
    {"creep_force.longitudinal",
     [](const RollingSolution& solution) { return solution.longitudinal_force; }},
    {"creep_force.lateral", [](const RollingSolution& solution) { return solution.lateral_force; }},
    {"spin_moment", [](const RollingSolution& solution) { return solution.spin_moment; }},
    {"slip_area", [](const RollingSolution& solution) { return solution.slip_area; }},
    {"adhesion_area", [](const RollingSolution& solution) { return solution.adhesion_area; }},
    {"friction_power", [](const RollingSolution& solution) { return solution.friction_power; }},
    {"numerical_loss", [](const RollingSolution& solution) { return solution.numerical_loss; }},
    {"iterations", [](const RollingSolution& solution) { return double(solution.iterations); }},
    {"convolutions", [](const RollingSolution& solution) { return double(solution.convolutions); }},
    {"residual", [](const RollingSolution& solution) { return solution.residual; }},
    {"converged", [](const RollingSolution& solution) { return solution.converged ? 1.0 : 0.0; }},
});

struct RollingField {
  const char* name;
  std::span<const double> (*of)(const RollingSolution&);
};

constexpr auto rolling_fields = std::to_array<RollingField>({
    {"traction_x",
     [](const RollingSolution& solution) { return std::span<const double>(solution.traction_x); }},
    {"traction_y",
     [](const RollingSolution& solution) { return std::span<const double>(solution.traction_y); }},
    {"slip_x",
     [](const RollingSolution& solution) { return std::span<const double>(solution.slip_x); }},
    {"slip_y",
     [](const RollingSolution& solution) { return std::span<const double>(solution.slip_y); }},
    {"normal_displacement",
     [](const RollingSolution& solution) {
       return std::span<const double>(solution.normal_displacement);
     }},
    {"creepage_derivatives",
     [](const RollingSolution& solution) { return std::span<const double>(solution.by_creepage); }},
});

} // namespace

extern "C" {

wrc_status wrc_rolling_create(wrc_rolling** rolling) {
  return wrc::create(rolling);
}

void wrc_rolling_destroy(wrc_rolling* rolling) {
  wrc::destroy(rolling);
}

const char* wrc_rolling_error(const wrc_rolling* rolling) {
  return wrc::error_of(rolling);
}

wrc_status wrc_rolling_set_grid(wrc_rolling* rolling, int64_t lateral_count,
                                int64_t longitudinal_count, double lateral_step,
                                double longitudinal_step) {
  return wrc::guard(rolling, [&](RollingObject& object) {
    wrc::Grid grid =
        wrc::checked_grid(lateral_count, longitudinal_count, lateral_step, longitudinal_step);
    grid.lateral_first = -0.5 * static_cast<double>(lateral_count - 1) * lateral_step;
    grid.longitudinal_first =
        -0.5 * static_cast<double>(longitudinal_count - 1) * longitudinal_step;
    object.problem.grid = grid;
    return WRC_OK;
  });
}

wrc_status wrc_rolling_set_pressure(wrc_rolling* rolling, const double* values, int64_t count) {
  return wrc::guard(rolling, [&](RollingObject& object) {
    object.pressure = wrc::copied(
        "values", values, count, [](double p) { return p >= 0.0 && p <= largest_pressure; },
        "must be between 0 and 1e30 MPa");
    return WRC_OK;
  });
}

wrc_status wrc_rolling_set_slip(wrc_rolling* rolling, const double* slip_x, const double* slip_y,
                                int64_t count) {
  return wrc::guard(rolling, [&](RollingObject& object) {
    std::vector<double> x;
    std::vector<double> y;
    if (count != 0) {
      const auto permitted = [](double slip) { return std::abs(slip) <= largest_slip; };
      const char* allowed = "must be between -1e30 and 1e30";
      x = wrc::copied("slip_x", slip_x, count, permitted, allowed);
      y = wrc::copied("slip_y", slip_y, count, permitted, allowed);
    }
    object.slip_x.swap(x);
    object.slip_y.swap(y);
    return WRC_OK;
  });
}

wrc_status wrc_rolling_set_previous(wrc_rolling* rolling, const double* traction_x,
                                    const double* traction_y, int64_t count) {
  return wrc::guard(rolling, [&](RollingObject& object) {
    std::vector<double> previous_x;
    std::vector<double> previous_y;
    if (count != 0) {
      const auto permitted = [](double q) { return std::abs(q) <= largest_pressure; };
      const char* allowed = "must be between -1e30 and 1e30 MPa";
      previous_x = wrc::copied("traction_x", traction_x, count, permitted, allowed);
      previous_y = wrc::copied("traction_y", traction_y, count, permitted, allowed);
    }
    object.previous_x.swap(previous_x);
    object.previous_y.swap(previous_y);
    return WRC_OK;
  });
}

wrc_status wrc_rolling_set_number(wrc_rolling* rolling, const char* key, double value) {
  return wrc::guard(rolling, [&](RollingObject& object) {
    wrc::set_number_in(rolling_number_keys, rolling_contact, object.problem, key, value);
    return WRC_OK;
  });
}

wrc_status wrc_rolling_set_text(wrc_rolling* rolling, const char* key, const char* value) {
  return wrc::guard(rolling, [&](RollingObject& object) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(value, "value");
    wrc::entry_in(rolling_text_keys, "text", rolling_contact, key).set(object, key, value);
    return WRC_OK;
  });
}

wrc_status wrc_rolling_solve(wrc_rolling* rolling) {
  return wrc::guard(rolling, [&](RollingObject& object) -> wrc_status {
    if (object.problem.grid.element_count() == 0) {
      wrc::throw_invalid_argument("grid", "none", "wrc_rolling_set_grid must be called first");
    }
    if (object.pressure.empty()) {
      wrc::throw_invalid_argument("pressure", "none",
                                  "wrc_rolling_set_pressure must be called first");
    }
    RollingProblem problem = object.problem;
    problem.difference_parameter = wrc::effective_difference(problem.difference_parameter,
                                                             problem.friction, problem.tolerance);
    problem.pressure = object.pressure;
    problem.slip_x = object.slip_x;
    problem.slip_y = object.slip_y;
    if (problem.motion != wrc::TangentialMotion::rolling) {
      problem.previous_x = object.previous_x;
      problem.previous_y = object.previous_y;
    }
    RollingSolution solution =
        object.fastsim ? solve_with_fastsim(problem, flexibilities_of(problem, object.solver))
                       : object.solver.solve(problem);
    const bool converged = solution.converged;
    std::string error =
        converged ? "" : "not converged: residual = " + wrc::short_text_of(solution.residual);
    if (solution.normal_displacement.empty()) {
      solution.normal_displacement.resize(problem.pressure.size());
    }
    // From here on nothing fails: the handle has the old results or all of the new ones.
    object.result = std::move(solution);
    object.error.swap(error);
    return converged ? WRC_OK : WRC_NOT_CONVERGED;
  });
}

wrc_status wrc_rolling_advance(wrc_rolling* rolling) {
  return wrc::with_result(rolling, [](RollingObject& object, const RollingSolution& solution) {
    std::vector<double> previous_x = solution.traction_x;
    std::vector<double> previous_y = solution.traction_y;
    object.previous_x.swap(previous_x);
    object.previous_y.swap(previous_y);
    return WRC_OK;
  });
}

wrc_status wrc_rolling_number(wrc_rolling* rolling, const char* name, double* value) {
  return wrc::with_result(rolling, [&](RollingObject&, const RollingSolution& solution) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    if (const auto removed = wrc::removed_result(wrc::NameOf::rolling_result, "", name)) {
      throw wrc::Error(wrc::ErrorCode::unknown_name, *removed);
    }
    const auto& number = wrc::entry_in(rolling_numbers, "number", rolling_contact, name);
    *value = number.of(solution) + 0.0; // without zeros of negative sign
    return WRC_OK;
  });
}

wrc_status wrc_rolling_field(wrc_rolling* rolling, const char* name, double* values,
                             int64_t capacity, int64_t* count) {
  return wrc::with_result(rolling, [&](RollingObject& object, const RollingSolution& solution) {
    wrc::require_pointer(name, "name");
    const auto found = wrc::entry_in(rolling_fields, "field", rolling_contact, name).of(solution);
    return wrc::copy_values(found.data(), found.size(), values, capacity, count, object.error);
  });
}
}
