// Bars of a fleet: the largest, mean or smallest result of each wheel, rail, ..., the largest of
// the first panel on top.
#include <algorithm>
#include <cmath>

#include "support/csv_table.hpp"
#include "support/gnuplot.hpp"
#include "support/output_file.hpp"
#include "support/text_table.hpp"
#include "wrc_sweep/pictures.hpp"

namespace driver {
namespace {

/// One value of a panel.
struct RankedValue {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string at; ///< the values of the other keys there; empty for a mean
};

struct RankedEntry {
  SeriesEntry entry;
  std::vector<RankedValue> values; ///< one for each panel
  std::int64_t scenes = 0;
  std::int64_t not_solved = 0;
  std::int64_t spoiled = 0; ///< not to be used
};

/// Numbers of the scenes that have these values.
std::vector<std::int64_t> scenes_with(const Values& where, const Study& study) {
  std::vector<std::int64_t> scenes;
  for (std::int64_t scene = 0; scene < study.scene_count(); ++scene) {
    const std::vector<std::size_t> places = study.places(scene);
    bool has_all = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto wanted = where.find(study.axes[i].key);
      has_all = has_all && (wanted == where.end() ||
                            text_of(study.axes[i].values[places[i]]) == text_of(wanted->second));
    }
    if (has_all) {
      scenes.push_back(scene);
    }
  }
  return scenes;
}

/// "pose.lateral 4.5", of the keys that are not in `where`.
std::string place_of(std::int64_t scene, const Values& where, const Study& study) {
  std::string text;
  const std::vector<std::size_t> places = study.places(scene);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Axis& axis = study.axes[i];
    if (!where.contains(axis.key)) {
      text += (text.empty() ? "" : ", ") + axis.key + ' ' + text_of(axis.values[places[i]]);
    }
  }
  return text;
}

RankedEntry ranked(SeriesEntry entry, const PictureRequest& picture, const PictureData& data) {
  RankedEntry made;
  const std::vector<std::int64_t> scenes = scenes_with(entry.where, data.study());
  made.scenes = static_cast<std::int64_t>(scenes.size());
  std::vector<Row> rows;
  for (const std::int64_t scene : scenes) {
    rows.push_back(data.row(scene));
    made.not_solved += rows.back().status != WRC_OK ? 1 : 0;
    made.spoiled += grade_of(rows.back().warnings) == WRC_DO_NOT_USE ? 1 : 0;
  }
  for (const PanelRequest& panel : picture.panels) {
    RankedValue& best = made.values.emplace_back();
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double value = panel.y_factor * data.number(rows[i], panel.lines.front().result);
      if (std::isnan(value)) {
        continue;
      }
      sum += value;
      ++count;
      if (std::isnan(best.value) ||
          (panel.statistic == "min" ? value < best.value : value > best.value)) {
        best = {value, place_of(scenes[i], entry.where, data.study())};
      }
    }
    if (panel.statistic == "mean") {
      best = {sum / count, ""}; // NaN without values
    }
  }
  made.entry = std::move(entry);
  return made;
}

/// The label of a tic, which gnuplot takes as the format of a number.
std::string tic_text(const std::string& title) {
  std::string text;
  for (const char letter : gnuplot_text(title, Markup::subscripts)) {
    text += letter == '%' ? "%%" : std::string(1, letter);
  }
  return text;
}

/// Four digits, or all before the point.
std::string value_text(double value) {
  return std::abs(value) >= 1000.0 ? fixed(value, 0) : general(value, 4);
}

/// A round step of which at most five lie in a length: narrow panels have no room for more.
double tic_step(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length / 5.0)));
  double step = power;
  for (const double factor : {2.0, 5.0, 10.0}) {
    step = 5.0 * step < length ? factor * power : step;
  }
  return step;
}

std::string heading_of(const PanelRequest& panel) {
  return panel.statistic + " of " + panel.lines.front().result;
}

void write_ranking(const std::vector<RankedEntry>& entries, const PictureRequest& picture,
                   int digits, const std::filesystem::path& path) {
  OutputFile file(path);
  std::vector<std::string> head = words("rank series");
  for (const PanelRequest& panel : picture.panels) {
    head.push_back(heading_of(panel));
    if (panel.statistic != "mean") {
      head.push_back("at");
    }
  }
  CsvLine(file.stream()).add(head).add(words("scenes not_solved do_not_use"));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    CsvLine line(file.stream());
    line << i + 1 << entries[i].entry.name;
    for (std::size_t k = 0; k < picture.panels.size(); ++k) {
      line << table_text(entries[i].values[k].value, digits);
      if (picture.panels[k].statistic != "mean") {
        line << entries[i].values[k].at;
      }
    }
    line << entries[i].scenes << entries[i].not_solved << entries[i].spoiled;
  }
  file.commit();
}

void print_ranking(const std::vector<RankedEntry>& entries, const PictureRequest& picture,
                   std::ostream& out) {
  TextTable table("rlr");
  std::vector<std::string> head{"rank", "series"};
  for (const PanelRequest& panel : picture.panels) {
    head.push_back(heading_of(panel));
  }
  head.insert(head.end(), {"not solved", "do not use"});
  table.add(head);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::vector<std::string> row{std::to_string(i + 1), one_line(entries[i].entry.shown)};
    for (const RankedValue& value : entries[i].values) {
      row.push_back(std::isnan(value.value) ? "-" : value_text(value.value));
    }
    row.push_back(std::to_string(entries[i].not_solved));
    row.push_back(std::to_string(entries[i].spoiled));
    table.add(std::move(row));
  }
  table.print(out);
}

} // namespace

void draw_ranking(const PictureRequest& picture, const PictureData& data,
                  const std::filesystem::path& path, const std::filesystem::path& table,
                  std::ostream& findings) {
  std::vector<RankedEntry> entries;
  for (SeriesEntry& entry : series_of(picture, data)) {
    entries.push_back(ranked(std::move(entry), picture, data));
  }
  const auto before = [](const RankedEntry& one, const RankedEntry& other) {
    const double a = one.values.front().value;
    const double b = other.values.front().value;
    return std::isnan(b) ? !std::isnan(a) : a > b; // those without a value last
  };
  std::stable_sort(entries.begin(), entries.end(), before);
  write_ranking(entries, picture, data.study().digits, table);
  print_ranking(entries, picture, findings);
  if (!picture.is_drawn) {
    return;
  }

  std::size_t letters = 0; // of the longest name
  Gnuplot gnuplot;
  gnuplot.begin_multiplot(1, picture.panels.size(), picture.title);
  std::ostream& out = gnuplot.script();
  out << "set grid noy\nunset key\nset ytics (";
  for (std::size_t i = 0; i < entries.size(); ++i) {
    letters = std::max(letters, entries[i].entry.shown.size());
    out << (i > 0 ? ", " : "") << tic_text(entries[i].entry.title) << ' ' << i + 1;
  }
  constexpr std::size_t most_letters = 40;
  letters = std::min(letters, most_letters);
  out << ")\nset yrange [" << entries.size() + 1 << ":0]\nset style fill solid 0.85\nset lmargin "
      << letters * 9 / 10 + 4 << "\nset bmargin 5\n"
      << warning_note(data);
  for (std::size_t k = 0; k < picture.panels.size(); ++k) {
    std::ostringstream bars;
    Range range;
    range.include(0.0);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const double value = entries[i].values[k].value;
      if (!std::isnan(value)) {
        bars << value << ' ' << i + 1 << ' ' << value_text(value) << '\n';
        range.include(value);
      }
    }
    const double least = range.least < 0.0 ? 1.2 * range.least : 0.0;
    const double greatest = range.greatest > 0.0 ? 1.2 * range.greatest : 1.0;
    out << "set xlabel " << gnuplot_text(picture.panels[k].y_label, Markup::subscripts)
        << "\nset xrange [" << least << ':' << greatest << "]\nset xtics "
        << tic_step(greatest - least) << '\n';
    const std::string block = bars.str().empty() ? "" : gnuplot.block(bars.str());
    if (block.empty()) {
      gnuplot.plot({});
    } else {
      gnuplot.plot({block + " using ($1/2):2:($1/2):(0.35) with boxxyerror lc rgb '" +
                        line_colour(k, picture.panels.size()) + '\'',
                    block + " using 1:2:3 with labels left offset 0.5,0"});
    }
    out << end_of_warning_note();
  }
  constexpr int bar_height = 34;
  constexpr int letter_width = 7;
  gnuplot.draw(path,
               (330 + letter_width * static_cast<int>(letters)) *
                   static_cast<int>(picture.panels.size()),
               170 + bar_height * static_cast<int>(entries.size()));
}

} // namespace driver
