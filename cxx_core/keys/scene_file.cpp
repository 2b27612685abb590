#include "keys/scene_file.hpp"

#include <algorithm>
#include <cstdint>

#include "base/error.hpp"
#include "base/file.hpp"
#include "keys/profile_text.hpp"
#include "keys/scene_keys.hpp"
#include "measured/readers.hpp"
#include "profile/writers.hpp"

namespace wrc {
namespace {

namespace fs = std::filesystem;

/// A TOML basic string.
std::string quoted(const std::string& text) {
  constexpr const char* hexadecimal = "0123456789ABCDEF";
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else if (code < 0x20 || code == 0x7F) {
      result += {'\\', 'u', '0', '0', hexadecimal[code / 16], hexadecimal[code % 16]};
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string toml_of(double value) {
  const std::string text = text_of(value);
  const bool is_float = text.find_first_of(".e") != std::string::npos;
  return is_float ? text : text + ".0";
}

std::string toml_of(const std::vector<double>& values) {
  std::string text = "[";
  for (const double value : values) {
    text += (text.size() > 1 ? ", " : "") + toml_of(value);
  }
  return text + ']';
}

bool is_built_in(const std::string& name, ProfileKind kind) {
  return !standard_name(name, kind).empty();
}

/// The name under which a profile is found again from anywhere.
std::string lasting_name(const std::string& name, ProfileKind kind) {
  return is_built_in(name, kind) ? name : fs::absolute(name).string();
}

/// Of points of a wheel given by the program.
const ProfilePlacement as_they_are{WheelOrigin::tape, {}, 0.0, {}};

/// Writes the points of a profile given by the program; returns the file's name.
std::string write_beside(const Profile& profile, const std::string& side,
                         const fs::path& scene_path, const Scene& scene) {
  const bool wheel = profile.kind == ProfileKind::wheel;
  fs::path path = scene_path;
  path.replace_extension(side + (wheel ? ".wheel.txt" : ".rail.txt"));
  write_points(profile, path);
  ReadOptions options;
  options.smoothing_wavelength = 0.0;
  options.kind = profile.kind;
  if (wheel) {
    static_cast<ProfilePlacement&>(options) = as_they_are;
    options.tape_offset = scene.tape_offset;
  }
  if (read_profile(path, options).profile.points != profile.points) {
    throw_invalid_argument(wheel ? "wheelset.wheel" : "track.rail", '"' + profile.name + '"',
                           "its points would not read back unchanged: give it as a file");
  }
  return path.filename().string();
}

/// Whether the text of a profile is read as this one: a name may look like options.
bool reads_back(const ProfileChoice& written, const ProfileKey& key) {
  ProfileChoice read = written;
  try {
    set_profile_text(read, profile_text(written, {}), key, {});
  } catch (const Error&) {
    return false;
  }
  return read == written;
}

} // namespace

std::string scene_text(const Scene& scene) {
  Scene in_mm = scene;
  in_mm.convention = {};
  std::string text;
  std::string table;
  for (const KeyDescription& key : scene_keys()) {
    const KeyValue value = key_value(in_mm, key.name);
    if (std::holds_alternative<std::monostate>(value)) {
      continue; // the keys of its two parts hold it
    }
    const std::size_t dot = key.name.rfind('.');
    if (key.name.substr(0, dot) != table) {
      table = key.name.substr(0, dot);
      text += "\n[" + table + "]\n";
    }
    text += std::string(key.name.substr(dot + 1)) + " = ";
    if (const auto* number = std::get_if<double>(&value)) {
      text += toml_of(*number);
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
      text += toml_of(*numbers);
    } else {
      text += quoted(std::get<std::string>(value));
    }
    text += '\n';
  }
  return text;
}

void write_scene(const Scene& scene, const fs::path& path) {
  Scene lasting = scene;
  const auto lasting_choice = [&](const ProfileChoice& choice, ProfileKind kind,
                                  const std::string& side) {
    ProfileChoice written = choice;
    if (choice.given) {
      written.name = write_beside(*choice.given, side, path, lasting);
      written.given = nullptr;
      written.options.smoothing = 0.0;
      if (kind == ProfileKind::wheel) {
        written.options.placement = as_they_are;
      }
    } else {
      written.name = lasting_name(choice.name, kind);
      if (std::string& nominal = written.options.placement.align_to; !nominal.empty()) {
        nominal = lasting_name(nominal, kind);
      }
    }
    const ProfileKey key{kind == ProfileKind::wheel ? "wheelset.wheel" : "track.rail", kind};
    if (!reads_back(written, key)) {
      throw_invalid_argument(std::string(key.name) + ".file", '"' + written.name + '"',
                             "must be another name to be written in a scene file: it looks like a "
                             "profile with options");
    }
    return written;
  };
  const auto make_lasting = [&](ProfileChoice& left, ProfileChoice& right, ProfileKind kind) {
    const bool same = left == right;
    left = lasting_choice(left, kind, same ? "" : ".left");
    right = same ? left : lasting_choice(right, kind, ".right");
  };
  make_lasting(lasting.left.wheel, lasting.right.wheel, ProfileKind::wheel);
  make_lasting(lasting.left.rail, lasting.right.rail, ProfileKind::rail);
  write_file(path, "# A scene of wrcontact, written by the library; mm, N, MPa, rad.\n" +
                       scene_text(lasting));
}

} // namespace wrc
