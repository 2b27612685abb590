/// An optional value on the heap: results hold many that are rarely there, and then take eight
/// bytes for each.
///
/// As std::optional, as far as it is used here. Copies copy the value. Thread rule: a plain value.
#pragma once

#include <memory>
#include <optional>
#include <utility>

namespace wrc {

template <typename Value> class HeapOptional {
public:
  HeapOptional() = default;
  HeapOptional(std::nullopt_t) {}
  HeapOptional(Value value) : value_(std::make_unique<Value>(std::move(value))) {}
  HeapOptional(std::optional<Value> value) {
    if (value) {
      emplace(*std::move(value));
    }
  }
  HeapOptional(const HeapOptional& other)
      : value_(other ? std::make_unique<Value>(*other) : nullptr) {}
  HeapOptional(HeapOptional&&) noexcept = default;
  HeapOptional& operator=(HeapOptional other) noexcept {
    value_ = std::move(other.value_);
    return *this;
  }
  ~HeapOptional() = default;

  template <typename... Arguments> Value& emplace(Arguments&&... arguments) {
    value_ = std::make_unique<Value>(std::forward<Arguments>(arguments)...);
    return *value_;
  }
  void reset() { value_.reset(); }
  [[nodiscard]] bool has_value() const { return value_ != nullptr; }
  explicit operator bool() const { return has_value(); }
  /// Throws std::bad_optional_access if there is none.
  [[nodiscard]] const Value& value() const {
    if (!value_) {
      throw std::bad_optional_access();
    }
    return *value_;
  }
  [[nodiscard]] Value& value() { return const_cast<Value&>(std::as_const(*this).value()); }
  Value& operator*() { return *value_; }
  const Value& operator*() const { return *value_; }
  Value* operator->() { return value_.get(); }
  const Value* operator->() const { return value_.get(); }

private:
  std::unique_ptr<Value> value_;
};

} // namespace wrc
