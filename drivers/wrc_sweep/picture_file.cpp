#include "wrc_sweep/picture_file.hpp"

#include <algorithm>
#include <array>

#include "support/profile.hpp"

namespace driver {
namespace {

/// Reads one table; every key has to be asked for, so that a wrong one is told.
class TableReader {
public:
  TableReader(const toml::table& table, std::string name) : table_(table), name_(std::move(name)) {}

  std::string text(const char* key, const std::string& otherwise) {
    const toml::node* node = find(key);
    if (node != nullptr && !node->is_string()) {
      refuse(key, *node, "a text");
    }
    return node == nullptr ? otherwise : *node->value<std::string>();
  }
  double number(const char* key, double otherwise) {
    const toml::node* node = find(key);
    if (node != nullptr && !number_of(*node)) {
      refuse(key, *node, "a number");
    }
    return node == nullptr ? otherwise : *number_of(*node);
  }
  std::vector<double> numbers(const char* key) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return {};
    }
    Value value = value_of(name_ + '.' + key, *node);
    if (auto* numbers = std::get_if<std::vector<double>>(&value)) {
      return std::move(*numbers);
    }
    refuse(key, *node, "a list of numbers");
  }
  std::vector<std::string> texts(const char* key) {
    std::vector<std::string> all;
    if (const toml::node* node = find(key)) {
      const toml::array* array = node->as_array();
      if (array == nullptr) {
        refuse(key, *node, "a list of texts");
      }
      for (const toml::node& entry : *array) {
        if (!entry.is_string()) {
          refuse(key, *node, "a list of texts");
        }
        all.push_back(*entry.value<std::string>());
      }
    }
    return all;
  }
  const toml::array& tables(const char* key) {
    static const toml::array none;
    const toml::node* node = find(key);
    if (node == nullptr) {
      return none;
    }
    if (!node->is_array_of_tables()) {
      refuse(key, *node, "a list of tables");
    }
    return *node->as_array();
  }
  Values values(const char* key) {
    Values all;
    if (const toml::node* node = find(key)) {
      const toml::table* table = node->as_table();
      if (table == nullptr) {
        refuse(key, *node, "a table of keys and values");
      }
      for (const auto& [name, value] : *table) {
        const std::string of(name.str());
        all.emplace(of, value_of(of, value));
      }
    }
    return all;
  }
  void refuse_others() const {
    for (const auto& [key, node] : table_) {
      if (std::find(asked_.begin(), asked_.end(), key.str()) == asked_.end()) {
        std::string allowed;
        for (const std::string& name : asked_) {
          allowed += (allowed.empty() ? "" : ", ") + name;
        }
        throw Failure(name_ + '.' + std::string(key.str()) + ": unknown key; allowed are " +
                      allowed);
      }
    }
  }
  [[noreturn]] void refuse(const char* key, const toml::node& node,
                           const std::string& allowed) const {
    throw Failure(name_ + '.' + key + " = " + text_of(node) + ": allowed is " + allowed);
  }
  [[noreturn]] void refuse(const char* key, const std::string& value,
                           const std::string& allowed) const {
    throw Failure(name_ + '.' + key + " = \"" + value + "\": allowed is " + allowed);
  }

private:
  const toml::node* find(const char* key) {
    asked_.emplace_back(key);
    return table_.get(key);
  }

  const toml::table& table_;
  std::string name_;
  std::vector<std::string> asked_;
};

struct KindName {
  const char* name;
  PictureRequest::Kind kind;
};
constexpr std::array kinds{KindName{"lines", PictureRequest::Kind::lines},
                           KindName{"patches", PictureRequest::Kind::patches},
                           KindName{"connections", PictureRequest::Kind::connections},
                           KindName{"conicity", PictureRequest::Kind::conicity}};

PictureRequest::Kind kind_of(const TableReader& reader, const std::string& name) {
  std::string allowed;
  for (const KindName& kind : kinds) {
    if (name == kind.name) {
      return kind.kind;
    }
    allowed += (allowed.empty() ? "" : ", ") + std::string(kind.name);
  }
  reader.refuse("kind", name, "one of " + allowed);
}

PanelRequest read_panel(const toml::table& table, const std::string& name, const Study& study) {
  TableReader reader(table, name);
  PanelRequest panel;
  panel.y_label = reader.text("y_label", "");
  panel.y_factor = reader.number("y_factor", 1.0);
  for (const toml::node& node : reader.tables("lines")) {
    TableReader line_reader(*node.as_table(), name + ".lines");
    LineRequest line;
    line.result = line_reader.text("result", "");
    line.title = line_reader.text("title", "");
    line_reader.refuse_others();
    if (std::find(study.results.begin(), study.results.end(), line.result) == study.results.end()) {
      line_reader.refuse("result", line.result, "a name of study.results");
    }
    panel.lines.push_back(std::move(line));
  }
  reader.refuse_others();
  return panel;
}

/// A key of an axis; others have one value and no place in a picture.
void check_axis(const TableReader& reader, const char* name, const std::string& key,
                const Study& study) {
  if (study.axis_of(key) < 0) {
    reader.refuse(name, key, "a key that varies in this study");
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
  picture.title = with_values(reader.text("title", study.title), study);
  picture.x = reader.text("x", study.axes.empty() ? "" : study.axes.back().key);
  picture.x_label = reader.text("x_label", picture.x);
  picture.x_factor = reader.number("x_factor", 1.0);
  picture.series = reader.text("series", "");
  picture.series_label = reader.text("series_label", picture.series);
  picture.sides = reader.texts("sides");
  picture.x_values = reader.numbers("x_values");
  picture.pressure_max = reader.number("pressure_max", 0.0);
  picture.where = reader.values("where");
  for (const toml::node& node : reader.tables("panels")) {
    picture.panels.push_back(read_panel(*node.as_table(), "picture.panels", study));
  }
  reader.refuse_others();

  if (!picture.file.ends_with(".png") && !picture.file.ends_with(".svg")) {
    reader.refuse("file", picture.file, "a name that ends in .png or .svg");
  }
  check_axis(reader, "x", picture.x, study);
  if (!picture.series.empty()) {
    check_axis(reader, "series", picture.series, study);
  }
  for (const auto& [key, value] : picture.where) {
    check_axis(reader, "where", key, study);
  }
  for (const std::string& side : picture.sides) {
    if (side != "left" && side != "right") {
      reader.refuse("sides", side, "\"left\" and \"right\"");
    }
  }
  if (picture.sides.empty()) {
    picture.sides = {"left", "right"};
  }
  check_results(picture, study);
  return picture;
}

/// What a profile is called in pictures: a reconstruction says so.
std::string profile_title(const std::string& name) {
  try {
    const std::string title = Profile::standard(name).text("title");
    return title.substr(0, title.find(','));
  } catch (const Failure&) {
    return name; // a file
  }
}

} // namespace

std::string with_values(std::string text, const Study& study) {
  for (const auto& [key, value] : study.fixed) {
    const std::string mark = '{' + key + '}';
    const std::string shown = names_profile(key) ? profile_title(text_of(value)) : text_of(value);
    for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark)) {
      text.replace(at, mark.size(), shown);
    }
  }
  return text;
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
    throw Failure("picture = " + text_of(*node) + ": allowed are tables [[picture]]");
  }
  for (const toml::node& entry : *node->as_array()) {
    pictures.push_back(read_picture(*entry.as_table(), study));
  }
  return pictures;
}

} // namespace driver
