#include "accuracy/expected_contact.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "accuracy/constants.hpp"
#include "patches/constants.hpp"
#include "remesh/constants.hpp"

namespace wrc {
namespace {

using patch_finding::LocusSample;

/// The row at a position between two samples.
ContactRow row_between(const LocusSample<double>& from, const LocusSample<double>& to, double share,
                       double level) {
  const LocusSample<double> here = patch_finding::between(from, to, share);
  const double penetration = patch_finding::Rise<double>(from, to).at(share) - level;
  if (!(penetration > 0.0 && here.curvature > 0.0)) {
    return {};
  }
  const double normal = penetration / std::sqrt(1.0 + here.slope * here.slope);
  const double squared_length = normal / here.curvature;
  return {normal * normal * std::sqrt(squared_length), here.x,
          variance_of_penetration * squared_length};
}

} // namespace

ExpectedContact expected_contact(const ContactPatch& penetration, const ContactFrame& frame,
                                 const PlaneArea& area,
                                 std::span<const LocusSample<double>> samples) {
  const double height = area.width() / static_cast<double>(penetration_rows);
  std::vector<ContactRow> rows(penetration_rows);
  const auto row_at = [&](const LocusSample<double>& sample) { // a whole number: in its middle
    const Vector3 from_origin = Vector3{sample.x, sample.y, sample.z} - frame.origin;
    return (dot(from_origin, frame.lateral) - area.lateral_first) / height - 0.5;
  };
  const double level = outside_contact_share * penetration.deepest;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    if (samples[i].penetration <= level && samples[i + 1].penetration <= level) {
      continue;
    }
    const double from = row_at(samples[i]);
    const double to = row_at(samples[i + 1]);
    const auto count = static_cast<double>(rows.size());
    const auto first =
        static_cast<std::size_t>(std::clamp(std::ceil(std::min(from, to)), 0.0, count));
    const auto end =
        static_cast<std::size_t>(std::clamp(std::ceil(std::max(from, to)), 0.0, count));
    for (std::size_t row = first; row < end; ++row) {
      rows[row] = row_between(samples[i], samples[i + 1],
                              (static_cast<double>(row) - from) / (to - from), level);
    }
  }
  ExpectedContact contact;
  contact.mean_x = penetration.mean_x;
  contact.mean_y = penetration.mean_y;
  contact.width = area.width();
  contact.length = area.length();
  double force = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    force += rows[i].force;
    moment += rows[i].force * (static_cast<double>(i) + 0.5);
  }
  if (force > 0.0) {
    contact.scale = contact_scale(rows, height, 1);
    contact.middle = moment / (force * static_cast<double>(rows.size()));
  } else {
    contact.scale = {height, height * area.length() / area.width()};
  }
  return contact;
}

} // namespace wrc
