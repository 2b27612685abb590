/// Statistics of samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace driver {

/// The value below which this fraction of the values lies, interpolated between neighbours; NaN of
/// none.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

/// NaN of none.
inline double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

inline double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}

/// A member of all entries of a list.
template <class Entry, class Member>
std::vector<double> all_of(const std::vector<Entry>& entries, Member Entry::*member) {
  std::vector<double> values;
  values.reserve(entries.size());
  for (const Entry& entry : entries) {
    values.push_back(entry.*member);
  }
  return values;
}

} // namespace driver
