#include "geometry/varying_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/root_bracket.hpp"
#include "geometry/constants.hpp"

namespace wrc {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Of the circle through a place beside its lowest point.
double curvature_of(double length, double height) {
  return 2.0 * height / (length * length + height * height);
}

/// Along a row to one side of a least distance: how far it is to where the distance is larger by
/// the typical depth. Where a body ends before that, or the distance falls again, to another least
/// one, how far it is on the circle through that place: as it sinks below the depth, this goes on
/// without a jump.
double half_length(GapField& field, const VaryingSearch::Spot& spot, double sign) {
  struct Place {
    double length;
    double slope;  ///< away from the least distance
    double height; ///< over it, less the typical depth
  };
  const auto on_circle = [&](const Place& through) {
    const double height = through.height + typical_depth;
    const double curvature = through.length > least_valley_half
                                 ? curvature_of(through.length, height)
                                 : spot.point.gap.xx;
    return std::sqrt(
        std::max(0.0, 2.0 / std::max(curvature, least_valley_curvature) - typical_depth) *
        typical_depth);
  };
  const auto at = [&](double length) -> std::optional<Place> {
    const auto point = field.at(spot.x + sign * length, spot.y);
    if (!point) {
      return std::nullopt;
    }
    return Place{length, sign * point->gap.x,
                 point->gap.value - spot.point.gap.value - typical_depth};
  };
  Place inside{0.0, std::max(row_tolerance * spot.point.gap.xx, least_valley_slope),
               -typical_depth};
  Place outside = inside;
  double step = longest_newton_step;
  while (outside.height < 0.0 && outside.slope > 0.0) {
    inside = outside;
    auto next = at(inside.length + step);
    while (!next && step > row_tolerance) { // at the end of a body, halved ever after
      step *= 0.5;
      next = at(inside.length + step);
    }
    if (!next || inside.length + step > longest_valley_half) {
      return on_circle(inside);
    }
    outside = *next;
  }
  if (outside.slope <= 0.0) {
    Place top = outside;
    RootBracket slopes({inside.length, inside.slope}, {outside.length, outside.slope});
    slopes.narrow(row_tolerance, [&](double length) -> std::optional<double> {
      const auto found = at(length);
      if (!found) {
        return std::nullopt;
      }
      top = *found;
      return found->slope;
    });
    if (top.height < 0.0) {
      return on_circle(top);
    }
    outside = top;
  }
  // Newton's method within the bracket, from where a secant meets the depth.
  double length = inside.length + (outside.length - inside.length) * inside.height /
                                      (inside.height - outside.height);
  for (int step = 0; step < most_row_steps; ++step) {
    const auto found = at(length);
    if (!found) {
      break;
    }
    (found->height < 0.0 ? inside : outside) = *found;
    double next = length - found->height / found->slope;
    if (!(next > inside.length && next < outside.length)) {
      next = 0.5 * (inside.length + outside.length);
    }
    if (std::abs(next - length) <= row_tolerance) {
      return next;
    }
    length = next;
  }
  return length;
}

} // namespace

VaryingSearch::VaryingSearch(const WheelSurface& wheel, const RailSurface& rail)
    : wheel_(wheel), rail_(rail), round_(wheel.as_round()), prism_(rail.as_prism()) {}

/// Where the locus turns back under yaw, its rows are those that it reached before.
void VaryingSearch::place_rows() {
  rows_.clear();
  const LocusPose locus(pose_);
  const ProfileNodes& nodes = wheel_.nodes();
  for (std::size_t node = 0; node < nodes.lateral.size(); ++node) {
    bool exists = false;
    const LocusAngle angle = locus.angle_at(nodes.slope[node], exists);
    if (!exists) {
      continue;
    }
    const double rho = wheel_.radius() + nodes.height[node];
    const Vector3 place = locus.rotation.to_track(
        {rho * angle.sine, wheel_.taping_line() + nodes.lateral[node], -rho * angle.cosine});
    const double y = place.y + pose_.lateral;
    if (!rows_.empty() && !(y > rows_.back() + same_chain)) {
      continue;
    }
    if (!rows_.empty()) {
      const double last = rows_.back();
      const auto parts = static_cast<int>(std::ceil((y - last) / row_spacing - same_chain));
      for (int part = 1; part < parts; ++part) {
        rows_.push_back(std::lerp(last, y, static_cast<double>(part) / parts));
      }
    }
    rows_.push_back(y);
  }
}

/// Newton's method within a bracket, down from x.
std::optional<VaryingSearch::Spot> VaryingSearch::least_in_row(GapField& field, double x,
                                                               double y) {
  auto point = field.at(x, y);
  if (!point) {
    return std::nullopt;
  }
  double low = -unbounded; // distances fall there, and rise at `high`
  double high = unbounded;
  for (int step = 0; step < most_row_steps; ++step) {
    const Graph& gap = point->gap;
    (gap.x < 0.0 ? low : high) = x;
    double move = gap.xx > 0.0  ? -gap.x / gap.xx
                  : gap.x < 0.0 ? longest_newton_step
                                : -longest_newton_step;
    move = std::clamp(move, -longest_newton_step, longest_newton_step);
    const bool is_inside = x + move > low && x + move < high;
    if (!is_inside && std::isfinite(low) && std::isfinite(high)) {
      move = 0.5 * (low + high) - x;
    }
    if (!(std::abs(move) > row_tolerance)) {
      return Spot{x, y, *point};
    }
    auto next = field.at(x + move, y);
    while (!next) {
      move *= 0.5;
      if (!(std::abs(move) > row_tolerance)) {
        return Spot{x, y, *point, true, true};
      }
      next = field.at(x + move, y);
    }
    x += move;
    point = next;
  }
  return std::nullopt;
}

/// Local minima along x of some rows.
std::vector<VaryingSearch::Spot> VaryingSearch::coarse_minima() {
  std::vector<double> rows;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows.empty() || i + 1 == rows_.size() || rows_[i + 1] - rows.back() > coarse_row_spacing) {
      rows.push_back(rows_[i]);
    }
  }
  if (rows.empty()) {
    return {};
  }
  double steepest = steepest_along;
  if (rail_.is_prismatic_along(along_track)) {
    steepest =
        std::min(steepest, wheel_.touch_slope(pose_.yaw) + coarse_row_step / wheel_.radius());
  }
  const auto reach = std::ceil(steepest * wheel_.radius() / coarse_row_step);
  const auto places = static_cast<std::size_t>(2.0 * reach) + 1;
  const auto x_of = [&](std::size_t place) {
    return coarse_row_step * (static_cast<double>(place) - reach);
  };
  std::vector<double> gaps(places * rows.size()); // by places, then rows
  for (std::size_t i = 0; i < places; ++i) {
    field_->scan(x_of(i), rows, std::span(gaps).subspan(i * rows.size(), rows.size()));
  }
  const double highest = *std::ranges::min_element(gaps) + chain_height;
  std::vector<Spot> minima;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < places; ++i) {
      const double here = gaps[i * rows.size() + k];
      const double before = i > 0 ? gaps[(i - 1) * rows.size() + k] : unbounded;
      const double after = i + 1 < places ? gaps[(i + 1) * rows.size() + k] : unbounded;
      if (here <= before && here < after && here < highest) {
        field_->restart();
        if (auto spot = least_in_row(*field_, x_of(i), rows[k])) {
          minima.push_back(*spot);
        }
      }
    }
  }
  std::stable_sort(minima.begin(), minima.end(), [](const Spot& one, const Spot& other) {
    return one.point.gap.value < other.point.gap.value;
  });
  return minima;
}

bool VaryingSearch::is_known(const Spot& spot) const {
  return std::any_of(chains_.begin(), chains_.end(), [&](const Chain& chain) {
    return std::any_of(chain.rows.begin(), chain.rows.end(), [&](const Spot& known) {
      return known.y == spot.y && std::abs(known.x - spot.x) < same_chain;
    });
  });
}

/// The least distance of another row that a least distance becomes on the way there; `found`: the
/// nearest one, which may be another. None if there is none, as far as halvings of the way show.
std::optional<VaryingSearch::Spot> VaryingSearch::followed(const Spot& from, const Spot& found,
                                                           int halvings) {
  if (std::abs(found.x - from.x) <= coarse_row_step) {
    return found;
  }
  const auto middle =
      halvings > 0 ? least_in_row(*field_, from.x, 0.5 * (from.y + found.y)) : std::nullopt;
  const auto reached = middle ? followed(from, *middle, halvings - 1) : std::nullopt;
  const auto next = reached ? least_in_row(*field_, reached->x, found.y) : std::nullopt;
  return next ? followed(*reached, *next, halvings - 1) : std::nullopt;
}

/// Follows a chain from its last row, to where it ends or is `highest`. Where the locus turns back
/// the nearest least distance of the next row is returned, which belongs to another chain.
std::optional<VaryingSearch::Spot> VaryingSearch::track(Chain& chain, std::size_t from,
                                                        int direction, double highest) {
  for (auto index = static_cast<std::ptrdiff_t>(from) + direction;
       index >= 0 && index < std::ssize(rows_); index += direction) {
    const Spot before = chain.rows.back();
    if (before.point.gap.value > highest) {
      return std::nullopt;
    }
    const double y = rows_[static_cast<std::size_t>(index)];
    auto next = least_in_row(*field_, before.x, y);
    if (!next) { // at the end of a body: its edge
      double inside = before.y;
      double outside = y;
      std::optional<Spot> edge;
      while (std::abs(outside - inside) > row_tolerance) {
        const double middle = 0.5 * (inside + outside);
        auto spot = least_in_row(*field_, before.x, middle);
        (spot ? inside : outside) = middle;
        if (spot) {
          edge = spot;
        }
      }
      if (edge) {
        chain.rows.push_back(*edge);
      }
      return std::nullopt;
    }
    const auto same = followed(before, *next, most_row_halvings);
    if (!same) {
      return next;
    }
    chain.rows.push_back(*same);
  }
  return std::nullopt;
}

/// Between two rows, of which distances fall at one and rise at the other.
VaryingSearch::Spot VaryingSearch::between(const Spot& low, const Spot& high) {
  Spot found = low.point.gap.value <= high.point.gap.value ? low : high;
  RootBracket bracket({low.y, low.point.gap.y}, {high.y, high.point.gap.y});
  bracket.narrow(position_tolerance, [&](double y) -> std::optional<double> {
    const auto spot = least_in_row(*field_, found.x, y);
    if (!spot) {
      return std::nullopt;
    }
    if (spot->point.gap.value <= found.point.gap.value) {
      found = *spot;
    }
    return spot->point.gap.y;
  });
  return found;
}

std::vector<VaryingSearch::Spot> VaryingSearch::minima_of(const Chain& chain) {
  std::vector<Spot> minima;
  const std::vector<Spot>& rows = chain.rows;
  const auto slope = [&](std::size_t i) { return rows[i].point.gap.y; };
  if (slope(0) >= 0.0 && !chain.turns_first) {
    minima.push_back(rows.front());
    minima.back().at_end = true;
  }
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    if (slope(i) < 0.0 && slope(i + 1) >= 0.0) {
      minima.push_back(between(rows[i], rows[i + 1]));
    }
  }
  if (slope(rows.size() - 1) < 0.0 && !chain.turns_last) {
    minima.push_back(rows.back());
    minima.back().at_end = true;
  }
  std::stable_sort(minima.begin(), minima.end(), [](const Spot& one, const Spot& other) {
    return one.point.gap.value < other.point.gap.value;
  });
  return minima;
}

bool VaryingSearch::try_scan(const Pose& pose) {
  pose_ = pose;
  field_.emplace(wheel_, rail_, pose);
  plain_.emplace(round_, prism_, pose);
  place_rows();
  chains_.clear();
  minima_.clear();
  std::vector<Spot> starts = coarse_minima();
  if (starts.empty()) {
    return false;
  }
  const double highest = starts.front().point.gap.value + chain_height;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Spot start = starts[i];
    if (start.point.gap.value > highest || is_known(start)) {
      continue;
    }
    const auto index =
        static_cast<std::size_t>(std::ranges::lower_bound(rows_, start.y) - rows_.begin());
    Chain chain{{start}};
    field_->restart();
    const auto before = track(chain, index, -1, highest);
    std::reverse(chain.rows.begin(), chain.rows.end());
    field_->restart();
    const auto after = track(chain, index, 1, highest);
    chain.turns_first = before.has_value();
    chain.turns_last = after.has_value();
    chains_.push_back(std::move(chain));
    for (const auto& other : {before, after}) {
      if (other) {
        starts.push_back(*other);
      }
    }
  }
  std::vector<std::vector<Spot>> found;
  for (const Chain& chain : chains_) {
    field_->restart();
    found.push_back(minima_of(chain));
    if (found.back().empty()) { // slopes that are not numbers
      found.back().push_back(chain.rows.front());
    }
  }
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < found.size(); ++k) {
    if (found[k].front().point.gap.value < found[nearest].front().point.gap.value) {
      nearest = k;
    }
  }
  std::swap(chains_[0], chains_[nearest]);
  std::swap(found[0], found[nearest]);
  minima_ = std::move(found);
  least_ = minima_.front().front();
  return true;
}

VaryingSearch::HalfLengths VaryingSearch::half_lengths(GapField& field, const Spot& spot) {
  return {half_length(field, spot, -1.0), half_length(field, spot, 1.0)};
}

/// Along the row: of the round wheel below the axle, times that of the distance over that of the
/// distance between this wheel and the prismatic rail.
DistanceSample VaryingSearch::sample(const Spot& spot, bool is_near) {
  const Graph& rail = spot.point.rail;
  DistanceSample result{
      {{spot.x, spot.y, rail.value + spot.point.gap.value},
       spot.point.wheel_lateral,
       std::max(spot.point.gap.xx, least_valley_curvature)}, // where a body ends, any
      spot.point.gap.value,
      rail.y,
      rail.x,
      0.0,
      spot.point.gap.y};
  if (!is_near || spot.at_end) {
    return result;
  }
  LocusPlace& place = result.wheel;
  const HalfLengths here = half_lengths(*field_, spot);
  place.position.x += here.shift();
  place.normal_curvature = curvature_of(here.mean(), typical_depth);
  if (const auto plain = least_in_row(*plain_, spot.x, spot.y)) {
    const HalfLengths there = half_lengths(*plain_, *plain);
    const double slope = wheel_.graph().heights().at(plain->point.wheel_lateral).slope;
    place.position.x -= there.shift();
    result.ahead = place.position.x - plain->x;
    place.normal_curvature /= curvature_of(there.mean(), typical_depth) *
                              (wheel_.radius() + plain->point.wheel_height) *
                              std::sqrt(1.0 + slope * slope);
  }
  return result;
}

ContactCandidate VaryingSearch::candidate(const Spot& spot) const {
  const Graph& rail = spot.point.rail;
  const double cosine = 1.0 / std::sqrt(1.0 + rail.y * rail.y);
  ContactCandidate result;
  result.wheel.position = {spot.x, spot.y, rail.value + spot.point.gap.value};
  result.wheel.lateral = spot.point.wheel_lateral;
  result.wheel.tangent_y = cosine;
  result.wheel.tangent_z = rail.y * cosine;
  result.wheel.height = spot.point.wheel_height;
  result.wheel.wheel_angle = spot.point.wheel_angle;
  result.distance = spot.point.gap.value;
  result.rail_angle = std::atan(rail.y);
  result.rail_rise = rail.x;
  result.at_profile_end = spot.at_end;
  result.at_part_end = spot.at_part_end;
  return result;
}

std::vector<ContactScan> VaryingSearch::scans(double near_tolerance) {
  std::vector<ContactScan> scans;
  const double least = least_.point.gap.value;
  for (std::size_t k = 0; k < chains_.size(); ++k) {
    ContactScan scan;
    scan.yaw_tangent = std::tan(pose_.yaw);
    for (const Spot& spot : minima_[k]) {
      if (scan.candidates.empty() || spot.point.gap.value <= least + near_tolerance) {
        scan.candidates.push_back(candidate(spot));
        const DistanceSample here = sample(spot, true);
        scan.candidates.back().wheel.normal_curvature = here.wheel.normal_curvature;
        scan.candidates.back().ahead = here.ahead;
      }
    }
    field_->restart();
    const std::vector<Spot>& rows = chains_[k].rows;
    const auto is_near = [&](std::size_t i) {
      return i < rows.size() && rows[i].point.gap.value <= least + near_chain_height;
    };
    for (std::size_t i = 0; i < rows.size(); ++i) { // with the next ones, whose curvature counts
      scan.samples.push_back(sample(rows[i], is_near(i - 1) || is_near(i) || is_near(i + 1)));
    }
    scans.push_back(std::move(scan));
  }
  return scans;
}

std::optional<VaryingSearch::Spot> VaryingSearch::follow(const Pose& pose, const Spot& from) {
  pose_ = pose;
  field_.emplace(wheel_, rail_, pose);
  double y = from.y;
  auto spot = least_in_row(*field_, from.x, y);
  for (int step = 0; spot && step < most_row_steps; ++step) {
    const Graph& gap = spot->point.gap;
    const double second = gap.yy - gap.xy * gap.xy / gap.xx; // of the row's least distance
    const double move = std::clamp(-gap.y / std::max(second, 1e-3), -row_spacing, row_spacing);
    if (std::abs(move) <= row_tolerance) {
      return spot;
    }
    y += move;
    spot = least_in_row(*field_, spot->x, y);
  }
  return std::nullopt;
}

double VaryingSearch::by_roll(const Spot& spot) const {
  const Rotation rotation(pose_);
  const Graph& rail = spot.point.rail;
  const double z = rail.value + spot.point.gap.value;
  const double y = rotation.cos_yaw * (spot.y - pose_.lateral) - rotation.sin_yaw * spot.x;
  return y + (rail.y * rotation.cos_yaw - rail.x * rotation.sin_yaw) * z;
}

} // namespace wrc
