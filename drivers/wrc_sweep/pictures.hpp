/// Pictures of a finished study, and its rows as they pick them.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "support/gnuplot.hpp"
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
  [[nodiscard]] const WarningSummary& warnings() const { return journal_.warnings(); }
  /// Whether a result of a scene is not to be used.
  [[nodiscard]] bool is_spoiled(std::int64_t scene, const std::string& result) const {
    return journal_.grades_of(scene).of(result) == WRC_DO_NOT_USE;
  }
  /// A result of a row; NaN if it failed or has none.
  [[nodiscard]] double number(const Row& row, const std::string& name) const;
  /// A field of one of its patches.
  [[nodiscard]] const std::vector<double>& field(const PatchFields& patch,
                                                 const std::string& name) const;

private:
  const Study& study_;
  Journal& journal_;
};

/// The positions along x that a picture shows: the requested ones, or all.
std::vector<double> places_of(const PictureRequest& picture, const PictureData& data);
/// One line of a picture: a result over these positions. NaN where there is no result.
std::vector<double> line_of(const PictureRequest& picture, const PictureData& data, Values where,
                            const std::string& result);

/// Positions of such a line at which the result is not to be used.
std::vector<double> spoiled_places_of(const PictureRequest& picture, const PictureData& data,
                                      Values where, const std::string& result);
/// Script lines for a line of text at the lower end of a picture that says how many scenes have
/// warnings, and by which marks ("hollow"), with room for it below the labels of axes. It is drawn
/// by each plot of a multiplot until end_of_warning_note follows. Nothing without warnings.
std::string warning_note(const PictureData& data, const std::string& marks = "",
                         bool has_axes = true);
std::string end_of_warning_note();

/// Says where values go that lie outside a scale, such as " (up to 9256)"; empty if none does.
std::string beyond_note(const std::vector<double>& values, const Range& range);

/// One combination of values of a picture's series.
struct SeriesEntry {
  Values where; ///< those of the picture, and the series' values
  std::string
      name; ///< "inclination {}" with the values instead of {}, or after the text if it has no {}
  std::string shown; ///< the same for people: files without their folders
  std::string title; ///< for the picture, with markup
};
/// The picture's series; without one a single entry that has no name.
///
/// Titles have markup: that of the study's label. Values, and keys that replace a missing label,
/// are drawn letter by letter.
std::vector<SeriesEntry> series_of(const PictureRequest& picture, const PictureData& data);
/// The label of a series of one key, as a title.
std::string series_label(const PictureRequest& picture);

/// Says of which value of a key a picture is where it shows the first of several, since it has no
/// place for the others; empty if it shows them all.
std::string note_of_scenes_left_out(const PictureRequest& picture, const Study& study);

/// The files of a picture in a folder: the picture, if it is drawn, then for conicity and ranking a
/// table.
std::vector<std::filesystem::path> files_of(const PictureRequest& picture,
                                            const std::filesystem::path& folder);
/// Draws one picture into a folder; `findings` gets what it shows in words, if there is such a
/// thing.
void draw_picture(const PictureRequest& picture, const PictureData& data,
                  const std::filesystem::path& folder, std::ostream& findings);

void draw_lines(const PictureRequest& picture, const PictureData& data,
                const std::filesystem::path& path);
void draw_map(const PictureRequest& picture, const PictureData& data,
              const std::filesystem::path& path);
void draw_patches(const PictureRequest& picture, const PictureData& data,
                  const std::filesystem::path& path);
void draw_connections(const PictureRequest& picture, const PictureData& data,
                      const std::filesystem::path& path);
/// Both also write what they draw as a table.
void draw_conicity(const PictureRequest& picture, const PictureData& data,
                   const std::filesystem::path& path, const std::filesystem::path& table,
                   std::ostream& findings);
void draw_ranking(const PictureRequest& picture, const PictureData& data,
                  const std::filesystem::path& path, const std::filesystem::path& table,
                  std::ostream& findings);

} // namespace driver
