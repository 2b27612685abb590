#include "wrc_sweep/pool.hpp"

#include <utility>

#include "wrc_sweep/scene_solver.hpp"

namespace driver {

Pool::Pool(const Study& study, int threads) {
  for (int i = 0; i < threads; ++i) {
    threads_.emplace_back([this, &study] { work(study); });
  }
}

Pool::~Pool() {
  {
    const std::scoped_lock lock(mutex_);
    queue_.clear();
    ended_ = true;
  }
  given_.notify_all();
}

void Pool::give(const std::vector<std::int64_t>& scenes) {
  {
    const std::scoped_lock lock(mutex_);
    queue_.insert(queue_.end(), scenes.begin(), scenes.end());
    open_ += scenes.size();
  }
  given_.notify_all();
}

void Pool::drop() {
  const std::scoped_lock lock(mutex_);
  open_ -= queue_.size();
  queue_.clear();
}

std::size_t Pool::waiting() const {
  const std::scoped_lock lock(mutex_);
  return queue_.size();
}

std::size_t Pool::open() const {
  const std::scoped_lock lock(mutex_);
  return open_;
}

std::vector<Row> Pool::take(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  finished_.wait_for(lock, patience, [this] { return !rows_.empty() || trouble_; });
  if (trouble_) {
    std::rethrow_exception(trouble_);
  }
  open_ -= rows_.size();
  return std::exchange(rows_, {});
}

void Pool::work(const Study& study) {
  try {
    SceneSolver solver(study);
    while (true) {
      std::int64_t scene = 0;
      {
        std::unique_lock lock(mutex_);
        given_.wait(lock, [this] { return ended_ || !queue_.empty(); });
        if (ended_) {
          return;
        }
        scene = queue_.front();
        queue_.pop_front();
      }
      Row row = solver.solve(scene);
      {
        const std::scoped_lock lock(mutex_);
        rows_.push_back(std::move(row));
      }
      finished_.notify_one();
    }
  } catch (...) {
    {
      const std::scoped_lock lock(mutex_);
      trouble_ = std::current_exception();
    }
    finished_.notify_one();
  }
}

} // namespace driver
