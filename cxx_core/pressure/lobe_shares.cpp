#include "pressure/lobe_shares.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/smoothstep.hpp"
#include "pressure/constants.hpp"

namespace wrc {
namespace {

/// A valley or a crest of the spline.
struct Extreme {
  double place = 0.0; ///< in rows, from the centre of the first one
  double value = 0.0;
};

/// Crests, and the valleys between them.
struct Relief {
  std::vector<Extreme> crests;
  std::vector<Extreme> valleys;

  [[nodiscard]] double depth_below(std::size_t crest, std::size_t valley) const {
    return 1.0 - valleys[valley].value / crests[crest].value;
  }
  /// Below the lesser crest.
  [[nodiscard]] double depth(std::size_t valley) const {
    return std::min(depth_below(valley, valley), depth_below(valley + 1, valley));
  }
};

/// The slope of the spline is linear between the borders of a row; at a border it is the difference
/// of the rows beside it.
Relief relief_of(std::span<const double> rows) {
  const auto row = [rows](std::size_t i) { return i < rows.size() ? rows[i] : 0.0; };
  Relief relief;
  std::size_t last = 0; // border of the last slope that is not 0: that before row 0, 1, ...
  double slope = rows.empty() ? 0.0 : rows.front();
  for (std::size_t border = 1; border <= rows.size(); ++border) {
    const double next = row(border) - rows[border - 1];
    if (next == 0.0) {
      continue;
    }
    if (slope != 0.0 && (slope > 0.0) != (next > 0.0)) {
      const auto from = static_cast<double>(last);
      Extreme extreme{0.5 * (from + static_cast<double>(border)) - 0.5, rows[last]};
      if (border == last + 1) {
        const double share = slope / (slope - next);
        const double before = last > 0 ? rows[last - 1] : 0.0;
        extreme = {from + share - 0.5, 0.5 * (before + rows[last]) + 0.5 * slope * share};
      }
      (slope > 0.0 ? relief.crests : relief.valleys).push_back(extreme);
    }
    slope = next;
    last = border;
  }
  return relief;
}

/// Joins lobes with hardly a valley between, the shallowest ones first.
void join_shallow(Relief& relief) {
  while (!relief.valleys.empty()) {
    std::size_t shallowest = 0;
    for (std::size_t k = 1; k < relief.valleys.size(); ++k) {
      if (relief.depth(k) < relief.depth(shallowest)) {
        shallowest = k;
      }
    }
    if (relief.depth(shallowest) > one_lobe_depth) {
      return;
    }
    const auto at = static_cast<std::ptrdiff_t>(shallowest);
    const bool second = relief.crests[shallowest + 1].value > relief.crests[shallowest].value;
    relief.valleys.erase(relief.valleys.begin() + at);
    relief.crests.erase(relief.crests.begin() + at + (second ? 0 : 1));
  }
}

/// Integral of a quadratic B-spline up to t elements from its middle.
double basis_below(double t) {
  const double beyond = 1.5 - std::abs(t);
  if (beyond <= 0.0) {
    return t < 0.0 ? 0.0 : 1.0;
  }
  if (beyond < 1.0) {
    const double tail = beyond * beyond * beyond / 6.0;
    return t < 0.0 ? tail : 1.0 - tail;
  }
  return 0.5 + t * (0.75 - t * t / 3.0);
}

/// Shares of rows by the valleys alone.
std::vector<std::vector<double>> shares_by_valleys(const Relief& relief, std::size_t rows) {
  std::vector<std::vector<double>> shares(relief.crests.size(), std::vector<double>(rows));
  for (std::size_t i = 0; i < rows; ++i) {
    double before = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const double below = k < relief.valleys.size()
                               ? basis_below(relief.valleys[k].place - static_cast<double>(i))
                               : 1.0;
      shares[k][i] = below - before;
      before = below;
    }
  }
  return shares;
}

double own_share(double depth) {
  return smoothstep((depth - one_lobe_depth) / (own_lobe_depth - one_lobe_depth));
}

} // namespace

std::vector<std::vector<double>> lobe_shares(std::span<const double> rows) {
  Relief relief = relief_of(rows);
  join_shallow(relief);
  const std::vector<std::vector<double>> own = shares_by_valleys(relief, rows.size());
  const std::size_t count = own.size();
  // What each lobe gives to the one before and the one after.
  std::vector<double> back(count);
  std::vector<double> on(count);
  for (std::size_t k = 0; k + 1 < count; ++k) {
    const double first = own_share(relief.depth_below(k, k));
    const double second = own_share(relief.depth_below(k + 1, k));
    const double either = first + second - first * second;
    on[k] = (1.0 - first) * second / either;
    back[k + 1] = (1.0 - second) * first / either;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double to_next = on[k] * (1.0 - 0.5 * back[k]);
    back[k] *= 1.0 - 0.5 * on[k];
    on[k] = to_next;
  }
  std::vector<std::vector<double>> shares = own;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      shares[k][i] *= 1.0 - back[k] - on[k];
      shares[k][i] += k > 0 ? on[k - 1] * own[k - 1][i] : 0.0;
      shares[k][i] += k + 1 < count ? back[k + 1] * own[k + 1][i] : 0.0;
    }
  }
  return shares;
}

} // namespace wrc
