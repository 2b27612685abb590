/// Curve: interpolation, bounds, motion, errors.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "profile/curve.hpp"

namespace wrc::test::curve_test {
namespace {

/// A few rounding errors of positions of some ten mm.
constexpr double rounding = 1e-13;

Curve::Piece arc_piece(double radius, double from, double to) {
  const auto end = [radius](double angle) {
    return Curve::End{radius * std::sin(angle),  -radius * std::cos(angle),
                      std::cos(angle),           std::sin(angle),
                      -std::sin(angle) / radius, std::cos(angle) / radius};
  };
  return {end(from), end(to), radius * (to - from)};
}

TEST(Curve, MeetsItsEndsWithThreeOrders) {
  const std::vector<Curve::Piece> pieces = {arc_piece(10.0, 0.0, 0.05),
                                            arc_piece(10.0, 0.05, 0.11)};
  const Curve curve{pieces};
  ASSERT_EQ(curve.piece_count(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const auto& [end, s] :
         {std::pair{pieces[i].begin, 0.0}, std::pair{pieces[i].end, pieces[i].length}}) {
      const CurvePoint point = curve.at(i, s);
      EXPECT_NEAR(point.lateral, end.lateral, rounding);
      EXPECT_NEAR(point.height, end.height, rounding);
      EXPECT_NEAR(point.tangent_lateral, end.tangent_lateral, rounding);
      EXPECT_NEAR(point.tangent_height, end.tangent_height, rounding);
      // Rounding of positions divided by the square of the length.
      EXPECT_NEAR(point.second_lateral, end.second_lateral, 1e-11);
      EXPECT_NEAR(point.second_height, end.second_height, 1e-11);
    }
  }
}

TEST(Curve, InterpolationErrorFallsWithTheSixthPower) {
  // Mid piece of an arc: R (h/R)^6 / 46080; within a tenth, since higher orders remain.
  const double radius = 10.0;
  for (const double angle : {0.8, 0.4, 0.2}) {
    const Curve curve{std::vector{arc_piece(radius, 0.0, angle)}};
    const CurvePoint middle = curve.at(0.5 * curve.length());
    const double error = std::abs(std::hypot(middle.lateral, middle.height) - radius);
    const double law = radius * std::pow(angle, 6) / 46080.0;
    EXPECT_NEAR(error, law, 0.1 * law) << "angle " << angle;
  }
}

TEST(Curve, ClampsItsArcLength) {
  const Curve curve{std::vector{arc_piece(10.0, 0.0, 0.05), arc_piece(10.0, 0.05, 0.1)}};
  EXPECT_EQ(curve.at(-1.0).lateral, curve.at(0.0).lateral);
  EXPECT_EQ(curve.at(99.0).lateral, curve.at(curve.length()).lateral);
  EXPECT_EQ(curve.piece_at(-1.0), 0U);
  EXPECT_EQ(curve.piece_at(0.49), 0U);
  EXPECT_EQ(curve.piece_at(0.51), 1U);
  EXPECT_EQ(curve.piece_at(99.0), 1U);
  EXPECT_EQ(curve.piece_at(std::numeric_limits<double>::quiet_NaN()), 1U);
}

TEST(Curve, NodesBelongToThePieceThatBegins) {
  const Curve curve{std::vector{arc_piece(10.0, 0.0, 0.05), arc_piece(10.0, 0.05, 0.1)}};
  ASSERT_EQ(curve.starts().size(), 3U);
  EXPECT_EQ(curve.piece_at(curve.starts()[1]), 1U);
}

TEST(Curve, MovingRotatesThenShifts) {
  const Curve curve{std::vector{arc_piece(10.0, 0.0, 0.1)}};
  const double angle = 0.3;
  const Curve moved = curve.moved(angle, 5.0, -2.0);
  EXPECT_DOUBLE_EQ(moved.length(), curve.length());
  for (const double s : {0.0, 0.2, 0.7, 1.0}) {
    const CurvePoint a = curve.at(s);
    const CurvePoint b = moved.at(s);
    EXPECT_NEAR(b.lateral, std::cos(angle) * a.lateral - std::sin(angle) * a.height + 5.0,
                rounding);
    EXPECT_NEAR(b.height, std::sin(angle) * a.lateral + std::cos(angle) * a.height - 2.0, rounding);
    EXPECT_NEAR(b.curvature(), a.curvature(), rounding);
    EXPECT_NEAR(std::atan2(b.tangent_height, b.tangent_lateral),
                std::atan2(a.tangent_height, a.tangent_lateral) + angle, rounding);
  }
}

ErrorCode code_of(const std::vector<Curve::Piece>& pieces) {
  try {
    const Curve curve{pieces};
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::internal;
}

TEST(Curve, RefusesInvalidPieces) {
  EXPECT_EQ(code_of({}), ErrorCode::invalid_argument);
  for (const double length : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()}) {
    Curve::Piece piece = arc_piece(10.0, 0.0, 0.1);
    piece.length = length;
    EXPECT_EQ(code_of({piece}), ErrorCode::invalid_argument) << length;
  }
  Curve::Piece piece = arc_piece(10.0, 0.0, 0.1);
  piece.end.height = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of({piece}), ErrorCode::invalid_argument);
}

TEST(Curve, WithoutPiecesHasNoLengthAndNoPoints) {
  const Curve curve;
  EXPECT_EQ(curve.length(), 0.0);
  EXPECT_EQ(curve.piece_count(), 0U);
  EXPECT_THROW((void)curve.at(0.0), Error);
}

/// Lines along the lateral axis, each begun that much higher than the last one's end.
Curve steps_of(const std::vector<double>& lengths, const std::vector<double>& rises) {
  std::vector<Curve::Piece> pieces;
  double lateral = 0.0;
  double height = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    height += rises[i];
    pieces.push_back({{lateral, height}, {lateral + lengths[i], height}, lengths[i]});
    lateral += lengths[i];
  }
  return Curve{pieces};
}

TEST(Curve, WithoutStepsIsUnchangedIfItHasNone) {
  const Curve curve{std::vector{arc_piece(10.0, 0.0, 0.05), arc_piece(10.0, 0.05, 0.1)}};
  const Curve closed = curve.without_steps();
  for (const double arc : {0.0, 0.2, 0.5, 0.7, 1.0}) {
    EXPECT_EQ(closed.at(arc).height, curve.at(arc).height);
    EXPECT_EQ(closed.at(arc).second_height, curve.at(arc).second_height);
  }
}

TEST(Curve, StepsAreClosedFromBothSidesWithoutAKink) {
  // Pieces of 1 mm, with a step up and a step down.
  std::vector<double> lengths(40, 1.0);
  std::vector<double> rises(40, 0.0);
  rises[15] = 1e-4;
  rises[25] = -3e-5;
  const Curve curve = steps_of(lengths, rises);
  const Curve closed = curve.without_steps();
  for (const double arc : {0.0, 5.0, 12.99, 17.01, 22.99, 27.01, 39.9}) {
    EXPECT_EQ(closed.at(arc).height, curve.at(arc).height) << arc;
  }
  EXPECT_NEAR(closed.at(15.0).height, 0.5e-4, rounding);
  EXPECT_NEAR(closed.at(14.0).height, 0.25e-4, rounding) << "half-way";
  EXPECT_NEAR(closed.at(25.0).height, 1e-4 - 1.5e-5, rounding);
  for (std::size_t piece = 0; piece + 1 < curve.piece_count(); ++piece) {
    const CurvePoint end = closed.at(piece, curve.starts()[piece + 1] - curve.starts()[piece]);
    const CurvePoint begin = closed.at(piece + 1, 0.0);
    EXPECT_NEAR(end.lateral, begin.lateral, rounding) << piece;
    EXPECT_NEAR(end.height, begin.height, rounding) << piece;
    EXPECT_NEAR(end.tangent_height, begin.tangent_height, rounding) << piece;
  }
}

TEST(Curve, ShortStretchesBetweenStepsCloseToo) {
  // A single piece between two steps, and one before the end.
  const Curve closed = steps_of({10.0, 0.5, 10.0, 0.5}, {0.0, 5e-5, 4e-5, -2e-5}).without_steps();
  for (std::size_t piece = 0; piece + 1 < closed.piece_count(); ++piece) {
    const CurvePoint end = closed.at(piece, closed.starts()[piece + 1] - closed.starts()[piece]);
    const CurvePoint begin = closed.at(piece + 1, 0.0);
    EXPECT_NEAR(end.height, begin.height, rounding) << piece;
    EXPECT_NEAR(end.tangent_height, begin.tangent_height, rounding) << piece;
  }
}

} // namespace
} // namespace wrc::test::curve_test
