#include "base/worker_threads.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace wrc {
namespace {

TEST(WorkerThreads, DoEachTaskOnce) {
  for (const int threads : {1, 3, 8}) {
    std::vector<int> done(101);
    double last = 0.0;
    run_tasks(
        done.size(), threads, [&last](double share) { last = share; },
        [&] { return [&](std::size_t task) { ++done[task]; }; });
    EXPECT_EQ(done, std::vector<int>(done.size(), 1));
    EXPECT_LE(last, 1.0);
  }
}

TEST(WorkerThreads, ThrowWhatATaskThrows) {
  for (const int threads : {1, 3}) {
    EXPECT_THROW(run_tasks(20, threads, {},
                           [] {
                             return [](std::size_t task) {
                               if (task == 7) {
                                 throw std::runtime_error("seven");
                               }
                             };
                           }),
                 std::runtime_error);
  }
}

TEST(WorkerThreads, StopWhereTheProgressThrows) {
  std::size_t done = 0;
  EXPECT_THROW(run_tasks(
                   1000, 1,
                   [](double share) {
                     if (share > 0.1) {
                       throw std::runtime_error("enough");
                     }
                   },
                   [&] { return [&](std::size_t) { ++done; }; }),
               std::runtime_error);
  EXPECT_LT(done, 200U);
}

} // namespace
} // namespace wrc
