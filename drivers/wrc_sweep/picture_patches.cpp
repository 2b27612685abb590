// Maps of pressures side by side, all at one scale: a column for each value of the picture's x, a
// row for each side, or for each value of its series.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "support/gnuplot.hpp"
#include "support/numbers.hpp"
#include "support/refined_map.hpp"
#include "wrc_sweep/pictures.hpp"

namespace driver {
namespace {

/// Patches, each in its own plane: mm, positive to the left and forwards.
struct Cell {
  std::vector<std::string> maps; ///< blocks of data
  Range lateral;                 ///< extent of all maps
  Range longitudinal;
  double pmax = std::numeric_limits<double>::quiet_NaN(); ///< also where it has no bound
  double highest = 0.0;                                   ///< of the elements drawn
  bool spoiled = false;
};

struct MapRow {
  std::string label; ///< of the value of the series; empty without a series
  std::string side;
  std::vector<Cell> cells;
};

/// Elements of a patch in its plane.
class Plane {
public:
  Plane(const PictureData& data, const PatchFields& patch)
      : patch_(patch), x_(data.field(patch, "x")), y_(data.field(patch, "y")),
        z_(data.field(patch, "z")), pressure_(data.field(patch, "pressure")) {
    const auto columns = static_cast<std::size_t>(patch.columns);
    const std::size_t last = x_.size() - columns;
    const double dy = y_[last] - y_[0];
    const double dz = z_[last] - z_[0];
    const double length = std::hypot(dy, dz);
    // Rows go to the field side: to the left on the left side.
    const double sign = patch.side == 0 ? 1.0 : -1.0;
    if (length > 0.0) {
      along_y_ = sign * dy / length;
      along_z_ = sign * dz / length;
    }
    double force = 0.0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      force += pressure_[i];
      centre_y_ += pressure_[i] * y_[i];
      centre_z_ += pressure_[i] * z_[i];
    }
    is_empty_ = !(force > 0.0);
    if (!is_empty_) {
      centre_y_ /= force;
      centre_z_ /= force;
    }
  }

  [[nodiscard]] double centre_y() const { return centre_y_; }
  [[nodiscard]] double centre_z() const { return centre_z_; }
  [[nodiscard]] bool empty() const { return is_empty_; }

  /// The values on a finer grid; `shift` is where the centre of the patch lies in its cell.
  [[nodiscard]] std::string data(double shift, Cell& cell) const {
    const RefinedMap map(x_.size() / static_cast<std::size_t>(patch_.columns),
                         static_cast<std::size_t>(patch_.columns));
    const auto x = map.linear(x_);
    const auto y = map.linear(y_);
    const auto z = map.linear(z_);
    const auto pressure = map.pressure(pressure_);
    std::ostringstream out;
    out.precision(9);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double s = shift + (y[i] - centre_y_) * along_y_ + (z[i] - centre_z_) * along_z_;
      out << s << ' ' << x[i] << ' ' << pressure[i] << '\n'
          << ((i + 1) % map.columns() == 0 ? "\n" : "");
      if (pressure[i] > 0.0) {
        cell.lateral.include(s);
        cell.longitudinal.include(x[i]);
        cell.highest = std::max(cell.highest, pressure[i]);
      }
    }
    return out.str();
  }

private:
  const PatchFields& patch_;
  const std::vector<double>& x_;
  const std::vector<double>& y_;
  const std::vector<double>& z_;
  const std::vector<double>& pressure_;
  double along_y_ = 1.0;
  double along_z_ = 0.0;
  double centre_y_ = 0.0;
  double centre_z_ = 0.0;
  bool is_empty_ = true;
};

Cell cell_of(Gnuplot& gnuplot, const PictureData& data, std::int64_t scene, std::size_t side) {
  Cell cell;
  if (scene < 0) {
    return cell;
  }
  const Row row = data.row(scene);
  const std::string pmax = std::string(side_names[side]) + ".pmax";
  cell.pmax = data.number(row, pmax);
  cell.spoiled = data.is_spoiled(scene, pmax);
  double first_y = 0.0;
  double first_z = 0.0;
  for (const PatchFields& patch : row.patches) {
    const Plane plane(data, patch);
    // A grid of one row or column is no image.
    if (patch.side != static_cast<std::int32_t>(side) || plane.empty() || patch.rows < 2 ||
        patch.columns < 2) {
      continue;
    }
    if (cell.maps.empty()) {
      first_y = plane.centre_y();
      first_z = plane.centre_z();
    }
    const double dy = plane.centre_y() - first_y;
    const double shift = std::copysign(std::hypot(dy, plane.centre_z() - first_z), dy);
    cell.maps.push_back(gnuplot.block(plane.data(shift, cell)));
  }
  return cell;
}

std::vector<MapRow> rows_of(Gnuplot& gnuplot, const PictureRequest& picture,
                            const PictureData& data, const std::vector<double>& columns) {
  std::vector<MapRow> rows;
  for (const SeriesEntry& entry : series_of(picture, data)) {
    Values where = entry.where;
    for (const std::string& side : picture.sides) {
      MapRow& row = rows.emplace_back();
      row.label = entry.title;
      row.side = side;
      for (const double column : columns) {
        where.insert_or_assign(picture.x, column);
        row.cells.push_back(
            cell_of(gnuplot, data, data.find(where), side == side_names[0] ? 0 : 1));
      }
    }
  }
  return rows;
}

/// Cells as wide and high as the largest of them, with room for labels; mm.
struct Layout {
  static constexpr double head = 9.0; ///< for the values of the columns and what they are
  static constexpr double foot = 5.0; ///< for the scale

  /// `letters`: of the longest label beside the rows.
  Layout(const std::vector<MapRow>& rows, std::size_t columns, std::size_t letters) {
    double highest = 0.0;
    for (const MapRow& row : rows) {
      for (const Cell& cell : row.cells) {
        if (!cell.maps.empty()) {
          cell_width = std::max(cell_width, cell.lateral.length());
          cell_height = std::max(cell_height, cell.longitudinal.length());
        }
        pmax = std::isnan(cell.pmax) ? pmax : std::max(pmax, cell.pmax);
        highest = std::max(highest, cell.highest);
      }
    }
    pmax = pmax > 0.0 ? pmax : highest;
    cell_width += 3.0;
    cell_height += 8.0;
    width = cell_width * static_cast<double>(columns);
    height = cell_height * static_cast<double>(rows.size());
    // As much of the picture's pixels as the letters take, up to half of them.
    constexpr double letter_pixels = 8.0;
    const double wanted = letter_pixels * static_cast<double>(std::min<std::size_t>(letters, 60));
    const double share = std::min(0.5, wanted / std::clamp(6.0 * width, least_pixels, most_pixels));
    margin = std::max(14.0, width * share / (1.0 - share));
  }

  static constexpr double least_pixels = 900.0; ///< of rows with their labels
  static constexpr double most_pixels = 1600.0;

  double margin = 0.0; ///< for the labels of the rows
  double cell_width = 4.0;
  double cell_height = 4.0;
  double width = 0.0; ///< of all cells
  double height = 0.0;
  double pmax = 0.0; ///< of the scale: of all cells, or of elements where none has a bound
};

void write_frame(std::ostream& out, const PictureRequest& picture, const Layout& layout) {
  const bool cut = picture.pressure_max > 0.0 && picture.pressure_max < layout.pmax;
  const double darkest = std::max(cut ? picture.pressure_max : layout.pmax, 1.0);
  constexpr double bar = 10.0;
  const double scale_y = -layout.height - 0.5 * Layout::foot;
  out << "unset key\nunset tics\nunset border\nset size ratio -1\nset title "
      << gnuplot_text(picture.title, Markup::subscripts) << "\nset cblabel 'pressure, MPa"
      << (cut ? " (darkest: this and more)" : "") << "' offset 1\nset cbtics\n"
      << map_palette << "set xrange [" << -layout.margin << ':' << layout.width << "]\nset yrange ["
      << -layout.height - Layout::foot << ':' << Layout::head << "]\nset cbrange [0:" << darkest
      << "]\nset label " << gnuplot_text(picture.x_label, Markup::subscripts) << " at "
      << 0.5 * layout.width << ',' << 0.75 * Layout::head << " center"
      << "\nset arrow from 0," << scale_y << " rto " << bar << ",0 heads size 1,90 lw 1.5\n"
      << "set label '10 mm; left is left, forward is up; below each patch p_{max} in MPa' at "
      << bar + 2.0 << ',' << scale_y << '\n';
}

} // namespace

void draw_patches(const PictureRequest& picture, const PictureData& data,
                  const std::filesystem::path& path) {
  Gnuplot gnuplot;
  std::ostream& out = gnuplot.script();
  const std::vector<double> columns = places_of(picture, data);
  const std::vector<MapRow> rows = rows_of(gnuplot, picture, data, columns);
  std::size_t letters = std::string_view("right wheel").size();
  for (const MapRow& row : rows) {
    letters = std::max(letters, row.label.size());
  }
  const Layout layout(rows, columns.size(), letters);
  write_frame(out, picture, layout);
  out << warning_note(data, "by (!)", false);
  const auto column_middle = [&layout](std::size_t column) {
    return (static_cast<double>(column) + 0.5) * layout.cell_width;
  };
  for (std::size_t j = 0; j < columns.size(); ++j) {
    out << "set label '" << text_of(picture.x_factor * columns[j]) << "' at " << column_middle(j)
        << ',' << 0.25 * Layout::head << " center\n";
  }
  std::vector<std::string> items;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double y = -(static_cast<double>(i) + 0.5) * layout.cell_height;
    const std::string side = gnuplot_text(rows[i].side + " wheel");
    out << "set label "
        << (rows[i].label.empty()
                ? side
                : '(' + gnuplot_text(rows[i].label, Markup::subscripts) + ".\"\\n\"." + side + ')')
        << " at " << -layout.margin << ',' << y << '\n';
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const Cell& cell = rows[i].cells[j];
      const bool is_drawn = !cell.maps.empty();
      out << "set label '"
          << (!std::isnan(cell.pmax) ? fixed(cell.pmax, 0)
              : is_drawn             ? "no bound"
                                     : "failed")
          << (cell.spoiled ? " (!)" : "") << "' at " << column_middle(j) << ','
          << y - 0.5 * layout.cell_height + 2.0 << " center\n";
      // Each contact in the middle of its cell, wherever it lies on the wheel.
      for (const std::string& map : cell.maps) {
        items.push_back(map + " using (" + text_of(column_middle(j) + cell.lateral.middle()) +
                        "-$1):($2+(" + text_of(y + 1.0 - cell.longitudinal.middle()) +
                        ")):($3 > 0 ? $3 : NaN) with image");
      }
    }
  }
  gnuplot.plot(items);

  constexpr double beside_width = 140.0; // pixels, for the colour box
  constexpr double above = 70.0;         // pixels, for the title
  const double wide = layout.width + layout.margin;
  const double pixels = std::clamp(6.0 * wide, Layout::least_pixels, Layout::most_pixels);
  const double high = layout.height + Layout::head + Layout::foot;
  gnuplot.draw(path, static_cast<int>(pixels + beside_width),
               static_cast<int>(pixels / wide * high + above));
}

} // namespace driver
