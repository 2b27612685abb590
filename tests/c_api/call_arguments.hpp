/// Arguments of calls, good and bad: whatever a program may pass.
///
/// Choices and arrays are a thread's own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "call_sequences.hpp"

/// From here on the thread's arguments come from these choices.
void choose_from(Choices& choices);

std::uint64_t below(std::uint64_t end);
std::uint64_t any_bits();

template <class List> const auto& any_of(const List& list) {
  return list[below(std::size(list))];
}

template <class Value> Value* maybe(Value* pointer) {
  return below(16) == 0 ? nullptr : pointer;
}

double any_number();
const char* any_text();

constexpr std::size_t array_length = 4096;
double* any_array();
/// Of keys, of results, and of nothing.
std::int32_t* any_ids();
/// Within the arrays, or absurd.
std::int64_t any_count();
std::int64_t any_capacity();
/// Fills the arrays with zeros.
void clear_arrays();
