#include "measured/alignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "measured/constants.hpp"
#include "measured/profile_shape.hpp"

extern "C" {
/// LAPACK: solves A x = b with A symmetric positive definite.
void dposv_(const char* uplo, const int* n, const int* nrhs, double* a, const int* lda, double* b,
            const int* ldb, int* info);
}

namespace wrc {
namespace {

struct Foot {
  Position normal{};
  double distance = 0.0; ///< of the point, along the normal
};

/// The nominal curve with points along it.
class Nominal {
public:
  explicit Nominal(const Curve& curve) : curve_(curve) {
    const auto count =
        std::max<std::size_t>(2, static_cast<std::size_t>(curve.length() / foot_spacing));
    for (std::size_t i = 0; i <= count; ++i) {
      samples_.push_back(
          curve.at(curve.length() * static_cast<double>(i) / static_cast<double>(count)));
    }
  }

  /// None beyond the ends.
  [[nodiscard]] std::optional<Foot> foot_of(const Position& point) const {
    std::size_t nearest = 0;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const double off_lateral = samples_[i].lateral - point[0];
      const double off_height = samples_[i].height - point[1];
      const double square = off_lateral * off_lateral + off_height * off_height;
      if (square < least) {
        least = square;
        nearest = i;
      }
    }
    const double spacing = curve_.length() / static_cast<double>(samples_.size() - 1);
    double arc = spacing * static_cast<double>(nearest);
    for (int step = 0; step < 3; ++step) {
      arc += std::clamp(along(curve_.at(arc), point), -spacing, spacing);
    }
    if (arc <= 0.0 || arc >= curve_.length()) {
      return std::nullopt;
    }
    const CurvePoint at = curve_.at(arc);
    const Position normal{-at.tangent_height, at.tangent_lateral};
    return Foot{normal, normal[0] * (point[0] - at.lateral) + normal[1] * (point[1] - at.height)};
  }

private:
  static double along(const CurvePoint& at, const Position& point) {
    return at.tangent_lateral * (point[0] - at.lateral) +
           at.tangent_height * (point[1] - at.height);
  }

  const Curve& curve_;
  std::vector<CurvePoint> samples_;
};

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

/// None if an unknown is not determined.
std::optional<Vector> solution_of(Matrix a, Vector b) {
  const Vector whole{a[0][0], a[1][1], a[2][2]};
  const char upper = 'U';
  const int order = 3;
  const int count = 1;
  int info = 0;
  dposv_(&upper, &order, &count, a[0].data(), &order, b.data(), &order, &info);
  for (std::size_t i = 0; i < 3; ++i) {
    if (info != 0 || !(a[i][i] * a[i][i] > least_pivot * whole[i])) {
      return std::nullopt;
    }
  }
  return b;
}

/// One step towards the least squares within a bound; false if they determine nothing.
bool improve(Alignment& alignment, const Nominal& nominal, std::span<const Position> points) {
  Matrix a{};
  Vector b{};
  std::size_t beside = 0;
  std::size_t counted = 0;
  double squares = 0.0;
  for (const Position& point : points) {
    const Position moved = alignment.motion.of(point);
    const std::optional<Foot> foot = nominal.foot_of(moved);
    if (!foot) {
      continue;
    }
    ++beside;
    const double share = foot->distance / alignment.bound;
    if (std::abs(share) >= 1.0) {
      continue;
    }
    ++counted;
    squares += foot->distance * foot->distance;
    const double weight = (1.0 - share * share) * (1.0 - share * share);
    const Vector row{foot->normal[0], foot->normal[1],
                     (foot->normal[1] * moved[0] - foot->normal[0] * moved[1]) / lever};
    for (std::size_t i = 0; i < 3; ++i) {
      b[i] -= weight * row[i] * foot->distance;
      for (std::size_t j = 0; j < 3; ++j) {
        a[i][j] += weight * row[i] * row[j];
      }
    }
  }
  if (counted < least_aligned_points) {
    return false;
  }
  alignment.beside = static_cast<double>(beside) / static_cast<double>(points.size());
  alignment.share = static_cast<double>(counted) / static_cast<double>(beside);
  alignment.deviation = std::sqrt(squares / static_cast<double>(counted));
  const std::optional<Vector> step = solution_of(a, b);
  if (!step) {
    return false;
  }
  const RigidMotion last{(*step)[2] / lever, {(*step)[0], (*step)[1]}};
  alignment.motion.shift = last.of(alignment.motion.shift);
  alignment.motion.rotation += last.rotation;
  return true;
}

} // namespace

Position RigidMotion::of(const Position& point) const {
  const double c = std::cos(rotation);
  const double s = std::sin(rotation);
  return {c * point[0] - s * point[1] + shift[0], s * point[0] + c * point[1] + shift[1]};
}

std::optional<Alignment> alignment_to(const Curve& nominal, std::span<const Position> points,
                                      const RigidMotion& start) {
  std::vector<Position> some;
  const std::size_t every = 1 + points.size() / aligned_points;
  for (std::size_t i = 0; i < points.size(); i += every) {
    some.push_back(points[i]);
  }
  const Nominal feet(nominal);
  Alignment best;
  best.motion = start;
  for (const double bound : alignment_bounds) {
    Alignment next = best;
    next.bound = bound;
    for (int step = 0; step < (bound == alignment_bounds.back() ? last_steps : steps_of_stage);
         ++step) {
      if (!improve(next, feet, some)) {
        return bound == alignment_bounds.front() ? std::nullopt : std::optional(best);
      }
    }
    if (next.share < least_aligned_share) {
      return bound == alignment_bounds.front() ? std::nullopt : std::optional(best);
    }
    best = next;
  }
  return best;
}

std::optional<Alignment> alignment_from_afar(const Curve& nominal,
                                             std::span<const Position> points) {
  std::vector<Position> places;
  for (const double arc : nominal.starts()) {
    const CurvePoint at = nominal.at(arc);
    places.push_back({at.lateral, at.height});
  }
  const auto highest = [](std::span<const Position> of) {
    return *std::ranges::max_element(of, {}, [](const Position& point) { return point[1]; });
  };
  const auto middle = [](std::span<const Position> of) {
    const Position lateral = reading::extent_of(of, 0);
    const Position height = reading::extent_of(of, 1);
    return Position{0.5 * (lateral[0] + lateral[1]), 0.5 * (height[0] + height[1])};
  };
  std::optional<Alignment> best;
  for (const double turn : far_turns) {
    std::vector<Position> turned;
    for (const Position& point : points) {
      turned.push_back(RigidMotion{turn, {}}.of(point));
    }
    for (const bool by_top : {true, false}) {
      const Position from = by_top ? highest(turned) : middle(turned);
      const Position to = by_top ? highest(places) : middle(places);
      const auto found = alignment_to(nominal, points, {turn, {to[0] - from[0], to[1] - from[1]}});
      if (found && found->beside >= least_aligned_share &&
          (!best || found->bound < best->bound ||
           (found->bound == best->bound && found->share > best->share))) {
        best = found;
      }
    }
  }
  return best;
}

} // namespace wrc
