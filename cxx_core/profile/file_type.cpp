#include "profile/file_type.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/lower_case.hpp"

namespace wrc {
namespace {

struct Extension {
  std::string_view name;
  FileType type;
};

constexpr std::array<Extension, 8> extensions{
    {{".prr", {ProfileFormat::simpack, ProfileKind::rail}},
     {".prw", {ProfileFormat::simpack, ProfileKind::wheel}},
     {".ban", {ProfileFormat::miniprof, ProfileKind::rail}},
     {".whl", {ProfileFormat::miniprof, ProfileKind::wheel}},
     {".slcs", {ProfileFormat::slices, ProfileKind::rail}},
     {".slcw", {ProfileFormat::slices, ProfileKind::wheel}},
     {".rail", {ProfileFormat::columns, ProfileKind::rail}},
     {".wheel", {ProfileFormat::columns, ProfileKind::wheel}}}};

} // namespace

FileType type_of(const std::filesystem::path& path) {
  const std::string name = lower_case(path.extension().string());
  const auto* const found = std::find_if(extensions.begin(), extensions.end(),
                                         [&](const Extension& each) { return each.name == name; });
  return found == extensions.end() ? FileType{} : found->type;
}

} // namespace wrc
