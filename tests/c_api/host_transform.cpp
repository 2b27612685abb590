#include "host_transform.hpp"

#include <vector>

#include <fftw3.h>

double sum_of_transform(std::recursive_mutex& planner, std::size_t length) {
  std::vector<double> values(length, 0.0);
  std::vector<double> spectrum(2 * (length / 2 + 1), 0.0);
  auto* transformed = reinterpret_cast<fftw_complex*>(spectrum.data());
  fftw_plan plan = nullptr;
  {
    const std::lock_guard lock(planner);
    plan =
        fftw_plan_dft_r2c_1d(static_cast<int>(length), values.data(), transformed, FFTW_ESTIMATE);
  }
  values[0] = 1.0; // planning may overwrite
  fftw_execute(plan);
  {
    const std::lock_guard lock(planner);
    fftw_destroy_plan(plan);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i <= length / 2; ++i) {
    sum += spectrum[2 * i];
  }
  return sum / static_cast<double>(length / 2 + 1);
}
