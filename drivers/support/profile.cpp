#include "support/profile.hpp"

#include "support/scene.hpp"

namespace driver {
namespace {

wrc_profile* create_profile() {
  wrc_profile* handle = nullptr;
  if (wrc_profile_create(&handle) != WRC_OK) {
    throw Failure("out of memory");
  }
  return handle;
}

} // namespace

Profile::Profile() : handle_(create_profile(), wrc_profile_destroy) {}

void Profile::check(wrc_status status) const {
  if (status != WRC_OK) {
    throw Failure(wrc_profile_error(handle_.get()));
  }
}

Profile Profile::standard(const std::string& name) {
  Profile profile;
  profile.check(wrc_profile_load_standard(profile.handle_.get(), name.c_str()));
  return profile;
}

Profile Profile::file(const std::string& path, const wrc_read_options& options) {
  Profile profile;
  profile.check(wrc_profile_load_file(profile.handle_.get(), path.c_str(), &options));
  return profile;
}

bool Profile::is_wheel() const {
  std::int32_t kind = WRC_WHEEL;
  check(wrc_profile_kind(handle_.get(), &kind));
  return kind == WRC_WHEEL;
}

std::string Profile::text(const std::string& name) const {
  const char* value = nullptr;
  check(wrc_profile_text(handle_.get(), name.c_str(), &value));
  return value;
}

std::vector<std::string> Profile::corrections() const {
  std::vector<std::string> all;
  for (std::int64_t i = 0; const char* one = wrc_profile_correction(handle_.get(), i); ++i) {
    all.emplace_back(one);
  }
  return all;
}

double Profile::length() const {
  double value = 0.0;
  check(wrc_profile_length(handle_.get(), &value));
  return value;
}

std::vector<double> Profile::nodes() const {
  std::int64_t count = 0;
  check(wrc_profile_nodes(handle_.get(), nullptr, 0, &count));
  std::vector<double> arcs(static_cast<std::size_t>(count));
  check(wrc_profile_nodes(handle_.get(), arcs.data(), count, &count));
  return arcs;
}

ProfilePoint Profile::at(double arc) const {
  ProfilePoint point;
  point.arc = arc;
  check(wrc_profile_at(handle_.get(), arc, &point.lateral, &point.height, &point.angle,
                       &point.curvature));
  return point;
}

void Profile::write(const std::string& path, double spacing) const {
  check(wrc_profile_write(handle_.get(), path.c_str(), spacing));
}

std::vector<std::string> standard_profile_names(std::int32_t kind) {
  std::vector<std::string> names;
  for (std::int64_t i = 0; const char* name = wrc_profile_standard_name(kind, i); ++i) {
    names.emplace_back(name);
  }
  return names;
}

std::string standard_names_text() {
  std::string text;
  for (const std::int32_t kind : {WRC_WHEEL, WRC_RAIL}) {
    text += kind == WRC_WHEEL ? "Built-in wheels:" : "Built-in rails: ";
    for (const std::string& name : standard_profile_names(kind)) {
      text += ' ' + name;
    }
    text += '\n';
  }
  return text;
}

} // namespace driver
