#include "grid_contact.hpp"

#include <algorithm>

#include "mechanics/normal_contact.hpp"

namespace wrc {

void refuse_name(const char* what, const char* contact, const std::string& name,
                 const std::string& known) {
  throw Error(ErrorCode::unknown_name, std::string("no ") + what + " of a " + contact +
                                           " is named \"" + name + "\"; there are " + known);
}

void refuse_word(const std::string& key, const std::string& text,
                 const std::vector<std::string>& words) {
  std::string allowed;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char* between = i == 0 ? "must be " : (i + 1 == words.size() ? " or " : ", ");
    allowed += between + ('"' + words[i] + '"');
  }
  throw_invalid_argument(key, '"' + text + '"', allowed);
}

Grid checked_grid(std::int64_t lateral_count, std::int64_t longitudinal_count, double lateral_step,
                  double longitudinal_step) {
  Grid grid;
  // A negative number becomes 0, which check_grid refuses too.
  grid.lateral_count = static_cast<std::size_t>(std::max<std::int64_t>(lateral_count, 0));
  grid.longitudinal_count = static_cast<std::size_t>(std::max<std::int64_t>(longitudinal_count, 0));
  grid.lateral_step = lateral_step;
  grid.longitudinal_step = longitudinal_step;
  check_grid(grid);
  return grid;
}

std::vector<double> copied(const char* name, const double* values, std::int64_t count,
                           bool (*permitted)(double), const char* allowed) {
  require_pointer(values, name);
  if (count < 1 || count > static_cast<std::int64_t>(maximum_element_count)) {
    throw_invalid_argument("count", std::to_string(count), "must be between 1 and 2^26");
  }
  const double* end = values + count;
  const double* wrong = std::find_if_not(values, end, permitted);
  if (wrong != end) {
    throw_invalid_argument(std::string(name) + '[' + std::to_string(wrong - values) + ']', *wrong,
                           allowed);
  }
  return {values, end};
}

} // namespace wrc
