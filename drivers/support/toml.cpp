#include "support/toml.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace driver {
namespace {

namespace fs = std::filesystem;

/// Files written by hand are short: a larger one is something else.
constexpr std::uintmax_t largest_file = 1 << 20;

} // namespace

toml::table read_toml(const std::string& what, const std::string& path) {
  std::error_code trouble;
  const auto size = fs::file_size(path, trouble);
  if (trouble) {
    throw Failure(what + ' ' + path + ": " + trouble.message());
  }
  if (size > largest_file) {
    throw Failure(what + ' ' + path + ": " + std::to_string(size) + " bytes; allowed are " +
                  std::to_string(largest_file));
  }
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) {
    throw Failure(what + ' ' + path + ": cannot be read");
  }
  return parse_toml(what, path, text);
}

toml::table parse_toml(const std::string& what, const std::string& path, const std::string& text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    std::ostringstream message;
    message << what << ' ' << path << ", line " << error.source().begin.line << ": "
            << error.description();
    throw Failure(message.str());
  }
}

toml::table parse_assignment(const std::string& assignment, const std::string& key,
                             const std::string& value) {
  try {
    return toml::parse(key + " = " + value);
  } catch (const toml::parse_error& error) {
    throw Failure("--set " + assignment + ": " + std::string(error.description()));
  }
}

std::string text_of(const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& value) { text << value; });
  return text.str();
}

std::optional<double> number_of(const toml::node& node) {
  return node.is_number() ? node.value<double>() : std::nullopt;
}

Value value_of(const std::string& key, const toml::node& node) {
  if (const auto number = number_of(node)) {
    return *number;
  }
  if (const auto text = node.value<std::string>(); text && node.is_string()) {
    return *text;
  }
  if (const toml::array* array = node.as_array()) {
    std::vector<double> numbers;
    for (const toml::node& entry : *array) {
      const auto number = number_of(entry);
      if (!number) {
        throw Failure(key + " = " + text_of(node) + ": allowed in a list are numbers");
      }
      numbers.push_back(*number);
    }
    return numbers;
  }
  throw Failure(key + " = " + text_of(node) +
                ": allowed are a number, a text or a list of numbers");
}

void flatten(const toml::table& table, const std::string& prefix, Values& values) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const toml::table* inner = node.as_table()) {
      flatten(*inner, name + '.', values);
    } else {
      values.insert_or_assign(name, value_of(name, node));
    }
  }
}

Assignment split_assignment(const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw Failure("--set " + assignment + ": allowed is key=value");
  }
  return {assignment.substr(0, equals), assignment.substr(equals + 1)};
}

} // namespace driver
