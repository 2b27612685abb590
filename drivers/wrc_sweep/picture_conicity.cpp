// Conicity of each value of a series, drawn and as a table by amplitude.
#include <algorithm>
#include <cmath>

#include "reports/conicity_curves.hpp"
#include "support/csv_table.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "wrc_sweep/pictures.hpp"

namespace driver {
namespace {

ConicityCurve curve_of(const PictureRequest& picture, const PictureData& data,
                       const SeriesEntry& entry) {
  PictureRequest ascending = picture;
  std::vector<double>& lateral = ascending.x_values;
  lateral = places_of(picture, data);
  std::sort(lateral.begin(), lateral.end());
  lateral.erase(std::unique(lateral.begin(), lateral.end()), lateral.end());
  const auto line = [&](const char* name) { return line_of(ascending, data, entry.where, name); };
  ConicityCurve curve =
      conicity_curve(lateral, line("rolling_radius_difference"), line("left.rigid_contact.angle"),
                     line("right.rigid_contact.angle"));
  if (!curve.lateral.empty()) {
    Values where = entry.where;
    where.insert_or_assign(picture.x, curve.lateral.front());
    Scene scene;
    data.study().apply(data.find(where), scene);
    add_spread(curve, std::move(scene), picture.x);
  }
  curve.name = entry.name;
  curve.title =
      entry.title + (entry.title.empty() ? "" : ": ") +
      (std::isnan(curve.standard()) ? "none at 3 mm" : fixed(curve.standard(), 3) + " at 3 mm");
  return curve;
}

void write_table(const std::vector<ConicityCurve>& curves, int digits,
                 const std::filesystem::path& path) {
  OutputFile file(path);
  CsvLine(file.stream()).add(words("series amplitude equivalent_conicity spread message"));
  for (const ConicityCurve& curve : curves) {
    for (std::size_t i = 0; i < curve.amplitude.size(); ++i) {
      CsvLine(file.stream()) << curve.name << text_of(curve.amplitude[i])
                             << table_text(curve.conicity[i], digits)
                             << (curve.spread.empty() ? "" : table_text(curve.spread[i], digits))
                             << curve.no_conicity[i];
    }
  }
  file.commit();
}

} // namespace

void draw_conicity(const PictureRequest& picture, const PictureData& data,
                   const std::filesystem::path& path, const std::filesystem::path& table,
                   std::ostream& findings) {
  std::vector<ConicityCurve> curves;
  for (const SeriesEntry& entry : series_of(picture, data)) {
    curves.push_back(curve_of(picture, data, entry));
    findings << curves.back().in_words(entry.shown) << '\n';
  }
  write_table(curves, data.study().digits, table);
  if (!picture.is_drawn) {
    return;
  }
  draw_conicity_curves(curves, picture.title, path, warning_note(data), end_of_warning_note());
}

} // namespace driver
