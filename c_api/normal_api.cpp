#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/warning.hpp"
#include "grid_contact.hpp"
#include "half_space/displacement_operator.hpp"
#include "pressure/contact_area.hpp"
#include "results/grade.hpp"

namespace {

using wrc::NormalObject;
using wrc::NormalProblem;
using wrc::NormalResult;

constexpr const char* normal_contact = "normal contact";

/// The tolerance from what double precision reaches on any grid (docs/evidence/limits.md) on; that
/// of solve.tolerance too.
constexpr auto normal_number_keys = std::to_array<wrc::NumberKey<NormalProblem>>({
    {"combined_modulus", 1e-30, 1e30, "must be between 1e-30 and 1e30 MPa",
     [](NormalProblem& problem, double value) { problem.combined_modulus = value; }},
    {"normal_load", 1e-60, 1e60, "must be 0, or 1e-60 to 1e60 N",
     [](NormalProblem& problem, double value) {
       problem.load = value;
       problem.approach.reset();
     },
     false, true},
    {"approach", -1e60, 1e60, "must be between -1e60 and 1e60 mm",
     [](NormalProblem& problem, double value) {
       problem.approach = value;
       problem.load.reset();
     }},
    {"tolerance", 1e-13, 0.1, "must be between 1e-13 and 0.1",
     [](NormalProblem& problem, double value) { problem.tolerance = value; }},
    {"maximum_iterations", 1.0, wrc::most_iterations, "must be a whole number, 1 to 1e9",
     [](NormalProblem& problem, double value) {
       problem.maximum_iterations = static_cast<int>(value);
     },
     true},
});

constexpr auto normal_text_keys = std::to_array<wrc::TextKey<NormalObject>>({
    {"solver",
     [](NormalObject& object, const char* key, const char* value) {
       object.paper_method = wrc::chosen<bool>(key, value, {{"default", false}, {"paper", true}});
     }},
    {"elements",
     [](NormalObject& object, const char* key, const char* value) {
       using wrc::Elements;
       object.elements = wrc::chosen<Elements>(
           key, value, {{"smooth", Elements::smooth}, {"constant", Elements::constant}});
     }},
    {"precision",
     [](NormalObject& object, const char* key, const char* value) {
       wrc::set_precision(object.options, key, value);
       object.solver.reset();
     }},
    {"planner",
     [](NormalObject& object, const char* key, const char* value) {
       wrc::set_planner(object.options, key, value);
       object.solver.reset();
     }},
});

const wrc::Grid& grid_of(const NormalResult& result) {
  return result.patches.front().grid;
}

const std::vector<double>& pressure_of(const NormalResult& result) {
  return result.solution.patches.front().pressure;
}

const std::vector<double>& displacement_of(NormalResult& result) {
  if (result.displacement.empty()) {
    std::vector<double> displacement(pressure_of(result).size());
    wrc::DisplacementOperator(grid_of(result), result.problem.combined_modulus,
                              result.problem.elements)
        .apply(pressure_of(result), displacement);
    result.displacement.swap(displacement);
  }
  return result.displacement;
}

const wrc::Residuals& residuals_of(NormalResult& result) {
  if (!result.residuals) {
    result.residuals =
        wrc::compute_residuals(result.problem, pressure_of(result), result.solution.approach);
  }
  return *result.residuals;
}

/// With at least this number of elements across a contact its largest pressure is right within 4 %.
/// origin: measured (1500 spheres on grids at random places): it is off by up to 88 % on one
/// element across, 78 % on two, 9 % on three, 8 % on four, 3.3 % on five and 2.2 % on six.
constexpr std::size_t enough_elements = 5;

/// What is doubtful of pressures that solve the problem on its grid.
wrc::Warnings warnings_of(const wrc::PressureRegion& contact) {
  wrc::Warnings warnings;
  if (contact.element_count == 0) {
    return warnings;
  }
  if (contact.touches_edge.any()) {
    warnings.push_back({wrc::WarningClass::grid_edge,
                        "contact reaches the edge of the grid: if the bodies go on beyond it, the "
                        "contact is larger and its pressures are lower"});
  }
  const std::size_t rows = contact.box.lateral_last - contact.box.lateral_first + 1;
  const std::size_t columns = contact.box.longitudinal_last - contact.box.longitudinal_first + 1;
  if (std::min(rows, columns) < enough_elements) {
    warnings.push_back({wrc::WarningClass::accuracy,
                        "contact covers " + std::to_string(rows) + " x " + std::to_string(columns) +
                            " elements, lateral by longitudinal: too few for its pressures; use "
                            "smaller elements",
                        std::numeric_limits<double>::infinity()});
  }
  return warnings;
}

/// A text by its name, the entry of a list such as "warnings.0"; none of another name.
const char* listed_text(const NormalResult& result, std::string_view name) {
  for (std::size_t i = 0; i < result.warnings.size(); ++i) {
    const wrc::Warning& warning = result.warnings[i];
    if (name == "warnings." + std::to_string(i)) {
      return warning.text.c_str();
    }
    if (name == "warning_classes." + std::to_string(i)) {
      return wrc::name_of(warning.kind).data();
    }
    if (name == "warning_grades." + std::to_string(i)) {
      return wrc::name_of(wrc::grade_of(warning)).data();
    }
  }
  return nullptr;
}

struct NormalNumber {
  const char* name;
  double (*of)(NormalResult&);
};

constexpr auto normal_numbers = std::to_array<NormalNumber>({
    {"approach", [](NormalResult& result) { return result.solution.approach; }},
    {"normal_force",
     [](NormalResult& result) { return result.solution.patches.front().normal_force; }},
    {"pmax", [](NormalResult& result) { return result.summary.peak_pressure; }},
    {"pmax_element", [](NormalResult& result) { return result.summary.largest_element_pressure; }},
    {"area",
     [](NormalResult& result) { return wrc::contact_area(grid_of(result), pressure_of(result)); }},
    {"fill",
     [](NormalResult& result) {
       return static_cast<double>(result.summary.element_count) /
              static_cast<double>(grid_of(result).element_count());
     }},
    {"iterations", [](NormalResult& result) { return double(result.solution.iterations); }},
    {"grade", [](NormalResult& result) { return double(wrc::grade_of(result.warnings)); }},
    {"warning_count", [](NormalResult& result) { return double(result.warnings.size()); }},
    {"residuals.load_balance",
     [](NormalResult& result) { return residuals_of(result).load_balance; }},
    {"residuals.least_gap", [](NormalResult& result) { return residuals_of(result).least_gap; }},
    {"residuals.complementarity",
     [](NormalResult& result) { return residuals_of(result).complementarity; }},
});

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
  return wrc::guard(normal, [&](NormalObject& object) {
    object.grid =
        wrc::checked_grid(lateral_count, longitudinal_count, lateral_step, longitudinal_step);
    return WRC_OK;
  });
}

wrc_status wrc_normal_set_distance(wrc_normal* normal, const double* values, int64_t count) {
  return wrc::guard(normal, [&](NormalObject& object) {
    object.distance = std::make_shared<const std::vector<double>>(wrc::copied(
        "values", values, count, [](double value) { return std::isfinite(value); },
        "a distance must be finite, mm"));
    return WRC_OK;
  });
}

wrc_status wrc_normal_set_number(wrc_normal* normal, const char* key, double value) {
  return wrc::guard(normal, [&](NormalObject& object) {
    wrc::set_number_in(normal_number_keys, normal_contact, object.problem, key, value);
    return WRC_OK;
  });
}

wrc_status wrc_normal_set_text(wrc_normal* normal, const char* key, const char* value) {
  return wrc::guard(normal, [&](NormalObject& object) {
    wrc::require_pointer(key, "key");
    wrc::require_pointer(value, "value");
    wrc::entry_in(normal_text_keys, "text", normal_contact, key).set(object, key, value);
    return WRC_OK;
  });
}

wrc_status wrc_normal_solve(wrc_normal* normal) {
  return wrc::guard(normal, [&](NormalObject& object) -> wrc_status {
    if (object.grid.element_count() == 0) {
      wrc::throw_invalid_argument("grid", "none", "wrc_normal_set_grid must be called first");
    }
    if (!object.distance) {
      wrc::throw_invalid_argument("undeformed_distance", "none",
                                  "wrc_normal_set_distance must be called first");
    }
    if (!object.problem.load && !object.problem.approach) {
      wrc::throw_invalid_argument("normal_load and approach", "none set",
                                  "exactly one of the two must be set");
    }
    NormalResult result;
    result.distance = object.distance;
    result.patches.push_back({object.grid, *result.distance});
    result.problem = object.problem;
    result.problem.patches = result.patches;
    result.problem.elements = object.elements.value_or(object.paper_method ? wrc::Elements::constant
                                                                           : wrc::Elements::smooth);
    if (object.paper_method) {
      result.solution = wrc::solve_with_polonsky_keer(result.problem);
    } else {
      if (!object.solver) {
        object.solver.emplace(object.options.planner, object.options.precision);
      }
      result.solution = object.solver->solve(result.problem);
      double& force = result.solution.patches.front().normal_force;
      force = result.problem.load.value_or(force); // without the rounding of the sum
    }
    result.summary = wrc::summarise_pressure(grid_of(result), pressure_of(result));
    result.warnings = warnings_of(result.summary);
    const bool converged = result.solution.stop_reason == wrc::StopReason::tolerance_met;
    std::string error = converged ? "" : "not converged: see stop_reason";
    // From here on nothing fails: the handle has the old results or all of the new ones.
    object.result = std::move(result);
    object.error.swap(error);
    return converged ? WRC_OK : WRC_NOT_CONVERGED;
  });
}

wrc_status wrc_normal_number(wrc_normal* normal, const char* name, double* value) {
  return wrc::with_result(normal, [&](NormalObject&, NormalResult& result) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    const auto& number = wrc::entry_in(normal_numbers, "number", normal_contact, name);
    *value = number.of(result) + 0.0; // without zeros of negative sign
    return WRC_OK;
  });
}

wrc_status wrc_normal_text(wrc_normal* normal, const char* name, const char** value) {
  return wrc::with_result(normal, [&](NormalObject&, NormalResult& result) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    const char* text = listed_text(result, name);
    if (std::string_view(name) == "stop_reason") {
      // Names are string literals, so their views end with a zero byte.
      text = wrc::name_of(result.solution.stop_reason).data();
    }
    if (text == nullptr) {
      wrc::refuse_name("text", normal_contact, name,
                       "stop_reason, warnings.0 ..., warning_classes.0 ..., warning_grades.0 ...");
    }
    *value = text;
    return WRC_OK;
  });
}

wrc_status wrc_normal_field(wrc_normal* normal, const char* name, double* values, int64_t capacity,
                            int64_t* count) {
  return wrc::with_result(normal, [&](NormalObject& object, NormalResult& result) {
    wrc::require_pointer(name, "name");
    const std::string_view requested = name;
    if (requested != "pressure" && requested != "displacement") {
      wrc::refuse_name("field", normal_contact, name, "pressure, displacement");
    }
    const std::size_t length = pressure_of(result).size();
    const double* from = pressure_of(result).data();
    if (requested == "displacement" && capacity >= static_cast<int64_t>(length)) {
      from = displacement_of(result).data();
    }
    return wrc::copy_values(from, length, values, capacity, count, object.error);
  });
}
}
