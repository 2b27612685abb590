/// Pictures by gnuplot: a script is made in memory and given to the program.
#pragma once

#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace driver {

/// Throws Failure if gnuplot cannot be run.
void require_gnuplot();
/// Throws Failure unless the file ends in .png or .svg.
void require_picture_name(const std::filesystem::path& path);

/// Whether _ and ^ make subscripts and superscripts, of one letter or of a group in braces.
enum class Markup { none, subscripts };

/// A text as a string of a script, with its quotes. Every text that is not part of the source of
/// a program goes through here. It cannot end its string or its line, so gnuplot runs nothing in it
/// and replaces nothing: single quotes become apostrophes (doubled ones, gnuplot's way to write
/// them, end the string where they stand first or side by side), control characters become blanks,
/// bytes that are not UTF-8 a replacement character, and texts of more than some lines are cut. The
/// letters that gnuplot takes as markup are drawn, except for subscripts and superscripts if asked
/// for and if the braces match.
std::string gnuplot_text(const std::string& text, Markup markup = Markup::none);
/// A text to be inserted into one with markup, where it is to be drawn letter by letter.
std::string without_markup(const std::string& text);

/// Colours of `count` lines in a picture: up to six that colour-blind readers can distinguish, more
/// along the rainbow.
std::string line_colour(std::size_t index, std::size_t count = 1);
/// Colours that most pictures need. python_bindings/wrcontact/plot.py has the same.
namespace colour {
inline constexpr const char* rail = "#8b5a2b";
inline constexpr const char* wheel = "#1f4e9e";
inline constexpr const char* marked = "#c00000"; ///< what the reader is to look at
inline constexpr const char* quiet = "#909090";  ///< what others are compared with
inline constexpr const char* contour = "#404040";
inline constexpr const char* arrow = "#303030";
inline constexpr const char* note = "#606060"; ///< texts beside the drawing
inline constexpr const char* rail_body = "#f3ebe3";
inline constexpr const char* wheel_body = "#e9eff8";
inline constexpr const char* adhesion = "#cfe2f3";
inline constexpr const char* slip = "#f6c7b6";
inline constexpr const char* band = "#a8c8e8"; ///< between two ends
} // namespace colour
/// Red, green and blue of a colour, 0 to 255, with blanks between.
std::string components_of(const std::string& colour);
/// Axes and grid as all pictures have them.
extern const char* const axes_style;
/// The same with the legend of lines.
std::string line_style(std::size_t lines);
/// Pixels beside the lines for a legend of more than six; 0 for fewer, whose legend is above.
int legend_width(std::size_t lines);
/// Colours of areas, from none to the largest: each is darker than those before.
extern const char* const map_palette;

/// Commands that make the block "..._contours" of a block of data over a grid: lines at the edge of
/// what is above 0, and at fifths of the largest value.
std::string contour_lines(const std::string& block, double largest);

/// From the least to the greatest value taken in.
class Range {
public:
  /// NaN is left out.
  void include(double value);
  void include(const Range& other);
  [[nodiscard]] bool empty() const { return least > greatest; }
  [[nodiscard]] double middle() const { return 0.5 * (least + greatest); }
  [[nodiscard]] double length() const { return greatest - least; }
  /// For example "set yrange [0:1]\n", with some room; also for equal values, and for none.
  [[nodiscard]] std::string command(const std::string& axis) const;

  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

/// The range of a scale: of all values, but without those far beyond nine tenths of them, such as
/// pressures of a flange that would leave those of the tread without colours or height.
Range range_of_most(std::vector<double> values);

class Gnuplot {
public:
  Gnuplot();
  /// The script so far; numbers are written with 9 digits.
  [[nodiscard]] std::ostringstream& script() { return script_; }

  /// Begins a picture of several plots: its layout, and a title with room below it, if any, in
  /// which _ and ^ are markup.
  void begin_multiplot(std::size_t rows, std::size_t columns, const std::string& title = "");
  /// Adds a block of data, whose name it returns.
  std::string block(const std::string& data);
  /// The same of points.
  std::string block(const std::vector<double>& x, const std::vector<double>& y);
  /// Draws items such as "$data1 with lines"; an empty plot if there is none.
  void plot(const std::vector<std::string>& items);

  /// Runs the script with its output in a .png or .svg file of the given size in pixels; gnuplot is
  /// not given its name, which it might take for a command. Throws Failure if gnuplot is missing or
  /// fails, or for another extension.
  void draw(const std::filesystem::path& path, int width, int height) const;

private:
  std::ostringstream script_;
  int blocks_ = 0;
  bool multiplot_ = false;
};

} // namespace driver
