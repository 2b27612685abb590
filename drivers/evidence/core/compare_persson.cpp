/// A disc in a hole of nearly its radius: rows along a curve and in a plane against the closed
/// form.
///
///   compare_persson [ROWS]     default 8000 in contact
///
/// Prints a table, over half angles of contact in rad: the closed form's largest pressure, errors
/// of the largest pressure and of the half angle at a prescribed load in %, and those of Hertz's
/// formulas (tests/core/support/conformal_disc.hpp).
#include <cstdio>

#include "arguments.hpp"
#include "support/conformal_disc.hpp"

namespace {

constexpr const char* usage =
    "compare_persson [ROWS]     default 8000 in contact\n\n"
    "Compares contact of a disc in a hole of nearly its radius with the closed form.\n";

int compare(const wrc::evidence::Arguments& arguments) {
  using namespace wrc::test;
  const auto rows = static_cast<std::size_t>(arguments.whole(0, "ROWS", 8000));
  arguments.refuse_beyond(1);
  std::puts("| half angle | p_max R/P | curve: p_max, half angle | plane | Hertz "
            "|\n|---|---|---|---|---|");
  for (const double angle : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2}) {
    const ConformalDisc exact(angle);
    const double largest = exact.pressure(0.0);
    std::printf("| %.2f | %.4f |", angle, largest);
    for (const DiscAnswer& found : {solve_disc(DiscRows::curve, angle, rows),
                                    solve_disc(DiscRows::plane, angle, rows), exact.by_hertz()}) {
      std::printf(" %+.2f, %+.2f |", 100.0 * (found.largest_pressure / largest - 1.0),
                  100.0 * (found.half_angle / angle - 1.0));
    }
    std::puts("");
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return wrc::evidence::run(argc, argv, usage, compare);
}
