/// Names of results that a study may ask for, and their units.
#pragma once

#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// What most studies want to know, the same for both sides. Nothing that differs from run to run.
std::vector<std::string> default_results();
/// Throw Failure naming what is unknown to the library, whether or not a scene of the study has it.
void check_results(const std::vector<std::string>& names);
void check_fields(const std::vector<std::string>& names);

/// A result of a solved scene; NaN if there is none.
double result_of(const Scene& scene, const std::string& name);

/// Unit of a key or field in the units of a scene: "mm", "MPa", "rad", ...; "1" for ratios and
/// counts.
std::string unit_of(const Scene& scene, const std::string& name);
/// For people: the library's text about a key; of a result its name in words.
std::string long_name_of(const std::string& name);

} // namespace driver
