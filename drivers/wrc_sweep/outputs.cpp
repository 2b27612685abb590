#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <netcdf.h>
#include <string>
#include <vector>

#include "support/child_process.hpp"
#include "support/csv_table.hpp"
#include "support/output_file.hpp"
#include "wrc_sweep/result_names.hpp"
#include "wrc_sweep/run.hpp"

namespace driver {
namespace {

/// A NetCDF-4 file being written, with failures as exceptions. Not closed by its destructor, see
/// there.
class NetcdfFile {
public:
  /// The file must exist. NetCDF is given its descriptor, not its name, in which it would look for
  /// servers (http:...), folders (\) and options (#...).
  explicit NetcdfFile(const std::filesystem::path& path)
      : path_(path.string()), descriptor_(open(path.c_str(), O_RDWR | O_CLOEXEC)) {
    const std::string name = "/proc/self/fd/" + std::to_string(descriptor_);
    check(nc_create(name.c_str(), NC_NETCDF4 | NC_CLOBBER, &file_));
  }

  int dimension(const std::string& name, std::size_t length) {
    int id = -1;
    check(nc_def_dim(file_, name.c_str(), length, &id));
    return id;
  }
  /// A variable over dimensions, of NC_DOUBLE, NC_INT64, NC_STRING or NC_CHAR.
  int variable(const std::string& name, int type, const std::vector<int>& dimensions) {
    int id = -1;
    check(nc_def_var(file_, name.c_str(), type, static_cast<int>(dimensions.size()),
                     dimensions.data(), &id));
    return id;
  }
  /// Compresses a variable of many numbers.
  void compress(int variable) {
    constexpr int shuffle = 1;
    constexpr int deflate = 1;
    constexpr int level = 1;
    check(nc_def_var_deflate(file_, variable, shuffle, deflate, level));
  }
  /// Attribute of a variable, or with NC_GLOBAL of the file.
  void attribute(int variable, const std::string& name, const std::string& value) {
    check(nc_put_att_text(file_, variable, name.c_str(), value.size(), value.c_str()));
  }
  void attribute(int variable, const std::string& name, const std::vector<int>& values) {
    check(nc_put_att_int(file_, variable, name.c_str(), NC_INT64, values.size(), values.data()));
  }

  void describe(int variable, const std::string& name, const std::string& unit) {
    attribute(variable, "units", unit);
    attribute(variable, "long_name", long_name_of(name));
  }

  /// Whole variables.
  void put(int variable, const std::vector<double>& values) {
    check(nc_put_var_double(file_, variable, values.data()));
  }
  void put(int variable, const std::vector<long long>& values) {
    check(nc_put_var_longlong(file_, variable, values.data()));
  }
  void put(int variable, const std::vector<std::string>& values) {
    std::vector<const char*> texts;
    for (const std::string& value : values) {
      texts.push_back(value.c_str());
    }
    check(nc_put_var_string(file_, variable, texts.data()));
  }
  void put(int variable, const std::string& characters) {
    check(nc_put_var_text(file_, variable, characters.data()));
  }
  /// Part of a variable with one dimension.
  void put_part(int variable, std::size_t first, const std::vector<double>& values) {
    const std::size_t count = values.size();
    check(nc_put_vara_double(file_, variable, &first, &count, values.data()));
  }
  void close() { check(nc_close(file_)); }

private:
  void check(int status) const {
    if (status != NC_NOERR) {
      throw Failure("cannot write " + path_ + ": " + nc_strerror(status));
    }
  }

  std::string path_;
  int descriptor_ = -1;
  int file_ = -1;
};

constexpr const char* warning_count_name = "warning_count";
constexpr const char* grade_name = "grade";

/// A number of a key: with these digits if they are exact, otherwise the shortest text that is.
std::string key_text(double number, int digits) {
  std::string text = table_text(number, digits);
  return std::strtod(text.c_str(), nullptr) == number ? text : text_of(number);
}

/// Whether a study asks for a result by itself, which is then listed among the others.
bool is_result(const Study& study, const char* name) {
  return std::find(study.results.begin(), study.results.end(), name) != study.results.end();
}

/// Numbers as numbers, anything else as texts.
void write_axis(NetcdfFile& file, const Scene& scene, const Axis& axis, int dimension) {
  std::vector<std::string> texts;
  std::vector<double> numbers;
  for (const Value& value : axis.values) {
    texts.push_back(text_of(value));
    if (const double* number = std::get_if<double>(&value)) {
      numbers.push_back(*number);
    }
  }
  if (numbers.size() < texts.size()) {
    const int variable = file.variable(axis.key, NC_STRING, {dimension});
    file.attribute(variable, "long_name", long_name_of(axis.key));
    file.put(variable, texts);
    return;
  }
  const int variable = file.variable(axis.key, NC_DOUBLE, {dimension});
  file.describe(variable, axis.key, unit_of(scene, axis.key));
  file.put(variable, numbers);
}

void describe_grade(NetcdfFile& file, int grade) {
  std::vector<int> codes;
  std::string meanings;
  for (std::string name : grade_names) {
    std::replace(name.begin(), name.end(), ' ', '_');
    codes.push_back(static_cast<int>(codes.size()));
    meanings += (meanings.empty() ? "" : " ") + name;
  }
  file.attribute(grade, "long_name", "worst of the warnings");
  file.attribute(grade, "flag_values", codes);
  file.attribute(grade, "flag_meanings", meanings);
}

void describe_status(NetcdfFile& file, int status) {
  std::vector<int> codes;
  std::string meanings;
  for (int code = WRC_OK; code <= WRC_NO_RESULT; ++code) {
    std::string meaning = wrc_status_name(code);
    std::replace(meaning.begin(), meaning.end(), ' ', '_'); // the CF conventions separate by blanks
    codes.push_back(code);
    meanings += (meanings.empty() ? "" : " ") + meaning;
  }
  file.attribute(status, "flag_values", codes);
  file.attribute(status, "flag_meanings", meanings);
}

void write_results(NetcdfFile& file, const Scene& scene, const Study& study, Journal& journal,
                   const std::vector<int>& dimensions) {
  const auto count = static_cast<std::size_t>(study.scene_count());
  std::vector<long long> status(count);
  std::vector<std::string> message(count);
  std::vector<long long> warning_count(count);
  std::vector<long long> grade(count);
  std::vector<std::string> warnings(count);
  std::vector<std::vector<double>> values(study.results.size(), std::vector<double>(count));
  for (std::size_t index = 0; index < count; ++index) {
    const Row row = journal.read(static_cast<std::int64_t>(index));
    status[index] = row.status;
    message[index] = row.message;
    warning_count[index] = static_cast<long long>(row.warnings.size());
    grade[index] = grade_of(row.warnings);
    warnings[index] = joined_warnings(row.warnings);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i][index] = row.values[i];
    }
  }
  const int status_variable = file.variable("status", NC_INT64, dimensions);
  describe_status(file, status_variable);
  file.put(status_variable, status);
  file.put(file.variable("message", NC_STRING, dimensions), message);
  if (!is_result(study, warning_count_name)) {
    const int variable = file.variable(warning_count_name, NC_INT64, dimensions);
    file.attribute(variable, "long_name", "warnings of profiles and both wheels");
    file.put(variable, warning_count);
  }
  if (!is_result(study, grade_name)) {
    const int variable = file.variable(grade_name, NC_INT64, dimensions);
    describe_grade(file, variable);
    file.put(variable, grade);
  }
  const int texts = file.variable("warnings", NC_STRING, dimensions);
  file.attribute(texts, "long_name", "their texts, separated by \" | \"");
  file.put(texts, warnings);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int variable = file.variable(study.results[i], NC_DOUBLE, dimensions);
    file.describe(variable, study.results[i], scene.number_unit(study.results[i]));
    file.put(variable, values[i]);
  }
}

/// One column of whole numbers, an entry per patch.
struct PatchColumn {
  const char* name;
  const char* meaning;
  std::vector<long long> values{};
};

void write_fields(NetcdfFile& file, const Scene& scene, const Study& study, Journal& journal) {
  std::array columns{
      PatchColumn{"patch_scene", "number of the scene, the last dimension varies fastest"},
      PatchColumn{"patch_side", "0: left, 1: right"},
      PatchColumn{"patch_index", "largest normal force first"},
      PatchColumn{"patch_rows",
                  "elements across the rail, from the track centre to the field side"},
      PatchColumn{"patch_columns", "elements along the rail; this index is the fastest"},
      PatchColumn{"element_count", "number of elements"}};
  std::size_t elements = 0;
  for (std::int64_t index = 0; index < study.scene_count(); ++index) {
    for (const PatchFields& patch : journal.read(index).patches) {
      const std::array values{
          index,         std::int64_t{patch.side},  std::int64_t{patch.index}, patch.rows,
          patch.columns, patch.rows * patch.columns};
      for (std::size_t i = 0; i < columns.size(); ++i) {
        columns[i].values.push_back(values[i]);
      }
      elements += patch.values.front().size();
    }
  }
  if (elements == 0) {
    return;
  }
  const int patch_dimension = file.dimension("patch", columns.front().values.size());
  const int element_dimension = file.dimension("element", elements);
  for (const PatchColumn& column : columns) {
    const int variable = file.variable(column.name, NC_INT64, {patch_dimension});
    file.attribute(variable, "long_name", column.meaning);
    if (&column == &columns.back()) {
      file.attribute(variable, "sample_dimension", "element");
    }
    file.put(variable, column.values);
  }
  std::vector<int> fields;
  for (const std::string& name : study.fields) {
    fields.push_back(file.variable("field." + name, NC_DOUBLE, {element_dimension}));
    file.describe(fields.back(), name, unit_of(scene, name));
    file.compress(fields.back());
  }
  std::size_t first = 0;
  for (std::int64_t index = 0; index < study.scene_count(); ++index) {
    for (const PatchFields& patch : journal.read(index).patches) {
      for (std::size_t i = 0; i < fields.size(); ++i) {
        file.put_part(fields[i], first, patch.values[i]);
      }
      first += patch.values.front().size();
    }
  }
}

/// Where the results come from: the study and its profile files as they were, one after the other.
void write_inputs(NetcdfFile& file, const Study& study) {
  std::vector<std::string> names;
  std::vector<std::string> sums;
  std::vector<long long> sizes;
  std::string content;
  for (const InputFile& input : study.inputs) {
    names.push_back(input.path);
    sums.push_back(input.sha256);
    sizes.push_back(static_cast<long long>(input.content.size()));
    content += input.content;
  }
  const int input_dimension = file.dimension("input", names.size());
  const int byte_dimension = file.dimension("input_byte", content.size());
  const auto add = [&](const char* name, int type, const char* meaning, int dimension) {
    const int variable = file.variable(name, type, {dimension});
    file.attribute(variable, "long_name", meaning);
    return variable;
  };
  file.put(add("input_name", NC_STRING, "files read: the study, then profiles", input_dimension),
           names);
  file.put(add("input_sha256", NC_STRING, "SHA-256 sum of their content", input_dimension), sums);
  const int size = add("input_size", NC_INT64, "number of bytes", input_dimension);
  file.attribute(size, "sample_dimension", "input_byte");
  file.put(size, sizes);
  const int bytes = add("input_content", NC_CHAR, "their content", byte_dimension);
  file.compress(bytes);
  file.put(bytes, content);
}

void write_whole(const Study& study, Journal& journal, const std::filesystem::path& path) {
  NetcdfFile file(path);
  file.attribute(NC_GLOBAL, "Conventions", "CF-1.8");
  file.attribute(NC_GLOBAL, "title", study.title.empty() ? study.name : study.title);
  file.attribute(NC_GLOBAL, "source", std::string("wrcontact ") + wrc_version());
  for (const auto& [key, value] : study.constants()) { // defaults included
    file.attribute(NC_GLOBAL, key, text_of(value));
  }
  Scene scene; // for its units
  study.apply(0, scene);
  std::vector<int> dimensions;
  for (const Axis& axis : study.axes) {
    dimensions.push_back(file.dimension(axis.key, axis.values.size()));
    write_axis(file, scene, axis, dimensions.back());
  }
  write_results(file, scene, study, journal, dimensions);
  if (!study.fields.empty()) {
    write_fields(file, scene, study, journal);
  }
  write_inputs(file, study);
  file.close();
}

} // namespace

void write_csv(const Study& study, Journal& journal, const std::filesystem::path& path) {
  OutputFile file(path);
  std::ostream& out = file.stream();
  std::vector<std::string> keys;
  for (const Axis& axis : study.axes) {
    keys.push_back(axis.key);
  }
  std::vector<std::string> last; // numbers, then texts
  const bool counts = !is_result(study, warning_count_name);
  const bool grades = !is_result(study, grade_name);
  if (grades) {
    last.emplace_back(grade_name);
  }
  if (counts) {
    last.emplace_back(warning_count_name);
  }
  CsvLine(out)
      .add(words("scene"))
      .add(keys)
      .add(study.results)
      .add(last)
      .add(words("status message warnings"));
  for (std::int64_t scene = 0; scene < study.scene_count(); ++scene) {
    const Row row = journal.read(scene);
    const std::vector<std::size_t> places = study.places(scene);
    CsvLine line(out);
    line << scene;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Value& value = study.axes[i].values[places[i]];
      const double* const number = std::get_if<double>(&value);
      line << (number == nullptr ? text_of(value) : key_text(*number, study.digits));
    }
    for (const double value : row.values) {
      line << table_text(value, study.digits);
    }
    if (grades) {
      line << grade_of(row.warnings);
    }
    if (counts) {
      line << row.warnings.size();
    }
    line << wrc_status_name(row.status) << row.message << joined_warnings(row.warnings);
  }
  file.commit();
}

void write_netcdf(const Study& study, Journal& journal, const std::filesystem::path& path) {
  OutputFile whole(path);
  // HDF5 does not get over a full disk: it fails again when the file is closed or the program ends,
  // by a fault. A process of its own keeps that from this one.
  const std::string trouble = in_own_process([&](int) {
    journal.give_up_lock();
    // Nobody else opens the file aside, and some file systems have no locks.
    setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0);
    write_whole(study, journal, whole.aside());
  });
  if (!trouble.empty()) {
    throw Failure(trouble.starts_with("cannot write")
                      ? trouble
                      : "cannot write " + path.string() + ": " + is_disk_full +
                            " (NetCDF's writer " + trouble + ')');
  }
  whole.commit();
}

} // namespace driver
