#include "scene/profile_warnings.hpp"

#include <algorithm>
#include <utility>

namespace wrc {
namespace {

std::string lead_in(const ProfileWarnings::Entry& entry) {
  const char* const side = entry.side == SideChoice::left    ? "left "
                           : entry.side == SideChoice::right ? "right "
                                                             : "";
  const char* const kind = entry.kind == ProfileKind::wheel ? "wheel" : "rail";
  return std::string(side) + kind + " profile " + entry.name + ": ";
}

} // namespace

void ProfileWarnings::add(Entry entry) {
  const auto same = std::find_if(entries_.begin(), entries_.end(), [&entry](const Entry& other) {
    return other.kind == entry.kind && other.name == entry.name &&
           (other.warnings == entry.warnings || *other.warnings == *entry.warnings);
  });
  if (same == entries_.end()) {
    entries_.push_back(std::move(entry));
  } else if (same->side != entry.side) {
    same->side = SideChoice::both;
  }
}

std::size_t ProfileWarnings::count() const {
  std::size_t count = 0;
  for (const Entry& entry : entries_) {
    count += entry.warnings->size();
  }
  return count;
}

void ProfileWarnings::append_to(Warnings& all) const {
  for (const Entry& entry : entries_) {
    for (const Warning& warning : *entry.warnings) {
      all.push_back({warning.kind, lead_in(entry) + warning.text});
    }
  }
}

} // namespace wrc
