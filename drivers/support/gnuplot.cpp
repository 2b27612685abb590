#include "support/gnuplot.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string_view>

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

Gnuplot::Gnuplot() {
  script_.precision(9);
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
        << script_.str() << "\nunset output\n";
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
    throw Failure("--plot " + path.string() + ": cannot be written whole: is the disk full?");
  }
  file.commit();
}

} // namespace driver
