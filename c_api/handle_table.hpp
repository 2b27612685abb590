/// Handles that can be trusted: numbers, looked up at each call, never addresses.
///
/// A handle that was destroyed, never made, or belongs to another kind of object is not found, so
/// that using it is an error and no crash; numbers are not used twice. An object in use by one
/// thread is refused to another, and one that is destroyed meanwhile lives until its call ends.
/// Thread rule: all functions may be called by any thread at any time.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <new>
#include <shared_mutex>
#include <unordered_map>

namespace wrc {

/// Next number of a handle, different for all kinds. Multiples of 32 leave low bits to callers that
/// mark their handles.
inline std::uintptr_t next_handle_number() noexcept {
  constexpr std::uintptr_t step = 32;
  static std::atomic<std::uintptr_t> last{0};
  return last.fetch_add(step, std::memory_order_relaxed) + step;
}

template <class Object> class HandleTable {
public:
  struct Entry {
    Object object;
    std::atomic<bool> in_use{false};
  };

  /// The one table of a kind. It is never destroyed: programs may give their handles back as late
  /// as they like.
  static HandleTable& instance() {
    static auto* table = new HandleTable;
    return *table;
  }

  std::uintptr_t add() {
    auto entry = std::make_shared<Entry>();
    const std::uintptr_t number = next_handle_number();
    const std::unique_lock lock(mutex_);
    entries_.emplace(number, std::move(entry));
    return number;
  }

  /// Empty if there is none of that number.
  [[nodiscard]] std::shared_ptr<Entry> find(std::uintptr_t number) const {
    const std::shared_lock lock(mutex_);
    const auto found = entries_.find(number);
    return found == entries_.end() ? nullptr : found->second;
  }

  void remove(std::uintptr_t number) {
    std::shared_ptr<Entry> removed; // destroyed after the lock is gone
    const std::unique_lock lock(mutex_);
    if (const auto found = entries_.find(number); found != entries_.end()) {
      removed = std::move(found->second);
      entries_.erase(found);
    }
  }

  /// While the process forks, no other thread is within the table.
  void lock() { mutex_.lock(); }
  void unlock() { mutex_.unlock(); }
  /// In the child. A new lock: the old one counts threads that wait, which are missing there.
  void renew_lock() { new (&mutex_) std::shared_mutex; }

private:
  mutable std::shared_mutex mutex_;
  std::unordered_map<std::uintptr_t, std::shared_ptr<Entry>> entries_;
};

/// An object in use by this call, or not available.
template <class Object> class InUse {
public:
  using Entry = typename HandleTable<Object>::Entry;

  explicit InUse(std::shared_ptr<Entry> entry) noexcept
      : entry_(std::move(entry)),
        held_(entry_ && !entry_->in_use.exchange(true, std::memory_order_acquire)) {}
  ~InUse() {
    if (held_) {
      entry_->in_use.store(false, std::memory_order_release);
    }
  }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;

  [[nodiscard]] bool exists() const noexcept { return entry_ != nullptr; }
  [[nodiscard]] bool held() const noexcept { return held_; }
  [[nodiscard]] Object& object() const noexcept { return entry_->object; }

private:
  std::shared_ptr<Entry> entry_;
  bool held_;
};

} // namespace wrc
