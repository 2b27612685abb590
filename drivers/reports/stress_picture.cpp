#include "reports/stress_picture.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "reports/patches.hpp"
#include "support/numbers.hpp"

namespace driver {

void plot_stress(Gnuplot& gnuplot, const Scene& scene, const std::string& side) {
  std::ostream& out = gnuplot.script();
  const auto patches = parts_with(scene, patches_of(scene, side), stress_result);
  // That of the greatest stress.
  const PatchName& patch =
      *std::max_element(patches.begin(), patches.end(), [&](const auto& one, const auto& other) {
        return scene.number(one.prefix + stress_result) <
               scene.number(other.prefix + stress_result);
      });
  const std::vector<double> places = scene.field(patch.prefix + "stress_place");
  const std::vector<double> depths = scene.field(patch.prefix + "stress_depth");
  const std::vector<double> stress = scene.field(patch.prefix + "stress_von_mises");
  std::ostringstream data;
  data.precision(9);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i > 0 && depths[i] != depths[i - 1]) {
      data << '\n';
    }
    data << places[i] << ' ' << depths[i] << ' ' << stress[i] << '\n';
  }
  const bool across = scene.get_text("stress.section") == "across";
  const double greatest = scene.number(patch.prefix + stress_result);
  const double depth = scene.number(patch.prefix + "stress.depth");
  const double place = scene.number(patch.prefix + (across ? "stress.across" : "stress.along"));
  const std::string block = gnuplot.block(data.str());
  out << "set size noratio\nset title '" << side << " wheel, in the "
      << scene.get_text("stress.body") << ": von Mises " << fixed(greatest, 0) << " MPa (cross), "
      << fixed(depth, 2) << " mm below the surface'\nset xlabel '"
      << (across ? "across the patch, mm (to the field side)" : "along the patch, mm (forward)")
      << "'\nset ylabel 'depth, mm'\nset cblabel 'von Mises stress, MPa' offset 1\n"
      << "set xrange [" << places.front() << ':' << places.back() << "]\nset yrange ["
      << depths.back() << ":0]\nset cbrange [0:" << greatest << "]\nset key off\n";
  gnuplot.script() << contour_lines(block, greatest);
  gnuplot.plot({block + " using 1:2:3 with image",
                block + "_contours using 1:2 with lines lw 0.8 lc rgb '" + colour::contour + '\'',
                gnuplot.block({place}, {depth}) + " with points pt 2 ps 1.5 lw 2 lc rgb 'black'"});
}

} // namespace driver
