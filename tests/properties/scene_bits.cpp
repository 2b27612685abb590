// Prints a line for each of a series of random scenes: its number, its status, and a checksum of
// the bits of all its results, fields and derivatives included. Two builds of the library that
// print the same lines compute the same bits.
//
// Usage: scene_bits drawn|loaded|posed|curved|varying COUNT SEED [FIRST]
// Drawn: drawn_scene.hpp. Loaded, posed: rolling_scene.hpp. Curved: loaded scenes that are solved
// along curves. Varying: varying_scene.hpp, whose lists are written into the folder where the
// program runs. With COUNT = 1 all numbers of the scene are printed as well, in 17 digits. Times
// are left out. scripts/compare_bits.sh runs this program on two libraries.
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "rolling_scene.hpp"
#include "varying_scene.hpp"

namespace {

using namespace properties;

/// FNV-1a (Fowler, Noll, Vo) of 64 bits.
class Checksum {
public:
  void add(const std::string& text) {
    for (const char letter : text) {
      add_byte(static_cast<unsigned char>(letter));
    }
  }
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned shift = 0; shift < 64; shift += 8) {
      add_byte(static_cast<unsigned char>(bits >> shift));
    }
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

private:
  void add_byte(unsigned char byte) {
    value_ ^= byte;
    value_ *= 1099511628211ULL;
  }
  std::uint64_t value_ = 14695981039346656037ULL;
};

void add_fields(const wrcontact::Scene& scene, const std::string& place, Checksum& sum) {
  for (const char* field : {".pressure", ".undeformed_distance", ".displacement", ".traction_x",
                            ".traction_y", ".slip_x", ".slip_y", ".creep_pressure"}) {
    const std::string name = place + field;
    std::int64_t count = 0;
    if (wrc_scene_field(scene.handle(), name.c_str(), nullptr, 0, &count) != WRC_OK || count == 0) {
      continue;
    }
    sum.add(name);
    for (const double value : scene.field(name)) {
      sum.add(value);
    }
  }
}

void print_scene(const DrawnScene& drawn, long index, bool with_values) {
  Checksum sum;
  std::string status;
  try {
    const wrcontact::Scene scene = drawn.made();
    const wrc_status solved = wrc_scene_solve(scene.handle());
    status = wrc_status_name(solved);
    if (solved == WRC_OK || solved == WRC_NOT_CONVERGED) {
      for (const std::string& name : scene.number_names()) {
        double value = 0.0;
        if (name.find("time_ms") != std::string::npos ||
            wrc_scene_number(scene.handle(), name.c_str(), &value) != WRC_OK) {
          continue;
        }
        sum.add(name);
        sum.add(value);
        if (with_values) {
          std::printf("%s = %.17g\n", name.c_str(), value);
        }
      }
      for (const char* side : {"left", "right"}) {
        add_fields(scene, side, sum);
        for (int i = 0; i < 4; ++i) {
          add_fields(scene, side + (".patches." + std::to_string(i)), sum);
        }
      }
    }
  } catch (const wrcontact::Error&) {
    status = "refused";
  }
  std::printf("%ld %s %016llx\n", index, status.c_str(),
              static_cast<unsigned long long>(sum.value()));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  const std::string kind = argc > 1 ? argv[1] : "";
  const std::array<std::string, 5> kinds{"drawn", "loaded", "posed", "curved", "varying"};
  bool is_known = false;
  for (const std::string& known : kinds) {
    is_known = is_known || kind == known;
  }
  if (argc < 4 || argc > 5 || !is_known) {
    std::fputs("usage: scene_bits drawn|loaded|posed|curved|varying COUNT SEED [FIRST]\n", stderr);
    return 2;
  }
  const long count = std::strtol(argv[2], nullptr, 10);
  const auto seed = std::strtoull(argv[3], nullptr, 10);
  const long begin = argc > 4 ? std::strtol(argv[4], nullptr, 10) : 0;
  std::optional<VaryingLists> lists;
  if (kind == "varying") {
    lists.emplace("no_other_lists");
  }
  for (long i = begin; i < begin + count; ++i) {
    const std::uint64_t of_scene = seed * 1000000007ULL + static_cast<std::uint64_t>(i);
    DrawnScene drawn = kind == "drawn"   ? DrawnScene(of_scene)
                       : lists           ? lists->scene(of_scene)
                       : kind == "posed" ? rolling_posed_scene(of_scene)
                                         : rolling_loaded_scene(of_scene);
    if (kind == "curved") {
      drawn.set("solve.curved", std::string(i % 2 == 0 ? "yes" : "auto"));
    }
    print_scene(drawn, i, count == 1);
  }
  return 0;
}
