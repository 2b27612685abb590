#include <algorithm>

#include "support/output_file.hpp"
#include "wrc_sweep/netcdf_file.hpp"
#include "wrc_sweep/outputs.hpp"
#include "wrc_sweep/units.hpp"

namespace driver {
namespace {

/// Numbers as numbers, anything else as texts.
void write_axis(NetcdfFile& file, const Axis& axis, int dimension) {
  const bool numeric = std::all_of(axis.values.begin(), axis.values.end(), [](const Value& value) {
    return std::holds_alternative<double>(value);
  });
  if (!numeric) {
    std::vector<std::string> texts;
    for (const Value& value : axis.values) {
      texts.push_back(text_of(value));
    }
    file.put(file.texts(axis.key, {dimension}), texts);
    return;
  }
  std::vector<double> numbers;
  for (const Value& value : axis.values) {
    numbers.push_back(std::get<double>(value));
  }
  const int variable = file.numbers(axis.key, {dimension});
  file.attribute(variable, "units", unit_of(axis.key));
  file.put(variable, numbers);
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

void write_results(NetcdfFile& file, const Study& study, Journal& journal,
                   const std::vector<int>& dimensions) {
  const auto count = static_cast<std::size_t>(study.scene_count());
  std::vector<std::int64_t> status(count);
  std::vector<std::string> message(count);
  std::vector<std::vector<double>> values(study.results.size(), std::vector<double>(count));
  for (std::size_t scene = 0; scene < count; ++scene) {
    const Row row = journal.read(static_cast<std::int64_t>(scene));
    status[scene] = row.status;
    message[scene] = row.message;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i][scene] = row.values[i];
    }
  }
  const int status_variable = file.integers("status", dimensions);
  describe_status(file, status_variable);
  file.put(status_variable, status);
  file.put(file.texts("message", dimensions), message);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int variable = file.numbers(study.results[i], dimensions);
    file.attribute(variable, "units", unit_of(study.results[i]));
    file.put(variable, values[i]);
  }
}

/// One column of whole numbers, an entry a patch.
struct PatchColumn {
  const char* name;
  const char* meaning;
  std::vector<std::int64_t> values{};
};

void write_fields(NetcdfFile& file, const Study& study, Journal& journal) {
  std::array columns{
      PatchColumn{"patch_scene", "number of the scene, the last dimension varies fastest"},
      PatchColumn{"patch_side", "0: left, 1: right"},
      PatchColumn{"patch_index", "largest normal force first"},
      PatchColumn{"patch_rows",
                  "elements across the rail, from the track centre to the field side"},
      PatchColumn{"patch_columns", "elements along the rail; this index is the fastest"},
      PatchColumn{"element_count", "number of elements"}};
  std::size_t elements = 0;
  for (std::int64_t scene = 0; scene < study.scene_count(); ++scene) {
    for (const PatchFields& patch : journal.read(scene).patches) {
      const std::array values{
          scene,         std::int64_t{patch.side},  std::int64_t{patch.index}, patch.rows,
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
    const int variable = file.integers(column.name, {patch_dimension});
    file.attribute(variable, "long_name", column.meaning);
    if (&column == &columns.back()) {
      file.attribute(variable, "sample_dimension", "element");
    }
    file.put(variable, column.values);
  }
  std::vector<int> fields;
  for (const std::string& name : study.fields) {
    fields.push_back(file.numbers("field." + name, {element_dimension}));
    file.attribute(fields.back(), "units", unit_of(name));
    file.compress(fields.back());
  }
  std::size_t first = 0;
  for (std::int64_t scene = 0; scene < study.scene_count(); ++scene) {
    for (const PatchFields& patch : journal.read(scene).patches) {
      for (std::size_t i = 0; i < fields.size(); ++i) {
        file.put_part(fields[i], first, patch.values[i]);
      }
      first += patch.values.front().size();
    }
  }
}

void write_whole(const Study& study, Journal& journal, const std::filesystem::path& path) {
  NetcdfFile file(path);
  file.attribute(NetcdfFile::whole_file, "Conventions", "CF-1.8");
  file.attribute(NetcdfFile::whole_file, "title", study.title.empty() ? study.name : study.title);
  file.attribute(NetcdfFile::whole_file, "source", std::string("wrcontact ") + wrc_version());
  for (const auto& [key, value] : study.fixed) {
    file.attribute(NetcdfFile::whole_file, key, text_of(value));
  }
  std::vector<int> dimensions;
  for (const Axis& axis : study.axes) {
    dimensions.push_back(file.dimension(axis.key, axis.values.size()));
    write_axis(file, axis, dimensions.back());
  }
  write_results(file, study, journal, dimensions);
  if (!study.fields.empty()) {
    write_fields(file, study, journal);
  }
  file.close();
}

} // namespace

void write_netcdf(const Study& study, Journal& journal, const std::filesystem::path& path) {
  OutputFile whole(path);
  in_own_process(path, [&] { write_whole(study, journal, whole.aside()); });
  whole.commit();
}

} // namespace driver
