#include "measured/slices.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "measured/constants.hpp"
#include "measured/read_options.hpp"
#include "measured/reader_lines.hpp"
#include "profile/limits.hpp"

namespace wrc {
namespace {

using reading::Lines;
using reading::Log;

constexpr double max_slices = SliceLimits::max_slices;
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
      if (!line.empty()) {
        return line;
      }
    }
    log_.refuse("ends before " + what);
  }
  /// Refuses lines after the last one, `what` with which the list ends.
  void refuse_rest(const std::string& what) {
    while (lines_.next()) {
      const std::string_view line =
          reading::trimmed(lines_.text().substr(0, lines_.text().find('%')));
      if (!line.empty()) {
        refuse(reading::quoted(line) + " after " + what);
      }
    }
  }
  [[nodiscard]] std::size_t line_number() const { return lines_.number(); }
  double number(std::string_view word) {
    return reading::finite_number(word, lines_.number(), log_);
  }
  /// At least `least` numbers at the begin of the next line.
  std::vector<double> numbers(std::size_t least, const std::string& what) {
    const reading::Words words = reading::words_of(next(what), " \t,");
    if (words.count < least) {
      refuse(what + " expected");
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < least; ++i) {
      values.push_back(number(words.word[i]));
    }
    return values;
  }
  /// All numbers of the next line, at least one; words that are none end them.
  std::vector<double> all_numbers(const std::string& what) {
    std::string_view rest = next(what);
    std::vector<double> values; // bounded by the length of a line
    for (constexpr std::string_view blanks = " \t,"; !rest.empty();) {
      const std::size_t end = std::min(rest.find_first_of(blanks), rest.size());
      const std::optional<double> value = reading::number_of(rest.substr(0, end));
      if (!value && values.empty()) {
        refuse(what + " expected");
      }
      if (!value) {
        break;
      }
      values.push_back(number(rest.substr(0, end)));
      rest = rest.substr(end);
      rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    }
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
  if (first == std::string_view::npos || last <= first + 1 || words.count != 1) {
    content.refuse(reading::quoted(line) + ", expected a position and a file in quotes");
  }
  std::string file(line.substr(first + 1, last - first - 1));
  std::replace(file.begin(), file.end(), '\\', '/');
  return {scale * (offset + content.number(words.word[0])), folder / file};
}

/// Numbers at the head of the list.
struct Head {
  std::size_t features = 0;
  bool has_kinks = false; ///< or accelerations
  bool is_smoothed = false;
  std::size_t line_of_count = 0; ///< of slices
};

Head read_features_and_interpolation(Content& content) {
  const std::vector<double> counts = content.all_numbers("the number of features");
  Head head;
  if (!(counts[0] >= 0.0 && counts[0] <= SliceLimits::max_features) ||
      std::trunc(counts[0]) != counts[0]) {
    content.refuse(text_of(counts[0]) + " features, must be between 0 and " +
                   std::to_string(SliceLimits::max_features));
  }
  head.features = static_cast<std::size_t>(counts[0]);
  head.has_kinks = std::any_of(
      counts.begin() + 1,
      counts.begin() + std::min<std::ptrdiff_t>(3, static_cast<std::ptrdiff_t>(counts.size())),
      [](double count) { return count != 0.0; });
  const double interpolation = content.numbers(1, "the interpolation, 1 or 2").front();
  if (interpolation != 1.0 && interpolation != 2.0) {
    content.refuse("interpolation " + text_of(interpolation) + ", must be 1 or 2");
  }
  head.is_smoothed = interpolation == 2.0;
  return head;
}

/// The features of a slice, whose place in the file's unit the line repeats.
void read_features(Content& content, std::size_t count, double offset, double scale,
                   std::size_t number, Slice& slice) {
  const std::string name = "slice " + std::to_string(number);
  const std::vector<double> values = content.all_numbers("the features of " + name);
  if (values.size() != count + 1) {
    content.refuse(std::to_string(values.size()) + " numbers, " + name + " has its place and " +
                   std::to_string(count) + " features");
  }
  const double place = scale * (offset + values[0]);
  if (std::abs(place - slice.place) > place_rounding * std::max(1.0, std::abs(slice.place))) {
    content.refuse("features at " + text_of(place) + ", " + name + " is at " +
                   text_of(slice.place));
  }
  double last = -1.0;
  for (std::size_t i = 1; i <= count; ++i) {
    if (values[i] == -1.0) {
      slice.features.emplace_back();
      continue;
    }
    if (!(values[i] >= 0.0 && values[i] > last)) {
      content.refuse("feature " + std::to_string(i) + " of " + name + " at " + text_of(values[i]) +
                     " mm, features must ascend from 0, or be -1 for one that is absent");
    }
    last = values[i];
    slice.features.emplace_back(values[i]);
  }
}

/// The list without features, and what its head says of them.
SliceList read_list(Content& content, const std::filesystem::path& path, Head& head,
                    std::vector<double>& along) {
  along = content.numbers(2, "offset and scale of the places");
  const double count = content.numbers(1, "the number of slices").front();
  if (!(count >= 1.0 && count <= max_slices) || std::trunc(count) != count) {
    content.refuse(text_of(count) + " slices, must be between 1 and " + text_of(max_slices));
  }
  const std::size_t line_of_count = content.line_number();
  head = read_features_and_interpolation(content);
  head.line_of_count = line_of_count;
  SliceList list;
  list.is_smoothed = head.is_smoothed;
  std::vector<Slice>& slices = list.slices;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    slices.push_back(read_slice(content, along[0], along[1], path.parent_path()));
    if (i > 0 && !(slices[i].place > slices[i - 1].place)) {
      content.refuse("place " + text_of(slices[i].place) + " after " +
                     text_of(slices[i - 1].place) + ", places must ascend");
    }
    if (!(std::abs(slices[i].place) <= SliceLimits::max_place)) {
      content.refuse("place " + text_of(slices[i].place) + ", must be between -" +
                     text_of(SliceLimits::max_place) + " and " + text_of(SliceLimits::max_place));
    }
  }
  return list;
}

/// The list ends with its last slice, or with the features of that.
void refuse_rest(Content& content, const SliceList& list, const Head& head) {
  const std::string count = std::to_string(list.slices.size());
  content.refuse_rest((head.features < 2 ? "slice " : "the features of slice ") + count +
                      ", the last of " + count + " that line " +
                      std::to_string(head.line_of_count) + " states");
}

} // namespace

std::vector<Slice> read_slices(std::string_view text, const std::filesystem::path& path) {
  const Log log(path.string(), false);
  Content content(text, log);
  Head head;
  std::vector<double> along;
  SliceList list = read_list(content, path, head, along);
  if (head.features < 2) { // else lines with features follow
    refuse_rest(content, list, head);
  }
  return std::move(list.slices);
}

SliceList read_slice_list(std::string_view text, const std::filesystem::path& path) {
  const Log log(path.string(), false);
  Content content(text, log);
  Head head;
  std::vector<double> along;
  SliceList list = read_list(content, path, head, along);
  if (head.has_kinks) {
    log.refuse("has kinks or accelerations between its parts, which are not supported");
  }
  for (std::size_t i = 0; i < list.slices.size() && head.features >= 2; ++i) {
    read_features(content, head.features, along[0], along[1], i + 1, list.slices[i]);
  }
  refuse_rest(content, list, head);
  return list;
}

std::string slices_text(const std::vector<Slice>& slices, ProfileKind kind) {
  std::string text = std::to_string(slices.size()) + " slices:";
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (i + 1 < slices.size() && i >= most_listed) {
      continue;
    }
    text.append(i == most_listed && i + 1 == slices.size() ? " ..., " : i > 0 ? ", " : " ");
    text.append(std::to_string(i + 1)).append(" at ").append(text_of(slices[i].place));
    text.append(kind == ProfileKind::rail ? " mm " : " rad ");
    text.append(reading::quoted(slices[i].file.filename().string()));
  }
  return text;
}

} // namespace wrc
