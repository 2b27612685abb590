#include "wrc_sweep/progress.hpp"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace driver {
namespace {

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

Progress::Progress(bool shown, std::int64_t before, std::int64_t all)
    : shown_(shown), before_(before), all_(all) {}

void Progress::show(std::int64_t done, std::int64_t failed) {
  constexpr std::chrono::milliseconds pause{100};
  const auto now = Clock::now();
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
  const double passed = std::chrono::duration<double>(Clock::now() - start_).count();
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
