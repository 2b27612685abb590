/// Pictures by gnuplot: a script is made in memory and given to the program.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>

namespace driver {

/// A text for single quotes of a script.
std::string within_quotes(const std::string& text);
/// The same, with the letters that enhanced text takes as commands shown as they are.
std::string plain_within_quotes(const std::string& text);

class Gnuplot {
public:
  Gnuplot();
  /// The script so far; numbers are written with 9 digits.
  [[nodiscard]] std::ostringstream& script() { return script_; }
  /// Runs the script with its output in a .png or .svg file of the given size in pixels. Throws
  /// Failure if gnuplot is missing or fails, or for another extension.
  void draw(const std::filesystem::path& path, int width, int height) const;

private:
  std::ostringstream script_;
};

} // namespace driver
