#include "wrc_sweep/study.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "support/checksum.hpp"
#include "support/input_file.hpp"

namespace driver {

std::int64_t Study::scene_count() const {
  std::int64_t count = 1;
  for (const Axis& axis : axes) {
    count *= static_cast<std::int64_t>(axis.values.size());
  }
  return count;
}

std::vector<std::size_t> Study::places(std::int64_t scene) const {
  std::vector<std::size_t> places(axes.size());
  auto rest = static_cast<std::size_t>(scene);
  for (std::size_t i = axes.size(); i-- > 0;) {
    places[i] = rest % axes[i].values.size();
    rest /= axes[i].values.size();
  }
  return places;
}

void Study::apply(std::int64_t index, Scene& scene) const {
  Values values = fixed;
  const std::vector<std::size_t> at = places(index);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    values.insert_or_assign(axes[i].key, axes[i].values[at[i]]);
  }
  Values last;
  for (const std::string& key : assigned) {
    last.insert(values.extract(key));
  }
  set_values(scene, values);
  set_values(scene, last);
}

int Study::axis_of(const std::string& key) const {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].key == key) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

InputFile read_input(const std::string& path) {
  constexpr std::size_t most = std::size_t{64} << 20; // of a profile file (docs/profiles.md)
  return input_of(path, read_file("input", path, most));
}

InputFile input_of(const std::string& path, std::string content) {
  InputFile input{path, std::move(content), ""};
  input.sha256 = sha256_of(path, input.content);
  return input;
}

void Study::refuse_changed_inputs() const {
  for (auto input = inputs.begin() + 1; input != inputs.end(); ++input) {
    if (read_input(input->path).sha256 != input->sha256) {
      throw Failure(input->path + " has changed since this study began, so its rows may be of two "
                                  "profiles: --restart begins again");
    }
  }
}

Values Study::constants() const {
  Scene scene;
  apply(0, scene);
  Values all = values_in_force(scene);
  for (const Axis& axis : axes) { // a key may change others: track.rail is that of both sides
    const auto other =
        std::find_if(axis.values.begin(), axis.values.end(), [&](const Value& value) {
          return text_of(value) != text_of(axis.values.front());
        });
    if (other != axis.values.end()) {
      Scene changed;
      apply(0, changed);
      set_value(changed, axis.key, *other);
      const Values values = values_in_force(changed);
      std::erase_if(all, [&](const auto& entry) {
        const auto found = values.find(entry.first);
        return found == values.end() || text_of(found->second) != text_of(entry.second);
      });
    }
    all.erase(axis.key);
  }
  for (const auto& [key, value] : fixed) {
    const auto is_of = [&](const Axis& axis) { return profile_of(axis.key) == key; };
    if (!profile_of(key).empty() || std::any_of(axes.begin(), axes.end(), is_of)) {
      all.insert_or_assign(key, value); // options of a profile, and what the varied ones are of
    }
  }
  return all;
}

std::string Study::fingerprint() const {
  std::ostringstream text; // quoted, so that no two lists give the same one
  text << wrc_version();
  for (const auto& [key, value] : fixed) {
    text << '\n' << key << " = " << std::quoted(text_of(value));
  }
  for (const Axis& axis : axes) {
    text << '\n' << axis.key << " in";
    for (const Value& value : axis.values) {
      text << ' ' << std::quoted(text_of(value));
    }
  }
  text << '\n'; // which of them count most
  for (const std::string& key : assigned) {
    text << key << ' ';
  }
  for (const auto* names : {&results, &fields}) {
    text << '\n';
    for (const std::string& one : *names) {
      text << std::quoted(one) << ' ';
    }
  }
  text << (for_page ? "\npage" : "");
  for (auto input = inputs.begin() + 1; input != inputs.end(); ++input) {
    text << '\n' << std::quoted(input->path) << ' ' << input->sha256;
  }
  return text.str();
}

} // namespace driver
