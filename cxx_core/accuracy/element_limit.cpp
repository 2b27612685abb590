#include "accuracy/element_limit.hpp"

#include "base/error.hpp"

namespace wrc {

std::string text_of_limit(double wanted, double limit) {
  return "the accuracy needs " + short_text_of(wanted) +
         " elements, but solve.element_limit = " + std::to_string(static_cast<long long>(limit)) +
         " permits fewer: solved less accurately with this number";
}

} // namespace wrc
