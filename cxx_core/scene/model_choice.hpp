/// Which contact model a scene is solved with, and why: in words, for the results.
#pragma once

#include <optional>
#include <string>

#include "keys/scene.hpp"
#include "wheel/approximate_wheel.hpp"

namespace wrc {

struct ModelChoice {
  std::optional<ApproximateModel> approximate; ///< none: the half-space
  std::string name;
  std::string reason;
};

/// `model` "auto" takes the half-space: see docs/evidence/models.md.
ModelChoice choose_model(const Scene& scene);

} // namespace wrc
