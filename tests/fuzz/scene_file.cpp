// Any text as a scene file, as the drivers read it: it is taken, or refused in one line, without a
// crash, a hang or memory without bound. A scene that was taken is written as a file that reads
// back as the same scene. Files are written into the working folder.
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include "support/scene_file.hpp"

namespace {

void demand(bool promise) {
  if (!promise) {
    __builtin_trap();
  }
}

std::string written(const driver::Scene& scene, const std::string& path) {
  scene.write(path);
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  driver::Scene scene;
  try {
    driver::apply_scene_text(scene, "scene.toml", text);
  } catch (const driver::Failure& failure) {
    demand(std::string(failure.what()).find_first_of("\r\n") == std::string::npos);
    return 0;
  }
  const std::string once = written(scene, "once.toml");
  driver::Scene again;
  driver::apply_scene_text(again, "scene.toml", once);
  demand(written(again, "again.toml") == once);
  return 0;
}
