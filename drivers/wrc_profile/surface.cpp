#include <array>
#include <sstream>

#include "support/gnuplot.hpp"
#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/scene.hpp"
#include "wrc_profile/reports.hpp"

namespace driver {
namespace {

/// Points of a sheet that are drawn, across and along.
constexpr int points_across = 160;
constexpr int points_along = 120;
/// Pixels.
constexpr int surface_width = 1100;
constexpr int surface_height = 800;

/// Place along, lateral and height, with an empty line after each section.
std::string block_of_sheet(Gnuplot& gnuplot, const Profile& profile, std::int64_t sheet) {
  std::ostringstream data;
  data.precision(9);
  for (int i = 0; i <= points_along; ++i) {
    for (int k = 0; k <= points_across; ++k) {
      std::array<double, 3> at{};
      const wrc_status status =
          wrc_profile_surface_at(profile.handle(), sheet, static_cast<double>(k) / points_across,
                                 static_cast<double>(i) / points_along, &at[0], &at[1], &at[2]);
      if (status != WRC_OK) {
        throw Failure(wrc_profile_error(profile.handle()));
      }
      data << at[0] << ' ' << at[1] << ' ' << at[2] << '\n';
    }
    data << '\n';
  }
  return gnuplot.block(data.str());
}

} // namespace

void print_surface(const Profile& profile, bool as_json, std::ostream& out) {
  const std::vector<std::string> lines = profile.surface_lines();
  if (as_json) {
    print_json({{"surface", lines}}, out);
    return;
  }
  for (const std::string& line : lines) {
    out << one_line(line) << '\n';
  }
}

void draw_surface(const Profile& profile, std::int64_t sheets, const std::string& name,
                  bool is_wheel, const std::filesystem::path& path) {
  Gnuplot gnuplot;
  std::string items;
  for (std::int64_t sheet = 0; sheet < sheets; ++sheet) {
    items += (sheet > 0 ? ", " : "") + block_of_sheet(gnuplot, profile, sheet) +
             " using 1:2:3 with pm3d notitle";
  }
  gnuplot.script() << "set title " << gnuplot_text(name) << "\nset xlabel "
                   << (is_wheel ? "'angle, rad'" : "'along the track, mm'")
                   << "\nset ylabel 'lateral, mm'\nset zlabel 'height, mm' rotate\n"
                   << "set xyplane 0.05\nset view 55, 320\nset pm3d depthorder lighting\n"
                   << map_palette << "set cblabel 'height, mm'\nsplot " << items << '\n';
  gnuplot.draw(path, surface_width, surface_height);
}

} // namespace driver
