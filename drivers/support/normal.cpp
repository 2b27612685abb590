#include "support/normal.hpp"

#include "support/scene.hpp"

namespace driver {
namespace {

wrc_normal* create_normal() {
  wrc_normal* handle = nullptr;
  if (wrc_normal_create(&handle) != WRC_OK) {
    throw Failure("out of memory");
  }
  return handle;
}

} // namespace

Normal::Normal() : handle_(create_normal(), wrc_normal_destroy) {}

void Normal::check(wrc_status status) const {
  if (status != WRC_OK) {
    throw Failure(wrc_normal_error(handle_.get()));
  }
}

void Normal::set_grid(std::int64_t lateral_count, std::int64_t longitudinal_count,
                      double lateral_step, double longitudinal_step) {
  check(wrc_normal_set_grid(handle_.get(), lateral_count, longitudinal_count, lateral_step,
                            longitudinal_step));
}

void Normal::set_distance(const std::vector<double>& distance) {
  check(wrc_normal_set_distance(handle_.get(), distance.data(),
                                static_cast<std::int64_t>(distance.size())));
}

void Normal::set(const std::string& key, double value) {
  check(wrc_normal_set_number(handle_.get(), key.c_str(), value));
}

void Normal::set(const std::string& key, const std::string& value) {
  check(wrc_normal_set_text(handle_.get(), key.c_str(), value.c_str()));
}

bool Normal::solve() {
  const wrc_status status = wrc_normal_solve(handle_.get());
  if (status != WRC_NOT_CONVERGED) {
    check(status);
  }
  return status == WRC_OK;
}

double Normal::number(const std::string& name) const {
  double value = 0.0;
  check(wrc_normal_number(handle_.get(), name.c_str(), &value));
  return value;
}

std::vector<double> Normal::field(const std::string& name) const {
  std::int64_t count = 0;
  check(wrc_normal_field(handle_.get(), name.c_str(), nullptr, 0, &count));
  std::vector<double> values(static_cast<std::size_t>(count));
  check(wrc_normal_field(handle_.get(), name.c_str(), values.data(), count, &count));
  return values;
}

} // namespace driver
