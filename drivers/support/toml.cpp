#include "support/toml.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "support/input_file.hpp"
#include "support/scene.hpp"

namespace driver {
namespace {

/// Files written by hand are short: a larger one is something else.
constexpr std::size_t largest_file = 1 << 20;
/// Parts of a key, "track.rail" has two. Tables within tables are parsed and destroyed by functions
/// that call themselves: a key of half a million parts would take all of the stack.
constexpr std::size_t most_parts = 64;

/// Whether a run of text that could be a key has more parts than allowed. Points next to each
/// other, as in a comment, and those of numbers in a list do not make a key.
bool has_endless_key(const std::string& text) {
  std::size_t parts = 1;
  char before = '.';
  for (const char letter : text) {
    if (letter == ' ' || letter == '\t') {
      continue;
    }
    if (letter == '\n' || letter == ',' || letter == '=') {
      parts = 1;
    } else if (letter == '.' && before != '.' && ++parts > most_parts) {
      return true;
    }
    before = letter;
  }
  return false;
}

/// Case does not matter in keys: LEFT and left in one table are the same.
void refuse_doubled(const std::string& file, const toml::table& table) {
  std::set<std::string> names;
  for (const auto& [key, node] : table) {
    if (!names.insert(lower_case(key.str())).second) {
      throw Failure(file + ", line " + std::to_string(key.source().begin.line) + ": " +
                    std::string(key.str()) + " occurs twice, in capital and in small letters");
    }
    if (const toml::table* inner = node.as_table()) {
      refuse_doubled(file, *inner);
    }
  }
}

} // namespace

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

toml::table read_toml(const std::string& what, const std::string& path) {
  return parse_toml(what, path, read_file(what, path, largest_file));
}

toml::table parse_toml(const std::string& what, const std::string& path, const std::string& text) {
  const bool has_mark = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  if (const auto zero = text.find('\0'); has_mark || zero != std::string::npos) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(has_mark ? 0 : zero);
    throw Failure(what + ' ' + path + ", line " +
                  std::to_string(1 + std::count(text.begin(), end, '\n')) +
                  ": not UTF-8; is it UTF-16, or no text at all?");
  }
  if (has_endless_key(text)) {
    throw Failure(what + ' ' + path + ": a key has more than " + std::to_string(most_parts) +
                  " parts");
  }
  try {
    toml::table table = toml::parse(text);
    refuse_doubled(what + ' ' + path, table);
    return table;
  } catch (const toml::parse_error& error) {
    std::ostringstream message;
    message << what << ' ' << path << ", line " << error.source().begin.line << ": "
            << error.description();
    throw Failure(message.str());
  }
}

toml::table parse_assignment(const std::string& assignment, const std::string& key,
                             const std::string& value) {
  if (has_endless_key(assignment)) {
    throw Failure("--set: a key has more than " + std::to_string(most_parts) + " parts");
  }
  try {
    return toml::parse(key + " = " + value);
  } catch (const toml::parse_error& error) {
    const char* hint = value.starts_with('[')
                           ? "; give several texts as one, with blanks between them, "
                             "or as a list, each in quotes"
                           : "";
    throw Failure("--set " + assignment + ": " + std::string(error.description()) + hint);
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
    std::string texts; // a list of words is their text
    for (const toml::node& entry : *array) {
      if (entry.is_string() && numbers.empty()) {
        texts += (texts.empty() ? "" : " ") + *entry.value<std::string>();
        continue;
      }
      const auto number = number_of(entry);
      if (!number || !texts.empty()) {
        throw Failure(key + " = " + text_of(node) + ": a list must hold numbers");
      }
      numbers.push_back(*number);
    }
    if (!texts.empty()) {
      return texts;
    }
    return numbers;
  }
  throw Failure(key + " = " + text_of(node) + ": must be a number, a text or a list of numbers");
}

std::string name_within(const std::string& prefix, const toml::key& key) {
  constexpr std::size_t longest = 256;
  std::string name = prefix + lower_case(key.str());
  if (name.size() > longest) {
    throw Failure("key " + name.substr(0, longest / 4) + "...: longer than " +
                  std::to_string(longest) + " bytes");
  }
  return name;
}

bool is_profile(const toml::table& table) {
  return table.contains("file");
}

std::vector<std::string> profile_texts(const std::string& key, const toml::table& table) {
  const auto values_of = [&](const std::string& name, const toml::node& node) {
    const auto text = [&](const toml::node& value) {
      if (!value.is_string() && !value.is_number()) {
        throw Failure(key + '.' + name + " = " + text_of(node) + ": must be a number or a text");
      }
      return value.is_string() ? *value.value<std::string>() : text_of(value);
    };
    std::vector<std::string> values;
    if (const toml::array* list = node.as_array(); list != nullptr && !list->empty()) {
      std::transform(list->begin(), list->end(), std::back_inserter(values), text);
    } else {
      values.push_back(text(node));
    }
    return values;
  };
  std::vector<std::string> texts = values_of("file", *table.get("file"));
  for (const auto& [option, node] : table) {
    const std::string name(option.str());
    if (name == "file") {
      continue;
    }
    const std::vector<std::string> values = values_of(name, node);
    if (values.size() > 1 && texts.size() > 1) {
      throw Failure(key + '.' + name + " = " + text_of(node) + ": must be the only list in it");
    }
    texts.resize(std::max(texts.size(), values.size()), std::string(texts.front()));
    for (std::size_t i = 0; i < texts.size(); ++i) {
      texts[i] += "; " + name + " = " + values[std::min(i, values.size() - 1)];
    }
  }
  return texts;
}

void flatten(const toml::table& table, const std::string& prefix, Values& values) {
  for (const auto& [key, node] : table) {
    const std::string name = name_within(prefix, key);
    const toml::table* inner = node.as_table();
    if (inner != nullptr && is_profile(*inner)) {
      std::vector<std::string> texts = profile_texts(name, *inner);
      if (texts.size() != 1) {
        throw Failure(name + ": must be one profile; wrc_sweep takes lists of values");
      }
      values.insert_or_assign(name, std::move(texts.front()));
    } else if (inner != nullptr) {
      flatten(*inner, name + '.', values);
    } else {
      values.insert_or_assign(name, value_of(name, node));
    }
  }
}

const toml::node* TableReader::find(const char* key, bool (*is)(const toml::node&),
                                    const char* allowed) {
  asked_.emplace_back(key);
  const toml::node* node = table_.get(key);
  if (node != nullptr && !is(*node)) {
    refuse(key, text_of(*node), allowed);
  }
  return node;
}

std::string TableReader::text(const char* key, const std::string& otherwise) {
  const toml::node* node = find(
      key, [](const toml::node& value) { return value.is_string(); }, "a text");
  return node == nullptr ? otherwise : *node->value<std::string>();
}

double TableReader::number(const char* key, double otherwise) {
  const toml::node* node = find(
      key, [](const toml::node& value) { return value.is_number(); }, "a number");
  return node == nullptr ? otherwise : *node->value<double>();
}

std::vector<double> TableReader::numbers(const char* key) {
  const toml::node* node = find(
      key, [](const toml::node& value) { return value.is_array(); }, "a list of numbers");
  return node == nullptr ? std::vector<double>()
                         : std::get<std::vector<double>>(value_of(name_ + '.' + key, *node));
}

std::vector<std::string> TableReader::texts(const char* key) {
  const auto is_list = [](const toml::node& value) {
    const toml::array* array = value.as_array();
    return array != nullptr && std::all_of(array->begin(), array->end(),
                                           [](const auto& entry) { return entry.is_string(); });
  };
  std::vector<std::string> all;
  if (const toml::node* node = find(key, is_list, "a list of texts")) {
    for (const toml::node& entry : *node->as_array()) {
      all.push_back(*entry.value<std::string>());
    }
  }
  return all;
}

std::vector<const toml::table*> TableReader::tables(const char* key) {
  const auto is_list = [](const toml::node& value) { return value.is_array_of_tables(); };
  std::vector<const toml::table*> all;
  if (const toml::node* node = find(key, is_list, "a list of tables")) {
    for (const toml::node& entry : *node->as_array()) {
      all.push_back(entry.as_table());
    }
  }
  return all;
}

Values TableReader::values(const char* key) {
  const auto is_table = [](const toml::node& value) { return value.is_table(); };
  Values all;
  if (const toml::node* node = find(key, is_table, "a table of keys and values")) {
    for (const auto& [name, value] : *node->as_table()) {
      const std::string of(name.str());
      all.emplace(of, value_of(of, value));
    }
  }
  return all;
}

void TableReader::refuse_others() const {
  for (const auto& [key, node] : table_) {
    if (std::find(asked_.begin(), asked_.end(), key.str()) == asked_.end()) {
      std::string allowed;
      for (const std::string& name : asked_) {
        allowed += (allowed.empty() ? "" : ", ") + name;
      }
      throw Failure(name_ + '.' + std::string(key.str()) + ": unknown key; must be one of " +
                    allowed);
    }
  }
}

void TableReader::refuse(const char* key, const std::string& value,
                         const std::string& allowed) const {
  throw Failure(name_ + '.' + key + " = " + value + ": must be " + allowed);
}

} // namespace driver
