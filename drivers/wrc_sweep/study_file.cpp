#include "wrc_sweep/study_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

#include "support/scene_file.hpp"
#include "support/toml.hpp"
#include "wrc_sweep/result_names.hpp"
#include "wrc_sweep/shipped_studies.hpp"

namespace driver {
namespace {

/// Largest number of values of a key, and of scenes of a study: each is kept in memory, with about
/// ten bytes.
constexpr double most_values = 1e6;
constexpr double most_scenes = 1e7;

/// 12 digits: 0.1, 0.2, 0.3 instead of 0.30000000000000004.
double rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.12g", value);
  return std::strtod(text.data(), nullptr);
}

std::vector<Value> range_values(const std::string& key, const toml::table& range) {
  const auto refuse = [&](const std::string& allowed) {
    throw Failure(key + " = " + text_of(range) + ": must be " + allowed);
  };
  const std::string form = "{from, to, step} or {from, to, count}";
  for (const auto& [name, node] : range) {
    const bool known = name == "from" || name == "to" || name == "step" || name == "count";
    if (!known || !number_of(node)) {
      refuse(form + " with numbers");
    }
  }
  const auto number = [&](const char* name) { return range[name].value<double>(); };
  const auto from = number("from");
  const auto to = number("to");
  const auto step = number("step");
  const auto count = number("count");
  if (!from || !to || step.has_value() == count.has_value()) {
    refuse(form);
  }
  constexpr double slack = 1e-9; // of a step: `to` itself belongs to the range
  // Of a step: 1e5 steps of 16 digits end closer, a step of four digits that does not fit farther
  // off.
  constexpr double ending_slack = 1e-6;
  double values = 0.0;
  if (step) {
    values = std::floor((*to - *from) / *step + slack) + 1.0;
    if (!(values >= 1.0) || !(values <= most_values)) {
      refuse("given with a step that leads from `from` to `to` in less than 1e6 steps");
    }
    const double steps = std::max(1.0, std::round((*to - *from) / *step));
    if (std::abs(*from + steps * *step - *to) > ending_slack * std::abs(*step) && *to != *from) {
      refuse("given with a step that ends at `to`, such as step = " +
             text_of(rounded((*to - *from) / steps)) +
             ", or to = " + text_of(rounded(*from + (values - 1.0) * *step)));
    }
  } else {
    values = *count;
    if (!(values >= 2.0) || !(values <= most_values) || values != std::floor(values)) {
      refuse("given with a count that is a whole number, 2 to 1e6");
    }
  }
  const double width = step ? *step : (*to - *from) / (values - 1.0);
  std::vector<Value> all;
  for (double i = 0.0; i < values; ++i) {
    all.emplace_back(rounded(*from + i * width));
  }
  return all;
}

/// The key of a profile, of which the file is what its text says without options.
std::string without_file(const std::string& key) {
  const std::string profile = profile_of(key);
  return key == profile + ".file" ? profile : key;
}

/// Reads keys with one or more values; remembers the positions of axes in the file.
class KeyReader {
public:
  explicit KeyReader(std::string path) : path_(std::move(path)) {}

  void read(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
      const std::string name = without_file(name_within(prefix, key));
      if (prefix.empty() && (name == "study" || name == "picture")) {
        continue;
      }
      const toml::table* inner = node.as_table();
      if (inner != nullptr && !inner->contains("from")) {
        read(*inner, name + '.');
      } else {
        set(name, node);
      }
    }
  }

  void set_bare(const std::string& key, const std::string& value) {
    remove(key);
    assigned_.insert(key);
    fixed_.insert_or_assign(key, Bare{value});
  }

  void set_names(const std::string& key, const std::vector<std::string>& names) {
    if (names.size() == 1) {
      set_bare(key, names.front());
    } else if (!names.empty()) {
      assigned_.insert(key);
      put_axis(key, {names.begin(), names.end()}, behind_all, 0);
    }
  }

  void move_to(Study& study) {
    std::stable_sort(axes_.begin(), axes_.end(),
                     [](const PlacedAxis& one, const PlacedAxis& other) {
                       return std::tie(one.line, one.column) < std::tie(other.line, other.column);
                     });
    study.fixed = std::move(fixed_);
    study.assigned = std::move(assigned_);
    for (PlacedAxis& axis : axes_) {
      study.axes.push_back(std::move(axis.axis));
    }
  }

  /// Later ones, from the command line, vary faster than those of the file.
  void start_assignments() { from_command_line_ = true; }

private:
  static constexpr std::size_t behind_all = std::size_t{1} << 30U;

  struct PlacedAxis {
    std::size_t line = 0;
    std::size_t column = 0;
    Axis axis;
  };

  /// On the command line a profile comes without the options that the file gives another one.
  void remove(const std::string& key) {
    const auto is_gone = [&](const std::string& one) {
      return one == key ||
             (from_command_line_ && profile_of(one) == key && !assigned_.contains(one));
    };
    std::erase_if(fixed_, [&](const auto& entry) { return is_gone(entry.first); });
    std::erase_if(axes_, [&](const PlacedAxis& axis) { return is_gone(axis.axis.key); });
  }

  [[nodiscard]] Value one(const std::string& key, const toml::node& node) const {
    Value value = value_of(key, node);
    if (std::string* name = std::get_if<std::string>(&value); name && names_profile(key)) {
      *name = from_command_line_ ? *name : beside(path_, key, *name);
    }
    return value;
  }

  /// Names file and line of a key that the library does not know.
  void refuse_unknown(const std::string& key, const toml::node& node) const {
    try {
      (void)scene_.key_unit(key);
    } catch (const wrcontact::Error& error) {
      throw Failure("study file " + path_ + ", line " + std::to_string(node.source().begin.line) +
                    ": " + error.what());
    }
  }

  /// Whether a list is one value of this key (solve.grid).
  [[nodiscard]] static bool is_one_value(const std::string& key, const toml::array& list) {
    return takes_list(key) && std::all_of(list.begin(), list.end(), [](const toml::node& entry) {
             return entry.is_number();
           });
  }

  void set(const std::string& key, const toml::node& node) {
    if (from_command_line_) {
      assigned_.insert(key);
    } else {
      refuse_unknown(key, node);
    }
    std::vector<Value> values;
    if (const toml::table* range = node.as_table()) {
      values = range_values(key, *range);
    } else if (const toml::array* array = node.as_array(); array && !is_one_value(key, *array)) {
      for (const toml::node& entry : *array) {
        values.push_back(one(key, entry));
      }
      if (values.empty()) {
        throw Failure(key + " = []: must be a list of at least one value");
      }
    } else {
      remove(key);
      fixed_.insert_or_assign(key, one(key, node));
      return;
    }
    const auto place = node.source().begin;
    put_axis(key, std::move(values), from_command_line_ ? behind_all : place.line, place.column);
  }

  void put_axis(const std::string& key, std::vector<Value> values, std::size_t line,
                std::size_t column) {
    // A key that was varied already keeps its position.
    const auto old = std::find_if(axes_.begin(), axes_.end(),
                                  [&](const PlacedAxis& axis) { return axis.axis.key == key; });
    PlacedAxis placed{line, column, {key, std::move(values)}};
    if (old != axes_.end()) {
      placed.line = old->line;
      placed.column = old->column;
    }
    remove(key);
    axes_.push_back(std::move(placed));
  }

  Scene scene_; ///< that knows the keys
  std::string path_;
  bool from_command_line_ = false;
  Values fixed_;
  std::set<std::string> assigned_;
  std::vector<PlacedAxis> axes_;
};

void read_study_table(const toml::table& file, Study& study) {
  const toml::node* node = file.get("study");
  if (node == nullptr) {
    return;
  }
  const toml::table* table = node->as_table();
  if (table == nullptr) {
    throw Failure("study = " + text_of(*node) + ": must be a table [study]");
  }
  TableReader reader(*table, "study");
  study.name = reader.text("name", study.name);
  study.title = reader.text("title", study.title);
  study.results = reader.texts("results");
  study.fields = reader.texts("fields");
  reader.refuse_others();
  if (study.name.empty() || study.name.find('/') != std::string::npos) {
    throw Failure("study.name = \"" + study.name + "\": must be a file name without folder");
  }
}

/// Each value of each key on a scene that has all other keys, so that errors are reported before
/// anything is solved.
void try_values(const Study& study) {
  Scene scene;
  study.apply(0, scene);
  for (const Axis& axis : study.axes) {
    for (const Value& value : axis.values) {
      set_value(scene, axis.key, value);
    }
  }
  double count = 1.0;
  for (const Axis& axis : study.axes) {
    count *= static_cast<double>(axis.values.size());
  }
  if (count > most_scenes) {
    throw Failure("the study has " + text_of(count) + " scenes; must be at most 1e7");
  }
}

/// The files that a list of slices names: in quotes, one to a line, % begins a comment.
std::set<std::string> slices_of(const InputFile& list) {
  std::set<std::string> files;
  std::istringstream lines(list.content);
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.find('%'), line.size()));
    const std::size_t first = line.find_first_of("'\"");
    const std::size_t last = line.find_last_of("'\"");
    if (first != std::string::npos && last > first + 1) {
      std::string name = line.substr(first + 1, last - first - 1);
      std::replace(name.begin(), name.end(), '\\', '/');
      files.insert((std::filesystem::path(list.path).parent_path() / name).string());
    }
  }
  return files;
}

/// The study and the profiles that are files, with their slices.
std::vector<InputFile> inputs_of(InputFile file, const Study& study) {
  std::set<std::string> profiles;
  const auto take = [&](const std::string& key, const Value& value) {
    if (names_profile(key)) {
      Scene scene;
      set_value(scene, key, value);
      profiles.merge(profile_files(scene));
    }
  };
  for (const auto& [key, value] : study.fixed) {
    take(key, value);
  }
  for (const Axis& axis : study.axes) {
    for (const Value& value : axis.values) {
      take(axis.key, value);
    }
  }
  std::vector<InputFile> inputs{std::move(file)};
  std::set<std::string> slices;
  for (const std::string& profile : profiles) {
    inputs.push_back(read_input(profile));
    if (profile.ends_with(".slcs") || profile.ends_with(".slcw")) {
      slices.merge(slices_of(inputs.back()));
    }
  }
  std::transform(slices.begin(), slices.end(), std::back_inserter(inputs), read_input);
  return inputs;
}

/// The text of a shipped study, null if there is none of this name or a file is meant.
const char* shipped_text(const std::string& name) {
  std::error_code ignored;
  const auto found = std::find_if(std::begin(shipped_study_texts), std::end(shipped_study_texts),
                                  [&](const ShippedStudy& study) { return study.name == name; });
  const bool is_file =
      std::filesystem::exists(name, ignored) && !std::filesystem::is_directory(name, ignored);
  return is_file || found == std::end(shipped_study_texts) ? nullptr : found->text;
}

/// Where the file of a shipped study is, with profiles beside it: from the program's folder,
/// whether it is installed or in the build folder. Without such a folder profiles are looked up by
/// their names alone.
std::string shipped_path(const std::string& name) {
  std::error_code trouble;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", trouble);
  return (program.parent_path() / studies_from_program / (name + ".toml"))
      .lexically_normal()
      .string();
}

/// The first sentence of the comment that a study begins with.
std::string purpose_of(const std::string& text) {
  std::string purpose;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && line.starts_with("# ");) {
    purpose += (purpose.empty() ? "" : " ") + line.substr(2);
  }
  purpose = purpose.substr(0, purpose.find(". "));
  return purpose.substr(0, purpose.find_last_not_of('.') + 1);
}

} // namespace

std::vector<std::pair<std::string, std::string>> shipped_studies() {
  std::vector<std::pair<std::string, std::string>> studies;
  for (const ShippedStudy& study : shipped_study_texts) {
    studies.emplace_back(study.name, purpose_of(study.text));
  }
  return studies;
}

Study read_study(const std::string& path, const StudyChanges& changes) {
  const char* const shipped = shipped_text(path);
  if (std::error_code ignored; shipped == nullptr && !std::filesystem::exists(path, ignored)) {
    std::string names;
    for (const ShippedStudy& study : shipped_study_texts) {
      names.append(" ").append(study.name);
    }
    throw Failure("study file " + path + ": no such file; shipped studies are" + names);
  }
  const toml::table file =
      shipped != nullptr ? parse_toml("study", path, shipped) : read_toml("study file", path);
  Study study;
  study.name = std::filesystem::path(path).stem().string();
  KeyReader reader(shipped != nullptr ? shipped_path(path) : path);
  reader.read(file, "");
  reader.start_assignments();
  for (const std::string& text : changes.assignments) {
    const Assignment assignment = split_assignment(text);
    if (assignment.is_toml()) {
      reader.read(parse_assignment(text, assignment.key, assignment.value), "");
    } else {
      reader.set_bare(without_file(assignment.key), assignment.value);
    }
  }
  reader.set_names("wheelset.wheel", changes.wheels);
  reader.set_names("track.rail", changes.rails);
  reader.move_to(study);
  try_values(study);
  read_study_table(file, study);
  if (study.results.empty()) {
    study.results = default_results();
  }
  check_results(study.results);
  check_fields(study.fields);
  study.inputs =
      inputs_of(shipped != nullptr ? input_of(path + ".toml", shipped) : read_input(path), study);
  study.pictures = read_pictures(file, study); // their titles escape values of keys
  study.title = with_values(study.title, study, std::identity());
  return study;
}

} // namespace driver
