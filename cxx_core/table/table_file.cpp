#include "table/table_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "table/constants.hpp"

namespace wrc {
namespace {

static_assert(std::endian::native == std::endian::little, "the format's numbers are little-endian");

constexpr std::string_view first_words = "wrcontact table of contact forces, format ";
constexpr std::string_view first_line = "wrcontact table of contact forces, format 3\n";

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorCode::file_malformed, "table file: " + what);
}

class Writer {
public:
  static constexpr bool reads = false;

  template <class Number> void number(Number& value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void name(std::string& value) {
    std::uint64_t size = value.size();
    number(size);
    text_ += value;
  }
  template <class Number> void numbers(std::vector<Number>& values, std::size_t) {
    text_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number));
  }
  void flag(std::string_view line) { text_ += line; }
  [[nodiscard]] std::string take() && { return std::move(text_); }

private:
  std::string text_;
};

class Reader {
public:
  static constexpr bool reads = true;

  explicit Reader(std::string_view text) : rest_(text) {}

  template <class Number> void number(Number& value) {
    const std::string_view bytes = next(sizeof value);
    std::memcpy(&value, bytes.data(), sizeof value);
    if constexpr (std::is_floating_point_v<Number>) {
      if (!std::isfinite(value)) {
        refuse("a number is not finite");
      }
    }
  }
  void name(std::string& value) {
    std::uint64_t size = 0;
    number(size);
    if (size > longest_table_name) {
      refuse("a name of " + std::to_string(size) + " bytes");
    }
    value = next(static_cast<std::size_t>(size));
    if (!is_name_of_table(value)) {
      refuse("a name that is no text of one line");
    }
  }
  template <class Number> void numbers(std::vector<Number>& values, std::size_t count) {
    if (count > rest_.size() / sizeof(Number)) {
      refuse("it ends within " + std::to_string(count) + " numbers");
    }
    const std::string_view bytes = next(count * sizeof(Number));
    values.resize(count);
    std::memcpy(values.data(), bytes.data(), bytes.size());
    for (const Number value : values) {
      if (!std::isfinite(value)) {
        refuse("a number is not finite");
      }
    }
  }
  void flag(std::string_view line) {
    if (next(line.size()) != line) {
      refuse("it does not begin with \"" + std::string(line.substr(0, line.size() - 1)) + '"');
    }
  }
  [[nodiscard]] bool ended() const { return rest_.empty(); }

private:
  std::string_view next(std::size_t size) {
    if (size > rest_.size()) {
      refuse("it ends too early");
    }
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return bytes;
  }
  std::string_view rest_;
};

template <class Stream> void axis(Stream& stream, SplineAxis& axis) {
  stream.number(axis.first);
  stream.number(axis.step);
  std::uint64_t count = axis.count;
  stream.number(count);
  if constexpr (Stream::reads) {
    if (count < 4 || count > most_table_nodes) {
      refuse("a variable of " + std::to_string(count) + " nodes");
    }
    if (!(axis.step > 0.0)) {
      refuse("nodes " + text_of(axis.step) + " apart");
    }
    axis.count = static_cast<std::size_t>(count);
  }
}

template <class Stream, std::size_t variables, std::size_t parts, class Stored>
void spline(Stream& stream, TensorSpline<variables, parts, Stored>& spline) {
  typename TensorSpline<variables, parts, Stored>::Axes axes = spline.axes();
  double size = parts; // no overflow
  for (SplineAxis& one : axes) {
    axis(stream, one);
    size *= static_cast<double>(one.count);
  }
  if constexpr (Stream::reads) {
    if (size > static_cast<double>(largest_table_file)) {
      refuse("more numbers than a file may have");
    }
    spline = TensorSpline<variables, parts, Stored>();
    spline.set_axes(axes);
  }
  stream.numbers(spline.coefficients(), static_cast<std::size_t>(size));
}

template <class Stream> void map(Stream& stream, ErrorMap& errors) {
  ErrorMap::Ranges ranges = errors.ranges();
  ErrorMap::Counts counts = errors.counts();
  double size = 1.0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    stream.number(ranges[i].first);
    stream.number(ranges[i].last);
    std::uint64_t count = counts[i];
    stream.number(count);
    if (count < 1 || count > most_table_nodes || !(ranges[i].last > ranges[i].first)) {
      refuse("a map of errors of " + std::to_string(count) + " cells");
    }
    counts[i] = static_cast<std::size_t>(count);
    size *= static_cast<double>(count + 1);
  }
  if (size > static_cast<double>(largest_map_of_errors)) {
    refuse("more numbers than a file may have");
  }
  if constexpr (Stream::reads) {
    errors = ErrorMap(ranges, counts);
  }
  for (ErrorMap::Errors& vertex : errors.vertices()) {
    for (double& error : vertex) {
      stream.number(error);
    }
  }
}

/// What the file names of itself, and no other table may have.
template <class Stream> void words(Stream& stream, const char* what, const std::string& known) {
  std::string found = known;
  stream.name(found);
  if (found != known) {
    refuse(std::string("its ") + what + " are \"" + found +
           "\"; this version of the library reads \"" + known + '"');
  }
}

/// All of a table, one way or the other.
template <class Stream> void whole(Stream& stream, ContactTable& table) {
  stream.flag(first_line);
  stream.name(table.identity.wheel);
  stream.name(table.identity.rail);
  for (double& number : table.identity.numbers) {
    stream.number(number);
  }
  stream.number(table.identity.profiles);
  stream.name(table.version);
  words(stream, "axes", axes_of_tables);
  words(stream, "outputs", names_of_outputs());
  std::uint64_t si = table.convention.units == Units::si ? 1 : 0;
  std::uint64_t down = table.convention.frame == TrackFrame::right_down ? 1 : 0;
  stream.number(si);
  stream.number(down);
  table.convention = {si != 0 ? Units::si : Units::mm,
                      down != 0 ? TrackFrame::right_down : TrackFrame::left_up};
  TableRanges& ranges = table.ranges;
  for (double* number :
       {&ranges.lateral, &ranges.roll, &ranges.yaw, &ranges.load, &table.taping_line, &table.radius,
        &table.rail_y, &table.rail_z, &table.friction, &table.standstill_speed, &table.flange,
        &table.tolerance, &table.measured.median, &table.measured.percentile_99,
        &table.measured.worst, &table.measured.factor, &table.measured.likely_factor,
        &table.measured.derivatives_median}) {
    stream.number(*number);
  }
  stream.number(table.measured.states);
  stream.number(table.measured.beyond);
  stream.number(table.measured.beyond_likely);
  stream.number(table.measured.map_states);
  spline(stream, table.shift);
  spline(stream, table.touch);
  spline(stream, table.contact);
  spline(stream, table.places);
  CreepLaw::Spline law = table.law.spline();
  spline(stream, law);
  table.law = CreepLaw(std::move(law));
  map(stream, table.errors);
  if (!(table.measured.states > 0 && table.measured.factor >= 1.0 && table.tolerance >= 0.0 &&
        table.friction >= 0.0 && table.friction <= 10.0 && table.ranges.load > 0.0)) {
    refuse("numbers that no table has");
  }
}

/// Of a text with its first line, without its checksum.
ContactTable table_from_whole(std::string_view text) {
  ContactTable table;
  Reader reader(text);
  whole(reader, table);
  if (!reader.ended()) {
    refuse("it goes on after its end");
  }
  const TableRanges& ranges = table.ranges;
  if (!(ranges.lateral > 0.0 && ranges.roll > 0.0 && ranges.yaw > 0.0 && ranges.load > 0.0 &&
        table.standstill_speed > 0.0 && table.radius > 0.0)) {
    refuse("a range, the radius or the speed of standstill is not above 0");
  }
  return table;
}

} // namespace

std::uint64_t checksum_of(std::string_view text) {
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (const char byte : text) {
    sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  }
  return sum;
}

std::string text_of_table(const ContactTable& table) {
  Writer writer;
  ContactTable copy = table;
  whole(writer, copy);
  std::string text = std::move(writer).take();
  const std::uint64_t sum = checksum_of(text);
  text.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  return text;
}

ContactTable table_from_text(std::string_view text) {
  std::uint64_t sum = 0;
  if (!text.starts_with(first_line)) {
    if (text.starts_with(first_words)) {
      const std::string_view rest = text.substr(first_words.size(), longest_table_format);
      refuse("its format is " + std::string(rest.substr(0, rest.find('\n'))) +
             ", that of another version of the library; this one reads format 3: make the table "
             "again");
    }
    refuse("it does not begin with \"" + std::string(first_line.substr(0, first_line.size() - 1)) +
           '"');
  }
  if (text.size() < first_line.size() + sizeof sum) {
    refuse("it ends too early");
  }
  std::memcpy(&sum, text.data() + text.size() - sizeof sum, sizeof sum);
  text.remove_suffix(sizeof sum);
  if (checksum_of(text) != sum) {
    refuse("its checksum is another: it was changed or is not whole");
  }
  try {
    return table_from_whole(text);
  } catch (const Error& error) {
    throw Error(error.code(), error.what() + std::string("; its checksum is right, so it may be of "
                                                         "another version of the library: make "
                                                         "the table again"));
  }
}

void write_table(const ContactTable& table, const std::filesystem::path& path) {
  write_file(path, text_of_table(table));
}

bool is_name_of_table(std::string_view name) {
  return name.size() <= longest_table_name &&
         std::none_of(name.begin(), name.end(),
                      [](unsigned char letter) { return letter < 0x20 || letter == 0x7F; });
}

ContactTable read_table(const std::filesystem::path& path) {
  return table_from_text(read_file(path, largest_table_file));
}

} // namespace wrc
