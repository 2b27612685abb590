#include "support/gnuplot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/scene.hpp"

namespace driver {

namespace {

/// Whether a picture has its end: gnuplot does not always tell that the disk is full.
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

} // namespace

std::string within_quotes(const std::string& text) {
  std::string out; // gnuplot doubles a quote within quotes
  for (const char letter : text) {
    out += letter == '\'' ? "''" : std::string(1, letter);
  }
  return out;
}

std::string plain_within_quotes(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (std::string_view("_^{}@&~\\").find(letter) != std::string_view::npos) {
      escaped += '\\';
    }
    escaped += letter;
  }
  return within_quotes(escaped);
}

const char* line_colour(std::size_t index) {
  constexpr std::array colours{"#0060ad", "#d55e00", "#009e73", "#7030a0", "#a08000", "#404040"};
  return colours[index % colours.size()];
}

const char* const pressure_palette =
    "set palette defined (0 '#e8f0ff', 0.25 '#6fa8dc', 0.5 '#3d85c6', 0.7 '#f1c232', 0.85 "
    "'#e69138', 1 '#990000')\n";

void Range::include(double value) {
  if (!std::isnan(value)) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
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

Gnuplot::Gnuplot() {
  script_.precision(9);
}

void Gnuplot::begin_multiplot(std::size_t rows, std::size_t columns, const std::string& title) {
  multiplot_ = true;
  script_ << "set multiplot layout " << rows << ',' << columns;
  if (!title.empty()) {
    std::string quoted; // double quotes, since the line below the title is empty but not nothing
    for (const char letter : title) {
      quoted += (letter == '"' || letter == '\\' ? "\\" : "") + std::string(1, letter);
    }
    script_ << " title \"" << quoted << "\\n \" font ',12'";
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

void Gnuplot::draw(const std::filesystem::path& path, int width, int height) const {
  const std::string extension = path.extension().string();
  std::string terminal;
  if (extension == ".png") {
    terminal = "pngcairo";
  } else if (extension == ".svg") {
    terminal = "svg";
  } else {
    throw Failure("--plot " + path.string() + ": allowed are files that end in .png or .svg");
  }
  OutputFile file(path);
  std::ostringstream whole;
  whole << "set terminal " << terminal << " size " << width << ',' << height
        << " enhanced font 'DejaVu Sans,10' background rgb 'white'\n"
        << "set output '" << within_quotes(file.aside().string()) << "'\n"
        << script_.str() << (multiplot_ ? "\nunset multiplot" : "") << "\nunset output\n";
  // A gnuplot that is missing or fails closes the pipe: that is told below, not by a signal.
  std::signal(SIGPIPE, SIG_IGN);
  FILE* pipe = popen("gnuplot -", "w");
  const std::string text = whole.str();
  const bool written =
      pipe != nullptr && std::fwrite(text.data(), 1, text.size(), pipe) == text.size();
  const int status = pipe == nullptr ? -1 : pclose(pipe);
  if (!written || status != 0) {
    throw Failure("--plot " + path.string() +
                  ": gnuplot failed; is it installed (Debian package gnuplot-nox)?");
  }
  if (!is_whole(file.aside(), extension)) {
    throw Failure("--plot " + path.string() + ": cannot be written completely: is the disk full?");
  }
  file.commit();
}

} // namespace driver
