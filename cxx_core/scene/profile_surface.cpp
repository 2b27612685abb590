#include "scene/profile_surface.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "geometry/along_check.hpp"
#include "measured/sliced_profile_reader.hpp"

namespace wrc {
namespace {

std::string range_text(const char* one, const char* several, std::size_t first, std::size_t last) {
  return first == last ? one + (' ' + std::to_string(first))
                       : several + (' ' + std::to_string(first)) + " to " + std::to_string(last);
}

/// The slices without a feature: "slices 1 to 7, slice 20"; empty if there is none.
std::string slices_without(const SlicedProfile& profile, std::size_t feature) {
  std::string text;
  const std::size_t count = profile.slices.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (profile.slices[i].features[feature]) {
      continue;
    }
    const std::size_t first = i;
    while (i + 1 < count && !profile.slices[i + 1].features[feature]) {
      ++i;
    }
    text += (text.empty() ? "" : ", ") + range_text("slice", "slices", first + 1, i + 1);
  }
  return text;
}

void add_features(const SlicedProfile& profile, std::vector<std::string>& lines) {
  const std::size_t count = profile.slices.front().features.size();
  if (count < 2) {
    lines.push_back(std::string(count == 0 ? "no features" : "1 feature, which joins nothing") +
                    ": equal shares of the slices' lengths correspond");
    return;
  }
  lines.push_back(std::to_string(count) + " features");
  for (std::size_t i = 0; i < count; ++i) {
    const std::string absent = slices_without(profile, i);
    const std::size_t first = i;
    while (i + 1 < count && slices_without(profile, i + 1) == absent) {
      ++i;
    }
    if (!absent.empty()) {
      lines.push_back(range_text("feature", "features", first + 1, i + 1) + " absent from " +
                      absent);
    }
  }
}

/// Slopes around a wheel of unknown radius are not looked at.
constexpr double unknown_radius = std::numeric_limits<double>::infinity();

void add_check(const AlongCheck& check, ProfileKind kind, std::vector<std::string>& lines) {
  lines.push_back(swing_text(check));
  for (const Warning& warning : warnings_of(check, kind)) {
    lines.push_back("warning: " + warning.text);
  }
}

std::vector<SurfaceSheet> sheets_or_refusal(const SlicedProfile& profile, double smoothing_length,
                                            bool is_given, const std::filesystem::path& path) {
  const double period = profile.kind == ProfileKind::wheel ? 2.0 * std::numbers::pi : 0.0;
  try {
    return sheets_of(profile, smoothing_length, period, {period > 0.0 ? "rad" : "mm"});
  } catch (const Error& error) {
    const ErrorCode code = is_given ? error.code() : ErrorCode::file_malformed;
    throw Error(code, path.string() + ": " + error.what());
  }
}

} // namespace

ProfileSurface::ProfileSurface(const std::filesystem::path& path, const ReadOptions& options,
                               std::optional<double> smoothing_length)
    : profile_(read_sliced_profile(path, options)),
      smoothing_length_(smoothing_length_of(profile_, smoothing_length)),
      sheets_(sheets_or_refusal(profile_, smoothing_length_, smoothing_length.has_value(), path)) {
  for (ProfileSlice& slice : profile_.slices) {
    slice.curve = {}; // the sheets have what they need
  }
}

std::vector<std::string> ProfileSurface::summary() const {
  const bool is_rail = profile_.kind == ProfileKind::rail;
  const std::string unit = is_rail ? " mm" : " rad";
  const std::string way = is_rail ? " along the track" : " around the wheel";
  const std::vector<ProfileSlice>& slices = profile_.slices;
  double closest = std::numeric_limits<double>::infinity();
  double farthest = 0.0;
  for (std::size_t i = 1; i < slices.size(); ++i) {
    closest = std::min(closest, slices[i].place - slices[i - 1].place);
    farthest = std::max(farthest, slices[i].place - slices[i - 1].place);
  }
  std::vector<std::string> lines{std::string(is_rail ? "rail" : "wheel") + " with " +
                                 std::to_string(slices.size()) + " slices" + way + ", " +
                                 short_text_of(slices.front().place) + " to " +
                                 short_text_of(slices.back().place) + unit};
  if (slices.size() > 1) {
    lines.back() += ", " +
                    (short_text_of(closest) == short_text_of(farthest)
                         ? short_text_of(closest)
                         : short_text_of(closest) + " to " + short_text_of(farthest)) +
                    unit + " apart";
  }
  lines.insert(lines.end(), profile_.corrections.begin(), profile_.corrections.end());
  lines.push_back(smoothing_length_ > 0.0
                      ? "smoothed" + way + ": waves of " + short_text_of(smoothing_length_) + unit +
                            " are halved"
                      : "not smoothed" + way + ": the surface passes through the slices");
  add_features(profile_, lines);
  const std::vector<SheetExtent> extents = sheet_extents(profile_);
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    const SheetExtent& extent = extents[i];
    const Stretch along = sheets_[i].along();
    const Stretch across = sheets_[i].across();
    std::string text = "surface " + std::to_string(i + 1) + ": ";
    if (slices.front().features.size() >= 2) {
      text += range_text("feature", "features", extent.first_part + 1, extent.last_part + 2) + ", ";
    }
    text += range_text("slice", "slices", extent.first_slice + 1, extent.last_slice + 1) + ", ";
    text += sheets_[i].is_periodic()
                ? "closed around the wheel"
                : short_text_of(along.begin) + " to " + short_text_of(along.end) + unit;
    lines.push_back(text + ", " + short_text_of(across.end - across.begin) + " mm across, " +
                    short_text_of(1e-6 * static_cast<double>(sheets_[i].memory())) + " MB");
  }
  add_check(
      check_along(profile_, sheets_, {is_rail ? "mm" : "rad", is_rail ? 1.0 : unknown_radius}),
      profile_.kind, lines);
  return lines;
}

} // namespace wrc
