#include <algorithm>
#include <cstring>

#include "handles.hpp"
#include "table/table_build.hpp"
#include "table/table_file.hpp"
#include "table/table_text.hpp"

namespace {

/// What a call of the progress throws to stop.
struct Stopped {};

static_assert(WRC_TABLE_OUTPUTS == wrc::output_count);

constexpr uint64_t most_bytes = 4096; // more is no size of a struct

/// The options that caller and library know.
wrc_table_options known_part(const wrc_table_options* given) {
  wrc_table_options known{};
  if (given != nullptr) {
    if (given->struct_size < sizeof(uint64_t) || given->struct_size > most_bytes ||
        given->struct_size % sizeof(uint64_t) != 0) {
      wrc::throw_invalid_argument("struct_size", static_cast<double>(given->struct_size),
                                  "sizeof(wrc_table_options)");
    }
    std::memcpy(&known, given, std::min<std::size_t>(given->struct_size, sizeof known));
  }
  return known;
}

wrc::TableOptions options_of(const wrc_table_options& given, const wrc::Convention& convention) {
  using namespace wrc::dimensions;
  wrc::TableOptions options;
  const auto set = [&convention](double& to, double value, const wrc::Dimension& dimension) {
    if (value != 0.0) {
      to = wrc::from_caller(value, convention, dimension);
    }
  };
  set(options.ranges.lateral, given.lateral, length);
  set(options.ranges.roll, given.roll, angle);
  set(options.ranges.yaw, given.yaw, angle);
  set(options.ranges.load, given.load, force);
  set(options.tolerance, given.tolerance, pure);
  set(options.fineness, given.fineness, pure);
  if (given.threads != 0) {
    if (given.threads < 1 || given.threads > 1024) {
      wrc::throw_invalid_argument("threads", static_cast<double>(given.threads),
                                  "must be between 1 and 1024");
    }
    options.threads = static_cast<int>(given.threads);
  }
  if (given.resume_file != nullptr) {
    options.resume_file = given.resume_file;
  }
  options.version = wrc_version();
  return options;
}

/// Runs a body that needs a table.
template <class Body> wrc_status with_table(wrc_table* table, Body&& body) {
  return wrc::guard(table, [&](wrc::TableObject& object) -> wrc_status {
    if (!object.table) {
      object.error = "there is no table yet: build or load one";
      return WRC_NO_RESULT;
    }
    return std::forward<Body>(body)(object);
  });
}

} // namespace

extern "C" {

const char* wrc_table_output_name(int64_t index) {
  return index >= 0 && index < static_cast<int64_t>(wrc::output_count)
             ? wrc::wheel_outputs[static_cast<std::size_t>(index)].name
             : nullptr;
}

wrc_status wrc_table_create(wrc_table** table) {
  return wrc::create(table);
}

void wrc_table_destroy(wrc_table* table) {
  wrc::destroy(table);
}

const char* wrc_table_error(const wrc_table* table) {
  return wrc::error_of(table);
}

wrc_status wrc_table_build(wrc_table* table, wrc_scene* scene, const wrc_table_options* options,
                           int32_t (*progress)(void* context, double fraction), void* context) {
  return wrc::guard(table, [&](wrc::TableObject& object) -> wrc_status {
    wrc::require_pointer(scene, "scene");
    const auto used = wrc::use(scene);
    if (!used.held()) {
      object.error = std::string("scene: ") + wrc::reason_of(used);
      return used.exists() ? WRC_BUSY : WRC_INVALID_ARGUMENT;
    }
    const wrc::Scene& of = used.object().scene;
    wrc::TableOptions known = options_of(known_part(options), of.convention);
    if (progress != nullptr) {
      known.progress = [progress, context](double fraction) {
        if (progress(context, fraction) != 0) {
          throw Stopped();
        }
      };
    }
    try {
      object.take(std::make_shared<const wrc::ContactTable>(
          wrc::build_table(of, known, wrc::SceneSolver())));
    } catch (const Stopped&) {
      object.error = "stopped by the call of its progress";
      return WRC_NO_RESULT;
    }
    return WRC_OK;
  });
}

wrc_status wrc_table_save(wrc_table* table, const char* path) {
  return with_table(table, [&](wrc::TableObject& object) {
    wrc::require_pointer(path, "path");
    wrc::write_table(*object.table, path);
    return WRC_OK;
  });
}

wrc_status wrc_table_load(wrc_table* table, const char* path) {
  return wrc::guard(table, [&](wrc::TableObject& object) {
    wrc::require_pointer(path, "path");
    object.take(std::make_shared<const wrc::ContactTable>(wrc::read_table(path)));
    return WRC_OK;
  });
}

wrc_status wrc_table_share(wrc_table* table, wrc_table* other) {
  return with_table(table, [&](wrc::TableObject& object) -> wrc_status {
    wrc::require_pointer(other, "other");
    if (other == table) {
      return WRC_OK;
    }
    const auto used = wrc::use(other);
    if (!used.held()) {
      object.error = std::string("other: ") + wrc::reason_of(used);
      return used.exists() ? WRC_BUSY : WRC_INVALID_ARGUMENT;
    }
    used.object().take(object.table);
    return WRC_OK;
  });
}

const char* wrc_table_line(const wrc_table* table, int64_t index) {
  return wrc::look_at<const char*>(table, nullptr,
                                   [index](wrc::TableObject& object) -> const char* {
                                     if (object.table && object.lines.empty()) {
                                       object.lines = wrc::lines_of(*object.table);
                                     }
                                     return wrc::line_of(object.lines, index);
                                   });
}

wrc_status wrc_table_get_facts(wrc_table* table, wrc_table_facts* facts) {
  return with_table(table, [&](wrc::TableObject& object) {
    wrc::require_pointer(facts, "facts");
    if (facts->struct_size < sizeof(uint64_t) || facts->struct_size > most_bytes ||
        facts->struct_size % sizeof(uint64_t) != 0) {
      wrc::throw_invalid_argument("struct_size", static_cast<double>(facts->struct_size),
                                  "sizeof(wrc_table_facts)");
    }
    const wrc::ContactTable& found = *object.table;
    const wrc::TableErrors& measured = found.measured;
    const wrc_table_facts known{
        facts->struct_size,
        wrc::to_caller(found.ranges.lateral, found.convention, wrc::dimensions::length),
        found.ranges.roll,
        found.ranges.yaw,
        found.ranges.load,
        found.tolerance,
        static_cast<double>(measured.states),
        static_cast<double>(measured.beyond),
        measured.beyond_at_most(),
        measured.median,
        measured.percentile_99,
        measured.worst,
        found.tolerance > 0.0 ? found.errors.share_beyond(found.tolerance) : 0.0,
        static_cast<double>(found.bytes()),
        static_cast<double>(measured.beyond_likely),
        measured.derivatives_median};
    std::memcpy(facts, &known, std::min<std::size_t>(facts->struct_size, sizeof known));
    return WRC_OK;
  });
}

} // extern "C"
