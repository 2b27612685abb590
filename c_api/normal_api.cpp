#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "half_space/displacement_operator.hpp"
#include "handles.hpp"
#include "pressure/contact_area.hpp"

namespace {

constexpr double most_iterations = 1e9;
/// What double precision reaches on any grid (docs/stability.md); that of solve.tolerance too.
constexpr double min_tolerance = 1e-13;

[[noreturn]] void refuse_name(const char* what, const std::string& name, const char* known) {
  throw wrc::Error(wrc::ErrorCode::unknown_name, std::string("no ") + what +
                                                     " of a normal contact is named \"" + name +
                                                     "\"; there are " + known);
}

/// True for `second`, false for `first`; throws Error(invalid_argument) for any other.
bool is_second(const char* key, std::string_view value, std::string_view first,
               std::string_view second) {
  if (value != first && value != second) {
    wrc::throw_invalid_argument(key, '"' + std::string(value) + '"',
                                "allowed is \"" + std::string(first) + "\" or \"" +
                                    std::string(second) + '"');
  }
  return value == second;
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
    check(value >= 1.0 && value <= most_iterations && value == std::floor(value),
          "allowed is a whole number, 1 to 1e9");
    problem.maximum_iterations = static_cast<int>(value);
  } else {
    refuse_name("number", key,
                "combined_modulus, normal_load, approach, tolerance, maximum_iterations");
  }
}

/// Runs a body that needs results.
template <class Body> wrc_status with_result(wrc_normal* normal, Body&& body) {
  return wrc::guard(normal, [&](wrc::NormalObject& object) -> wrc_status {
    if (!object.result) {
      object.error = "the normal contact has not been solved yet";
      return WRC_NO_RESULT;
    }
    return body(object, *object.result);
  });
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
  refuse_name("number", name,
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
    wrc::Grid grid;
    // A negative number becomes 0, which check_grid refuses too.
    grid.lateral_count = static_cast<std::size_t>(std::max<int64_t>(lateral_count, 0));
    grid.longitudinal_count = static_cast<std::size_t>(std::max<int64_t>(longitudinal_count, 0));
    grid.lateral_step = lateral_step;
    grid.longitudinal_step = longitudinal_step;
    wrc::check_grid(grid);
    object.problem.grid = grid;
    return WRC_OK;
  });
}

wrc_status wrc_normal_set_distance(wrc_normal* normal, const double* values, int64_t count) {
  return wrc::guard(normal, [&](wrc::NormalObject& object) {
    wrc::require_pointer(values, "values");
    if (count < 1 || count > static_cast<int64_t>(wrc::maximum_element_count)) {
      wrc::throw_invalid_argument("count", std::to_string(count), "allowed is 1 to 2^26");
    }
    const double* end = values + count;
    const double* bad =
        std::find_if(values, end, [](double value) { return !std::isfinite(value); });
    if (bad != end) {
      wrc::throw_invalid_argument("values[" + std::to_string(bad - values) + ']', *bad,
                                  "a distance must be finite, mm");
    }
    object.distance = std::make_shared<const std::vector<double>>(values, end);
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
    const std::string_view asked = key;
    if (asked == "solver") {
      object.paper_method = is_second(key, value, "default", "paper");
    } else if (asked == "precision") {
      const auto precision = is_second(key, value, "mixed", "double") ? wrc::Precision::double_only
                                                                      : wrc::Precision::mixed;
      if (precision != object.precision) {
        object.precision = precision;
        object.solver.reset();
      }
    } else if (asked == "elements") {
      object.elements = is_second(key, value, "smooth", "constant") ? wrc::Elements::constant
                                                                    : wrc::Elements::smooth;
    } else if (asked == "planner") {
      const auto rigor = is_second(key, value, "estimate", "measure") ? wrc::PlannerRigor::measure
                                                                      : wrc::PlannerRigor::estimate;
      if (rigor != object.rigor) {
        object.rigor = rigor;
        object.solver.reset();
      }
    } else {
      refuse_name("text", key, "solver, elements, precision, planner");
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
  return with_result(normal, [&](wrc::NormalObject&, wrc::NormalResult& result) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    *value = number_of(result, name);
    return WRC_OK;
  });
}

wrc_status wrc_normal_text(wrc_normal* normal, const char* name, const char** value) {
  return with_result(normal, [&](wrc::NormalObject&, wrc::NormalResult& result) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    if (std::string_view(name) != "stop_reason") {
      refuse_name("text", name, "stop_reason");
    }
    // The name is a string literal, so the view ends with a zero byte.
    *value = wrc::name_of(result.solution.stop_reason).data();
    return WRC_OK;
  });
}

wrc_status wrc_normal_field(wrc_normal* normal, const char* name, double* values, int64_t capacity,
                            int64_t* count) {
  return with_result(normal, [&](wrc::NormalObject& object, wrc::NormalResult& result) {
    wrc::require_pointer(name, "name");
    const std::string_view asked = name;
    if (asked != "pressure" && asked != "displacement") {
      refuse_name("field", name, "pressure, displacement");
    }
    const std::size_t length = result.solution.pressure.size();
    const double* from = result.solution.pressure.data();
    if (asked == "displacement" && capacity >= static_cast<int64_t>(length)) {
      from = displacement_of(result).data();
    }
    return wrc::copy_values(from, length, values, capacity, count, object.error);
  });
}
}
