/// A handle of a normal contact problem for the drivers: owned, and with failures as exceptions.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "wrcontact.h"

namespace driver {

class Normal {
public:
  Normal();

  /// Numbers of elements, and their sides in mm.
  void set_grid(std::int64_t lateral_count, std::int64_t longitudinal_count, double lateral_step,
                double longitudinal_step);
  /// Undeformed distance in mm, longitudinal index fastest.
  void set_distance(const std::vector<double>& distance);
  void set(const std::string& key, double value);
  void set(const std::string& key, const std::string& value);

  /// False if the iteration has not converged; the results are usable all the same.
  bool solve();

  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] std::vector<double> field(const std::string& name) const;

private:
  void check(wrc_status status) const;
  std::unique_ptr<wrc_normal, void (*)(wrc_normal*)> handle_;
};

} // namespace driver
