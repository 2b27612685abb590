/// Values of keys, as files and command lines give them.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace driver {

/// A value that stands for itself, without quotes: a word or a number, as the key needs it.
struct Bare {
  std::string text;
};
using Value = std::variant<double, std::string, std::vector<double>, Bare>;
using Values = std::map<std::string, Value>;

} // namespace driver
