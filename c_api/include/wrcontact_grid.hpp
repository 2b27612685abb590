// Contacts on a grid of the caller's for C++: normal and rolling contact (wrcontact_grid.h), with
// the rules of wrcontact.hpp, which includes this header. Since 0.2.
#ifndef WRCONTACT_GRID_HPP
#define WRCONTACT_GRID_HPP

#include "wrcontact.hpp"

namespace wrcontact {

/// A gap of the caller's on a grid (wrc_normal).
class NormalContact
    : public detail::Owner<wrc_normal, wrc_normal_create, wrc_normal_destroy, wrc_normal_error> {
public:
  void set_grid(std::int64_t lateral_count, std::int64_t longitudinal_count, double lateral_step,
                double longitudinal_step) {
    check(wrc_normal_set_grid(handle(), lateral_count, longitudinal_count, lateral_step,
                              longitudinal_step));
  }
  void set_distance(const std::vector<double>& values) {
    check(
        wrc_normal_set_distance(handle(), values.data(), static_cast<std::int64_t>(values.size())));
  }
  void set(const std::string& key, double value) {
    check(wrc_normal_set_number(handle(), key.c_str(), value));
  }
  void set(const std::string& key, const std::string& value) {
    check(wrc_normal_set_text(handle(), key.c_str(), value.c_str()));
  }
  /// False if the iteration has not converged.
  bool solve() { return converged(wrc_normal_solve(handle())); }

  double number(const std::string& name) const {
    return value_of<double>(wrc_normal_number, name.c_str());
  }
  std::string text(const std::string& name) const {
    return value_of<const char*>(wrc_normal_text, name.c_str());
  }
  std::vector<double> field(const std::string& name) const {
    return copied([&](double* values, std::int64_t capacity, std::int64_t* count) {
      return wrc_normal_field(handle(), name.c_str(), values, capacity, count);
    });
  }
};

/// Tangential contact of pressures of the caller's on a grid (wrc_rolling). Since 0.3.
class RollingContact : public detail::Owner<wrc_rolling, wrc_rolling_create, wrc_rolling_destroy,
                                            wrc_rolling_error> {
public:
  void set_grid(std::int64_t lateral_count, std::int64_t longitudinal_count, double lateral_step,
                double longitudinal_step) {
    check(wrc_rolling_set_grid(handle(), lateral_count, longitudinal_count, lateral_step,
                               longitudinal_step));
  }
  void set_pressure(const std::vector<double>& values) {
    check(wrc_rolling_set_pressure(handle(), values.data(),
                                   static_cast<std::int64_t>(values.size())));
  }
  /// Rigid slip of each element in addition to that of the creepages; both empty: none. Since 0.3.
  void set_slip(const std::vector<double>& slip_x, const std::vector<double>& slip_y) {
    if (slip_x.size() != slip_y.size()) {
      throw Error(WRC_INVALID_ARGUMENT, "slip_x and slip_y differ in length");
    }
    check(wrc_rolling_set_slip(handle(), slip_x.data(), slip_y.data(),
                               static_cast<std::int64_t>(slip_x.size())));
  }
  /// Both empty: none.
  void set_previous(const std::vector<double>& traction_x, const std::vector<double>& traction_y) {
    if (traction_x.size() != traction_y.size()) {
      throw Error(WRC_INVALID_ARGUMENT, "traction_x and traction_y differ in length");
    }
    check(wrc_rolling_set_previous(handle(), traction_x.data(), traction_y.data(),
                                   static_cast<std::int64_t>(traction_x.size())));
  }
  void set(const std::string& key, double value) {
    check(wrc_rolling_set_number(handle(), key.c_str(), value));
  }
  void set(const std::string& key, const std::string& value) {
    check(wrc_rolling_set_text(handle(), key.c_str(), value.c_str()));
  }
  /// False if the iteration has not converged.
  bool solve() { return converged(wrc_rolling_solve(handle())); }
  /// The tractions just found become the previous ones.
  void advance() { check(wrc_rolling_advance(handle())); }

  double number(const std::string& name) const {
    return value_of<double>(wrc_rolling_number, name.c_str());
  }
  std::vector<double> field(const std::string& name) const {
    return copied([&](double* values, std::int64_t capacity, std::int64_t* count) {
      return wrc_rolling_field(handle(), name.c_str(), values, capacity, count);
    });
  }
};

} // namespace wrcontact

#endif
