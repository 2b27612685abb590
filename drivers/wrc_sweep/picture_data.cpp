#include "wrc_sweep/picture_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace driver {

std::vector<Value> PictureData::values_of(const std::string& key) const {
  const int axis = study_.axis_of(key);
  if (axis >= 0) {
    return study_.axes[static_cast<std::size_t>(axis)].values;
  }
  const auto found = study_.fixed.find(key);
  return found == study_.fixed.end() ? std::vector<Value>() : std::vector<Value>{found->second};
}

std::vector<double> PictureData::numbers_of(const std::string& key) const {
  std::vector<double> numbers;
  for (const Value& value : values_of(key)) {
    const double* number = std::get_if<double>(&value);
    if (number == nullptr) {
      throw Failure("picture.x = \"" + key + "\": allowed is a key whose values are numbers, not " +
                    text_of(value));
    }
    numbers.push_back(*number);
  }
  return numbers;
}

std::int64_t PictureData::find(const Values& values) const {
  std::int64_t scene = 0;
  for (const Axis& axis : study_.axes) {
    std::size_t place = 0;
    if (const auto wanted = values.find(axis.key); wanted != values.end()) {
      const auto same = [&](const Value& value) {
        return text_of(value) == text_of(wanted->second);
      };
      place = static_cast<std::size_t>(std::find_if(axis.values.begin(), axis.values.end(), same) -
                                       axis.values.begin());
      if (place == axis.values.size()) {
        return -1;
      }
    }
    scene =
        scene * static_cast<std::int64_t>(axis.values.size()) + static_cast<std::int64_t>(place);
  }
  return scene;
}

double PictureData::number(const Row& row, const std::string& name) const {
  const auto found = std::find(study_.results.begin(), study_.results.end(), name);
  return found == study_.results.end()
             ? std::numeric_limits<double>::quiet_NaN()
             : row.values[static_cast<std::size_t>(found - study_.results.begin())];
}

const std::vector<double>& PictureData::field(const PatchFields& patch,
                                              const std::string& name) const {
  const auto found = std::find(study_.fields.begin(), study_.fields.end(), name);
  return patch.values.at(static_cast<std::size_t>(found - study_.fields.begin()));
}

std::vector<double> places_of(const PictureRequest& picture, const PictureData& data) {
  return picture.x_values.empty() ? data.numbers_of(picture.x) : picture.x_values;
}

std::vector<double> line_of(const PictureRequest& picture, const PictureData& data, Values where,
                            const std::string& result) {
  std::vector<double> line;
  for (const double value : places_of(picture, data)) {
    where.insert_or_assign(picture.x, value);
    const std::int64_t scene = data.find(where);
    line.push_back(scene < 0 ? std::numeric_limits<double>::quiet_NaN()
                             : data.number(data.row(scene), result));
  }
  return line;
}

std::string multiplot(int rows, std::size_t columns, const std::string& title) {
  std::string quoted; // double quotes, since the line below the title is empty but not nothing
  for (const char letter : title) {
    if (letter == '"' || letter == '\\') {
      quoted += '\\';
    }
    quoted += letter;
  }
  return "set multiplot layout " + std::to_string(rows) + ',' + std::to_string(columns) +
         " title \"" + quoted + "\\n \" font ',12'\n";
}

std::string series_name(const PictureRequest& picture, const Value& value) {
  std::string name = picture.series_label;
  const auto place = name.find("{}");
  return place == std::string::npos ? name + ' ' + text_of(value)
                                    : name.replace(place, 2, text_of(value));
}

const char* const line_style = "set grid back lt 1 lw 1 lc rgb '#d8d8d8'\nset tics out nomirror\n"
                               "set lmargin 10\nset rmargin 3\n"
                               "set key outside top center horizontal\n";

void AxisRange::include(double value) {
  if (!std::isnan(value)) {
    least_ = empty_ ? value : std::min(least_, value);
    greatest_ = empty_ ? value : std::max(greatest_, value);
    empty_ = false;
  }
}

std::string AxisRange::command(const std::string& axis) const {
  constexpr double room = 0.05;
  constexpr double rounding = 1e-9;
  const double size = std::max(std::abs(least_), std::abs(greatest_));
  const double width = greatest_ - least_;
  const double beyond = width > rounding * size ? room * width : size > 0.0 ? room * size : 1.0;
  return "set " + axis + "range [" + text_of(least_ - beyond) + ':' + text_of(greatest_ + beyond) +
         "]\n";
}

const char* line_colour(std::size_t index) {
  constexpr std::array colours{"#0060ad", "#d55e00", "#009e73", "#7030a0", "#a08000", "#404040"};
  return colours[index % colours.size()];
}

} // namespace driver
