/// The caller's floating-point environment is set aside during a call.
///
/// Callers trap exceptions (-ffpe-trap), flush small numbers to zero (-ffast-math) or round
/// differently; the library computes with the IEEE default whatever they do, and its own exception
/// flags do not reach them. Threads started meanwhile inherit the default. Thread rule: an object
/// belongs to the thread that made it.
#pragma once

#include <cfenv>

namespace wrc {

class DefaultFloatingPoint {
public:
  DefaultFloatingPoint() noexcept {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultFloatingPoint() { std::fesetenv(&callers_); }
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

private:
  std::fenv_t callers_{};
};

} // namespace wrc
