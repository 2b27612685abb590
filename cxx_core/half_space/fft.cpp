#include "half_space/fft.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fftw3.h>
#if !defined(_WIN32)
#include <dlfcn.h>
#endif

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/stopwatch.hpp"
#include "half_space/constants.hpp"

namespace wrc {

namespace {

/// Guards plan creation and destruction, which share tables inside FFTW. In single and in double
/// precision FFTW has tables of its own; one lock for both is enough.
class Planner {
public:
  // The host's lock first: a host that holds it (recursively) while it calls must find ours free.
  void lock() {
    if (host_.lock != nullptr) {
      host_.lock(host_.context);
    }
    own_.lock();
  }
  void unlock() {
    own_.unlock();
    if (host_.unlock != nullptr) {
      host_.unlock(host_.context);
    }
  }
  void set_host_lock(const PlannerLock& host) {
    const std::lock_guard<std::mutex> guard(own_);
    host_ = host;
  }
  // The host's lock is the host's to take care of.
  void lock_own() { own_.lock(); }
  void unlock_own() { own_.unlock(); }

private:
  std::mutex own_;
  PlannerLock host_;
};

#if !defined(_WIN32) // where a mutex has no constant initial value
constinit
#endif
    Planner the_planner;

Planner& planner() {
  return the_planner;
}

using PlanningGuard = std::lock_guard<Planner>;

unsigned flags_of(PlannerRigor rigor) {
  return rigor == PlannerRigor::measure ? FFTW_MEASURE : FFTW_ESTIMATE;
}

void check_length(std::size_t length) {
  constexpr auto longest = static_cast<std::size_t>(std::numeric_limits<int>::max());
  if (length < 1 || length > longest) {
    throw_invalid_argument("length", static_cast<double>(length), "must be between 1 and 2^31 - 1");
  }
}

/// Throws std::bad_alloc unless so much memory is there, which FFTW may take then.
void require_memory(std::size_t bytes) {
  void* volatile memory = std::malloc(bytes); // volatile: else the pair would be left out
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  std::free(memory);
}

[[noreturn]] void throw_no_memory(std::size_t rows, std::size_t columns) {
  throw Error(ErrorCode::out_of_memory, "no memory for a transform of " + std::to_string(rows) +
                                            " x " + std::to_string(columns) + " values");
}

/// FFTW's names in one precision.
template <typename Real> struct Library;

template <> struct Library<double> {
  using Complex = fftw_complex;
  using Plan = fftw_plan_s;
  static void destroy(Plan* plan) { fftw_destroy_plan(plan); }
  static Plan* plan_complex(int length, int lines, int pitch, Complex* from, Complex* to, int sign,
                            unsigned flags) {
    return fftw_plan_many_dft(1, &length, lines, from, nullptr, 1, pitch, to, nullptr, 1, pitch,
                              sign, flags | FFTW_PRESERVE_INPUT);
  }
  static void run(const Plan* plan, Complex* from, Complex* to) {
    fftw_execute_dft(const_cast<Plan*>(plan), from, to);
  }
};

template <> struct Library<float> {
  using Complex = fftwf_complex;
  using Plan = fftwf_plan_s;
  static void destroy(Plan* plan) { fftwf_destroy_plan(plan); }
  static Plan* plan_complex(int length, int lines, int pitch, Complex* from, Complex* to, int sign,
                            unsigned flags) {
    return fftwf_plan_many_dft(1, &length, lines, from, nullptr, 1, pitch, to, nullptr, 1, pitch,
                               sign, flags | FFTW_PRESERVE_INPUT);
  }
  static void run(const Plan* plan, Complex* from, Complex* to) {
    fftwf_execute_dft(const_cast<Plan*>(plan), from, to);
  }
};

template <typename Real> struct PlanRelease {
  void operator()(typename Library<Real>::Plan* plan) const {
    const PlanningGuard guard(planner());
    Library<Real>::destroy(plan);
  }
};

template <typename Real>
using Plan = std::unique_ptr<typename Library<Real>::Plan, PlanRelease<Real>>;

/// FFTW documents its complex type as layout-compatible with std::complex.
template <typename Real> typename Library<Real>::Complex* fftw_of(std::complex<Real>* values) {
  return reinterpret_cast<typename Library<Real>::Complex*>(values);
}

#if !defined(_WIN32)
/// How many threads the planner gives to plans of one precision: a setting of the host's, in
/// FFTW's library of threads. With several, the last bits of results are others, and a child of
/// fork waits for threads that it does not have.
class PlannerThreads {
public:
  /// `execute`: our FFTW's; a library of threads that belongs to another FFTW is left alone.
  PlannerThreads(const std::string& prefix, const std::string& library, void* execute) {
    // That which the host's own calls reach, else one that it has loaded for itself.
    take(RTLD_DEFAULT, prefix, execute);
    for (const char* kind : {"_threads", "_omp"}) {
      if (set_ == nullptr) {
        loaded_.reset(dlopen((library + kind + ".so.3").c_str(), RTLD_LAZY | RTLD_NOLOAD));
        if (loaded_ != nullptr) {
          take(loaded_.get(), prefix, execute);
        }
      }
    }
    count_ = set_ != nullptr ? get_() : 1;
    if (count_ > 1) { // not without need: it starts FFTW's threads
      set_(1);
    }
  }
  ~PlannerThreads() {
    if (count_ > 1) {
      set_(count_);
    }
  }
  PlannerThreads(const PlannerThreads&) = delete;
  PlannerThreads& operator=(const PlannerThreads&) = delete;

private:
  void take(void* from, const std::string& prefix, void* execute) {
    const auto find = [&](const char* name) { return dlsym(from, (prefix + name).c_str()); };
    get_ = reinterpret_cast<int (*)()>(find("_planner_nthreads")); // since FFTW 3.3.9
    set_ = get_ != nullptr && find("_execute") == execute
               ? reinterpret_cast<void (*)(int)>(find("_plan_with_nthreads"))
               : nullptr;
  }

  struct Close {
    void operator()(void* library) const { dlclose(library); }
  };
  std::unique_ptr<void, Close> loaded_;
  int (*get_)() = nullptr;
  void (*set_)(int) = nullptr;
  int count_ = 1;
};

/// While it lives, plans of both precisions have one thread. Under the planner's lock.
struct OneThread {
  PlannerThreads wide{"fftw", "libfftw3", reinterpret_cast<void*>(&fftw_execute)};
  PlannerThreads narrow{"fftwf", "libfftw3f", reinterpret_cast<void*>(&fftwf_execute)};
};
#else
struct OneThread {}; // FFTW belongs to the library there
#endif

/// Parts of a wisdom file: both precisions, one after the other.
constexpr const char* single_precision_mark = "single precision\n";

} // namespace

void set_planner_lock(const PlannerLock& host_lock) {
  if ((host_lock.lock == nullptr) != (host_lock.unlock == nullptr)) {
    throw_invalid_argument("planner lock", "only one of lock and unlock",
                           "must be both functions or neither");
  }
  planner().set_host_lock(host_lock);
}

void load_wisdom(const std::string& path) {
  prepare_transforms(); // before wisdom can change what is estimated
  constexpr std::size_t max_wisdom_size = std::size_t{1} << 24;
  const std::string text = read_file(path, max_wisdom_size);
  if (text.empty()) {
    throw Error(ErrorCode::file_unreadable, "wisdom file \"" + path + "\" is empty");
  }
  const std::size_t mark = text.find(single_precision_mark);
  const PlanningGuard guard(planner());
  if (mark == std::string::npos ||
      fftw_import_wisdom_from_string(text.substr(0, mark).c_str()) == 0 ||
      fftwf_import_wisdom_from_string(
          text.substr(mark + std::string(single_precision_mark).size()).c_str()) == 0) {
    throw Error(ErrorCode::file_malformed,
                "wisdom file \"" + path + "\" contains no FFTW wisdom written by this library");
  }
}

void save_wisdom(const std::string& path) {
  std::string text;
  {
    const PlanningGuard guard(planner());
    const std::unique_ptr<char, decltype(&std::free)> wide(fftw_export_wisdom_to_string(),
                                                           &std::free);
    const std::unique_ptr<char, decltype(&std::free)> narrow(fftwf_export_wisdom_to_string(),
                                                             &std::free);
    if (wide == nullptr || narrow == nullptr) {
      throw Error(ErrorCode::out_of_memory, "no memory for the text of FFTW's wisdom");
    }
    text.append(wide.get()).append(single_precision_mark).append(narrow.get());
  }
  write_file(path, text);
}

std::size_t fast_line_length(std::size_t least) {
  constexpr std::size_t vector_length = 16;
  if (least <= vector_length) {
    return std::max<std::size_t>(least + least % 2, 2);
  }
  for (const std::size_t length : {20U, 32U}) {
    if (least <= length) {
      return length;
    }
  }
  std::size_t best = std::numeric_limits<std::size_t>::max();
  for (const std::size_t odd : {1U, 3U, 5U, 9U, 15U, 25U}) {
    std::size_t length = odd * vector_length;
    while (length < least) {
      length *= 2;
    }
    if (odd <= 5 || length <= max_odd_line) {
      best = std::min(best, length);
    }
  }
  return best;
}

// Lines of other memory need no more than the same alignment to be transformed by the same plan.

template <typename Real> struct LineFft<Real>::Plans {
  std::size_t pitch = 0;
  Plan<Real> forward;
  Plan<Real> backward;
  // Plan for blocks; none for long lines.
  Plan<Real> block_forward;
  Plan<Real> block_backward;

  void run(const Plan<Real>& line, const Plan<Real>& block, Complex* from, Complex* to,
           std::size_t count) const {
    const bool in_blocks = block != nullptr && count > 1;
    const std::size_t lines = in_blocks ? block_lines : 1;
    for (std::size_t first = 0; first < count; first += lines) {
      Library<Real>::run((in_blocks ? block : line).get(), fftw_of(from + first * pitch),
                         fftw_of(to + first * pitch));
    }
  }
};

template <typename Real> LineFft<Real>::LineFft(std::size_t length, PlannerRigor rigor) {
  const PlanningGuard guard(planner());
  plan(length, rigor);
}

template <typename Real> void LineFft<Real>::plan(std::size_t length, PlannerRigor rigor) {
  check_length(length);
  plans_.reset(new Plans);
  Plans& own = *plans_;
  own.pitch = aligned_pitch<Complex>(length);
  const std::size_t lines = length < min_lone_line ? block_lines : 1;
  AlignedArray<Complex> first(lines * own.pitch);
  AlignedArray<Complex> second(lines * own.pitch);
  const auto plan = [&](std::size_t count, int sign) {
    Plan<Real> made(Library<Real>::plan_complex(static_cast<int>(length), static_cast<int>(count),
                                                static_cast<int>(own.pitch), fftw_of(first.data()),
                                                fftw_of(second.data()), sign, flags_of(rigor)));
    if (made == nullptr) {
      throw_no_memory(count, length);
    }
    return made;
  };
  const OneThread one_thread;
  require_memory(fft_memory_of_tables + 4 * fft_memory_of_plan + length * fft_memory_per_value);
  own.forward = plan(1, FFTW_FORWARD);
  own.backward = plan(1, FFTW_BACKWARD);
  if (lines > 1) {
    own.block_forward = plan(lines, FFTW_FORWARD);
    own.block_backward = plan(lines, FFTW_BACKWARD);
  }
}

template <typename Real> LineFft<Real>::~LineFft() = default;

template <typename Real> std::size_t LineFft<Real>::best_count() const {
  return plans_->block_forward != nullptr ? block_lines : 1;
}

template <typename Real>
void LineFft<Real>::forward(Complex* from, Complex* to, std::size_t count) const {
  plans_->run(plans_->forward, plans_->block_forward, from, to, count);
}
template <typename Real>
void LineFft<Real>::backward(Complex* from, Complex* to, std::size_t count) const {
  plans_->run(plans_->backward, plans_->block_backward, from, to, count);
}

template class LineFft<float>;
template class LineFft<double>;

/// The transforms of the process, kept as long as it: a thread may still use them while it ends.
class KeptTransforms {
public:
  template <typename Real> const LineFft<Real>& get(std::size_t length, PlannerRigor rigor) {
    if (const LineFft<Real>* kept = find<Real>(length, rigor)) {
      return *kept;
    }
    if (rigor == PlannerRigor::measure) {
      prepare(); // what FFTW measures would change later estimates
    }
    std::unique_ptr<LineFft<Real>> made(new LineFft<Real>); // its plans take the lock if they fail
    // Nobody waits for the planner, which may take the host's lock, while holding the other lock.
    const PlanningGuard planning(planner());
    if (const LineFft<Real>* kept = find<Real>(length, rigor)) {
      return *kept; // another thread was first
    }
    made->plan(length, rigor);
    const std::lock_guard<std::mutex> guard(lock_);
    return *std::get<Kept<Real>>(kept_).try_emplace({rigor, length}, std::move(made)).first->second;
  }

  /// Those with `estimate` of all lines that grids up to 1024 elements across need.
  void prepare() {
    // origin: bound: changes no result. All of these take 10 to 12 ms; longer lines take 2 ms more
    // per octave and belong to grids of many MB, beside which a plan's 16 kB are little.
    constexpr std::size_t longest = 2048;
    for (std::size_t length = 0; length < longest;) {
      length = fast_line_length(length + 1);
      get<float>(length, PlannerRigor::estimate);
      get<double>(length, PlannerRigor::estimate);
    }
  }

  void lock() {
    planner().lock_own();
    lock_.lock();
  }
  void unlock() {
    lock_.unlock();
    planner().unlock_own();
  }

private:
  template <typename Real>
  using Kept = std::map<std::pair<PlannerRigor, std::size_t>, std::unique_ptr<const LineFft<Real>>>;

  template <typename Real> const LineFft<Real>* find(std::size_t length, PlannerRigor rigor) {
    const std::lock_guard<std::mutex> guard(lock_);
    const auto& kept = std::get<Kept<Real>>(kept_);
    const auto found = kept.find({rigor, length});
    return found == kept.end() ? nullptr : found->second.get();
  }

  std::mutex lock_; ///< guards kept_
  std::tuple<Kept<float>, Kept<double>> kept_;
};

namespace {

KeptTransforms& kept_transforms() {
  static auto* const kept = new KeptTransforms;
  return *kept;
}

} // namespace

template <typename Real> const LineFft<Real>& line_fft(std::size_t length, PlannerRigor rigor) {
  return kept_transforms().get<Real>(length, rigor);
}
template const LineFft<float>& line_fft<float>(std::size_t, PlannerRigor);
template const LineFft<double>& line_fft<double>(std::size_t, PlannerRigor);

void prepare_transforms() {
  kept_transforms().prepare();
}

void lock_for_fork() {
  kept_transforms().lock();
}
void unlock_after_fork() {
  kept_transforms().unlock();
}

} // namespace wrc
