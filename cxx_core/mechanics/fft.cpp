#include "mechanics/fft.hpp"

#include <limits>
#include <mutex>
#include <new>
#include <string>

#include <fftw3.h>

#include "error.hpp"

namespace wrc {

namespace {

/// Guards plan creation and destruction, which share tables inside FFTW.
std::mutex& planner_lock() {
  static std::mutex lock;
  return lock;
}

struct BufferRelease {
  void operator()(void* buffer) const { fftw_free(buffer); }
};

struct PlanRelease {
  void operator()(fftw_plan_s* plan) const {
    const std::lock_guard<std::mutex> guard(planner_lock());
    fftw_destroy_plan(plan);
  }
};

using Plan = std::unique_ptr<fftw_plan_s, PlanRelease>;

[[noreturn]] void throw_no_memory(std::size_t rows, std::size_t columns) {
  throw Error(ErrorCode::out_of_memory, "no memory for a transform of " + std::to_string(rows) +
                                            " x " + std::to_string(columns) + " values");
}

} // namespace

std::size_t good_fft_length(std::size_t least) {
  std::size_t best = 1;
  while (best < least) {
    best *= 2;
  }
  for (std::size_t five = 1; five < best; five *= 5) {
    for (std::size_t three = five; three < best; three *= 3) {
      std::size_t length = three;
      while (length < least) {
        length *= 2;
      }
      best = length < best ? length : best;
    }
  }
  return best;
}

struct RealFft::Resources {
  std::size_t rows;
  std::size_t columns;
  std::unique_ptr<double, BufferRelease> field;
  std::unique_ptr<fftw_complex, BufferRelease> spectrum;
  Plan forward;
  Plan backward;
};

RealFft::RealFft(std::size_t rows, std::size_t columns)
    : resources_(new Resources{rows, columns, nullptr, nullptr, nullptr, nullptr}) {
  constexpr auto longest = static_cast<std::size_t>(std::numeric_limits<int>::max());
  if (rows < 1 || rows > longest) {
    throw_invalid_argument("rows", static_cast<double>(rows), "must lie in 1 to 2^31 - 1");
  }
  if (columns < 1 || columns > longest) {
    throw_invalid_argument("columns", static_cast<double>(columns), "must lie in 1 to 2^31 - 1");
  }
  Resources& own = *resources_;
  own.field.reset(fftw_alloc_real(rows * columns));
  own.spectrum.reset(fftw_alloc_complex(rows * (columns / 2 + 1)));
  if (own.field == nullptr || own.spectrum == nullptr) {
    throw_no_memory(rows, columns);
  }
  {
    const std::lock_guard<std::mutex> guard(planner_lock());
    own.forward.reset(fftw_plan_dft_r2c_2d(static_cast<int>(rows), static_cast<int>(columns),
                                           own.field.get(), own.spectrum.get(),
                                           FFTW_ESTIMATE | FFTW_PRESERVE_INPUT));
    own.backward.reset(fftw_plan_dft_c2r_2d(static_cast<int>(rows), static_cast<int>(columns),
                                            own.spectrum.get(), own.field.get(), FFTW_ESTIMATE));
  }
  if (own.forward == nullptr || own.backward == nullptr) {
    throw_no_memory(rows, columns);
  }
}

RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

std::size_t RealFft::rows() const {
  return resources_->rows;
}
std::size_t RealFft::columns() const {
  return resources_->columns;
}
std::size_t RealFft::spectrum_columns() const {
  return resources_->columns / 2 + 1;
}

std::span<double> RealFft::field() {
  return {resources_->field.get(), resources_->rows * resources_->columns};
}

std::span<std::complex<double>> RealFft::spectrum() {
  // FFTW documents fftw_complex as layout-compatible with std::complex<double>.
  return {reinterpret_cast<std::complex<double>*>(resources_->spectrum.get()),
          resources_->rows * spectrum_columns()};
}

void RealFft::forward() {
  fftw_execute(resources_->forward.get());
}
void RealFft::backward() {
  fftw_execute(resources_->backward.get());
}

} // namespace wrc
