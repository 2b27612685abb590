#include "profile/slices.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "profile/reader_lines.hpp"

namespace wrc {
namespace {

using reading::Lines;
using reading::Log;

constexpr double max_slices = 4999.0;   // as in CONTACT; not a tuning constant
constexpr std::size_t most_listed = 20; // in a message; not a tuning constant

/// Lines with something on them, without comments.
class Content {
public:
  Content(std::string_view text, const Log& log) : lines_(text, log), log_(log) {}

  /// Refuses the end of the text, which lacks `what`.
  std::string_view next(const std::string& what) {
    while (lines_.next()) {
      const std::string_view line =
          reading::trimmed(lines_.text().substr(0, lines_.text().find('%')));
      if (!line.empty())
        return line;
    }
    log_.refuse("ends before " + what);
  }
  double number(std::string_view word) {
    return reading::finite_number(word, lines_.number(), log_);
  }
  /// At least `least` numbers at the begin of the next line.
  std::vector<double> numbers(std::size_t least, const std::string& what) {
    const reading::Words words = reading::words_of(next(what), " \t,");
    if (words.count < least)
      refuse(what + " expected");
    std::vector<double> values;
    for (std::size_t i = 0; i < least; ++i)
      values.push_back(number(words.word[i]));
    return values;
  }
  [[noreturn]] void refuse(const std::string& text) const { log_.refuse(lines_.number(), text); }

private:
  Lines lines_;
  const Log& log_;
};

Slice read_slice(Content& content, double offset, double scale,
                 const std::filesystem::path& folder) {
  const std::string_view line = content.next("the place and file of a slice");
  const std::size_t first = line.find_first_of("'\"");
  const std::size_t last = line.find_last_of("'\"");
  const reading::Words words = reading::words_of(line.substr(0, first), " \t,");
  if (first == std::string_view::npos || last <= first + 1 || words.count != 1)
    content.refuse(reading::quoted(line) + ", expected a position and a file in quotes");
  std::string file(line.substr(first + 1, last - first - 1));
  std::replace(file.begin(), file.end(), '\\', '/');
  return {scale * (offset + content.number(words.word[0])), folder / file};
}

} // namespace

std::vector<Slice> read_slices(std::string_view text, const std::filesystem::path& path) {
  const Log log(path.string(), false);
  Content content(text, log);
  const std::vector<double> along = content.numbers(2, "offset and scale of the places");
  const double count = content.numbers(1, "the number of slices").front();
  if (!(count >= 1.0 && count <= max_slices) || std::trunc(count) != count)
    content.refuse(text_of(count) + " slices, allowed are 1 to " + text_of(max_slices));
  content.numbers(1, "the number of features");
  content.numbers(1, "the interpolation, 1 or 2");
  std::vector<Slice> slices;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    slices.push_back(read_slice(content, along[0], along[1], path.parent_path()));
    if (i > 0 && !(slices[i].place > slices[i - 1].place))
      content.refuse("place " + text_of(slices[i].place) + " after " +
                     text_of(slices[i - 1].place) + ", places must ascend");
  }
  return slices;
}

std::string slices_text(const std::vector<Slice>& slices, ProfileKind kind) {
  std::string text = std::to_string(slices.size()) + " slices:";
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (i + 1 < slices.size() && i >= most_listed)
      continue;
    text.append(i == most_listed && i + 1 == slices.size() ? " ..., " : i > 0 ? ", " : " ");
    text.append(std::to_string(i + 1)).append(" at ").append(text_of(slices[i].place));
    text.append(kind == ProfileKind::rail ? " mm " : " rad ");
    text.append(reading::quoted(slices[i].file.filename().string()));
  }
  return text;
}

} // namespace wrc
