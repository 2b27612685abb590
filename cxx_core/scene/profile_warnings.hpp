/// Warnings of the profiles that a scene is solved with.
///
/// They are kept with the profiles, and a result refers to them: texts are put together when they
/// are read. Thread rule: a plain value.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/warning.hpp"
#include "keys/scene.hpp"
#include "profile/profile.hpp"

namespace wrc {

class ProfileWarnings {
public:
  struct Entry {
    ProfileKind kind = ProfileKind::wheel;
    SideChoice side = SideChoice::both; ///< that uses it
    std::string name;                   ///< of the profile, or its file
    std::shared_ptr<const Warnings> warnings;
  };

  /// A profile of both sides is one entry.
  void add(Entry entry);
  [[nodiscard]] std::size_t count() const;
  /// Appends them, each with the name of its profile: "wheel profile worn.prw: ", "left rail
  /// profile x: ".
  void append_to(Warnings& all) const;

private:
  std::vector<Entry> entries_;
};

} // namespace wrc
