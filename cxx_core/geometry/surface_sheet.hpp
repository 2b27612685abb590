/// A surface whose sections are curves that vary along x: one connected part of a rail that varies
/// along the track, or of a wheel that varies around its circumference.
///
///   P(u, x) = (Y(u, x), Z(u, x)) = sum_j N_j(x) C_j(s_j(u))
/// with C_j the curves of slices at x_j, s_j the map of features (feature_map.hpp), N_j the
/// cardinal functions of the spline along (along_spline.hpp). Y and Z are polynomials of the fifth
/// degree in u and the third in x; C2 along, C2 across as the slices are. Slices with nodes at the
/// same arc lengths keep their own polynomials, and equal slices give the constant curve to the
/// last bit; others are sampled every `max_node_distance` with two derivatives, error h^6 / 46080
/// times the sixth derivative.
///
/// Units mm; along mm or, of wheels, rad. Frame: lateral Y and height Z of profile.hpp, along
/// forward. u ascends from the gauge (flange) side as arc lengths do and is that of the slices if
/// all are of equal length. The surface is regular wherever (Y_u, Z_u) is not 0, also at vertical
/// sides and below overhangs. Folded surfaces are refused: between two slices, sections must
/// nowhere turn away by 90 degrees or more from the corresponding place of either slice. Not
/// covered: what is beyond the ends of a sheet (nothing is there), kinks along, contact. Thread
/// rule: immutable after construction, safe to share.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "profile/along_spline.hpp"
#include "profile/curve.hpp"
#include "profile/quintic.hpp"

namespace wrc {

/// A point of a surface and its derivatives by u (across) and x (along).
struct SheetPoint {
  Position at{};
  Position across{};
  Position along{};
  Position across2{};
  Position across_along{};
  Position along2{};
};

/// The surface as a graph, height over along x and lateral y, with derivatives.
struct GraphPoint {
  std::size_t sheet = 0; ///< of several
  double across = 0.0;   ///< the parameter u
  double height = 0.0;
  double by_along = 0.0;
  double by_lateral = 0.0;
  double by_along2 = 0.0;
  double by_along_lateral = 0.0;
  double by_lateral2 = 0.0;
};

/// From one value to a larger one.
struct Stretch {
  double begin = 0.0;
  double end = 0.0;
};

/// What a sheet takes of a slice: its curve, and where its features are along the arc.
struct SheetSection {
  std::size_t number = 0; ///< of the slice, from 1, for messages
  double place = 0.0;
  const Curve* curve = nullptr;
  std::vector<double> features; ///< first and last bound the sheet
};

class SurfaceSheet {
public:
  /// `smoothing_length` as of AlongSpline; `period` 0 or that of a wheel. Throws
  /// Error(invalid_argument), for a folded surface with the numbers of the slices.
  SurfaceSheet(std::span<const SheetSection> sections, double smoothing_length, double period);

  [[nodiscard]] Stretch across() const { return {starts_.front(), starts_.back()}; }
  [[nodiscard]] Stretch along() const { return {spline_.knots().front(), spline_.knots().back()}; }
  [[nodiscard]] bool is_periodic() const { return spline_.is_periodic(); }
  /// Whether it is there at a place along.
  [[nodiscard]] bool holds(double place) const {
    return is_periodic() || (place >= along().begin && place <= along().end);
  }
  /// Parameters at the begin of each piece across and at the end: searches scan these.
  [[nodiscard]] std::span<const double> starts() const { return starts_; }
  [[nodiscard]] std::span<const double> knots() const { return spline_.knots(); }
  /// The place at a fraction of the way over the knots from the first to the last slice, which are
  /// closer where slices are.
  [[nodiscard]] double place_at(double share) const;
  /// At parameters that are clamped to the sheet, along taken modulo the period if periodic.
  [[nodiscard]] SheetPoint at(double across, double along) const;
  /// On a given piece at a distance from its begin, and a place from locate().
  [[nodiscard]] SheetPoint at(std::size_t piece, double distance, const AlongPlace& along) const;
  [[nodiscard]] AlongPlace locate(double along) const { return spline_.locate(along); }
  [[nodiscard]] std::size_t piece_at(double across) const;
  /// The highest point over a place in the plane; none beyond the sheet, and where all points are
  /// on sides steeper than 89.4 degrees.
  [[nodiscard]] std::optional<GraphPoint> over(double along, double lateral) const;
  /// Raises `heights` to the section's over lateral places in ascending order, where it is a graph.
  void raise_to(double along, std::span<const double> laterals, std::span<double> heights) const;
  /// The section at a place, as a curve over its arc length.
  [[nodiscard]] Curve section(double along) const;
  /// Where sections are the same to `tolerance` in mm, by ascending begins; around a wheel the last
  /// may go on beyond the period. None of a part of slices, at whose sides contact ends.
  [[nodiscard]] std::vector<Stretch> constant_stretches(double tolerance) const;
  /// Its steepest rise or fall along, of places half an interval of knots and 2 mm apart.
  [[nodiscard]] double steepest_along() const;
  /// How far it rises anywhere over its section at a place, along the normals of that.
  [[nodiscard]] double rise_over(double along) const;
  /// Bytes of its tables.
  [[nodiscard]] std::size_t memory() const;

private:
  /// The spline along at one knot: values and second derivatives of the polynomials of a piece.
  struct Node {
    Quintic lateral;
    Quintic height;
    Quintic lateral_second;
    Quintic height_second;
  };
  [[nodiscard]] const Node& node(std::size_t piece, std::size_t knot) const {
    return nodes_[piece * spline_.knots().size() + knot];
  }
  /// How far sections leave that at a knot, at most, from there to the end of an interval.
  [[nodiscard]] double change_from(std::size_t knot, std::size_t interval) const;
  void fill(std::span<const SheetSection> sections);
  /// The longest run of pieces whose begins ascend in lateral all over an interval.
  [[nodiscard]] std::pair<std::size_t, std::size_t> ascending_run(std::size_t interval) const;
  /// Lateral coordinate of the section at the begins of its pieces, and at its end.
  class BeginLaterals;
  [[nodiscard]] bool is_folded(std::size_t piece, std::size_t interval) const;
  void refuse_folds(std::span<const SheetSection> sections) const;

  AlongSpline spline_;
  bool is_whole_ = true; ///< all of each slice
  std::vector<double> starts_;
  std::vector<Node> nodes_; ///< by pieces, then knots
  /// Lateral coordinate at the begins of pieces, and at the end, and its second derivative along;
  /// by knots, then pieces.
  std::vector<double> begin_lateral_;
  std::vector<double> begin_second_;
  std::vector<std::pair<std::size_t, std::size_t>>
      ascending_; ///< by intervals: first, past the last
};

/// Height, slopes and second derivatives over (along, lateral) of a point that is not vertical.
GraphPoint graph_of(const SheetPoint& point);

} // namespace wrc
