/// Errors that calls of the core must throw.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace wrc::test {

/// The call throws an error with this code and a text that has these parts.
template <class Call, class... Parts>
void expect_error(ErrorCode code, Call&& call, const Parts&... parts) {
  try {
    call();
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.code(), code) << text;
    for (const std::string& part : {std::string(), std::string(parts)...}) {
      EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
    }
    return;
  }
  ADD_FAILURE() << "no error";
}

} // namespace wrc::test
