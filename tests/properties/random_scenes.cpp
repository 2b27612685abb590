// Draws scenes and checks what must hold for all of them (scene_properties.hpp). Every scene is
// checked for equilibrium, and for two of the other properties in turn.
//
// Usage: random_scenes COUNT SEED [FIRST], in a folder into which scene files of failures go, and
// that of a single scene in any case.
// Prints how many had which status and what failed; exits with 1 if anything did, and with 3 if a
// scene took longer than a minute.
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unistd.h>

#include "scene_properties.hpp"

namespace {

using namespace properties;

constexpr unsigned longest = 60; // s, of a scene with all its checks: a hang, not a measurement

long current = 0;

extern "C" void give_up(int /*signal*/) {
  std::array<char, 64> text{};
  const int length = std::snprintf(text.data(), text.size(), "scene %ld hangs\n", current);
  if (write(STDERR_FILENO, text.data(), static_cast<std::size_t>(length)) >= 0) {
    _exit(3);
  }
}

/// What a status other than success may be, and that it comes with a text.
std::string check_status(const Outcome& outcome) {
  switch (outcome.status) {
  case WRC_OK:
    return "";
  case WRC_NOT_CONVERGED:
  case WRC_NO_CONTACT:
  case WRC_INVALID_ARGUMENT:
    return outcome.error.empty() ? "a status without a text" : "";
  default:
    return "status " + std::to_string(outcome.status) + ", " + outcome.error;
  }
}

std::string checked(const DrawnScene& scene, const Outcome& outcome, long index) {
  using Check = std::function<std::string(const DrawnScene&, const Outcome&)>;
  static const std::array<Check, 6> checks{
      check_mirror,    [](const DrawnScene& s, const Outcome&) { return check_units(s); },
      check_stiffness, check_monotony,
      check_solver,    check_batch};
  std::string wrong = check_status(outcome);
  if (!wrong.empty() || !outcome.has_results()) {
    return wrong;
  }
  wrong = check_equilibrium(scene, outcome);
  const auto first = static_cast<std::size_t>(index) % checks.size();
  const auto second =
      (first + 1 + static_cast<std::size_t>(index) / checks.size() % (checks.size() - 1)) %
      checks.size();
  for (const std::size_t i : {first, second}) {
    if (wrong.empty()) {
      wrong = checks[i](scene, outcome);
    }
  }
  return wrong;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::fputs("usage: random_scenes COUNT SEED [FIRST]\n", stderr);
    return 2;
  }
  const long count = std::strtol(argv[1], nullptr, 10);
  const auto seed = std::strtoull(argv[2], nullptr, 10);
  const long begin = argc > 3 ? std::strtol(argv[3], nullptr, 10) : 0;
  std::signal(SIGALRM, give_up);
  std::map<std::string, long> statuses;
  long failures = 0;
  long inaccurate = 0;
  for (current = begin; current < begin + count; ++current) {
    alarm(longest);
    const DrawnScene scene(seed * 1000000007ULL + static_cast<std::uint64_t>(current));
    std::optional<wrcontact::Scene> made;
    try {
      made = scene.made();
    } catch (const wrcontact::Error& refusal) {
      const std::string text = refusal.what();
      ++statuses["refused: " + text.substr(0, text.find('='))];
      continue;
    }
    const std::string file =
        "scene_" + std::to_string(seed) + '_' + std::to_string(current) + ".toml";
    if (count == 1) {
      made->write(file);
    }
    const wrc_status status = wrc_scene_solve(made->handle());
    const Outcome outcome(*made, status, true);
    ++statuses[wrc_status_name(outcome.status) +
               (outcome.error.empty() ? "" : ": " + outcome.error.substr(0, 60))];
    for (const std::string& side : outcome.sides()) {
      inaccurate += outcome.is_told_inaccurate(side) ? 1 : 0;
    }
    const std::string wrong = checked(scene, outcome, current);
    if (!wrong.empty()) {
      ++failures;
      made->write(file);
      std::printf("scene %ld: %s\n", current, wrong.c_str());
      std::fflush(stdout);
    }
  }
  for (const auto& [text, times] : statuses) {
    std::printf("%ld %s\n", times, text.c_str());
  }
  std::printf("%ld wheels told that the accuracy was not reached\n", inaccurate);
  std::printf("%ld scenes, %ld failures\n", count, failures);
  return failures == 0 ? 0 : 1;
}
