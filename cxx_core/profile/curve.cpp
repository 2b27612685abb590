#include "profile/curve.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "profile/constants.hpp"

namespace wrc {
namespace {

bool is_finite(const Curve::End& end) {
  return std::isfinite(end.lateral) && std::isfinite(end.height) &&
         std::isfinite(end.tangent_lateral) && std::isfinite(end.tangent_height) &&
         std::isfinite(end.second_lateral) && std::isfinite(end.second_height);
}

} // namespace

Curve::Curve(std::span<const Piece> pieces) {
  if (pieces.empty()) {
    throw_invalid_argument("number of curve pieces", "0", "at least 1");
  }
  starts_.reserve(pieces.size() + 1);
  coefficients_.reserve(pieces.size());
  double arc = 0.0;
  for (const Piece& piece : pieces) {
    const std::string name = "curve piece " + std::to_string(coefficients_.size());
    if (!(piece.length > 0.0) || !std::isfinite(piece.length)) {
      throw_invalid_argument("length of " + name, piece.length, "a positive finite number, mm");
    }
    if (!is_finite(piece.begin) || !is_finite(piece.end)) {
      throw_invalid_argument("ends of " + name, "not a number or infinite", "finite numbers");
    }
    const End& b = piece.begin;
    const End& e = piece.end;
    coefficients_.push_back(
        {quintic({b.lateral, b.tangent_lateral, b.second_lateral},
                 {e.lateral, e.tangent_lateral, e.second_lateral}, piece.length),
         quintic({b.height, b.tangent_height, b.second_height},
                 {e.height, e.tangent_height, e.second_height}, piece.length)});
    arc += piece.length;
    starts_.push_back(arc);
  }
}

std::size_t Curve::piece_at(double arc) const {
  // The first interior boundary beyond `arc` ends its piece; not-a-number lands on the last piece.
  const auto first = starts_.begin() + 1;
  const auto last = starts_.end() - (starts_.size() > 1 ? 1 : 0);
  return static_cast<std::size_t>(std::upper_bound(first, last, arc) - first);
}

CurvePoint Curve::at(double arc) const {
  const double inside = std::clamp(arc, 0.0, length());
  const std::size_t piece = piece_at(inside);
  return at(piece, inside - starts_[piece]);
}

void Curve::throw_no_piece(std::size_t piece) const {
  throw Error(ErrorCode::internal, "curve piece " + std::to_string(piece) + ": the curve has " +
                                       std::to_string(coefficients_.size()) + " pieces");
}

Curve Curve::moved(double angle, double lateral_shift, double height_shift) const {
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  Curve result = *this;
  for (Coefficients& c : result.coefficients_) {
    for (std::size_t power = 0; power < c.lateral.size(); ++power) {
      const double lateral = c.lateral[power];
      const double height = c.height[power];
      c.lateral[power] = cosine * lateral - sine * height;
      c.height[power] = sine * lateral + cosine * height;
    }
    c.lateral[0] += lateral_shift;
    c.height[0] += height_shift;
  }
  return result;
}

namespace {

/// Adds begin + (end - begin) (3 t^2 - 2 t^3) with t = (offset + s) / length to a quintic of s.
void add_transition(Quintic& quintic, double begin, double end, double offset, double length) {
  const double change = end - begin;
  const double t = offset / length;
  quintic[0] += begin + change * t * t * (3.0 - 2.0 * t);
  quintic[1] += change * 6.0 * t * (1.0 - t) / length;
  quintic[2] += change * (3.0 - 6.0 * t) / (length * length);
  quintic[3] -= change * 2.0 / (length * length * length);
}

} // namespace

Curve Curve::without_steps() const {
  Curve closed = *this;
  const auto add = [&](std::size_t first, std::size_t end, const Position& begin,
                       const Position& finish) {
    const double length = starts_[end] - starts_[first];
    for (std::size_t piece = first; piece < end; ++piece) {
      const double offset = starts_[piece] - starts_[first];
      Coefficients& c = closed.coefficients_[piece];
      add_transition(c.lateral, begin[0], finish[0], offset, length);
      add_transition(c.height, begin[1], finish[1], offset, length);
    }
  };
  std::vector<std::size_t> cuts{0}; // pieces that begin after a step, and the ends
  std::vector<Position> halves{{}};
  for (std::size_t piece = 1; piece < piece_count(); ++piece) {
    const CurvePoint before = at(piece - 1, starts_[piece] - starts_[piece - 1]);
    const CurvePoint after = at(piece, 0.0);
    const Position step{after.lateral - before.lateral, after.height - before.height};
    if (std::hypot(step[0], step[1]) > min_step) {
      cuts.push_back(piece);
      halves.push_back({0.5 * step[0], 0.5 * step[1]});
    }
  }
  cuts.push_back(piece_count());
  for (std::size_t i = 1; i + 1 < cuts.size(); ++i) {
    const std::size_t cut = cuts[i];
    std::size_t first = cut - 1;
    while (first > cuts[i - 1] && starts_[cut] - starts_[first] < transition_length) {
      --first;
    }
    std::size_t end = cut + 1;
    while (end < cuts[i + 1] && starts_[end] - starts_[cut] < transition_length) {
      ++end;
    }
    add(first, cut, {}, halves[i]);
    add(cut, end, {-halves[i][0], -halves[i][1]}, {});
  }
  return closed;
}

} // namespace wrc
