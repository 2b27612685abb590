/// Vectors, the rotation of the wheelset, and the mirror that turns a right side into a left one.
///
/// Track frame: x forward, y to the left, z up, right-handed; origin at the track centre in the
/// plane of the rail tops. Wheelset frame: centre at (0, lateral, vertical), rotation wheelset ->
/// track R = Rz(yaw) Rx(roll); roll > 0 lifts the left wheel, yaw > 0 is anticlockwise from above.
/// Only the left side is ever computed: the right side is the left side of the mirrored pose
/// (y -> -y), so both are symmetric to the last bit. Units mm and rad. Thread rule: plain values.
#pragma once

#include <cmath>

namespace wrc {

/// Vectors of plain numbers, or of numbers with rates (base/value_with_rates.hpp).
template <class Real> struct VectorOf {
  Real x{};
  Real y{};
  Real z{};

  friend VectorOf operator+(const VectorOf& a, const VectorOf& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend VectorOf operator-(const VectorOf& a, const VectorOf& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend VectorOf operator*(const Real& s, const VectorOf& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  friend Real dot(const VectorOf& a, const VectorOf& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  friend VectorOf cross(const VectorOf& a, const VectorOf& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

using Vector3 = VectorOf<double>;

/// In which wheels roll and rails run: x of the track frame; not a tuning constant.
inline constexpr Vector3 along_track{1.0, 0.0, 0.0};

inline double norm(const Vector3& a) {
  return std::sqrt(dot(a, a));
}

/// Position of the wheelset in the track frame, without its height.
struct Pose {
  double lateral = 0.0; ///< y of the wheelset's centre, mm; > 0: left flange towards left rail
  double yaw = 0.0;     ///< rad
  double roll = 0.0;    ///< rad
};

/// The pose seen in the mirror y -> -y.
inline Pose mirrored(Pose pose) {
  return {-pose.lateral, -pose.yaw, -pose.roll};
}

/// R = Rz(yaw) Rx(roll), with sines and cosines taken once.
class Rotation {
public:
  explicit Rotation(const Pose& pose);
  [[nodiscard]] Vector3 to_track(Vector3 body) const {
    const double y = cos_roll * body.y - sin_roll * body.z;
    const double z = sin_roll * body.y + cos_roll * body.z;
    return {cos_yaw * body.x - sin_yaw * y, sin_yaw * body.x + cos_yaw * y, z};
  }
  [[nodiscard]] Vector3 to_body(Vector3 track) const {
    const double x = cos_yaw * track.x + sin_yaw * track.y;
    const double y = cos_yaw * track.y - sin_yaw * track.x;
    return {x, cos_roll * y + sin_roll * track.z, cos_roll * track.z - sin_roll * y};
  }

  double sin_yaw;
  double cos_yaw;
  double sin_roll;
  double cos_roll;
};

} // namespace wrc
