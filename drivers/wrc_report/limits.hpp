/// Limits that a user sets to the quantities of a report, and whether they are kept.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace driver {

/// A number of a report that can have limits.
struct Quantity {
  double value = std::numeric_limits<double>::quiet_NaN();
  double spread = 0.0; ///< half of the range in which it lies in 95 of 100 cases; NaN: unknown
  std::string unit;    ///< mm, MPa, or empty
  std::string meaning;
};
using Quantities = std::map<std::string, Quantity>;

struct Limit {
  std::string quantity;
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  std::string source;
};

/// Of a CSV file with the columns quantity, least, greatest and source; an empty number is no
/// limit. Throws Failure for other columns, for texts where finite numbers should be, and for rows
/// without a limit.
std::vector<Limit> read_limits(const std::string& path);

/// pass, fail, or what is between: a limit within the spread, or no value or spread.
std::string verdict(const Quantity& quantity, const Limit& limit);

/// A row of titles and one for each limit. Throws Failure for an unknown quantity.
std::vector<std::vector<std::string>> limit_rows(const std::vector<Limit>& limits,
                                                 const Quantities& quantities);

} // namespace driver
