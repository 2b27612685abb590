/// A solved scene as its picture shows it: for each wheel the outlines, and each patch in its
/// plane.
///
/// Units mm, MPa, N, rad; track frame. The planes of the patches of a wheel lie side by side on one
/// lateral axis, positive to the left, 0 at the reference of the patch with the largest force. A
/// gap between neighbours that would leave the patches too small to be seen is shortened.
#pragma once

#include <string>
#include <vector>

#include "reports/patches.hpp"
#include "support/gnuplot.hpp"

namespace driver {

/// A patch as it is drawn.
struct DrawnPatch {
  PatchName name;
  double y = 0.0; ///< reference, track frame
  double z = 0.0;
  double plane_angle = 0.0;
  double centroid_x = 0.0; ///< of the pressures, track frame
  double centroid_y = 0.0;
  double centroid_z = 0.0;
  double force = 0.0;
  double force_angle = 0.0; ///< of the tangent across the force: `angle` of the results
  double across = 0.0;      ///< of the reference, along the axis as it is drawn
  double developed = 0.0;   ///< the same if no gap is shortened
  Range lateral;            ///< of the contact, from the reference, positive to the left
  Range longitudinal;       ///< of the contact, track x

  std::vector<std::string> areas;  ///< blocks of an image: x, y, red, green, blue, opacity
  std::vector<std::string> arrows; ///< blocks: x, y, traction to the left and forward
  double largest_traction = 0.0;
  double arrow_step = 0.0; ///< between arrows, mm

  std::string block;         ///< of data, on a finer grid; pressure 0 without contact
  bool has_contours = false; ///< lines of equal pressure; none on a grid of one row or column
  [[nodiscard]] std::string contours() const { return block + "_contours"; }

  /// Where a point of the track frame lies in the plane, from the reference.
  [[nodiscard]] double in_plane(double of_y, double of_z) const;
};

/// A gap between neighbours of which only a part is drawn.
struct ShortenedGap {
  double middle = 0.0; ///< along the axis as it is drawn
  double left_out = 0.0;
};

struct DrawnSide {
  std::string name;
  std::string rail; ///< blocks of data
  std::string wheel;
  std::vector<DrawnPatch> patches; ///< from right to left
  std::vector<ShortenedGap> gaps;  ///< likewise
  Range across;                    ///< of all contacts, as they are drawn
  Range along;
};

/// The blocks of data are added to the script. Without pressures there are no patches.
DrawnSide write_side(Gnuplot& gnuplot, const Scene& scene, const std::string& name,
                     bool has_pressures);

} // namespace driver
