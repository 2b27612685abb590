#include "results/cut_contact.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "remesh/met_distance.hpp"

namespace wrc {
namespace {

constexpr const char* at_cut =
    ": pressures there are too large and do not converge, forces jump by about 1 % of the load "
    "as the contact passes";

/// The end of a part that is nearest to a place, and how far it is.
struct PartEnd {
  double place = 0.0;
  double distance = 0.0;
};

std::optional<PartEnd> nearest_end(std::span<const SurfaceSheet> sheets, double place,
                                   double period) {
  std::optional<PartEnd> nearest;
  for (const SurfaceSheet& sheet : sheets) {
    if (sheet.is_periodic()) {
      continue;
    }
    for (const double end : {sheet.along().begin, sheet.along().end}) {
      const double apart = period > 0.0 ? std::remainder(place - end, period) : place - end;
      if (!nearest || std::abs(apart) < nearest->distance) {
        nearest = PartEnd{end, std::abs(apart)};
      }
    }
  }
  return nearest;
}

class CutSearch {
public:
  CutSearch(const PatchResult& patch, const WheelSurface& wheel, const RailSurface& rail)
      : patch_(patch), wheel_(wheel), rail_(rail) {}

  [[nodiscard]] std::optional<ContactCut> find() const {
    const Grid& grid = patch_.grid;
    if (patch_.pressure.size() != grid.element_count() ||
        patch_.undeformed_distance.size() != grid.element_count()) {
      return std::nullopt;
    }
    bool at_side = false;
    for (std::size_t row = 0; row < grid.lateral_count; ++row) {
      for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
        const std::size_t here = row * grid.longitudinal_count + column;
        if (!(patch_.pressure[here] > 0.0)) {
          continue;
        }
        if (column > 0 && (ends(here, here - 1) || drops(here, here - 1))) {
          if (auto cut =
                  cut_between(row, grid.longitudinal(column - 1), grid.longitudinal(column))) {
            return cut;
          }
        }
        if (column + 1 < grid.longitudinal_count &&
            (ends(here, here + 1) || drops(here, here + 1))) {
          if (auto cut =
                  cut_between(row, grid.longitudinal(column), grid.longitudinal(column + 1))) {
            return cut;
          }
        }
        at_side = at_side || (row > 0 && ends(here, here - grid.longitudinal_count)) ||
                  (row + 1 < grid.lateral_count && ends(here, here + grid.longitudinal_count));
      }
    }
    if (!at_side) {
      return std::nullopt;
    }
    return ContactCut{
        false,
        {WarningClass::profile_end, std::string("contact reaches the side of a part") + at_cut}};
  }

private:
  /// Whether a ray misses a body beside an element under pressure.
  [[nodiscard]] bool ends(std::size_t here, std::size_t beside) const {
    return is_met(patch_.undeformed_distance[here]) && !is_met(patch_.undeformed_distance[beside]);
  }
  /// Whether the surface may drop there.
  [[nodiscard]] bool drops(std::size_t here, std::size_t beside) const {
    const std::vector<double>& distance = patch_.undeformed_distance;
    return !(patch_.pressure[beside] > 0.0) && is_met(distance[beside]) &&
           distance[beside] - distance[here] > patch_.approach;
  }

  /// The end of a part between two columns of a row; none if none is there.
  [[nodiscard]] std::optional<ContactCut> cut_between(std::size_t row, double before,
                                                      double after) const {
    // The ray meets the surface within an element of where it crosses the plane.
    const double reach = 1.5 * (after - before);
    const Vector3 middle =
        patch_.frame.to_track(0.5 * (before + after), patch_.grid.lateral(row), 0.0);
    std::string where;
    if (rail_.varying() != nullptr) {
      const auto end = nearest_end(rail_.varying()->sheets(), rail_.along() + middle.x, 0.0);
      if (end && end->distance <= reach) {
        where = "the rail at " + short_text_of(end->place) + " mm";
      }
    }
    if (where.empty() && wheel_.varying() != nullptr) {
      const double radius = wheel_.radius();
      const auto end =
          nearest_end(wheel_.varying()->sheets(), wheel_.pitch() + std::asin(middle.x / radius),
                      2.0 * std::numbers::pi);
      if (end && end->distance * radius <= reach) {
        where = "the wheel at " + short_text_of(end->place) + " rad";
      }
    }
    if (where.empty()) {
      return std::nullopt;
    }
    return ContactCut{true,
                      {WarningClass::profile_end, "contact reaches an end of " + where + at_cut}};
  }

  const PatchResult& patch_;
  const WheelSurface& wheel_;
  const RailSurface& rail_;
};

/// Those of one plane are solved as parts.
std::optional<ContactCut> cut_of(const PatchResult& patch, const WheelSurface& wheel,
                                 const RailSurface& rail) {
  if (patch.parts.empty()) {
    return CutSearch(patch, wheel, rail).find();
  }
  return find_cut(patch.parts, wheel, rail);
}

} // namespace

std::optional<ContactCut> find_cut(std::span<const PatchResult> patches, const WheelSurface& wheel,
                                   const RailSurface& rail) {
  if (rail.varying() == nullptr && wheel.varying() == nullptr) {
    return std::nullopt;
  }
  std::optional<ContactCut> found;
  for (const PatchResult& patch : patches) {
    if (auto cut = cut_of(patch, wheel, rail); cut && (!found || cut->is_along)) {
      found = std::move(cut);
      if (found->is_along) {
        return found;
      }
    }
  }
  return found;
}

} // namespace wrc
