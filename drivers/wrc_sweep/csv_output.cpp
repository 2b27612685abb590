#include "support/csv_table.hpp"
#include "support/output_file.hpp"
#include "wrc_sweep/outputs.hpp"

namespace driver {

void write_csv(const Study& study, Journal& journal, const std::filesystem::path& path) {
  OutputFile file(path);
  std::ostream& out = file.stream();
  out << "scene";
  for (const Axis& axis : study.axes) {
    out << ',' << axis.key;
  }
  out << ",status,message";
  for (const std::string& name : study.results) {
    out << ',' << name;
  }
  out << '\n';
  for (std::int64_t scene = 0; scene < study.scene_count(); ++scene) {
    const Row row = journal.read(scene);
    out << scene;
    const std::vector<std::size_t> places = study.places(scene);
    for (std::size_t i = 0; i < places.size(); ++i) {
      out << ',' << csv_entry(text_of(study.axes[i].values[places[i]]));
    }
    out << ',' << wrc_status_name(row.status) << ',' << csv_entry(row.message);
    for (const double value : row.values) {
      out << ',' << text_of(value);
    }
    out << '\n';
  }
  file.commit();
}

} // namespace driver
