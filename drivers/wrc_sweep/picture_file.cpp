#include "wrc_sweep/study_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "support/gnuplot.hpp"
#include "support/scene.hpp"

namespace driver {
namespace {

std::string in_quotes(const std::string& text) {
  return '"' + text + '"';
}

struct KindName {
  const char* name;
  PictureRequest::Kind kind;
};
constexpr std::array kinds{KindName{"lines", PictureRequest::Kind::lines},
                           KindName{"map", PictureRequest::Kind::map},
                           KindName{"patches", PictureRequest::Kind::patches},
                           KindName{"connections", PictureRequest::Kind::connections},
                           KindName{"conicity", PictureRequest::Kind::conicity},
                           KindName{"ranking", PictureRequest::Kind::ranking}};

PictureRequest::Kind kind_of(const TableReader& reader, const std::string& name) {
  std::string allowed;
  for (const KindName& kind : kinds) {
    if (name == kind.name) {
      return kind.kind;
    }
    allowed += (allowed.empty() ? "" : ", ") + std::string(kind.name);
  }
  reader.refuse("kind", in_quotes(name), "one of " + allowed);
}

PanelRequest read_panel(const toml::table& table, const std::string& name, const Study& study) {
  TableReader reader(table, name);
  PanelRequest panel;
  panel.y_label = reader.text("y_label", "");
  panel.y_factor = reader.number("y_factor", 1.0);
  const std::string style = reader.text("style", "lines");
  if (style != "lines" && style != "points") {
    reader.refuse("style", in_quotes(style), "\"lines\" or \"points\"");
  }
  panel.is_joined = style == "lines";
  panel.statistic = reader.text("statistic", panel.statistic);
  if (panel.statistic != "max" && panel.statistic != "mean" && panel.statistic != "min") {
    reader.refuse("statistic", in_quotes(panel.statistic), "\"max\", \"mean\" or \"min\"");
  }
  for (const toml::table* line_table : reader.tables("lines")) {
    TableReader line_reader(*line_table, name + ".lines");
    LineRequest line;
    line.result = line_reader.text("result", "");
    line.title = line_reader.text("title", "");
    line_reader.refuse_others();
    if (std::find(study.results.begin(), study.results.end(), line.result) == study.results.end()) {
      line_reader.refuse("result", in_quotes(line.result), "a name of study.results");
    }
    panel.lines.push_back(std::move(line));
  }
  reader.refuse_others();
  return panel;
}

/// A key of an axis; others have one value and cannot be drawn.
void check_axis(const TableReader& reader, const char* name, const std::string& key,
                const Study& study) {
  if (study.axis_of(key) < 0) {
    reader.refuse(name, in_quotes(key), "a key that varies in this study");
  }
}

/// A picture of values that the study does not have would be empty.
void check_value(const TableReader& reader, const char* name, const std::string& key,
                 const Value& value, const Study& study) {
  std::string allowed;
  for (const Value& other : study.axes[static_cast<std::size_t>(study.axis_of(key))].values) {
    if (text_of(other) == text_of(value)) {
      return;
    }
    allowed += (allowed.empty() ? "" : ", ") + text_of(other);
  }
  reader.refuse(name, text_of(value), "a value of " + key + ": " + allowed);
}

bool has_numbers(const Axis& axis) {
  return std::all_of(axis.values.begin(), axis.values.end(),
                     [](const Value& value) { return std::holds_alternative<double>(value); });
}

/// The key that varies fastest and whose values are numbers.
std::string default_x(const Study& study) {
  const auto found = std::find_if(study.axes.rbegin(), study.axes.rend(), has_numbers);
  return found != study.axes.rend() ? found->key : study.axes.empty() ? "" : study.axes.back().key;
}

/// Values of an axis in the picture are positions.
void check_numbers(const TableReader& reader, const char* name, const std::string& key,
                   const Study& study) {
  for (const Value& value : study.axes[static_cast<std::size_t>(study.axis_of(key))].values) {
    if (!std::holds_alternative<double>(value)) {
      reader.refuse(name, in_quotes(key),
                    "a key whose values are numbers, not " + in_quotes(text_of(value)));
    }
  }
}

/// Keys of the series that have one value in this study are left out, except from maps.
void check_series(const TableReader& reader, PictureRequest& picture, const Study& study) {
  if (picture.kind == PictureRequest::Kind::map) {
    const std::string key = picture.series.size() == 1 ? picture.series.front() : "";
    check_axis(reader, "series", key, study);
    check_numbers(reader, "series", key, study);
  }
  std::erase_if(picture.series, [&](const std::string& key) {
    if (study.axis_of(key) < 0 && !study.constants().contains(key)) {
      reader.refuse("series", in_quotes(key), "a key of the scene");
    }
    return study.axis_of(key) < 0;
  });
}

void check_panels(const TableReader& reader, const PictureRequest& picture) {
  using Kind = PictureRequest::Kind;
  const bool takes_one = picture.kind == Kind::map || picture.kind == Kind::ranking;
  if ((takes_one || picture.kind == Kind::lines) && picture.panels.empty()) {
    reader.refuse("panels", "[]", "one panel or more, each with lines");
  }
  for (const PanelRequest& panel : picture.panels) {
    if (panel.lines.empty() || (takes_one && panel.lines.size() > 1)) {
      reader.refuse("panels.lines", std::to_string(panel.lines.size()) + " lines",
                    takes_one ? "one" : "one line or more");
    }
  }
}

/// What a kind of picture reads must be among the study's results and fields.
void check_results(const PictureRequest& picture, const Study& study) {
  const auto need = [&](const std::vector<std::string>& have, const std::string& name,
                        const char* list) {
    if (std::find(have.begin(), have.end(), name) == have.end()) {
      throw Failure("picture " + picture.file + " needs \"" + name + "\" in study." + list);
    }
  };
  for (const std::string& name : needed_results(picture)) {
    need(study.results, name, "results");
  }
  if (picture.kind == PictureRequest::Kind::patches) {
    for (const char* name : {"x", "y", "z", "pressure"}) {
      need(study.fields, name, "fields");
    }
  }
}

PictureRequest read_picture(const toml::table& table, const Study& study) {
  TableReader reader(table, "picture");
  PictureRequest picture;
  picture.file = reader.text("file", study.name + ".png");
  picture.kind = kind_of(reader, reader.text("kind", "lines"));
  picture.title = with_values(reader.text("title", study.title), study, without_markup);
  picture.x = reader.text("x", default_x(study));
  picture.x_label = reader.text("x_label", without_markup(picture.x));
  picture.x_factor = reader.number("x_factor", 1.0);
  picture.series_is_list = table["series"].is_array();
  picture.series =
      picture.series_is_list ? reader.texts("series") : words(reader.text("series", ""));
  picture.series_factor = reader.number("series_factor", 1.0);
  if (std::string label = reader.text("series_label", ""); table.contains("series_label")) {
    picture.series_label = std::move(label);
  }
  picture.sides = reader.texts("sides");
  picture.x_values = reader.numbers("x_values");
  picture.pressure_max = reader.number("pressure_max", 0.0);
  picture.where = reader.values("where");
  for (const toml::table* panel : reader.tables("panels")) {
    picture.panels.push_back(read_panel(*panel, "picture.panels", study));
  }
  reader.refuse_others();

  if ((!picture.file.ends_with(".png") && !picture.file.ends_with(".svg")) ||
      picture.file.find('/') != std::string::npos) {
    reader.refuse("file", in_quotes(picture.file),
                  "a name without folder that ends in .png or .svg");
  }
  if (picture.kind != PictureRequest::Kind::ranking) {
    check_axis(reader, "x", picture.x, study);
    check_numbers(reader, "x", picture.x, study);
  }
  for (const double value : picture.x_values) {
    check_value(reader, "x_values", picture.x, value, study);
  }
  check_panels(reader, picture);
  check_series(reader, picture, study);
  for (const auto& [key, value] : picture.where) {
    check_axis(reader, "where", key, study);
    check_value(reader, "where", key, value, study);
  }
  for (const std::string& side : picture.sides) {
    if (side != "left" && side != "right") {
      reader.refuse("sides", in_quotes(side), "\"left\" or \"right\"");
    }
  }
  if (picture.sides.empty()) {
    picture.sides = {"left", "right"};
  }
  check_results(picture, study);
  return picture;
}

/// What a profile is called in pictures: a reconstruction says so, a file is named without folder.
std::string profile_title(const std::string& key, const std::string& value) {
  const std::string name = profile_of(key).empty() ? profile_name(key, value) : value;
  if (!is_standard(name)) {
    std::error_code trouble;
    return std::filesystem::is_regular_file(name, trouble)
               ? std::filesystem::path(name).filename().string()
               : name;
  }
  Profile profile;
  profile.load_standard(name);
  const std::string title = profile.text("title");
  return title.substr(0, title.find(','));
}

/// The value of a key in a title; of several profiles their names, or their number if they are
/// many.
std::optional<std::string> shown_value(const std::string& key, const Study& study) {
  if (const auto found = study.fixed.find(key); found != study.fixed.end()) {
    const std::string value = text_of(found->second);
    return names_profile(key) ? profile_title(key, value) : value;
  }
  const int axis = study.axis_of(key);
  if (axis < 0) { // of a key that is not set, its default
    const Values all = values_in_force(Scene());
    const auto found = all.find(key);
    return found == all.end() ? std::nullopt : std::optional(text_of(found->second));
  }
  if (!names_profile(key)) {
    return std::nullopt;
  }
  constexpr std::size_t most_names = 3;
  const std::vector<Value>& values = study.axes[static_cast<std::size_t>(axis)].values;
  if (values.size() > most_names) {
    return std::to_string(values.size()) + (key.ends_with("rail") ? " rails" : " wheels");
  }
  std::string names;
  for (const Value& value : values) {
    names += (names.empty() ? "" : ", ") + profile_title(key, text_of(value));
  }
  return names;
}

} // namespace

std::string with_values(const std::string& text, const Study& study,
                        const std::function<std::string(const std::string&)>& shown) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) { // values are not searched for keys
    const std::size_t end = text[at] == '{' ? text.find('}', at) : std::string::npos;
    const auto value = end == std::string::npos
                           ? std::nullopt
                           : shown_value(text.substr(at + 1, end - at - 1), study);
    if (!value) {
      out += text[at++];
      continue;
    }
    out += shown(*value);
    at = end + 1;
  }
  return out;
}

std::vector<std::string> needed_results(const PictureRequest& picture) {
  std::vector<std::string> names;
  if (picture.kind == PictureRequest::Kind::patches) {
    for (const std::string& side : picture.sides) {
      names.push_back(side + ".pmax");
    }
  } else if (picture.kind == PictureRequest::Kind::connections) {
    for (const std::string& side : picture.sides) {
      for (const char* name : {"y", "z", "s_wheel", "w_wheel", "rolling_radius"}) {
        names.push_back(side + ".rigid_contact." + name);
      }
    }
  } else if (picture.kind == PictureRequest::Kind::conicity) {
    names = {"rolling_radius_difference", "left.rigid_contact.angle", "right.rigid_contact.angle"};
  }
  return names;
}

std::vector<PictureRequest> read_pictures(const toml::table& file, const Study& study) {
  std::vector<PictureRequest> pictures;
  const toml::node* node = file.get("picture");
  if (node == nullptr) {
    return pictures;
  }
  if (!node->is_array_of_tables()) {
    throw Failure("picture = " + text_of(*node) + ": must be tables [[picture]]");
  }
  for (const toml::node& entry : *node->as_array()) {
    pictures.push_back(read_picture(*entry.as_table(), study));
  }
  return pictures;
}

} // namespace driver
