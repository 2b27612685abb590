#include "support/scene.hpp"

#include <algorithm>
#include <utility>

namespace driver {
namespace {

wrc_solver* create_solver() {
  wrc_solver* handle = nullptr;
  if (wrc_solver_create(&handle) != WRC_OK) {
    throw Failure("out of memory");
  }
  return handle;
}

wrc_scene* create_scene() {
  wrc_scene* handle = nullptr;
  if (wrc_scene_create(&handle) != WRC_OK) {
    throw Failure("out of memory");
  }
  return handle;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char letter) {
        const auto byte = static_cast<unsigned char>(letter);
        return byte < 0x20 || byte == 0x7F;
      },
      ' ');
  return text;
}

} // namespace

Failure::Failure(std::string text) : std::runtime_error(one_line(std::move(text))) {}

Solver::Solver() : handle_(create_solver(), wrc_solver_destroy) {}

bool Solver::solve(Scene& scene) {
  const wrc_status status = wrc_solver_solve(handle_.get(), scene.handle());
  if (status != WRC_NOT_CONVERGED) {
    scene.check(status);
  }
  return status == WRC_OK;
}

wrc_status Solver::solve_alone(Scene& scene) {
  const wrc_status status = wrc_solver_forget(handle_.get(), 0);
  return status == WRC_OK ? wrc_solver_solve(handle_.get(), scene.handle()) : status;
}

Scene::Scene() : handle_(create_scene(), wrc_scene_destroy) {}

void Scene::check(wrc_status status) const {
  if (status != WRC_OK) {
    throw Failure(wrc_scene_error(handle_.get()));
  }
}

void Scene::set(const std::string& key, double value) {
  check(wrc_scene_set_number(handle_.get(), key.c_str(), value));
}

void Scene::set(const std::string& key, const std::string& value) {
  check(wrc_scene_set_text(handle_.get(), key.c_str(), value.c_str()));
}

void Scene::set(const std::string& key, const std::vector<double>& values) {
  check(wrc_scene_set_numbers(handle_.get(), key.c_str(), values.data(),
                              static_cast<std::int64_t>(values.size())));
}

std::string Scene::input_text(const std::string& key) const {
  const char* value = nullptr;
  check(wrc_scene_get_text(handle_.get(), key.c_str(), &value));
  return value;
}

void Scene::write(const std::string& path) const {
  check(wrc_scene_write(handle_.get(), path.c_str()));
}

bool Scene::solve() {
  const wrc_status status = wrc_scene_solve(handle_.get());
  if (status != WRC_NOT_CONVERGED) {
    check(status);
  }
  return status == WRC_OK;
}

bool Scene::has_number(const std::string& name) const {
  double value = 0.0;
  return wrc_scene_number(handle_.get(), name.c_str(), &value) == WRC_OK;
}

double Scene::number(const std::string& name) const {
  double value = 0.0;
  check(wrc_scene_number(handle_.get(), name.c_str(), &value));
  return value;
}

double Scene::number_or(const std::string& name, double otherwise) const {
  return has_number(name) ? number(name) : otherwise;
}

std::string Scene::text(const std::string& name) const {
  const char* value = nullptr;
  check(wrc_scene_text(handle_.get(), name.c_str(), &value));
  return value;
}

std::vector<double> Scene::field(const std::string& name) const {
  std::int64_t count = 0;
  check(wrc_scene_field(handle_.get(), name.c_str(), nullptr, 0, &count));
  std::vector<double> values(static_cast<std::size_t>(count));
  check(wrc_scene_field(handle_.get(), name.c_str(), values.data(), count, &count));
  return values;
}

std::vector<std::string> Scene::number_names() const {
  std::vector<std::string> names;
  for (std::int64_t i = 0; i < wrc_scene_number_count(handle_.get()); ++i) {
    names.emplace_back(wrc_scene_number_name(handle_.get(), i));
  }
  return names;
}

std::vector<std::string> Scene::text_names() const {
  std::vector<std::string> names;
  for (std::int64_t i = 0; i < wrc_scene_text_count(handle_.get()); ++i) {
    names.emplace_back(wrc_scene_text_name(handle_.get(), i));
  }
  return names;
}

std::vector<std::string> Scene::sides() const {
  std::vector<std::string> sides;
  for (const char* side : {"left", "right"}) {
    if (has_number(std::string(side) + ".pmax")) {
      sides.emplace_back(side);
    }
  }
  return sides;
}

int Scene::count_of(const std::string& list) const {
  int count = 0;
  const std::string prefix = list + '.';
  for (const auto& names : {number_names(), text_names()}) {
    for (const std::string& name : names) {
      if (name.starts_with(prefix)) {
        count = std::max(count, std::stoi(name.substr(prefix.size())) + 1);
      }
    }
  }
  return count;
}

std::vector<Key> scene_keys() {
  std::vector<Key> keys;
  for (std::int64_t i = 0; i < wrc_scene_key_count(); ++i) {
    const char* name = nullptr;
    const char* default_value = nullptr;
    const char* allowed = nullptr;
    const char* meaning = nullptr;
    if (wrc_scene_key(i, &name, &default_value, &allowed, &meaning) == WRC_OK) {
      keys.push_back({name, default_value, allowed, meaning});
    }
  }
  return keys;
}

} // namespace driver
