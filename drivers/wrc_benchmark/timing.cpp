#include "wrc_benchmark/timing.hpp"

#include "support/scene.hpp"

namespace benchmark {

Times median(const std::vector<Times>& times) {
  const auto of = [&times](double Times::*stage) {
    std::vector<double> values;
    for (const Times& time : times) {
      values.push_back(time.*stage);
    }
    return median(values);
  };
  return {of(&Times::setup), of(&Times::geometry), of(&Times::remesh), of(&Times::mechanics),
          of(&Times::total)};
}

std::vector<double> totals(const std::vector<Times>& times) {
  std::vector<double> values;
  for (const Times& time : times) {
    values.push_back(time.total);
  }
  return values;
}

void Yardstick::sample() {
  // A sample takes some milliseconds: several small pairs, one large one.
  constexpr std::int64_t large = 1024 * 512;
  const std::int32_t repeats = grid_.count() >= large ? 1 : 5;
  double milliseconds = 0.0;
  if (wrc_measure_transform(2 * grid_.lateral, 2 * grid_.longitudinal, repeats, &milliseconds) !=
      WRC_OK) {
    throw driver::Failure("a transform of twice " + grid_.text() + " cannot be measured");
  }
  samples_.push_back(milliseconds);
}

double Yardstick::milliseconds() {
  if (samples_.empty()) {
    sample();
  }
  return median(samples_);
}

} // namespace benchmark
