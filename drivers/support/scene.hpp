/// A scene handle for the drivers: owned, and with failures as exceptions.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "wrcontact.h"

namespace driver {

/// A failure that ends the program with one line on stderr: what it quotes of a file may hold line
/// ends and other control characters, which become blanks.
class Failure : public std::runtime_error {
public:
  explicit Failure(std::string text);
};

class Scene;

/// What is kept from one scene to the next (wrc_solver).
class Solver {
public:
  Solver();
  /// Solves like Scene::solve, with what is kept.
  bool solve(Scene& scene);
  /// Bit for bit as Scene::solve, but with profiles, tables and plans of earlier scenes. Tells the
  /// status instead of throwing.
  wrc_status solve_alone(Scene& scene);

private:
  std::unique_ptr<wrc_solver, void (*)(wrc_solver*)> handle_;
};

class Scene {
public:
  Scene();

  void set(const std::string& key, double value);
  void set(const std::string& key, const std::string& value);
  void set(const std::string& key, const std::vector<double>& values);

  /// The word a key is set to.
  [[nodiscard]] std::string input_text(const std::string& key) const;
  /// Writes a scene file with all keys.
  void write(const std::string& path) const;

  /// False if the iteration has not converged; the results are usable all the same.
  bool solve();

  [[nodiscard]] bool has_number(const std::string& name) const;
  [[nodiscard]] double number(const std::string& name) const;
  /// The number, or a value to take if there is none.
  [[nodiscard]] double number_or(const std::string& name, double otherwise) const;
  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] std::vector<double> field(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> number_names() const;
  [[nodiscard]] std::vector<std::string> text_names() const;
  /// "left" and "right", as far as they were solved.
  [[nodiscard]] std::vector<std::string> sides() const;
  /// Number of entries of a list of results, for example "left.patches".
  [[nodiscard]] int count_of(const std::string& list) const;

  /// Text of the last failure.
  [[nodiscard]] std::string error() const { return wrc_scene_error(handle_.get()); }
  [[nodiscard]] wrc_scene* handle() const { return handle_.get(); }

private:
  friend class Solver;
  void check(wrc_status status) const;
  std::unique_ptr<wrc_scene, void (*)(wrc_scene*)> handle_;
};

/// What is told of a key of a scene.
struct Key {
  std::string name;
  std::string default_value;
  std::string allowed;
  std::string meaning;
};
std::vector<Key> scene_keys();

} // namespace driver
