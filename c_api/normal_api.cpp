#include <cmath>
#include <string_view>

#include "grid_contact.hpp"
#include "half_space/displacement_operator.hpp"
#include "pressure/contact_area.hpp"

namespace {

/// What double precision reaches on any grid (docs/stability.md); that of solve.tolerance too.
constexpr double min_tolerance = 1e-13;

[[noreturn]] void refuse(const char* what, const std::string& name, const char* known) {
  wrc::refuse_name(what, "normal contact", name, known);
}

void set_number(wrc::NormalProblem& problem, const std::string& key, double value) {
  const auto check = [&](bool permitted, const char* allowed) {
    if (!permitted || !std::isfinite(value)) {
      wrc::throw_invalid_argument(key, value, allowed);
    }
  };
  if (key == "combined_modulus") {
    check(value >= 1e-30 && value <= 1e30, "allowed is 1e-30 to 1e30 MPa");
    problem.combined_modulus = value;
  } else if (key == "normal_load") {
    check(value == 0.0 || (value >= 1e-60 && value <= 1e60), "allowed is 0, or 1e-60 to 1e60 N");
    problem.normal_load = value;
    problem.approach.reset();
  } else if (key == "approach") {
    check(std::abs(value) <= 1e60, "allowed is -1e60 to 1e60 mm");
    problem.approach = value;
    problem.normal_load.reset();
  } else if (key == "tolerance") {
    check(value >= min_tolerance && value <= 0.1, "allowed is 1e-13 to 0.1");
    problem.tolerance = value;
  } else if (key == "maximum_iterations") {
    check(value >= 1.0 && value <= wrc::most_iterations && value == std::floor(value),
          "allowed is a whole number, 1 to 1e9");
    problem.maximum_iterations = static_cast<int>(value);
  } else {
    refuse("number", key, "combined_modulus, normal_load, approach, tolerance, maximum_iterations");
  }
}

const std::vector<double>& displacement_of(wrc::NormalResult& result) {
  if (result.solution.displacement.empty()) {
    std::vector<double> displacement(result.solution.pressure.size());
    wrc::DisplacementOperator(result.problem.grid, result.problem.combined_modulus,
                              result.problem.elements)
        .apply(result.solution.pressure, displacement);
    result.solution.displacement.swap(displacement);
  }
  return result.solution.displacement;
}

const wrc::Residuals& residuals_of(wrc::NormalResult& result) {
  if (!result.residuals) {
    result.residuals =
        wrc::compute_residuals(result.problem, result.solution.pressure, result.solution.approach);
  }
  return *result.residuals;
}

double number_of(wrc::NormalResult& result, const std::string& name) {
  if (name == "approach") {
    return result.solution.approach;
  }
  if (name == "normal_force") {
    return result.solution.normal_force;
  }
  if (name == "pmax") {
    return result.summary.peak_pressure;
  }
  if (name == "pmax_element") {
    return result.summary.largest_element_pressure;
  }
  if (name == "area") {
    return wrc::contact_area(result.problem.grid, result.solution.pressure);
  }
  if (name == "fill") {
    return static_cast<double>(result.summary.element_count) /
           static_cast<double>(result.problem.grid.element_count());
  }
  if (name == "iterations") {
    return result.solution.iterations;
  }
  if (name == "residuals.load_balance") {
    return residuals_of(result).load_balance;
  }
  if (name == "residuals.least_gap") {
    return residuals_of(result).least_gap;
  }
  if (name == "residuals.complementarity") {
    return residuals_of(result).complementarity;
  }
  refuse("number", name,
         "approach, normal_force, pmax, pmax_element, area, fill, iterations, "
         "residuals.load_balance, residuals.least_gap, residuals.complementarity");
}

} // namespace

extern "C" {

wrc_status wrc_normal_create(wrc_normal** normal) {
  return wrc::create(normal);
}

void wrc_normal_destroy(wrc_normal* normal) {
  wrc::destroy(normal);
}

const char* wrc_normal_error(const wrc_normal* normal) {
  return wrc::error_of(normal);
}

wrc_status wrc_normal_set_grid(wrc_normal* normal, int64_t lateral_count,
                               int64_t longitudinal_count, double lateral_step,
                               double longitudinal_step) {
  return wrc::guard(normal, [&](wrc::NormalObject& object) {
    object.problem.grid =
        wrc::checked_grid(lateral_count, longitudinal_count, lateral_step, longitudinal_step);
    return WRC_OK;
  });
}

wrc_status wrc_normal_set_distance(wrc_normal* normal, const double* values, int64_t count) {
  return wrc::guard(normal, [&](wrc::NormalObject& object) {
    object.distance = std::make_shared<const std::vector<double>>(wrc::copied(
        "values", values, count, [](double value) { return std::isfinite(value); },
        "a distance must be finite, mm"));
    return WRC_OK;
  });
}

wrc_status wrc_normal_set_number(wrc_normal* normal, const char* key, double value) {
  return wrc::guard(normal, [&](wrc::NormalObject& object) {
    wrc::require_pointer(key, "key");
    set_number(object.problem, key, value);
    return WRC_OK;
  });
}

wrc_status wrc_normal_set_text(wrc_normal* normal, const char* key, const char* value) {
  return wrc::guard(normal, [&](wrc::NormalObject& object) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(value, "value");
    const std::string_view requested = key;
    if (requested == "solver") {
      object.paper_method = wrc::chosen<bool>(key, value, {{"default", false}, {"paper", true}});
    } else if (requested == "precision") {
      const auto precision = wrc::chosen<wrc::Precision>(
          key, value, {{"mixed", wrc::Precision::mixed}, {"double", wrc::Precision::double_only}});
      if (precision != object.precision) {
        object.precision = precision;
        object.solver.reset();
      }
    } else if (requested == "elements") {
      object.elements = wrc::chosen<wrc::Elements>(
          key, value, {{"smooth", wrc::Elements::smooth}, {"constant", wrc::Elements::constant}});
    } else if (requested == "planner") {
      const auto rigor = wrc::chosen<wrc::PlannerRigor>(
          key, value,
          {{"estimate", wrc::PlannerRigor::estimate}, {"measure", wrc::PlannerRigor::measure}});
      if (rigor != object.rigor) {
        object.rigor = rigor;
        object.solver.reset();
      }
    } else {
      refuse("text", key, "solver, elements, precision, planner");
    }
    return WRC_OK;
  });
}

wrc_status wrc_normal_solve(wrc_normal* normal) {
  return wrc::guard(normal, [&](wrc::NormalObject& object) -> wrc_status {
    if (object.problem.grid.element_count() == 0) {
      wrc::throw_invalid_argument("grid", "none", "wrc_normal_set_grid must be called first");
    }
    if (!object.distance) {
      wrc::throw_invalid_argument("undeformed_distance", "none",
                                  "wrc_normal_set_distance must be called first");
    }
    wrc::NormalResult result;
    result.distance = object.distance;
    result.problem = object.problem;
    result.problem.undeformed_distance = *result.distance;
    result.problem.elements = object.elements.value_or(object.paper_method ? wrc::Elements::constant
                                                                           : wrc::Elements::smooth);
    if (object.paper_method) {
      result.solution = wrc::solve_with_polonsky_keer(result.problem);
    } else {
      if (!object.solver) {
        object.solver.emplace(object.rigor, object.precision);
      }
      result.solution = object.solver->solve(result.problem);
    }
    result.summary = wrc::summarise_pressure(result.problem.grid, result.solution.pressure);
    const bool converged = result.solution.stop_reason == wrc::StopReason::tolerance_met;
    std::string error = converged ? "" : "not converged: see stop_reason";
    // From here on nothing fails: the handle has the old results or all of the new ones.
    object.result = std::move(result);
    object.error.swap(error);
    return converged ? WRC_OK : WRC_NOT_CONVERGED;
  });
}

wrc_status wrc_normal_number(wrc_normal* normal, const char* name, double* value) {
  return wrc::with_result(normal, [&](wrc::NormalObject&, wrc::NormalResult& result) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    *value = number_of(result, name);
    return WRC_OK;
  });
}

wrc_status wrc_normal_text(wrc_normal* normal, const char* name, const char** value) {
  return wrc::with_result(normal, [&](wrc::NormalObject&, wrc::NormalResult& result) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    if (std::string_view(name) != "stop_reason") {
      refuse("text", name, "stop_reason");
    }
    // The name is a string literal, so the view ends with a zero byte.
    *value = wrc::name_of(result.solution.stop_reason).data();
    return WRC_OK;
  });
}

wrc_status wrc_normal_field(wrc_normal* normal, const char* name, double* values, int64_t capacity,
                            int64_t* count) {
  return wrc::with_result(normal, [&](wrc::NormalObject& object, wrc::NormalResult& result) {
    wrc::require_pointer(name, "name");
    const std::string_view requested = name;
    if (requested != "pressure" && requested != "displacement") {
      refuse("field", name, "pressure, displacement");
    }
    const std::size_t length = result.solution.pressure.size();
    const double* from = result.solution.pressure.data();
    if (requested == "displacement" && capacity >= static_cast<int64_t>(length)) {
      from = displacement_of(result).data();
    }
    return wrc::copy_values(from, length, values, capacity, count, object.error);
  });
}
}
