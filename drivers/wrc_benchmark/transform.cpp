#include "wrc_benchmark/transform.hpp"

#include <algorithm>
#include <complex>
#include <mutex>
#include <vector>

#include <fftw3.h>

#include "support/scene.hpp"
#include "support/statistics.hpp"
#include "support/stopwatch.hpp"

namespace benchmark {
namespace {

/// FFTW plans one transform at a time. The library plans none while transforms are measured.
std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

struct Transform {
  fftw_plan plan;

  explicit Transform(fftw_plan made) : plan(made) {}
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;
  ~Transform() {
    const std::lock_guard lock(planner());
    fftw_destroy_plan(plan);
  }
};

template <class Make> fftw_plan planned(Make make) {
  const std::lock_guard lock(planner());
  return make();
}

} // namespace

double measure_transform(const GridSize& size, int repeats) {
  const auto rows = static_cast<std::size_t>(size.lateral);
  const auto columns = static_cast<std::size_t>(size.longitudinal);
  std::vector<double> field(rows * columns);
  std::vector<std::complex<double>> spectrum(rows * (columns / 2 + 1));
  const int height = static_cast<int>(rows);
  const int width = static_cast<int>(columns);
  auto* transformed = reinterpret_cast<fftw_complex*>(spectrum.data());
  const Transform forward(planned([&] {
    return fftw_plan_dft_r2c_2d(height, width, field.data(), transformed,
                                FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  }));
  const Transform backward(planned([&] {
    return fftw_plan_dft_c2r_2d(height, width, transformed, field.data(), FFTW_ESTIMATE);
  }));
  if (forward.plan == nullptr || backward.plan == nullptr) {
    throw driver::Failure("a transform of " + size.text() + " cannot be measured");
  }
  std::vector<double> times;
  for (int i = 0; i <= repeats; ++i) {
    std::fill(field.begin(), field.end(), 1.0); // again: a pair multiplies by the size
    driver::ProcessorStopwatch watch;
    fftw_execute(forward.plan);
    fftw_execute(backward.plan);
    if (i > 0) { // the first one touches the memory
      times.push_back(watch.lap());
    }
  }
  return driver::median(times);
}

} // namespace benchmark
