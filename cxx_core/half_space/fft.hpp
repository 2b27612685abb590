/// Fast Fourier transforms: the one file that sees FFTW.
///
/// LineFft: of complex values in one dimension, in single or double precision, on lines of the
/// caller's memory:
///   F[k] = sum_m f[m] exp(-2 pi i k m / length);
/// backward is its conjugate sum, so that backward(forward(f)) = length f (FFTW 3 manual, "What
/// FFTW Really Computes"). Plans are made with the requested rigor. With `estimate` they are the
/// same in every order of planning, unless the host measures by itself; with `measure` FFTW times
/// several algorithms, once a length, and the last bits of results may differ from one process to
/// the next. All estimates up to 2048 values are made before anything is measured or wisdom loaded,
/// so neither changes them.
/// Memory: FFTW ends the program if it gets none while it plans. So as much memory as it takes is
/// requested before any planning and given back: if there is none, that is Error(out_of_memory). A
/// line is planned when first needed and kept as long as the process; code that must not plan later
/// calls prepare_transforms first. Thread rule: planning takes a lock shared by the whole process,
/// since only FFTW's execute is thread-safe; a host that plans by itself can have its own lock
/// taken before it. Plans have one thread, whatever number the host has set for its own plans (with
/// FFTW 3.3.9 or newer); its setting is put back. One LineFft serves any number of threads at once,
/// each with lines of its own. Fork rule: lock_for_fork before, unlock_after_fork in both processes
/// after it.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <memory>
#include <new>
#include <string>

#include "half_space/constants.hpp"

namespace wrc {

/// How much work goes into the choice of an algorithm (FFTW's planner flags).
enum class PlannerRigor { estimate, measure };

/// A lock of the host program around all planning: `lock` and `unlock` are called with `context`.
struct PlannerLock {
  void (*lock)(void* context) = nullptr;
  void (*unlock)(void* context) = nullptr;
  void* context = nullptr;
};

/// Sets the host's lock for the whole process, or takes it away again (both functions null). To be
/// called while no other thread uses the library. Throws Error(invalid_argument) for one of two.
void set_planner_lock(const PlannerLock& host_lock);

/// Wisdom: what `measure` found out in this process, in single and in double precision. Reads and
/// writes the file named, at no other time than when called.
/// Throws Error(file_unreadable) or Error(file_malformed).
void load_wisdom(const std::string& path);
void save_wisdom(const std::string& path);

/// Least length for a line that is also fast with vector instructions: a multiple of 16 with an
/// odd factor of 1, 3, 5, 9, 15 or 25 where that has been measured to be as good per element (9,
/// 15 and 25 only up to 400); below 48 those that FFTW transforms several lines of at once: 2 to
/// 16, 20 and 32. Always even.
std::size_t fast_line_length(std::size_t least);

/// Memory aligned for vector instructions; values are not initialised. At least one value.
template <typename Value> class AlignedArray {
public:
  AlignedArray() = default;
  explicit AlignedArray(std::size_t size)
      : values_(static_cast<Value*>(::operator new (std::max<std::size_t>(size, 1) * sizeof(Value),
                                                    std::align_val_t{vector_alignment}))),
        size_(size) {}

  [[nodiscard]] Value* data() { return values_.get(); }
  [[nodiscard]] const Value* data() const { return values_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }

private:
  struct Release {
    void operator()(Value* values) const {
      ::operator delete (values, std::align_val_t{vector_alignment});
    }
  };
  std::unique_ptr<Value, Release> values_;
  std::size_t size_ = 0;
};

/// Memory for at least this number of values; earlier content is lost if it has to grow.
template <typename Value> void provide(AlignedArray<Value>& array, std::size_t size) {
  if (array.size() < size) {
    array = AlignedArray<Value>(size);
  }
}

/// Values per line in an array of lines, so that each line is aligned.
template <typename Value> constexpr std::size_t aligned_pitch(std::size_t length) {
  constexpr std::size_t unit = vector_alignment / sizeof(Value);
  return (length + unit - 1) / unit * unit;
}

/// Complex values as pairs of real ones, which the standard permits.
template <typename Real> Real* pairs_of(std::complex<Real>* values) {
  return reinterpret_cast<Real*>(values);
}
template <typename Real> const Real* pairs_of(const std::complex<Real>* values) {
  return reinterpret_cast<const Real*>(values);
}

/// Transforms of complex lines of one length; not normalised. Lines are aligned (AlignedArray),
/// several of them aligned_pitch apart; `from` and `to` do not overlap; `from` is kept. Lines
/// shorter than 48 use vector instructions across block_lines of them: 24 to 72 ns each for 12 to
/// 32 single-precision values, both ways, instead of 83 to 230 one by one. The last bits of such a
/// line depend on whether it comes alone.
template <typename Real> class LineFft {
public:
  using Complex = std::complex<Real>;

  /// Throws Error(out_of_memory) if plans cannot be made.
  LineFft(std::size_t length, PlannerRigor rigor);
  ~LineFft();
  LineFft(const LineFft&) = delete;
  LineFft& operator=(const LineFft&) = delete;

  /// How many lines should come at once.
  [[nodiscard]] std::size_t best_count() const;
  /// More than one line: there is room for whole blocks, filled with numbers.
  void forward(Complex* from, Complex* to, std::size_t count = 1) const;
  void backward(Complex* from, Complex* to, std::size_t count = 1) const;

private:
  struct Plans;
  friend class KeptTransforms;
  LineFft() = default; ///< to be planned by one that holds the planner's lock
  void plan(std::size_t length, PlannerRigor rigor);

  std::unique_ptr<Plans> plans_;
};

/// The transform of lines of a length, kept as long as the process. Throws Error(out_of_memory).
template <typename Real> const LineFft<Real>& line_fft(std::size_t length, PlannerRigor rigor);

/// Plans the lines of all grids up to 1024 elements across, once a process (10 ms). Throws
/// Error(out_of_memory).
void prepare_transforms();

/// While a process forks, no other thread plans.
void lock_for_fork();
void unlock_after_fork();

} // namespace wrc
