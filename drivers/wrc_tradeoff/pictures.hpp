/// The trade on four pictures: work and precision, asked and achieved, estimated and achieved, and
/// which model is enough where.
#pragma once

#include <filesystem>
#include <vector>

#include "wrc_tradeoff/measure.hpp"

namespace tradeoff {

/// Writes tradeoff_work_precision.png, tradeoff_asked.png, tradeoff_estimate.png and
/// tradeoff_models.png (with models measured) into a folder that exists.
void draw_pictures(const std::vector<Measured>& all, const std::filesystem::path& folder,
                   bool with_models);

} // namespace tradeoff
