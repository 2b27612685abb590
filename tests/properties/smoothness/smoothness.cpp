// How smoothly results follow the scene, and whether they depend on it alone (smoothness.hpp).
//
// Usage: smoothness [OPTION VALUE]..., options as printed by --help. Progress on stderr.
// Exits with 1 if a limit is exceeded.
#include "smoothness.hpp"

#include <cstdio>
#include <exception>
#include <map>
#include <sstream>
#include <variant>

namespace {

using smoothness::Options;

struct Option {
  std::variant<int*, long*, double*, std::uint64_t*, std::string*> value;
  const char* meaning;
};

std::map<std::string, Option> options_of(Options& options) {
  return {
      {"--parts",
       {&options.parts, "1 lateral sweeps, 2 vertical sweeps, 3 Newton's iteration, "
                        "4 scenes moved by 1e-9 mm, 5 sequences"}},
      {"--accuracy", {&options.accuracy, "asked"}},
      {"--accuracy-of", {&options.accuracy_of, "forces or pressures"}},
      {"--curved", {&options.curved, "solve.curved: no, yes or auto"}},
      {"--derivative", {&options.derivative, "of part 3: sensitivities or difference"}},
      {"--positions", {&options.positions, "of parts 1 to 3, for each pair of profiles"}},
      {"--first", {&options.first, "of them, mm"}},
      {"--last", {&options.last, "of them, mm"}},
      {"--steps", {&options.steps, "of parts 1 and 2 at each position"}},
      {"--scenes", {&options.scenes, "of part 4"}},
      {"--sequence", {&options.sequence, "scenes of part 5"}},
      {"--seed", {&options.seed, "of parts 4 and 5"}},
      {"--threads", {&options.threads, "positions or scenes solved at once"}},
      {"--fresh", {&options.fresh, "1: parts 1 to 4 solve each scene by itself, without a solver"}},
      {"--list", {&options.list, "lines of each list, at most"}},
      {"--limit", {&options.limit, "of deviations in parts 1, 2 and 4, relative"}},
      {"--pressure-share", {&options.pressure_share, "part 4: limit of pmax over the accuracy"}},
      {"--scene-share", {&options.scene_share, "part 4: least share of scenes within the limits"}},
      {"--newton", {&options.newton, "part 3: most iterations"}},
      {"--differing", {&options.differing, "part 5: most scenes that differ"}},
  };
}

int print_help(const std::map<std::string, Option>& all) {
  std::printf("usage: smoothness [OPTION VALUE]...\n");
  for (const auto& [name, option] : all) {
    std::ostringstream value;
    std::visit([&value](const auto* stored) { value << *stored; }, option.value);
    std::printf("  %-17s %s [%s]\n", name.c_str(), option.meaning, value.str().c_str());
  }
  return 0;
}

bool read(std::map<std::string, Option>& all, const std::string& name, const std::string& text) {
  const auto found = all.find(name);
  if (found == all.end()) {
    return false;
  }
  std::istringstream in(text);
  return std::visit([&in](auto* stored) { return static_cast<bool>(in >> *stored); },
                    found->second.value) &&
         in.peek() == std::istringstream::traits_type::eof();
}

bool measure(const Options& options) {
  using Part = bool (*)(const Options&);
  const std::map<char, Part> parts{{'1', smoothness::measure_lateral_sweeps},
                                   {'2', smoothness::measure_vertical_sweeps},
                                   {'3', smoothness::measure_newton},
                                   {'4', smoothness::measure_moved_scenes},
                                   {'5', smoothness::measure_sequences}};
  std::printf("accuracy %g of %s, solve.curved %s, %s\n", options.accuracy,
              options.accuracy_of.c_str(), options.curved.c_str(),
              options.fresh != 0 ? "each scene by itself" : "through a solver");
  bool kept = true;
  for (const char part : options.parts) {
    const bool good = parts.at(part)(options);
    std::printf("%s\n", good ? "within the limits" : "BEYOND THE LIMITS");
    std::fflush(stdout);
    kept = kept && good;
  }
  return kept;
}

} // namespace

int main(int argc, char** argv) {
  Options options;
  std::map<std::string, Option> all = options_of(options);
  if (argc == 2 && std::string(argv[1]) == "--help") {
    return print_help(all);
  }
  for (int i = 1; i < argc; i += 2) {
    if (i + 1 == argc || !read(all, argv[i], argv[i + 1])) {
      std::fprintf(stderr, "smoothness: cannot read %s (see smoothness --help)\n", argv[i]);
      return 2;
    }
  }
  if (options.parts.find_first_not_of("12345") != std::string::npos || options.positions < 1 ||
      options.steps < 1 || options.threads < 1 || options.scenes < 1 || options.sequence < 1) {
    std::fprintf(stderr, "smoothness: parts are 1 to 5, numbers at least 1\n");
    return 2;
  }
  try {
    return measure(options) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "smoothness: %s\n", error.what());
    return 2;
  }
}
