#include "accuracy/element_limit.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/constants.hpp"
#include "base/error.hpp"

namespace wrc {

double limit_by_accuracy(double accuracy) {
  return std::min(default_element_limit,
                  elements_by_root / std::sqrt(std::min(accuracy, coarsest_accuracy)));
}

std::string text_of_limit(double wanted, double limit) {
  return "the accuracy needs " + short_text_of(wanted) +
         " elements, but solve.element_limit = " + std::to_string(static_cast<long long>(limit)) +
         " permits fewer: solved less accurately with this number";
}

} // namespace wrc
