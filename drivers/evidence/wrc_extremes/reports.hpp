/// The study as table of ranges, JSON and pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "wrc_extremes/row.hpp"

namespace extremes {

void print_table(const std::vector<Row>& rows, std::ostream& out);
nlohmann::json json_of(const std::vector<Row>& rows, std::uint64_t seed);

/// One picture per quantity, extremes_<quantity>.png: residuals and errors over it, and where it is
/// refused or warned of.
void draw_pictures(const std::vector<Row>& rows, const std::filesystem::path& folder);

} // namespace extremes
