#include "support/gnuplot.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

#include "support/child_process.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/scene.hpp"

namespace driver {

namespace {

/// Whether a picture has its end: gnuplot does not always report a full disk.
bool is_whole(const std::filesystem::path& path, const std::string& extension) {
  using namespace std::string_literals;
  const std::string end = extension == ".png" ? "IEND\xAE\x42\x60\x82"s : "</svg>"s;
  constexpr std::streamoff most = 64;
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max(size - most, std::streamoff{0}));
  const std::string last{std::istreambuf_iterator<char>(stream), {}};
  return stream && last.find(end) != std::string::npos;
}

/// Has a script drawn, into an existing file if one is given. Returns what went wrong.
std::string run_gnuplot(const std::string& script, const std::filesystem::path& output = {}) {
  const int file = memfd_create("gnuplot", MFD_CLOEXEC);
  if (file < 0) {
    return std::string("no room for its script: ") + std::strerror(errno);
  }
  for (std::size_t done = 0; done < script.size();) {
    const ssize_t count = write(file, script.data() + done, script.size() - done);
    if (count <= 0) {
      close(file);
      return std::string("no room for its script: ") + is_disk_full;
    }
    done += static_cast<std::size_t>(count);
  }
  std::string text;
  try {
    text = in_own_process([&](int messages) {
      const int picture =
          output.empty() ? STDOUT_FILENO : open(output.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
      if (picture < 0) {
        throw Failure("cannot write " + output.string() + ": " + std::strerror(errno));
      }
      lseek(file, 0, SEEK_SET);
      dup2(picture, STDOUT_FILENO);
      dup2(file, STDIN_FILENO);
      dup2(messages, STDERR_FILENO);
      execlp("gnuplot", "gnuplot", "-", static_cast<char*>(nullptr));
      throw Failure(errno == ENOENT ? "is not installed (Debian package gnuplot-nox)"
                                    : std::string("cannot be started: ") + std::strerror(errno));
    });
  } catch (const Failure& failure) {
    text = failure.what();
  }
  close(file);
  return text.empty() ? text : "gnuplot: " + text;
}

constexpr std::string_view letters_of_markup = "_^{}@&~\\";

/// The letter that begins at a byte, as it is drawn; moves on to the byte behind it.
std::string_view next_letter(std::string_view text, std::size_t& at) {
  constexpr std::string_view no_letter = "\uFFFD";
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t begin = at++;
  const unsigned first = byte(begin);
  const std::size_t more = first < 0x80U                      ? 0
                           : first >= 0xC2U && first <= 0xDFU ? 1
                           : (first & 0xF0U) == 0xE0U         ? 2
                           : first >= 0xF0U && first <= 0xF4U ? 3
                                                              : text.size();
  unsigned code = more == 0 ? first : first & (0x3FU >> more);
  if (begin + more >= text.size()) {
    return no_letter;
  }
  for (std::size_t i = begin + 1; i <= begin + more; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) {
      return no_letter;
    }
    code = code << 6U | (byte(i) & 0x3FU);
  }
  const bool is_too_long = (more == 2 && code < 0x800U) || (more == 3 && code < 0x10000U);
  const bool is_half = code >= 0xD800U && code <= 0xDFFFU; // of a pair in UTF-16
  if (is_too_long || is_half || code > 0x10FFFFU || (code & 0xFFFEU) == 0xFFFEU) {
    return no_letter;
  }
  at += more;
  if (code < 0x20U || (code >= 0x7FU && code < 0xA0U) || code == 0x2028U || code == 0x2029U) {
    return " "; // would end a line, or is for a terminal
  }
  return code == '\'' ? "\u2019" : text.substr(begin, more + 1);
}

/// The letters of a text that can be drawn, in UTF-8.
std::string printable(std::string_view text) {
  constexpr int most = 400; // letters: some lines of the widest picture
  std::string out;
  int count = 0;
  for (std::size_t at = 0; at < text.size(); ++count) {
    if (count == most) {
      return out + "\u2026";
    }
    out += next_letter(text, at);
  }
  return out;
}

/// With the letters that gnuplot takes as markup drawn.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    if (letters_of_markup.find(letter) != std::string_view::npos) {
      out += '\\';
    }
    out += letter;
  }
  return out;
}

/// With subscripts, superscripts and groups; a backslash in front of a letter of markup draws it.
/// Other markup of gnuplot is drawn as text: it writes the names of fonts into SVG unescaped.
std::string with_subscripts(std::string_view text) {
  std::string out;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    const bool is_escape = letter == '\\' && i + 1 < text.size() &&
                           letters_of_markup.find(text[i + 1]) != std::string_view::npos;
    if (is_escape) {
      out += letter;
      out += text[++i];
    } else if (std::string_view("@&~\\").find(letter) != std::string_view::npos) {
      out += '\\';
      out += letter;
    } else {
      out += letter == '/' && out.ends_with('{') ? "\\/" : std::string(1, letter);
      depth += letter == '{' ? 1 : letter == '}' ? -1 : 0;
    }
    if (depth < 0) {
      break;
    }
  }
  return depth == 0 ? out : escaped(text);
}

} // namespace

void require_gnuplot() {
  const std::string trouble = run_gnuplot("exit\n");
  if (!trouble.empty()) {
    throw Failure("no picture can be drawn: " + trouble);
  }
}

std::string gnuplot_text(const std::string& text, Markup markup) {
  const std::string shown = printable(text);
  return '\'' + (markup == Markup::subscripts ? with_subscripts(shown) : escaped(shown)) + '\'';
}

std::string without_markup(const std::string& text) {
  return escaped(text);
}

std::string line_colour(std::size_t index, std::size_t count) {
  constexpr std::array colours{"#0060ad", "#d55e00", "#009e73", "#7030a0", "#a08000", "#404040"};
  if (count <= colours.size()) {
    return colours[index % colours.size()];
  }
  // Hues from blue through green to red, dark enough for lines; every other one darker.
  constexpr double blue = 240.0;
  const double share = static_cast<double>(index) / static_cast<double>(count - 1);
  const double hue = blue * (1.0 - share) / 60.0;
  const double value = index % 2 == 0 ? 0.85 : 0.6;
  std::ostringstream text;
  text << '#' << std::hex << std::setfill('0');
  for (const double of : {5.0, 3.0, 1.0}) { // red, green, blue of a colour wheel
    const double k = std::fmod(of + hue, 6.0);
    const double part = value * (1.0 - std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
    text << std::setw(2) << std::lround(255.0 * part);
  }
  return text.str();
}

std::string components_of(const std::string& colour) {
  constexpr int hexadecimal = 16;
  std::string text;
  for (const std::size_t at : {1U, 3U, 5U}) {
    text += (text.empty() ? "" : " ") +
            std::to_string(std::stoi(colour.substr(at, 2), nullptr, hexadecimal));
  }
  return text;
}

int legend_width(std::size_t lines) {
  constexpr std::size_t most_above = 6;
  constexpr int beside = 240;
  return lines > most_above ? beside : 0;
}

const char* const axes_style = "set grid back lt 1 lw 1 lc rgb '#d8d8d8'\nset tics out "
                               "nomirror\nset border lc rgb '#404040'\n";

std::string line_style(std::size_t lines) {
  return std::string(axes_style) + "set lmargin 13\n" +
         (legend_width(lines) > 0 ? "set key outside right top vertical\n"
                                  : "set rmargin 3\nset key outside top center horizontal\n");
}

const char* const map_palette =
    "set palette defined (0 '#fdf3c8', 0.25 '#fcc75a', 0.5 '#f28934', 0.75 '#cc3d3d', 1 "
    "'#6b1446')\n";

std::string contour_lines(const std::string& block, double largest) {
  constexpr double edge = 0.05;
  std::string levels = text_of(edge * largest);
  for (const double share : {0.2, 0.4, 0.6, 0.8}) {
    levels += ',' + text_of(share * largest);
  }
  return "set contour base\nunset surface\nset cntrparam levels discrete " + levels +
         "\nset table " + block + "_contours\nsplot " + block +
         " using 1:2:3 with lines\nunset table\nunset contour\nset surface\n";
}

void Range::include(double value) {
  if (!std::isnan(value)) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
}

void Range::include(const Range& other) {
  least = std::min(least, other.least);
  greatest = std::max(greatest, other.greatest);
}

std::string Range::command(const std::string& axis) const {
  constexpr double room = 0.05;
  constexpr double rounding = 1e-9;
  const double from = empty() ? 0.0 : least;
  const double to = empty() ? 0.0 : greatest;
  const double size = std::max(std::abs(from), std::abs(to));
  const double beyond = to - from > rounding * size ? room * (to - from)
                        : size > 0.0                ? room * size
                                                    : 1.0;
  return "set " + axis + "range [" + text_of(from - beyond) + ':' + text_of(to + beyond) + "]\n";
}

Range range_of_most(std::vector<double> values) {
  constexpr std::size_t fewest = 10; // of which any may be what matters
  constexpr double share = 0.9;      // of the values, on each side
  constexpr double far = 1.5;        // in ranges of these
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::sort(values.begin(), values.end());
  Range all;
  Range most;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double rank = (static_cast<double>(i) + 0.5) / static_cast<double>(values.size());
    all.include(values[i]);
    if (std::abs(rank - 0.5) <= share - 0.5) {
      most.include(values[i]);
    }
  }
  if (values.size() < fewest || most.length() <= 0.0) {
    return all;
  }
  Range shown = most;
  for (const double value : values) {
    if (value >= most.least - far * most.length() && value <= most.greatest + far * most.length()) {
      shown.include(value);
    }
  }
  constexpr double worth_it = 2.0; // times the range
  return all.length() > worth_it * shown.length() ? shown : all;
}

Gnuplot::Gnuplot() {
  script_.precision(9);
}

void Gnuplot::begin_multiplot(std::size_t rows, std::size_t columns, const std::string& title) {
  multiplot_ = true;
  script_ << "set multiplot layout " << rows << ',' << columns;
  if (!title.empty()) { // the line below it is empty but not nothing
    script_ << " title (" << gnuplot_text(title, Markup::subscripts) << ".\"\\n \")";
  }
  script_ << '\n';
}

std::string Gnuplot::block(const std::string& data) {
  const std::string name = "$data" + std::to_string(++blocks_);
  script_ << name << " << EOD\n" << data << "EOD\n";
  return name;
}

std::string Gnuplot::block(const std::vector<double>& x, const std::vector<double>& y) {
  std::ostringstream data;
  data.precision(script_.precision());
  for (std::size_t i = 0; i < x.size(); ++i) {
    data << x[i] << ' ' << y[i] << '\n';
  }
  return block(data.str());
}

void Gnuplot::plot(const std::vector<std::string>& items) {
  const char* separator = "plot ";
  for (const std::string& item : items) {
    script_ << std::exchange(separator, ", ") << item;
  }
  script_ << (items.empty() ? "plot NaN notitle\n" : "\n");
}

void require_picture_name(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension != ".png" && extension != ".svg") {
    throw Failure("--plot " + path.string() + ": must be a file that ends in .png or .svg");
  }
}

void Gnuplot::draw(const std::filesystem::path& path, int width, int height) const {
  require_picture_name(path);
  const std::string extension = path.extension().string();
  const std::string terminal = extension == ".png" ? "pngcairo" : "svg";
  OutputFile file(path);
  std::ostringstream whole;
  whole << "set terminal " << terminal << " size " << width << ',' << height
        << " enhanced font 'DejaVu Sans,10' background rgb 'white'\nset encoding utf8\n";
  constexpr std::size_t own_colours = 8; // that gnuplot has
  for (std::size_t i = 0; i < own_colours; ++i) {
    whole << "set linetype " << i + 1 << " lc rgb '" << line_colour(i) << "'\n";
  }
  whole << axes_style << script_.str() << (multiplot_ ? "\nunset multiplot" : "")
        << "\nunset output\n";
  const std::string trouble = run_gnuplot(whole.str(), file.aside());
  if (!trouble.empty()) {
    throw Failure("--plot " + path.string() + ": " + trouble);
  }
  if (!is_whole(file.aside(), extension)) {
    throw Failure("--plot " + path.string() + ": cannot be written completely: " + is_disk_full);
  }
  file.commit();
}

} // namespace driver
