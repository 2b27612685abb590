/// Statistics of samples.
#pragma once

#include <vector>

namespace driver {

/// The value below which this share of the values lies, between neighbours; NaN of none.
double quantile(std::vector<double> values, double share);
double median(const std::vector<double>& values);

} // namespace driver
