#include "remesh/surface_rays.hpp"

namespace wrc {

double RailRay::inclination(double lateral) const {
  const ContactFrame::Row row = frame_.row_at(lateral);
  return line_.inclination(row.lateral, row.normal);
}

std::optional<double> RailRay::solve(double longitudinal, double lateral) {
  return line_.meet(frame_.to_track(longitudinal, lateral, 0.0),
                    frame_.curve ? frame_.row_at(lateral).normal : frame_.normal);
}

WheelRay::WheelRay(const PosedPair& pair, const ContactFrame& frame)
    : wheel_(pair.wheel), rotation_(pair.pose),
      frame_(frame), centre_{0.0, pair.pose.lateral, pair.vertical},
      longitudinal_(rotation_.to_body(frame.longitudinal)),
      normal_(rotation_.to_body(frame.normal)),
      line_(pair.wheel, wheel_.graph().heights().at(base(0.0, 0.0).y).height) {}

Vector3 WheelRay::base(double longitudinal, double lateral) const {
  Vector3 base = rotation_.to_body(frame_.to_track(longitudinal, lateral, 0.0) - centre_);
  base.y -= wheel_.taping_line();
  return base;
}

std::optional<double> WheelRay::solve(double longitudinal, double lateral) {
  const Vector3 from = base(longitudinal, lateral);
  if (frame_.curve) {
    normal_ = rotation_.to_body(frame_.row_at(lateral).normal);
  }
  return line_.meet(from, normal_);
}

double WheelRay::inclination(double longitudinal, double lateral, double position) const {
  const Vector3 met = base(longitudinal, lateral) + position * normal_;
  const Vector3 gradient = line_.gradient(met);
  return -dot(gradient, cross(normal_, longitudinal_)) / dot(gradient, normal_);
}

} // namespace wrc
