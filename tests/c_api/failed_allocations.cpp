/// Every allocation of a call fails once, whoever makes it: the library, FFTW, LAPACK or the C
/// library. Each failure happens in a child process, so that one that ends its process is counted.
/// The call must return WRC_OK or WRC_OUT_OF_MEMORY; with memory it must then return WRC_OK and the
/// values of a call that never failed. Then a first handle and solution under each limit of memory
/// from none to plenty. Usage: failed_allocations [STRIDE [FOLDER]]: every STRIDE-th one.
///
/// One remainder is counted and printed, but no fault: FFTW ends the process if one of its own
/// allocations fails while it plans. No limit of memory does that, since as much is
/// asked for before.
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "wrcontact.h"

// What stands behind malloc in glibc; this program's own malloc counts and fails.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

/// Allocations until the one that fails; below 0: none does.
std::atomic<long> left{-1};
std::atomic<long> failures{0};

bool fails() {
  if (left.load(std::memory_order_relaxed) >= 0 && left.fetch_sub(1) == 0) {
    ++failures;
    errno = ENOMEM;
    return true;
  }
  return false;
}

} // namespace

#pragma GCC visibility push(default)
extern "C" {
void* malloc(std::size_t size) {
  return fails() ? nullptr : __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  return fails() ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  return fails() ? nullptr : __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  return fails() ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  *memory = memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
}
#pragma GCC visibility pop

namespace {

void require(bool holds, const char* what) {
  if (!holds) {
    std::fprintf(stderr, "%s\n", what);
    std::exit(1);
  }
}

double number(wrc_scene* scene, const char* name) {
  double value = -1.0;
  require(wrc_scene_number(scene, name, &value) == WRC_OK, name);
  return value;
}

wrc_scene* make_scene(double lateral) {
  wrc_scene* scene = nullptr;
  require(wrc_scene_create(&scene) == WRC_OK, "no scene");
  require(wrc_scene_set_number(scene, "pose.lateral", lateral) == WRC_OK, "no lateral position");
  return scene;
}

/// A call, what has to stay as it was if it fails, and what it gives.
struct Case {
  const char* name;
  std::function<wrc_status()> call;
  std::function<double()> kept;   ///< an old result
  std::function<double()> result; ///< a new one
};

enum Outcome { good, wrong_status, old_lost, next_wrong, refused };

int in_child(const Case& one, long count, double expected) {
  const double before = one.kept();
  left = count;
  const wrc_status status = one.call();
  left = -1;
  if (status != WRC_OK && status != WRC_OUT_OF_MEMORY) {
    std::fprintf(stderr, "%s, allocation %ld: %s\n", one.name, count, wrc_status_name(status));
    return wrong_status;
  }
  if (status == WRC_OUT_OF_MEMORY && one.kept() != before) {
    return old_lost;
  }
  return one.call() == WRC_OK && one.result() == expected ? good : next_wrong;
}

/// Runs a body in a child; its exit code, or 100 and more if it did not end by itself.
int forked(const std::function<int()>& body) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    constexpr unsigned patience = 60; // seconds, on a busy machine
    alarm(patience);                  // ends one that waits for a lock which it holds itself
    const int code = body();
    std::fflush(nullptr);
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 100 + WTERMSIG(status);
}

/// How many allocations the call makes, and what it gives, from a child, which leaves no traces.
std::pair<long, double> measured(const Case& one) {
  int ends[2] = {};
  require(pipe(ends) == 0, "no pipe");
  std::pair<long, double> found;
  require(forked([&] {
            constexpr long many = 1L << 40;
            left = many;
            const bool solved = one.call() == WRC_OK;
            found = {many - left, 0.0};
            left = -1;
            found.second = one.result();
            return solved && write(ends[1], &found, sizeof found) == sizeof found ? 0 : 1;
          }) == 0,
          one.name);
  require(read(ends[0], &found, sizeof found) == sizeof found, "nothing measured");
  close(ends[0]);
  close(ends[1]);
  return found;
}

void print_nothing() {
  require(std::freopen("/dev/null", "w", stderr) != nullptr, "no /dev/null");
}

/// The number of failures of any kind but those in which FFTW ends the process while it plans.
long run_first(const Case& one, long stride) {
  const long allocations = measured(one).first;
  long ended = 0;
  long faults = 0;
  for (long count = 0; count < allocations; count += stride) {
    const int code = forked([&] {
      print_nothing(); // FFTW does
      return in_child(one, count, 0.0);
    });
    ended += code == 100 + SIGABRT ? 1 : 0;
    faults += code == good || code == 100 + SIGABRT ? 0 : 1;
  }
  std::printf("%-28s %6ld allocations: FFTW ended the process at %ld, %ld other faults\n", one.name,
              allocations, ended, faults);
  return faults;
}

long address_space() {
  long pages = -1;
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  require(file != nullptr && std::fscanf(file, "%ld", &pages) == 1, "no address space known");
  std::fclose(file);
  return pages * sysconf(_SC_PAGESIZE);
}

void limit_address_space(rlim_t bytes) {
  rlimit limit{};
  require(getrlimit(RLIMIT_AS, &limit) == 0, "no limit known");
  limit.rlim_cur = bytes;
  require(setrlimit(RLIMIT_AS, &limit) == 0, "no limit set");
}

/// Makes room on the stack, which could not grow later.
__attribute__((noinline)) void touch_stack() {
  volatile char room[1 << 20];
  for (std::size_t i = 0; i < sizeof room; i += 1024) {
    room[i] = 0;
  }
}

wrc_status first_solution(double* pmax) {
  wrc_scene* scene = nullptr;
  wrc_status status = wrc_scene_create(&scene);
  if (status == WRC_OK) {
    status = wrc_scene_solve(scene);
  }
  if (status == WRC_OK) {
    status = wrc_scene_number(scene, "left.pmax", pmax);
  }
  wrc_scene_destroy(scene);
  return status;
}

/// A first handle and solution in `bytes` more than the process has, and then without limit.
int within(long bytes) {
  touch_stack();
  limit_address_space(static_cast<rlim_t>(address_space() + bytes));
  double limited = -1.0;
  const wrc_status status = first_solution(&limited);
  limit_address_space(RLIM_INFINITY);
  if (status != WRC_OK && status != WRC_OUT_OF_MEMORY) {
    std::fprintf(stderr, "%ld bytes: %s\n", bytes, wrc_status_name(status));
    return wrong_status;
  }
  double free = -1.0;
  if (first_solution(&free) != WRC_OK || (status == WRC_OK && free != limited)) {
    return next_wrong;
  }
  return status == WRC_OK ? good : refused;
}

/// The number of limits under which something else happens than a status.
long run_under_limits(long stride) {
  const long step = 4096 * stride;
  long refusals = 0;
  long faults = 0;
  long bytes = 0;
  for (int code = -1; code != good; bytes += step) {
    code = forked([&] { return within(bytes); });
    refusals += code == refused ? 1 : 0;
    faults += code == refused || code == good ? 0 : 1;
    require(bytes < 1L << 30, "a solution takes more than 1 GB");
  }
  std::printf("%-28s to %.1f MB more: %ld refused, then solved, %ld faults\n", "limits of memory",
              static_cast<double>(bytes - step) / 1e6, refusals, faults);
  return faults;
}

/// The number of failures of any kind.
long run(const Case& one, long stride) {
  const auto [allocations, expected] = measured(one);
  long outcomes[4] = {};
  long ended = 0;
  for (long count = 0; count < allocations; count += stride) {
    const int code = forked([&, expected = expected] { return in_child(one, count, expected); });
    if (code < 4) {
      ++outcomes[code];
    } else {
      ++ended;
    }
  }
  std::printf("%-28s %6ld allocations: %ld good, %ld ended the process, %ld other status, %ld lost "
              "old results, %ld wrong afterwards\n",
              one.name, allocations, outcomes[good], ended, outcomes[wrong_status],
              outcomes[old_lost], outcomes[next_wrong]);
  return ended + outcomes[wrong_status] + outcomes[old_lost] + outcomes[next_wrong];
}

} // namespace

int main(int count, char** arguments) {
  const long stride = count > 1 ? std::atol(arguments[1]) : 1;
  const std::string file = std::string(count > 2 ? arguments[2] : ".") + "/failed_allocations.toml";
  const auto nothing = [] { return 0.0; };
  long faults = run_first({"first solver",
                           [] {
                             wrc_solver* solver = nullptr;
                             const wrc_status status = wrc_solver_create(&solver);
                             wrc_solver_destroy(solver);
                             return status;
                           },
                           nothing, nothing},
                          stride);
  faults += run_under_limits(stride);
  wrc_solver* solver = nullptr; // plans all transforms: none of the calls below does
  require(wrc_solver_create(&solver) == WRC_OK, "no solver");
  wrc_scene* cold = make_scene(3.0);
  faults += run({"cold scene", [&] { return wrc_scene_solve(cold); }, nothing,
                 [&] { return number(cold, "left.pmax"); }},
                stride);
  faults += run({"cold solver", [&] { return wrc_solver_solve(solver, cold); }, nothing,
                 [&] { return number(cold, "left.pmax"); }},
                stride);
  wrc_scene* batch[] = {make_scene(0.0), make_scene(1.0), make_scene(2.0)};
  for (const std::int32_t threads : {1, 2}) {
    faults += run({threads == 1 ? "cold batch" : "cold batch on two threads",
                   [&] { return wrc_solve_batch(batch, 3, threads, nullptr); }, nothing,
                   [&] { return number(batch[2], "left.pmax"); }},
                  stride);
  }
  faults +=
      run({"scene file", [&] { return wrc_scene_write(cold, file.c_str()); }, nothing, nothing},
          stride);
  std::remove(file.c_str());
  require(wrc_solver_solve(solver, cold) == WRC_OK, "no solution");
  require(wrc_scene_set_number(cold, "pose.lateral", 5.0) == WRC_OK, "no lateral position");
  faults +=
      run({"warm solver", [&] { return wrc_solver_solve(solver, cold); },
           [&] { return number(cold, "left.pmax"); }, [&] { return number(cold, "left.pmax"); }},
          stride);
  faults +=
      run({"warm scene", [&] { return wrc_scene_solve(cold); },
           [&] { return number(cold, "left.pmax"); }, [&] { return number(cold, "left.pmax"); }},
          stride);
  double least_gap = 0.0;
  faults += run({"residuals",
                 [&] { return wrc_scene_number(cold, "left.residuals.least_gap", &least_gap); },
                 [&] { return number(cold, "left.pmax"); },
                 [&] { return number(cold, "left.residuals.least_gap"); }},
                stride);
  const double creepage[] = {1e-3, 5e-4, 2e-4};
  require(wrc_scene_set_numbers(cold, "creepage.left", creepage, 3) == WRC_OK, "no creepage");
  require(wrc_scene_set_number(cold, "solve.accuracy", 1e-2) == WRC_OK, "no accuracy");
  faults += run({"creep forces", [&] { return wrc_scene_solve(cold); },
                 [&] { return number(cold, "left.pmax"); },
                 [&] { return number(cold, "left.patches.0.creep_force.longitudinal"); }},
                stride);
  return faults == 0 ? 0 : 1;
}
