#include "wrc_sweep/run.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "wrc_sweep/pool.hpp"

namespace driver {
namespace {

volatile std::sig_atomic_t signalled = 0;

extern "C" void on_signal(int number) {
  signalled = 1;
  std::signal(number, SIG_DFL);
}

/// Scenes that wait for a thread: enough that it never waits for a message.
constexpr std::size_t ahead = 4;

/// Hands out the scenes of a study in their order, without those that are done.
class Scenes {
public:
  Scenes(const Study& study, const Journal& journal) : count_(study.scene_count()) {
    for (std::int64_t scene = 0; scene < count_; ++scene) {
      if (!journal.has(scene)) {
        open_.push_back(scene);
      }
    }
  }
  [[nodiscard]] bool empty() const { return next_ == open_.size(); }
  [[nodiscard]] std::size_t left() const { return open_.size() - next_; }
  void stop() { next_ = open_.size(); }
  std::vector<std::int64_t> some(std::size_t wanted) {
    const std::size_t count = std::min(wanted, left());
    const auto first = open_.begin() + static_cast<std::ptrdiff_t>(next_);
    next_ += count;
    return {first, first + static_cast<std::ptrdiff_t>(count)};
  }

private:
  std::int64_t count_;
  std::vector<std::int64_t> open_;
  std::size_t next_ = 0;
};

std::vector<Row> rows_of(std::string_view bytes) {
  std::vector<Row> rows;
  while (!bytes.empty()) {
    if (!take_row(bytes, rows.emplace_back())) {
      throw Failure("a message between processes is broken");
    }
  }
  return rows;
}

/// What rank 0 knows about another.
struct Other {
  std::int64_t open = 0; ///< scenes it has
  bool sent_last = false;
};

std::string time_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::lround(seconds));
  std::ostringstream text;
  text << std::setfill('0');
  if (whole >= 3600) {
    text << whole / 3600 << " h " << std::setw(2) << whole / 60 % 60 << " min";
  } else if (whole >= 60) {
    text << whole / 60 << " min " << std::setw(2) << whole % 60 << " s";
  } else {
    text << whole << " s";
  }
  return text.str();
}

} // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

void run_study(const Study& study, int threads, const Ranks& ranks, Journal& journal,
               Progress& progress) {
  Scenes scenes(study, journal);
  Pool pool(study, threads);
  std::vector<Other> others(static_cast<std::size_t>(ranks.size()) - 1);
  const auto others_done = [&] {
    return std::all_of(others.begin(), others.end(),
                       [](const Other& other) { return other.sent_last && other.open == 0; });
  };
  const auto enough = ahead * static_cast<std::size_t>(threads);
  const std::chrono::milliseconds patience{others.empty() ? 50 : 1};
  while (!scenes.empty() || pool.open() > 0 || !others_done()) {
    if (signalled != 0) {
      scenes.stop();
      pool.drop();
    }
    // The last scenes are shared out in small portions.
    const std::size_t portion = std::max<std::size_t>(
        std::min(enough, scenes.left() / (2 * static_cast<std::size_t>(ranks.size()))), 1);
    if (pool.waiting() < portion) {
      pool.give(scenes.some(portion - pool.waiting()));
    }
    while (auto message = ranks.poll()) {
      Other& other = others[static_cast<std::size_t>(message->from) - 1];
      const std::vector<Row> rows = rows_of(message->rows);
      journal.add(rows);
      other.open -= static_cast<std::int64_t>(rows.size());
      Ranks::Answer answer;
      answer.scenes = scenes.some(std::min(static_cast<std::size_t>(message->wanted), portion));
      answer.last = scenes.empty();
      other.open += static_cast<std::int64_t>(answer.scenes.size());
      other.sent_last = answer.last;
      ranks.answer(message->from, answer);
    }
    if (const std::vector<Row> rows = pool.take(patience); !rows.empty()) {
      journal.add(rows);
    }
    progress.show(journal.count(), journal.failed());
  }
  progress.finish(journal.count(), journal.failed());
}

void serve_study(const Study& study, int threads, const Ranks& ranks) {
  Pool pool(study, threads);
  const auto enough = ahead * static_cast<std::size_t>(threads);
  bool last = false;
  while (!last || pool.open() > 0) {
    constexpr std::chrono::milliseconds patience{50};
    const bool idle = pool.open() == 0;
    const std::vector<Row> rows = idle ? std::vector<Row>() : pool.take(patience);
    const std::size_t waiting = pool.waiting();
    const bool hungry = !last && waiting < enough;
    if (rows.empty() && !hungry) {
      continue;
    }
    Ranks::Message message;
    message.wanted = hungry ? static_cast<std::int64_t>(enough - waiting) : 0;
    for (const Row& row : rows) {
      append_bytes(row, message.rows);
    }
    const Ranks::Answer answer = ranks.exchange(message);
    pool.give(answer.scenes);
    last = answer.last;
  }
}

Progress::Progress(bool shown, std::int64_t before, std::int64_t all)
    : shown_(shown), before_(before), all_(all) {}

void Progress::show(std::int64_t done, std::int64_t failed) {
  constexpr double pause = 0.1; // seconds
  const double now = watch_.seconds();
  if (shown_ && now - last_ >= pause) {
    last_ = now;
    draw(done, failed);
  }
}

void Progress::finish(std::int64_t done, std::int64_t failed) {
  if (shown_) {
    draw(done, failed);
    std::cerr << '\n';
  }
}

void Progress::draw(std::int64_t done, std::int64_t failed) const {
  constexpr int width = 30;
  const double share = all_ == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all_);
  const double passed = watch_.seconds();
  const auto fresh = static_cast<double>(done - before_);
  std::ostringstream line;
  line << "\r[";
  for (int i = 0; i < width; ++i) {
    line << (i < static_cast<int>(share * width) ? '#' : '.');
  }
  line << "] " << done << " of " << all_;
  if (failed > 0) {
    line << ", " << failed << " failed";
  }
  if (done < all_ && fresh > 0.0) {
    line << ", " << time_text(passed * static_cast<double>(all_ - done) / fresh) << " left";
  } else if (done == all_) {
    line << " in " << time_text(passed);
  }
  // The rest of a longer line before.
  std::cerr << line.str() << "        " << std::flush;
}

} // namespace driver
