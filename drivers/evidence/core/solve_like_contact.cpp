/// Solves a scene as CONTACT does where it differs: slip is that of three creepages of a patch (its
/// D = 2), and only patches that are close displace each other. No key has these choices.
///
///   solve_like_contact SCENE.toml RESULT ...
///
/// Prints each result on a line of its own, in mm, N, MPa, rad, in 17 digits; "nan" for none.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <variant>

#include "arguments.hpp"
#include "keys/scene_keys.hpp"
#include "scene/solve_scene.hpp"
#include "support/toml.hpp"

namespace {

constexpr const char* usage = "solve_like_contact SCENE.toml RESULT ...\n\n"
                              "Solves a scene with slip at three creepages of a patch and with "
                              "close patches alone displacing "
                              "each other, as CONTACT does, and prints results by name.\n";

wrc::Scene scene_of(const std::string& path) {
  driver::Values values;
  driver::flatten(driver::read_toml("scene file", path), "", values);
  wrc::Scene scene;
  for (const wrc::KeyDescription& key : wrc::scene_keys()) { // the general before the special
    const auto found = values.find(std::string(key.name));
    if (found == values.end()) {
      continue;
    }
    if (const auto* number = std::get_if<double>(&found->second)) {
      wrc::set_number(scene, key.name, *number);
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&found->second)) {
      wrc::set_numbers(scene, key.name, *numbers);
    } else {
      wrc::set_text(scene, key.name, std::get<std::string>(found->second));
    }
  }
  scene.slip.variation = wrc::SlipVariation::planar;
  scene.interaction = wrc::Interaction::near;
  return scene;
}

int solve(const wrc::evidence::Arguments& arguments) {
  if (arguments.count() < 2) {
    throw wrc::evidence::WrongArgument("must be a scene file and names of results");
  }
  if (!std::filesystem::is_regular_file(arguments.text(0))) {
    throw wrc::evidence::WrongArgument("SCENE.toml = \"" + arguments.text(0) +
                                       "\": must be a file");
  }
  wrc::SceneResult result = wrc::solve_scene(scene_of(arguments.text(0)));
  for (std::size_t i = 1; i < arguments.count(); ++i) {
    std::printf("%.17g\n", wrc::number_value(result, arguments.text(i)).value_or(std::nan("")));
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  return wrc::evidence::run(argc, argv, usage, solve);
}
