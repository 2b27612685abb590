/// Random numbers between limits. The same seed draws the same ones on all machines.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace properties {

class Draw {
public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  [[nodiscard]] double between(double least, double greatest) {
    constexpr double steps = 9007199254740992.0; // 2^53
    return least + (greatest - least) * (static_cast<double>(random_() >> 11U) / steps);
  }
  [[nodiscard]] double by_ratio(double least, double greatest) {
    return least * std::exp(between(0.0, std::log(greatest / least)));
  }
  [[nodiscard]] bool chance(double share) { return between(0.0, 1.0) < share; }
  /// Of either sign.
  [[nodiscard]] double signed_by_ratio(double least, double greatest) {
    return (chance(0.5) ? 1.0 : -1.0) * by_ratio(least, greatest);
  }

private:
  std::mt19937_64 random_;
};

} // namespace properties
