// Solves random scenes with creep forces, each in a process of its own, and checks that each ends
// in a result or a status, that every number and field of it is finite, that no grid has more
// elements than solve.element_limit permits, and that pressures no steel carries are not to be
// used.
//
// Usage: bounded_scenes loaded|posed|varying COUNT SEED [FIRST]
// Varying: on rails along the track and under wheels around the circumference (varying_scene.hpp).
// Prints arguments of wrc_case for each failure and for each scene beyond 2 s of processor time or
// 500 MB; the folder takes scene files of those with profiles made of points. At the end: counts by
// status, failures, results that are not finite, scenes that take more than 30 times the median of
// their kind, the slowest scene and the one with the most memory and elements. A kind of scenes has
// the same third of a decade of accuracy, and derivatives, curves and profiles made of points or
// none; refused ones do not count. Exits with 1 on failures, to which time and memory do not count.
// A single scene is solved in this process, for a debugger.
#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <variant>
#include <vector>

#include "outcome.hpp"
#include "rolling_scene.hpp"
#include "varying_scene.hpp"

namespace {

using namespace properties;

constexpr double long_time = 2.0;     // s
constexpr double much_memory = 500.0; // MB
constexpr double longest = 120.0;     // s, a hang
constexpr double much_longer = 30.0;  // times the median
constexpr double high_pressure = 1e4; // MPa
constexpr const char* limit_key = "solve.element_limit";

/// What a process tells of its scene.
struct Told {
  std::array<char, 96> status{};
  std::array<char, 160> wrong{}; ///< empty: nothing is
  double elements = 0.0;         ///< of the largest set of grids of a wheel
  double not_finite = 0.0;       ///< results
};

void copy_text(const std::string& text, auto& to) {
  std::strncpy(to.data(), text.c_str(), to.size() - 1);
}

double size_of(const wrcontact::Scene& scene, const std::string& field) {
  std::int64_t count = 0;
  return wrc_scene_field(scene.handle(), field.c_str(), nullptr, 0, &count) == WRC_OK
             ? static_cast<double>(count)
             : 0.0;
}

/// The limit that is set, or that of the accuracy (docs/accuracy.md).
double limit_of(const wrcontact::Scene& scene) {
  const double of_accuracy = 1600.0 / std::sqrt(std::min(scene.get_number("solve.accuracy"), 1e-2));
  double limit = 0.0;
  return wrc_scene_get_number(scene.handle(), limit_key, &limit) == WRC_OK
             ? limit
             : std::min(of_accuracy, 1e5);
}

/// Elements of the patches of a wheel, or of their parts; those of a patch with parts only show
/// them.
void check_elements(const wrcontact::Scene& scene, const DrawnScene& drawn, const std::string& side,
                    Told& told) {
  const double limit = limit_of(scene);
  double normal = 0.0;
  double creep = 0.0;
  const auto add = [&](const std::string& patch) {
    normal += size_of(scene, patch + ".pressure");
    creep += size_of(scene, patch + ".traction_x");
  };
  for (int i = 0;; ++i) {
    const std::string patch = side + ".patches." + std::to_string(i);
    if (size_of(scene, patch + ".pressure") == 0.0) {
      break;
    }
    if (size_of(scene, patch + ".parts.0.pressure") == 0.0) {
      add(patch);
      continue;
    }
    for (int k = 0; size_of(scene, patch + ".parts." + std::to_string(k) + ".pressure") > 0.0;
         ++k) {
      add(patch + ".parts." + std::to_string(k));
    }
  }
  told.elements = std::max({told.elements, normal, creep});
  // Pressures of approximate models are sampled on a grid of their own.
  const bool by_accuracy = !drawn.has_grid() && scene.text(side + ".model") == "half-space";
  if ((by_accuracy && normal > limit) || creep > limit) {
    copy_text(std::to_string(std::max(normal, creep)) + " elements", told.wrong);
  }
}

void check_numbers(const wrcontact::Scene& scene, Told& told) {
  for (const std::string& name : scene.number_names()) {
    double value = 0.0;
    // Where an end of a body cuts a contact, and where points do not tell their noise.
    const bool may_lack = name.ends_with("pmax") || name.ends_with("pmax_elastic") ||
                          name.ends_with("pmax_element") || name.ends_with("traction_max") ||
                          name.find("spread.") != std::string::npos ||
                          name.find("smoothed_") != std::string::npos;
    if (wrc_scene_number(scene.handle(), name.c_str(), &value) != WRC_OK ||
        !(std::isfinite(value) || (may_lack && std::isnan(value)))) {
      told.not_finite += 1.0;
      copy_text(name + " is not finite", told.wrong);
    }
  }
  for (const char* side : {"left", "right"}) {
    for (const char* field : {".pressure", ".displacement", ".traction_x", ".traction_y", ".slip_x",
                              ".slip_y", ".creep_pressure"}) {
      const std::string name = side + std::string(field);
      if (size_of(scene, name) == 0.0) {
        continue;
      }
      const std::vector<double> values = scene.field(name);
      if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) {
        told.not_finite += 1.0;
        copy_text(name + " is not finite", told.wrong);
      }
    }
  }
}

void check_peak(const wrcontact::Scene& scene, const std::string& side, Told& told) {
  double pmax = 0.0;
  if (wrc_scene_number(scene.handle(), (side + ".pmax").c_str(), &pmax) == WRC_OK &&
      pmax > high_pressure && scene.number(side + ".grade") != WRC_DO_NOT_USE) {
    copy_text(side + ".pmax = " + std::to_string(pmax) + " MPa with a grade to be used",
              told.wrong);
  }
}

Told solve(const DrawnScene& drawn) {
  Told told;
  try {
    const wrcontact::Scene scene = drawn.made();
    const wrc_status status = wrc_scene_solve(scene.handle());
    const std::string text = wrc_scene_error(scene.handle());
    copy_text(wrc_status_name(status) + (text.empty() ? "" : ": " + text.substr(0, 40)),
              told.status);
    if (status != WRC_OK && status != WRC_NOT_CONVERGED && status != WRC_NO_CONTACT &&
        status != WRC_INVALID_ARGUMENT) {
      copy_text(std::string(told.status.data()), told.wrong);
    }
    if (status == WRC_INVALID_ARGUMENT && text.find('.') > text.find(" = ")) {
      copy_text("names no key: " + text, told.wrong);
    }
    if (status == WRC_OK || status == WRC_NOT_CONVERGED) {
      const std::string solved = scene.get_text("solve.side");
      for (const char* side : {"left", "right"}) {
        if (solved == "both" || solved == side) {
          check_elements(scene, drawn, side, told);
          check_peak(scene, side, told);
        }
      }
      check_numbers(scene, told);
    }
  } catch (const wrcontact::Error& refusal) {
    copy_text("refused: " + std::string(refusal.what()).substr(0, 40), told.status);
  }
  return told;
}

/// Told by a process of its own, with the time and memory that it took.
struct Solved {
  Told told;
  double seconds = 0.0;
  double megabytes = 0.0;
};

Solved solve_apart(const DrawnScene& drawn) {
  Solved result;
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    std::perror("pipe");
    std::exit(2);
  }
  const pid_t child = fork();
  if (child == 0) {
    alarm(static_cast<unsigned>(longest));
    const Told told = solve(drawn);
    const bool sent = write(ends[1], &told, sizeof told) == static_cast<ssize_t>(sizeof told);
    _exit(sent ? 0 : 2);
  }
  close(ends[1]);
  const bool received =
      read(ends[0], &result.told, sizeof result.told) == static_cast<ssize_t>(sizeof result.told);
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!received) {
    result.told = {};
    const std::string how = WIFSIGNALED(status)
                                ? "ended by signal " + std::to_string(WTERMSIG(status))
                                : "exit status " + std::to_string(WEXITSTATUS(status));
    copy_text(how, result.told.status);
    copy_text(how, result.told.wrong);
  }
  constexpr double micro = 1e-6;
  for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
    result.seconds += static_cast<double>(time.tv_sec) + micro * static_cast<double>(time.tv_usec);
  }
  result.megabytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return result;
}

/// The scene as arguments of wrc_case; one with profiles made of points goes into a file.
std::string arguments_of(const DrawnScene& drawn, const std::string& name) {
  if (drawn.has_points()) {
    drawn.made().write(name);
    return name;
  }
  std::string text;
  std::array<char, 32> number{};
  const auto add = [&](double value) {
    std::snprintf(number.data(), number.size(), "%.17g", value);
    text += number.data();
  };
  for (const auto& [key, value] : drawn.values()) {
    text += (text.empty() ? "--set " : " --set ") + key + '=';
    if (const auto* one = std::get_if<double>(&value)) {
      add(*one);
    } else if (const auto* word = std::get_if<std::string>(&value)) {
      text += *word;
    } else {
      char before = '[';
      for (const double entry : std::get<std::vector<double>>(value)) {
        text += std::exchange(before, ',');
        add(entry);
      }
      text += ']';
    }
  }
  return text;
}

/// What a user expects to cost more, in words.
std::string kind_of(const DrawnScene& drawn) {
  double accuracy = 1e-3; // the default
  std::string kind;
  for (const auto& [key, value] : drawn.values()) {
    if (key == "solve.accuracy") {
      accuracy = std::get<double>(value);
    } else if (key == "solve.derivatives" || key == "solve.curved") {
      kind += key.substr(key.find('.') + 1) + ' ' + std::get<std::string>(value) + ", ";
    }
  }
  if (drawn.has_points()) { // read and solved along other lines for the spread of results
    kind += "points, ";
  }
  const double third = std::floor(3.0 * std::log10(accuracy)); // of a decade
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "from %.2g on", std::pow(10.0, third / 3.0));
  return kind + text.data();
}

/// Those that take much longer than the median of their kind.
void print_long_ones(std::map<std::string, std::vector<std::pair<double, long>>> times) {
  for (auto& [kind, of_kind] : times) {
    std::ranges::sort(of_kind, std::greater{});
    const double median = of_kind[of_kind.size() / 2].first;
    std::printf("%s: %zu scenes, median %.4g s; longer than %g times that:", kind.c_str(),
                of_kind.size(), median, much_longer);
    for (const auto& [seconds, scene] : of_kind) {
      if (seconds > much_longer * median) {
        std::printf(" %ld (%.2g s)", scene, seconds);
      }
    }
    std::printf("\n");
  }
}

/// The scene that has most of something.
struct Most {
  double value = -1.0;
  long scene = 0;
  std::string arguments;
};

} // namespace

int main(int argc, char** argv) {
  const std::string kind = argc > 1 ? argv[1] : "";
  if (argc < 4 || argc > 5 || (kind != "loaded" && kind != "posed" && kind != "varying")) {
    std::fputs("usage: bounded_scenes loaded|posed|varying COUNT SEED [FIRST]\n", stderr);
    return 2;
  }
  const long count = std::strtol(argv[2], nullptr, 10);
  const auto seed = std::strtoull(argv[3], nullptr, 10);
  const long begin = argc > 4 ? std::strtol(argv[4], nullptr, 10) : 0;
  std::optional<VaryingLists> lists;
  if (kind == "varying") {
    lists.emplace(std::filesystem::path(WRCONTACT_ORIGINAL_FILES_DIR) / "slices");
  }
  std::map<std::string, long> statuses;
  long failures = 0;
  long beyond = 0;
  double not_finite = 0.0;
  std::array<Most, 3> most;
  std::map<std::string, std::vector<std::pair<double, long>>> times;
  for (long i = begin; i < begin + count; ++i) {
    const std::uint64_t of_scene = seed * 1000000007ULL + static_cast<std::uint64_t>(i);
    const DrawnScene drawn = lists             ? lists->scene(of_scene)
                             : kind == "posed" ? rolling_posed_scene(of_scene)
                                               : rolling_loaded_scene(of_scene);
    const std::string name = kind + '_' + std::to_string(seed) + '_' + std::to_string(i) + ".toml";
    const Solved solved = count == 1 ? Solved{solve(drawn)} : solve_apart(drawn);
    const Told& told = solved.told;
    if (told.elements > 0.0) { // not refused
      times[kind_of(drawn)].emplace_back(solved.seconds, i);
    }
    ++statuses[told.status.data()];
    not_finite += told.not_finite;
    const bool wrong = told.wrong[0] != '\0';
    const bool is_beyond = solved.seconds > long_time || solved.megabytes > much_memory;
    failures += wrong ? 1 : 0;
    beyond += is_beyond ? 1 : 0;
    if (wrong || is_beyond || count == 1) {
      std::printf("scene %ld: %.2f s, %.0f MB, %.0f elements: %s\n  %s\n", i, solved.seconds,
                  solved.megabytes, told.elements, wrong ? told.wrong.data() : told.status.data(),
                  arguments_of(drawn, name).c_str());
      std::fflush(stdout);
    }
    const std::array values{solved.seconds, solved.megabytes, told.elements};
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (values.at(k) > most.at(k).value) {
        most.at(k) = {values.at(k), i, arguments_of(drawn, name)};
      }
    }
  }
  for (const auto& [text, scenes] : statuses) {
    std::printf("%ld %s\n", scenes, text.c_str());
  }
  print_long_ones(std::move(times));
  constexpr std::array names{"slowest, s", "most memory, MB", "most elements"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::printf("%s: %.4g, scene %ld\n  %s\n", names.at(k), most.at(k).value, most.at(k).scene,
                most.at(k).arguments.c_str());
  }
  std::printf("%ld %s scenes, %ld failures, %.0f results not finite, %ld beyond %g s or %g MB\n",
              count, kind.c_str(), failures, not_finite, beyond, long_time, much_memory);
  return failures == 0 ? 0 : 1;
}
