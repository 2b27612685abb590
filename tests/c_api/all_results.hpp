/// All results of scenes, read through the interface and compared bit for bit.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "owned_handles.hpp"

using SolverPointer = std::unique_ptr<wrc_solver, void (*)(wrc_solver*)>;

inline SolverPointer make_solver() {
  wrc_solver* solver = nullptr;
  EXPECT_EQ(wrc_solver_create(&solver), WRC_OK);
  return {solver, wrc_solver_destroy};
}

inline std::vector<double> field_of(wrc_scene* scene, const std::string& name) {
  std::int64_t count = 0;
  if (wrc_scene_field(scene, name.c_str(), nullptr, 0, &count) != WRC_OK) {
    return {}; // a side that was not solved
  }
  std::vector<double> values(static_cast<std::size_t>(count));
  if (count > 0) {
    EXPECT_EQ(wrc_scene_field(scene, name.c_str(), values.data(), count, &count), WRC_OK) << name;
  }
  return values;
}

/// What one scene came to. Numbers are kept as their bits; times are left out.
struct AllResults {
  std::map<std::string, std::uint64_t> numbers;
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<double>> fields;

  explicit AllResults(wrc_scene* scene) {
    for (std::int64_t i = 0; i < wrc_scene_number_count(scene); ++i) {
      const std::string name = wrc_scene_number_name(scene, i);
      if (!name.starts_with("time_ms.")) {
        numbers[name] = std::bit_cast<std::uint64_t>(number_of(scene, name.c_str()));
      }
    }
    for (std::int64_t i = 0; i < wrc_scene_text_count(scene); ++i) {
      const std::string name = wrc_scene_text_name(scene, i);
      const char* value = nullptr;
      EXPECT_EQ(wrc_scene_text(scene, name.c_str(), &value), WRC_OK) << name;
      texts[name] = value;
    }
    for (const char* side : {"left", "right"}) {
      for (const char* field : {".undeformed_distance", ".pressure"}) {
        fields[std::string(side) + field] = field_of(scene, std::string(side) + field);
      }
    }
  }

  bool operator==(const AllResults&) const = default;

  /// Name of the first result that differs; empty if none does.
  [[nodiscard]] std::string difference_to(const AllResults& other) const {
    std::string name = first_difference(numbers, other.numbers);
    name = name.empty() ? first_difference(texts, other.texts) : name;
    return name.empty() ? first_difference(fields, other.fields) : name;
  }

private:
  template <class Map> static std::string first_difference(const Map& one, const Map& other) {
    for (const auto& [name, value] : one) {
      const auto found = other.find(name);
      if (found == other.end() || found->second != value) {
        return name;
      }
    }
    return one.size() == other.size() ? "" : "a result that only the other has";
  }
};

/// Both scenes have the same results, but for times.
inline void expect_same_bits(wrc_scene* one, wrc_scene* other, const std::string& where) {
  EXPECT_EQ(AllResults(one).difference_to(AllResults(other)), "") << where;
}

/// Scenes that differ in everything that is kept between two of them.
inline ScenePointer make_varied_scene(int index) {
  constexpr std::array<std::pair<const char*, const char*>, 3> pairs{
      {{"S1002", "60E1"}, {"LMA", "CHN60"}, {"S1002", "54E1"}}};
  const auto pair = pairs[static_cast<std::size_t>(index) % pairs.size()];
  ScenePointer scene = make_scene();
  wrc_scene* s = scene.get();
  set(s, {{"wheelset.wheel", pair.first},
          {"track.rail", pair.second},
          {"pose.lateral", 0.7 * (index % 9) - 2.5},
          {"pose.yaw", 1e-3 * (index % 4)},
          {"load.both", 20e3 * (1 + index % 5)},
          {"solve.accuracy", 1e-2},
          {"solve.threads", index % 8 == 0 ? 2.0 : 1.0}});
  if (index % 2 == 1) {
    const std::array grid{20.0 + index % 7, 30.0 - index % 5};
    EXPECT_EQ(wrc_scene_set_numbers(s, "solve.grid", grid.data(), 2), WRC_OK);
  }
  return scene;
}
