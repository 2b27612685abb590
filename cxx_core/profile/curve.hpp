/// A plane curve with position, tangent and curvature as functions of its arc length.
///
/// Profiles of wheels and rails are such curves. Steep flanks, gauge faces and even vertical sides
/// are no special case because the parameter is the arc length, not the lateral coordinate.
///
/// Representation: pieces of quintic Hermite polynomials in arc length, matching position, unit
/// tangent and curvature at their ends (Farin, Curves and Surfaces for CAGD, 2002, ch. 7). The node
/// distance is chosen by the builder so that the pieces reproduce the defining arcs and polynomials
/// to 1e-11 mm. Between pieces the curve may have a kink, or a step as small as the rounding of a
/// standard's coefficients (S1002: 1.2e-4 mm); both are kept unless without_steps is used.
///
/// Units mm. Frame: `lateral` positive to the field side, `height` as the profile defines it
/// (wheel: positive towards larger radius; rail: positive upwards). The arc length grows with the
/// lateral coordinate, from the flange (gauge) side to the field side.
/// Thread rule: immutable after construction, safe to share.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "profile/quintic.hpp"

namespace wrc {

/// (lateral, height).
using Position = std::array<double, 2>;

/// The curve at one place; derivatives are with respect to arc length.
struct CurvePoint {
  double lateral = 0.0;
  double height = 0.0;
  double tangent_lateral = 1.0; ///< d lateral / d arc
  double tangent_height = 0.0;  ///< d height / d arc
  double second_lateral = 0.0;  ///< d^2 lateral / d arc^2, 1/mm
  double second_height = 0.0;   ///< d^2 height / d arc^2, 1/mm

  /// d height / d lateral.
  [[nodiscard]] double slope() const { return tangent_height / tangent_lateral; }
  /// Signed curvature in 1/mm, positive where the curve bends towards larger height.
  [[nodiscard]] double curvature() const {
    return tangent_lateral * second_height - tangent_height * second_lateral;
  }
};

class Curve {
public:
  /// One end of a piece: where the curve is, with unit tangent and second derivative.
  using End = CurvePoint;
  /// A piece between two ends, `length` apart along the arc.
  struct Piece {
    End begin;
    End end;
    double length = 0.0;
  };

  Curve() = default;
  /// Joins pieces end to end. Throws Error(invalid_argument) if there is no piece, or one has no
  /// positive finite length.
  explicit Curve(std::span<const Piece> pieces);

  [[nodiscard]] double length() const { return starts_.back(); }
  [[nodiscard]] std::size_t piece_count() const { return coefficients_.size(); }
  /// Arc length at the begin of each piece and at the curve's end: piece_count() + 1 values.
  [[nodiscard]] std::span<const double> starts() const { return starts_; }
  /// The curve at an arc length, which is clamped to [0, length()].
  [[nodiscard]] CurvePoint at(double arc) const;
  /// The curve on a given piece, at a distance from the piece's begin (not clamped).
  [[nodiscard]] CurvePoint at(std::size_t piece, double distance) const {
    if (piece >= coefficients_.size()) {
      throw_no_piece(piece);
    }
    const QuinticValues lateral = evaluate(coefficients_[piece].lateral, distance);
    const QuinticValues height = evaluate(coefficients_[piece].height, distance);
    return {lateral.value, height.value,   lateral.first,
            height.first,  lateral.second, height.second};
  }
  /// The polynomials of a piece in the distance from its begin.
  struct Polynomials {
    Quintic lateral;
    Quintic height;
  };
  [[nodiscard]] const Polynomials& polynomials(std::size_t piece) const {
    return coefficients_[piece];
  }
  /// Index of the piece that holds an arc length (clamped).
  [[nodiscard]] std::size_t piece_at(double arc) const;

  /// The curve turned anticlockwise by `angle` rad about the origin of (lateral, height), then
  /// shifted.
  [[nodiscard]] Curve moved(double angle, double lateral_shift, double height_shift) const;

  /// The curve with its steps of more than 1e-6 mm closed. Where the bodies touch a step has no
  /// bounded pressure, and those of a standard are only the rounding of its coefficients. Each side
  /// of a step d moves by half of it at the step, and over 2 mm along the curve (less if there is
  /// less up to the next step) by
  ///   d/2 (3 t^2 - 2 t^3),
  /// which keeps the tangents. S1002: 6e-5 mm at s = -35, 2e-5 mm at -26; curvatures change by up
  /// to 9e-5 and 3e-5 per mm.
  [[nodiscard]] Curve without_steps() const;

private:
  using Coefficients = Polynomials;
  [[noreturn]] void throw_no_piece(std::size_t piece) const;

  std::vector<double> starts_{0.0}; ///< a curve without pieces has no length
  std::vector<Coefficients> coefficients_;
};

} // namespace wrc
