#include "support/reference_data.hpp"

#include <fstream>
#include <stdexcept>

namespace wrc::test {

std::filesystem::path reference_file(const std::string& name) {
  return std::filesystem::path(WRCONTACT_REFERENCE_DIR) / name;
}

nlohmann::json reference_data(const std::string& name) {
  std::ifstream file(reference_file(name));
  if (!file) {
    throw std::runtime_error("cannot open " + reference_file(name).string());
  }
  return nlohmann::json::parse(file);
}

nlohmann::json creep_wheel_rail_cases() {
  const nlohmann::json data = reference_data("creep_wheel_rail.json");
  nlohmann::json cases = data.at("cases");
  for (nlohmann::json& entry : cases) {
    entry.at("input").update(data.at("common"));
  }
  return cases;
}

std::filesystem::path original_file(const std::string& name) {
  return std::filesystem::path(WRCONTACT_ORIGINAL_FILES_DIR) / name;
}

} // namespace wrc::test
