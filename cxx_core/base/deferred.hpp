/// A value that is computed when it is first asked for, once for all copies.
///
/// If that fails, for want of memory say, the next one who asks tries again. Thread rule: any
/// number of threads may ask.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace wrc {

template <class T> class Deferred {
public:
  /// None.
  Deferred() = default;
  explicit Deferred(std::function<T()> compute)
      : state_(std::make_shared<State>(std::move(compute))) {}

  [[nodiscard]] bool valid() const { return state_ != nullptr; }
  /// Only if valid.
  [[nodiscard]] const T& get() const {
    const std::scoped_lock lock(state_->mutex);
    if (!state_->value) {
      state_->value.emplace(state_->compute());
      state_->compute = nullptr;
    }
    return *state_->value;
  }

private:
  struct State {
    explicit State(std::function<T()> how) : compute(std::move(how)) {}
    std::mutex mutex;
    std::function<T()> compute;
    std::optional<T> value;
  };
  std::shared_ptr<State> state_;
};

} // namespace wrc
