#include "wrc_sweep/pictures.hpp"

#include <algorithm>
#include <limits>

#include "support/gnuplot.hpp"

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

std::vector<double> warned_places_of(const PictureRequest& picture, const PictureData& data,
                                     Values where, const std::string& result) {
  std::vector<double> places;
  for (const double value : places_of(picture, data)) {
    where.insert_or_assign(picture.x, value);
    const std::int64_t scene = data.find(where);
    if (scene >= 0 && data.is_warned(scene, result)) {
      places.push_back(value);
    }
  }
  return places;
}

std::string warning_note(const PictureData& data, const std::string& marks, bool has_axes) {
  if (data.warned() == 0) {
    return "";
  }
  const std::int64_t all = data.study().scene_count();
  return (has_axes ? "set bmargin 5\n" : "") +
         ("set label 9999 '" + std::to_string(data.warned())) + " of " + std::to_string(all) +
         (all == 1 ? " scene has" : " scenes have") + " warnings" +
         (marks.empty() ? "" : ", shown ") + marks +
         "' at screen 0.006,0.012 left font ',9' tc rgb '#b00000' front\n";
}

std::string end_of_warning_note() {
  return "unset label 9999\n";
}

namespace {

std::string with_value(std::string label, const std::string& value) {
  const auto place = label.find("{}");
  return place == std::string::npos ? label + ' ' + value : label.replace(place, 2, value);
}

} // namespace

std::string series_name(const PictureRequest& picture, const Value& value) {
  return with_value(picture.series_label.value_or(picture.series), text_of(value));
}

std::string series_title(const PictureRequest& picture, const Value& value) {
  return with_value(series_label(picture), without_markup(text_of(value)));
}

std::string series_label(const PictureRequest& picture) {
  return picture.series_label.value_or(without_markup(picture.series));
}

int legend_width(std::size_t lines) {
  constexpr std::size_t most_above = 6;
  constexpr int beside = 240;
  return lines > most_above ? beside : 0;
}

std::string line_style(std::size_t lines) {
  return std::string("set grid back lt 1 lw 1 lc rgb '#d8d8d8'\nset tics out nomirror\n"
                     "set lmargin 10\n") +
         (legend_width(lines) > 0 ? "set key outside right top vertical\n"
                                  : "set rmargin 3\nset key outside top center horizontal\n");
}

std::vector<std::filesystem::path> files_of(const PictureRequest& picture,
                                            const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files{folder / picture.file};
  if (picture.kind == PictureRequest::Kind::conicity) {
    files.push_back(folder / (files[0].stem().string() + "_by_amplitude.csv"));
  }
  return files;
}

void draw_picture(const PictureRequest& picture, const PictureData& data,
                  const std::filesystem::path& folder) {
  const std::vector<std::filesystem::path> files = files_of(picture, folder);
  switch (picture.kind) {
  case PictureRequest::Kind::lines:
    draw_lines(picture, data, files[0]);
    break;
  case PictureRequest::Kind::map:
    draw_map(picture, data, files[0]);
    break;
  case PictureRequest::Kind::patches:
    draw_patches(picture, data, files[0]);
    break;
  case PictureRequest::Kind::connections:
    draw_connections(picture, data, files[0]);
    break;
  case PictureRequest::Kind::conicity:
    draw_conicity(picture, data, files[0], files[1]);
    break;
  }
}

} // namespace driver
