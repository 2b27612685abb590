#include "wrc_sweep/pictures.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "support/gnuplot.hpp"
#include "support/numbers.hpp"

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
      throw Failure("picture.x = \"" + key + "\": must be a key whose values are numbers, not " +
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

std::vector<double> spoiled_places_of(const PictureRequest& picture, const PictureData& data,
                                      Values where, const std::string& result) {
  std::vector<double> places;
  for (const double value : places_of(picture, data)) {
    where.insert_or_assign(picture.x, value);
    const std::int64_t scene = data.find(where);
    if (scene >= 0 && data.is_spoiled(scene, result)) {
      places.push_back(value);
    }
  }
  return places;
}

std::string warning_note(const PictureData& data, const std::string& marks, bool has_axes) {
  const std::string brief = data.warnings().brief(data.study().scene_count(), marks);
  if (brief.empty()) {
    return "";
  }
  const bool loud = data.warnings().scenes(WRC_DO_NOT_USE) > 0;
  return (has_axes ? "set bmargin 5\n" : "") + ("set label 9999 '" + brief) +
         "' at screen 0.006,character 0.7 left tc rgb '" + (loud ? colour::marked : colour::note) +
         "' front\n";
}

std::string end_of_warning_note() {
  return "unset label 9999\n";
}

std::string beyond_note(const std::vector<double>& values, const Range& range) {
  Range all;
  for (const double value : values) {
    all.include(value);
  }
  const std::string low = all.least < range.least ? "down to " + general(all.least, 4) : "";
  const std::string high = all.greatest > range.greatest ? "up to " + general(all.greatest, 4) : "";
  const std::string both = low + (low.empty() || high.empty() ? "" : ", ") + high;
  return both.empty() ? "" : " (" + both + ')';
}

namespace {

std::string with_value(std::string label, const std::string& value) {
  const auto place = label.find("{}");
  return place == std::string::npos ? label + ' ' + value : label.replace(place, 2, value);
}

/// The last `count` parts of a path.
std::string tail_of(const std::string& path, int count) {
  std::size_t slash = path.size();
  for (; count > 0; --count) {
    slash = slash == 0 ? std::string::npos : path.rfind('/', slash - 1);
    if (slash == std::string::npos) {
      return path;
    }
  }
  return path.substr(slash + 1);
}

/// Values as a picture shows them: a profile's file by its name, with the folders that it takes
/// to distinguish it from the others.
std::vector<std::string> titles_of(const std::string& key, const std::vector<Value>& values) {
  std::vector<std::string> titles;
  std::vector<std::string> texts;
  std::transform(values.begin(), values.end(), std::back_inserter(texts),
                 [](const Value& value) { return text_of(value); });
  for (const std::string& text : texts) {
    std::string title = names_profile(key) ? tail_of(text, 1) : text;
    for (int count = 2; title != text; ++count) {
      const auto same = [&](const std::string& other) {
        return tail_of(other, count - 1) == title;
      };
      if (std::count_if(texts.begin(), texts.end(), same) == 1) {
        break;
      }
      title = tail_of(text, count);
    }
    titles.push_back(std::move(title));
  }
  return titles;
}

} // namespace

std::string series_label(const PictureRequest& picture) {
  return picture.series_label.value_or(
      picture.series.empty() ? "" : without_markup(picture.series.front()));
}

std::vector<SeriesEntry> series_of(const PictureRequest& picture, const PictureData& data) {
  std::vector<SeriesEntry> all{{picture.where, "", "", ""}};
  for (const std::string& key : picture.series) {
    const std::vector<Value> values = data.values_of(key);
    const std::vector<std::string> titles = titles_of(key, values);
    // In a list of keys profiles speak for themselves, a number does not.
    const std::string label =
        !picture.series_is_list || picture.series_label || names_profile(key) ? "" : key + ' ';
    std::vector<SeriesEntry> crossed;
    for (const SeriesEntry& entry : all) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        const char* const comma = entry.name.empty() ? "" : ", ";
        SeriesEntry& made = crossed.emplace_back(entry);
        made.where.insert_or_assign(key, values[i]);
        made.name += comma + label + text_of(values[i]);
        made.shown += comma + label + titles[i];
        made.title += comma + without_markup(label + titles[i]);
      }
    }
    all = std::move(crossed);
  }
  if (!picture.series.empty()) {
    const std::string otherwise = picture.series_is_list ? "{}" : picture.series.front();
    for (SeriesEntry& entry : all) {
      entry.name = with_value(picture.series_label.value_or(otherwise), entry.name);
      entry.shown = with_value(picture.series_label.value_or(otherwise), entry.shown);
      entry.title =
          with_value(picture.series_is_list && !picture.series_label ? "{}" : series_label(picture),
                     entry.title);
    }
  }
  return all;
}

std::string note_of_scenes_left_out(const PictureRequest& picture, const Study& study) {
  std::string note;
  for (const Axis& axis : study.axes) {
    const bool is_shown =
        picture.kind == PictureRequest::Kind::ranking || axis.key == picture.x ||
        picture.where.contains(axis.key) ||
        std::find(picture.series.begin(), picture.series.end(), axis.key) != picture.series.end();
    if (!is_shown && axis.values.size() > 1) {
      note += (note.empty() ? picture.file + " shows " : " and ") + axis.key + " = " +
              text_of(axis.values.front()) + ", the first of " +
              std::to_string(axis.values.size()) + " values,";
    }
  }
  if (!note.empty()) {
    note.back() = ';';
    note += " where = {...} of the picture selects others, and --set one value";
  }
  return note;
}

std::vector<std::filesystem::path> files_of(const PictureRequest& picture,
                                            const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (picture.is_drawn) {
    files.push_back(folder / picture.file);
  }
  const std::string stem = std::filesystem::path(picture.file).stem().string();
  if (picture.kind == PictureRequest::Kind::conicity) {
    files.push_back(folder / (stem + "_by_amplitude.csv"));
  } else if (picture.kind == PictureRequest::Kind::ranking) {
    files.push_back(folder / (stem + ".csv"));
  }
  return files;
}

void draw_picture(const PictureRequest& picture, const PictureData& data,
                  const std::filesystem::path& folder, std::ostream& findings) {
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
    draw_conicity(picture, data, files.front(), files.back(), findings);
    break;
  case PictureRequest::Kind::ranking:
    draw_ranking(picture, data, files.front(), files.back(), findings);
    break;
  }
}

} // namespace driver
