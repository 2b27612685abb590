#include "profile/sliced_profile.hpp"

#include <algorithm>

namespace wrc {

bool has_equal_slices(const SlicedProfile& profile) {
  const ProfileSlice& first = profile.slices.front();
  return std::all_of(profile.slices.begin(), profile.slices.end(), [&](const ProfileSlice& slice) {
    bool equal = slice.curve.piece_count() == first.curve.piece_count() &&
                 std::ranges::all_of(slice.features, [](const auto& f) { return f.has_value(); });
    for (std::size_t piece = 0; equal && piece < first.curve.piece_count(); ++piece) {
      const Curve::Polynomials& here = slice.curve.polynomials(piece);
      const Curve::Polynomials& there = first.curve.polynomials(piece);
      equal = slice.curve.starts()[piece + 1] == first.curve.starts()[piece + 1] &&
              here.lateral == there.lateral && here.height == there.height;
    }
    return equal;
  });
}

} // namespace wrc
