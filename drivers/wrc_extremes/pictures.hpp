/// One picture a quantity: residuals and errors over it, and where it is refused or warned of.
#pragma once

#include <filesystem>
#include <vector>

#include "wrc_extremes/row.hpp"

namespace extremes {

/// Writes extremes_<quantity>.png for each quantity that has rows.
void draw_pictures(const std::vector<Row>& rows, const std::filesystem::path& folder);

} // namespace extremes
