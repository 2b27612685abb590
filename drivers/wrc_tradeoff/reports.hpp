/// The measurements as table, CSV (one line a wheel and way) and JSON.
#pragma once

#include <ostream>
#include <vector>

#include "wrc_tradeoff/measure.hpp"

namespace tradeoff {

void print_summary(const std::vector<Measured>& all, std::ostream& out);
void print_csv(const std::vector<Measured>& all, std::ostream& out);
void print_json(const std::vector<Measured>& all, std::ostream& out);

} // namespace tradeoff
