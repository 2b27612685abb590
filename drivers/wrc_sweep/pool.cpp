#include "wrc_sweep/pool.hpp"

#include <limits>
#include <utility>

#include "wrc_sweep/page.hpp"
#include "wrc_sweep/result_names.hpp"

namespace driver {

namespace {

/// Solves scenes of a study one by one, each as if it were the only one.
class SceneSolver {
public:
  explicit SceneSolver(const Study& study) : study_(study) {}

  /// Never throws for a scene that cannot be solved: the row says why.
  Row solve(std::int64_t index) {
    Row row;
    row.scene = index;
    try {
      study_.apply(index, scene_);
      if (!solver_.solve(scene_)) {
        row.status = WRC_NOT_CONVERGED;
        row.message = wrc_scene_error(scene_.handle());
      }
    } catch (const Failure& failure) {
      row.status = WRC_INVALID_ARGUMENT;
      row.message = failure.what();
    } catch (const wrcontact::Error& error) {
      row.status = error.status();
      row.message = error.what();
    }
    if (row.status == WRC_OK || row.status == WRC_NOT_CONVERGED) {
      read_results(row);
    } else {
      row.values.assign(study_.results.size(), std::numeric_limits<double>::quiet_NaN());
    }
    return row;
  }

private:
  void read_results(Row& row) {
    row.warnings = warnings_of(scene_);
    for (const std::string& name : study_.results) {
      row.values.push_back(result_of(scene_, name));
    }
    if (study_.for_page) {
      row.page = page_text(scene_);
    }
    if (study_.fields.empty()) {
      return;
    }
    for (std::size_t side = 0; side < side_names.size(); ++side) {
      for (std::int32_t index = 0;; ++index) {
        const std::string prefix =
            std::string(side_names[side]) + ".patches." + std::to_string(index) + '.';
        if (!scene_.has_number(prefix + "grid.lateral")) {
          break;
        }
        PatchFields& patch = row.patches.emplace_back();
        patch.side = static_cast<std::int32_t>(side);
        patch.index = index;
        patch.rows = static_cast<std::int64_t>(scene_.number(prefix + "grid.lateral"));
        patch.columns = static_cast<std::int64_t>(scene_.number(prefix + "grid.longitudinal"));
        for (const std::string& field : study_.fields) {
          patch.values.push_back(scene_.field(prefix + field));
        }
      }
    }
  }

  const Study& study_;
  Scene scene_;
  /// Keeps profiles, tables and plans, but nothing that the answer depends on.
  Solver solver_;
};

} // namespace

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
