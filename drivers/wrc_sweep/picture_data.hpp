/// Rows of a study, as pictures pick them.
#pragma once

#include <string>
#include <vector>

#include "wrc_sweep/journal.hpp"

namespace driver {

class PictureData {
public:
  PictureData(const Study& study, Journal& journal) : study_(study), journal_(journal) {}

  [[nodiscard]] const Study& study() const { return study_; }
  /// Values that a key has in the study: those of its axis, or its only one.
  [[nodiscard]] std::vector<Value> values_of(const std::string& key) const;
  /// The same as numbers; throws Failure for texts.
  [[nodiscard]] std::vector<double> numbers_of(const std::string& key) const;
  /// The first scene whose keys have these values, -1 if there is none. An axis that is not named
  /// has its first value.
  [[nodiscard]] std::int64_t find(const Values& values) const;
  [[nodiscard]] Row row(std::int64_t scene) const { return journal_.read(scene); }
  /// A result of a row; NaN if it failed or has none.
  [[nodiscard]] double number(const Row& row, const std::string& name) const;
  /// A field of one of its patches.
  [[nodiscard]] const std::vector<double>& field(const PatchFields& patch,
                                                 const std::string& name) const;

private:
  const Study& study_;
  Journal& journal_;
};

/// The places along x that a picture shows: those it asks for, or all.
std::vector<double> places_of(const PictureRequest& picture, const PictureData& data);
/// One line of a picture: a result over these places. NaN where there is no result.
std::vector<double> line_of(const PictureRequest& picture, const PictureData& data, Values where,
                            const std::string& result);

/// Begins a picture of several plots: its layout, and a title with room below it.
std::string multiplot(int rows, std::size_t columns, const std::string& title);

/// "cant {}" with a value in the place of {}, or behind if there is no such place.
std::string series_name(const PictureRequest& picture, const Value& value);

/// Axes, grid and legend as all pictures of lines have them.
extern const char* const line_style;

/// An axis from the least to the greatest value taken in, with some room; also for equal values,
/// and for none.
class AxisRange {
public:
  /// NaN is left out.
  void include(double value);
  /// For example "set yrange [0:1]\n".
  [[nodiscard]] std::string command(const std::string& axis) const;

private:
  double least_ = 0.0;
  double greatest_ = 0.0;
  bool empty_ = true;
};

/// Colours of lines, told apart also by people who see colours less well.
const char* line_colour(std::size_t index);

} // namespace driver
