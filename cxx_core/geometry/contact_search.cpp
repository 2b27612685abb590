#include "geometry/contact_search.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/root_bracket.hpp"
#include "geometry/constants.hpp"

namespace wrc {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

SideSearch::SideSearch(const WheelSurface& wheel, const RailSurface& rail)
    : wheel_(wheel), rail_(rail.graph().heights()), scan_(wheel, rail), pose_(Pose{}) {}

CurvePoint SideSearch::profile_at(std::size_t piece, double along) const {
  return wheel_.graph().curve().at(wheel_.graph().first_piece() + piece, along);
}

double SideSearch::length_of(std::size_t piece) const {
  const auto starts = wheel_.graph().curve().starts();
  const std::size_t index = wheel_.graph().first_piece() + piece;
  return starts[index + 1] - starts[index];
}

/// The node of a ridge with a tangent between those of its flanks.
CurvePoint SideSearch::on_ridge(const Ridge& ridge, double turned) const {
  CurvePoint edge = profile_at(ridge.node, 0.0);
  const double slope = std::lerp(ridge.slope_before, edge.slope(), turned);
  edge.tangent_lateral = 1.0 / std::sqrt(1.0 + slope * slope);
  edge.tangent_height = slope * edge.tangent_lateral;
  return edge;
}

/// The ridge at a node along which the locus runs at this pose; otherwise none.
const Ridge* SideSearch::ridge_at(std::size_t node) const {
  const std::vector<Ridge>& ridges = wheel_.ridges();
  const auto found = std::find_if(ridges.begin(), ridges.end(),
                                  [node](const Ridge& ridge) { return ridge.node == node; });
  return found != ridges.end() && yaw_tangent() != 0.0 ? &*found : nullptr;
}

SideSearch::Meeting SideSearch::meet(std::size_t piece, double along) const {
  return meet(profile_at(piece, along));
}

SideSearch::Meeting SideSearch::meet(const CurvePoint& point) const {
  bool exists = false;
  const LocusAngle angle = pose_.angle_at(point.slope(), exists);
  const double rho = wheel_.radius() + point.height;
  const Vector3 place = pose_.rotation.to_track(
      {rho * angle.sine, wheel_.taping_line() + point.lateral, -rho * angle.cosine});
  const double y = place.y + pose_.lateral;
  if (!exists || !rail_.covers(y)) {
    return {};
  }
  const double radial = point.tangent_lateral;
  const Vector3 normal =
      pose_.rotation.to_track({radial * angle.sine, -point.tangent_height, -radial * angle.cosine});
  const HeightPoint rail = rail_.at(rail_.piece_at(y), y);
  return {(normal.y + rail.slope * normal.z) / std::sqrt(1.0 + rail.slope * rail.slope),
          place.z - rail.height, true};
}

/// How far the locus is inside the rail's ends, mm; negative outside.
double SideSearch::inside_by(std::size_t piece, double along) const {
  const CurvePoint point = profile_at(piece, along);
  bool exists = false;
  const LocusAngle angle = pose_.angle_at(point.slope(), exists);
  if (!exists) {
    return -1.0;
  }
  const double rho = wheel_.radius() + point.height;
  const Vector3 place = pose_.rotation.to_track(
      {rho * angle.sine, wheel_.taping_line() + point.lateral, -rho * angle.cosine});
  const double y = place.y + pose_.lateral;
  return std::min(y - rail_.begin(), rail_.end() - y);
}

/// The last point towards `outside` at which wheel and rail still face each other.
double SideSearch::edge_along(std::size_t piece, double inside, double outside) const {
  const RootBracket::Point in{inside, inside_by(piece, inside)};
  const RootBracket::Point out{outside, inside_by(piece, outside)};
  if (!(in.value > 0.0 && out.value < 0.0)) {
    // A ridge ends the piece with its own flank's slope, and may lie over the rail with that alone.
    return in.value > 0.0 && out.value >= 0.0 ? outside : inside;
  }
  RootBracket edge(in, out);
  edge.narrow(position_tolerance, [&](double along) { return inside_by(piece, along); });
  return edge.one();
}

/// Least distance on a part of a piece.
LocusSpot SideSearch::refine(std::size_t piece, double low, double high) const {
  const Meeting at_low = meet(piece, low);
  const Meeting at_high = meet(piece, high);
  if (at_low.sine >= 0.0) {
    return {piece, low, at_low.distance};
  }
  if (at_high.sine <= 0.0) {
    return {piece, high, at_high.distance};
  }
  RootBracket least({low, at_low.sine}, {high, at_high.sine});
  least.narrow(position_tolerance, [&](double along) -> std::optional<double> {
    const Meeting meeting = meet(piece, along);
    return meeting.exists ? std::optional(meeting.sine) : std::nullopt;
  });
  const double below = meet(piece, least.one()).distance;
  const double above = meet(piece, least.other()).distance;
  return below <= above ? LocusSpot{piece, least.one(), below}
                        : LocusSpot{piece, least.other(), above};
}

/// The last point towards `outside` at which a ridge is over the rail.
SideSearch::RidgePlace SideSearch::ridge_end(const Ridge& ridge, RidgePlace inside,
                                             double outside) const {
  while (std::abs(outside - inside.turned) > position_tolerance) {
    const double middle = 0.5 * (inside.turned + outside);
    const Meeting meeting = meet(on_ridge(ridge, middle));
    if (meeting.exists) {
      inside = {middle, meeting};
    } else {
      outside = middle;
    }
  }
  return inside;
}

/// From flank to flank, with the points where it leaves the rail or reaches it.
std::vector<SideSearch::RidgePlace> SideSearch::ridge_places(const Ridge& ridge, int count) const {
  std::vector<RidgePlace> places{{0.0, meet(on_ridge(ridge, 0.0))}};
  for (int i = 1; i <= count; ++i) {
    const RidgePlace before = places.back();
    const double turned = static_cast<double>(i) / count;
    const RidgePlace after{turned, meet(on_ridge(ridge, turned))};
    if (before.meeting.exists != after.meeting.exists) {
      places.push_back(before.meeting.exists ? ridge_end(ridge, before, turned)
                                             : ridge_end(ridge, after, before.turned));
    }
    places.push_back(after);
  }
  return places;
}

/// Number of points that a search for the least distance samples: proportional to the length of the
/// ridge.
int SideSearch::searched_places(const Ridge& ridge) const {
  const auto sine_at = [&](double turned) {
    bool exists = false;
    return pose_.angle_at(on_ridge(ridge, turned).slope(), exists).sine;
  };
  const double across =
      wheel_.largest_radius() * (sine_at(1.0) - sine_at(0.0)) * pose_.rotation.sin_yaw;
  return std::max(least_ridge_samples, static_cast<int>(std::abs(across) / ridge_sample_spacing));
}

/// Between the flanks of a ridge, where the locus comes down to it from both, or where the ridge
/// leaves the rail.
std::optional<LocusSpot> SideSearch::least_on_ridge(std::size_t node) const {
  const Ridge* ridge = ridge_at(node);
  if (ridge == nullptr) {
    return std::nullopt;
  }
  std::optional<LocusSpot> least;
  const auto take = [&](double turned, double distance) {
    if (!least || distance < least->distance) {
      least = LocusSpot{node, 0.0, distance, turned};
    }
  };
  const std::vector<RidgePlace> places = ridge_places(*ridge, searched_places(*ridge));
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const auto& [share, before] = places[i];
    const auto& [next, after] = places[i + 1];
    if (before.exists && after.exists && before.sine < 0.0 && after.sine > 0.0) {
      RootBracket bracket({share, before.sine}, {next, after.sine});
      bracket.narrow(position_tolerance, [&](double turned) -> std::optional<double> {
        const Meeting meeting = meet(on_ridge(*ridge, turned));
        return meeting.exists ? std::optional(meeting.sine) : std::nullopt;
      });
      take(bracket.one(), meet(on_ridge(*ridge, bracket.one())).distance);
    } else if (!before.exists && after.exists && after.sine >= 0.0) {
      take(next, after.distance);
    } else if (before.exists && !after.exists && before.sine <= 0.0) {
      take(share, before.distance);
    }
  }
  return least;
}

/// Least distances next to a node that is lower than its neighbours: to its left, to its right, or
/// at the node itself if the profile has a kink there along which the locus does not run.
void SideSearch::refine_around(std::size_t node, std::vector<LocusSpot>& spots) const {
  bool found = false;
  LocusSpot here{0, 0.0, infinity};
  if (node > 0) {
    const std::size_t piece = node - 1;
    const double length = length_of(piece);
    const Meeting end = meet(piece, length);
    const Edge* edge = edge_at(node, piece);
    if (end.exists) {
      here = {piece, length, end.distance};
      if (end.sine > 0.0 && (edge != nullptr || scan_.over_rail(node - 1))) {
        spots.push_back(refine(piece, edge != nullptr ? edge->spot.along : 0.0, length));
        found = true;
      }
    }
  }
  if (node < wheel_.graph().piece_count()) {
    const Meeting begin = meet(node, 0.0);
    const Edge* edge = edge_at(node, node);
    if (begin.exists) {
      if (begin.distance <= here.distance) {
        here = {node, 0.0, begin.distance};
      }
      if (begin.sine < 0.0 && (edge != nullptr || scan_.over_rail(node + 1))) {
        spots.push_back(refine(node, 0.0, edge != nullptr ? edge->spot.along : length_of(node)));
        found = true;
      }
    }
  }
  if (!found && !least_on_ridge(node)) {
    spots.push_back(here);
  }
}

const SideSearch::Edge* SideSearch::edge_at(std::size_t node, std::size_t piece) const {
  for (const Edge& edge : edges_) {
    if (edge.node == node && edge.spot.piece == piece) {
      return &edge;
    }
  }
  return nullptr;
}

void SideSearch::find_edges() {
  edges_.clear();
  least_ = scan_.least();
  for (std::size_t node = scan_.first(); node + 1 < scan_.last(); ++node) {
    const bool here = scan_.over_rail(node);
    if (here == scan_.over_rail(node + 1)) {
      continue;
    }
    const double length = length_of(node);
    const double along = here ? edge_along(node, 0.0, length) : edge_along(node, length, 0.0);
    const Meeting meeting = meet(node, along);
    if (meeting.exists) {
      edges_.push_back({here ? node : node + 1, {node, along, meeting.distance}});
      least_ = std::min(least_, meeting.distance);
    }
  }
}

bool SideSearch::try_scan(const Pose& pose) {
  pose_ = LocusPose(pose);
  scan_.run(pose_);
  if (!(scan_.least() < infinity)) {
    return false;
  }
  find_edges();
  return true;
}

void throw_off_the_rail(const Pose& pose, const std::string& hint) {
  throw Error(ErrorCode::no_contact,
              "wheel off the rail: no part of the wheel profile lies over the rail at "
              "pose.lateral = " +
                  text_of(pose.lateral) + " mm, roll " + short_text_of(pose.roll) +
                  " rad (as for a left wheel; opposite signs for a right one); "
                  "displacement and roll must be such that the wheel lies over the rail; "
                  "they depend on track.gauge and wheelset.back_to_back" +
                  hint);
}

void SideSearch::scan(const Pose& pose) {
  if (!try_scan(pose)) {
    throw_off_the_rail(pose);
  }
}

std::vector<LocusSpot> SideSearch::least_spots(double near_tolerance) const {
  std::vector<LocusSpot> spots;
  const double highest = least_ + near_tolerance + scan_slack;
  for (std::size_t node = scan_.first(); node < scan_.last(); ++node) {
    const double here = scan_.distance(node);
    if (!(here <= highest)) {
      continue;
    }
    const auto towards = [&](std::size_t neighbour, std::size_t piece) {
      const Edge* edge = edge_at(node, piece);
      return edge != nullptr ? edge->spot.distance : scan_.distance(neighbour);
    };
    if (here <= towards(node - 1, node - 1) && here < towards(node + 1, node)) {
      refine_around(node, spots);
    }
  }
  for (const Edge& edge : edges_) {
    const bool edge_first = edge.spot.piece < edge.node;
    const double inside = scan_.distance(edge.node);
    const bool least = edge_first ? edge.spot.distance < inside : edge.spot.distance <= inside;
    if (least && edge.spot.distance <= highest) {
      const double length = length_of(edge.spot.piece);
      spots.push_back(edge_first ? refine(edge.spot.piece, edge.spot.along, length)
                                 : refine(edge.spot.piece, 0.0, edge.spot.along));
    }
  }
  for (const Ridge& ridge : wheel_.ridges()) {
    if (const auto spot = least_on_ridge(ridge.node)) {
      spots.push_back(*spot);
    }
  }
  std::stable_sort(spots.begin(), spots.end(),
                   [](const auto& a, const auto& b) { return a.distance < b.distance; });
  const double limit = spots.front().distance + near_tolerance;
  std::erase_if(spots, [limit](const auto& spot) { return spot.distance > limit; });
  return spots;
}

std::optional<LocusSpot> SideSearch::follow(const Pose& pose, const LocusSpot& from) {
  pose_ = LocusPose(pose);
  if (const auto still = from.turned < 1.0 ? least_on_ridge(from.piece) : std::nullopt) {
    return still;
  }
  std::size_t piece = from.piece;
  int direction = 0;
  while (true) {
    const double length = length_of(piece);
    const Meeting begin = meet(piece, 0.0);
    const Meeting end = meet(piece, length);
    if (!begin.exists || !end.exists) {
      return std::nullopt;
    }
    if (begin.sine < 0.0 && end.sine > 0.0) {
      return refine(piece, 0.0, length);
    }
    const int next = begin.sine >= 0.0 ? -1 : 1;
    if (direction == -next) {
      // Down from both sides to the node between two pieces: a kink of the wheel.
      const auto on_ridge = least_on_ridge(next < 0 ? piece : piece + 1);
      return on_ridge   ? on_ridge
             : next < 0 ? LocusSpot{piece, 0.0, begin.distance}
                        : LocusSpot{piece, length, end.distance};
    }
    direction = next;
    if (next < 0 ? piece == 0 : piece + 1 == wheel_.graph().piece_count()) {
      return std::nullopt;
    }
    piece = next < 0 ? piece - 1 : piece + 1;
  }
}

DistanceSample SideSearch::sample(const LocusSpot& spot) const {
  const ContactCandidate whole = candidate(spot);
  const double rail_slope = std::tan(whole.rail_angle);
  return {whole.wheel, whole.distance, rail_slope, 0.0, 0.0, whole.wheel.slope() - rail_slope};
}

/// The points of a ridge between those of its flanks.
void SideSearch::add_ridge(const Ridge& ridge, std::vector<DistanceSample>& samples) const {
  for (const auto& [turned, meeting] : ridge_places(ridge, least_ridge_samples)) {
    if (!meeting.exists || turned >= 1.0) {
      continue;
    }
    const CurvePoint edge = on_ridge(ridge, turned);
    bool exists = false;
    const LocusPoint place = wheel_.locus(edge, pose_.angle_at(edge.slope(), exists), pose_);
    if (exists && rail_.covers(place.position.y)) {
      const HeightPoint rail = rail_.at(place.position.y);
      samples.push_back({place, place.position.z - rail.height, rail.slope, 0.0, 0.0,
                         place.slope() - rail.slope});
    }
  }
}

std::vector<DistanceSample> SideSearch::samples() const {
  std::vector<DistanceSample> samples;
  samples.reserve(scan_.last() - scan_.first() + edges_.size() +
                  least_ridge_samples * wheel_.ridges().size());
  const ProfileNodes& nodes = wheel_.nodes();
  auto edge = edges_.begin();
  auto ridge = wheel_.ridges().begin();
  for (std::size_t node = scan_.first(); node < scan_.last(); ++node) {
    for (; edge != edges_.end() && edge->spot.piece < node; ++edge) {
      samples.push_back(sample(edge->spot));
    }
    for (; ridge != wheel_.ridges().end() && ridge->node <= node; ++ridge) {
      if (ridge->node == node && yaw_tangent() != 0.0) {
        add_ridge(*ridge, samples);
      }
    }
    if (scan_.over_rail(node)) {
      const double slope = nodes.slope[node];
      const double rail_slope = scan_.rail_slope(node);
      const double rho = wheel_.radius() + nodes.height[node];
      samples.push_back({{scan_.position(node), nodes.lateral[node],
                          1.0 / (rho * std::sqrt(1.0 + slope * slope))},
                         scan_.distance(node),
                         rail_slope,
                         0.0,
                         0.0,
                         pose_.slope_at(slope) - rail_slope});
    }
  }
  return samples;
}

ContactCandidate SideSearch::candidate(const LocusSpot& spot) const {
  const CurvePoint profile_point = spot.turned < 1.0 ? on_ridge(*ridge_at(spot.piece), spot.turned)
                                                     : profile_at(spot.piece, spot.along);
  bool exists = false;
  ContactCandidate result;
  result.wheel = wheel_.locus(profile_point, pose_.angle_at(profile_point.slope(), exists), pose_);
  result.distance = spot.distance;
  const double y = result.wheel.position.y;
  const double rail_slope = rail_.at(y).slope;
  result.rail_angle = std::atan(rail_slope);
  const CurveGraph& graph = wheel_.graph();
  const double wheel_arc = graph.curve().starts()[graph.first_piece() + spot.piece] + spot.along;
  const double rail_reach = same_place / std::sqrt(1.0 + rail_slope * rail_slope);
  result.at_profile_end = wheel_arc <= graph.arc_begin() + same_place ||
                          wheel_arc >= graph.arc_end() - same_place ||
                          y <= rail_.begin() + rail_reach || y >= rail_.end() - rail_reach;
  return result;
}

ContactScan contacts_of(const SideSearch& search, double near_tolerance) {
  ContactScan scan{search.samples(), {}, search.yaw_tangent()};
  for (const LocusSpot& spot : search.least_spots(near_tolerance)) {
    scan.candidates.push_back(search.candidate(spot));
  }
  return scan;
}

ContactScan search_contacts(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose,
                            double near_tolerance) {
  SideSearch search(wheel, rail);
  search.scan(pose);
  return contacts_of(search, near_tolerance);
}

} // namespace wrc
