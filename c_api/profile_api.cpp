#include <algorithm>
#include <cmath>
#include <cstring>

#include "handles.hpp"
#include "measured/readers.hpp"
#include "profile/limits.hpp"
#include "profile/writers.hpp"

namespace {

/// Runs a body that needs a loaded profile.
template <class Body> wrc_status with_profile(wrc_profile* profile, Body&& body) {
  return wrc::guard(profile, [&](wrc::ProfileObject& object) -> wrc_status {
    if (!object.profile) {
      object.error = "no profile has been loaded into the handle";
      return WRC_NO_RESULT;
    }
    return body(object, *object.profile);
  });
}

std::optional<bool> choice_of(std::int32_t value, const char* name) {
  if (value < -1 || value > 1) {
    wrc::throw_invalid_argument(name, value, "must be -1, 0 or 1");
  }
  return value == 0 ? std::nullopt : std::optional(value == 1);
}

wrc::ReadOptions options_from(const wrc_read_options* given) {
  wrc::ReadOptions options;
  if (given == nullptr) {
    return options;
  }
  wrc_read_options known{};
  if (given->struct_size < sizeof(std::uint64_t)) {
    wrc::throw_invalid_argument("struct_size", static_cast<double>(given->struct_size),
                                "sizeof(wrc_read_options)");
  }
  std::memcpy(&known, given, std::min<std::size_t>(given->struct_size, sizeof known));
  if (known.kind_given != 0) {
    if (known.kind != WRC_WHEEL && known.kind != WRC_RAIL) {
      wrc::throw_invalid_argument("kind", known.kind, "must be WRC_WHEEL or WRC_RAIL");
    }
    options.kind = known.kind == WRC_WHEEL ? wrc::ProfileKind::wheel : wrc::ProfileKind::rail;
  }
  options.mirror_lateral = choice_of(known.mirror_lateral, "mirror_lateral");
  options.mirror_height = choice_of(known.mirror_height, "mirror_height");
  options.strict = known.strict != 0;
  if (known.scale != 0.0) {
    options.scale = known.scale;
  }
  if (known.smoothing_wavelength == WRC_SMOOTHING_NONE) {
    options.smoothing_wavelength = 0.0;
  } else if (known.smoothing_wavelength == WRC_SMOOTHING_AUTO) {
    options.smoothing_wavelength = wrc::automatic_smoothing;
  } else if (known.smoothing_wavelength < 0.0) {
    wrc::throw_invalid_argument("smoothing_wavelength", known.smoothing_wavelength,
                                "must be 0, a wavelength in mm or WRC_SMOOTHING_...");
  } else if (known.smoothing_wavelength != 0.0) {
    options.smoothing_wavelength = known.smoothing_wavelength;
  }
  if (known.origin < 0 || known.origin > WRC_ORIGIN_FLANGE_BACK) {
    wrc::throw_invalid_argument("origin", known.origin,
                                "must be 0, WRC_ORIGIN_TAPE or WRC_ORIGIN_FLANGE_BACK");
  }
  options.origin = static_cast<wrc::WheelOrigin>(known.origin);
  options.slice = known.slice;
  if (known.tape_offset != 0.0) {
    options.tape_offset = known.tape_offset;
  }
  if (known.rotation_given != 0) {
    options.rotation = known.rotation;
  }
  constexpr std::size_t with_align_to = offsetof(wrc_read_options, align_to) + sizeof(char*);
  if (known.align_to != nullptr && given->struct_size >= with_align_to) { // not half a pointer
    options.align_to = known.align_to;
  }
  if (std::abs(known.lateral_shift) > wrc::negligible_length) { // a sum may leave rounding for 0
    options.lateral_shift = known.lateral_shift;
  }
  return options;
}

void store(double* where, double value) {
  if (where != nullptr) {
    *where = value;
  }
}

} // namespace

extern "C" {

const char* wrc_profile_standard_name(int32_t kind, int64_t index) {
  if (kind != WRC_WHEEL && kind != WRC_RAIL) {
    return nullptr;
  }
  try {
    const auto names = wrc::standard_profile_names(kind == WRC_RAIL ? wrc::ProfileKind::rail
                                                                    : wrc::ProfileKind::wheel);
    // The names are string literals, so each view ends with a zero byte.
    return index >= 0 && index < static_cast<int64_t>(names.size())
               ? names[static_cast<std::size_t>(index)].data()
               : nullptr;
  } catch (...) {
    return nullptr;
  }
}

wrc_status wrc_profile_create(wrc_profile** profile) {
  return wrc::create(profile);
}

void wrc_profile_destroy(wrc_profile* profile) {
  wrc::destroy(profile);
}

const char* wrc_profile_error(const wrc_profile* profile) {
  return wrc::error_of(profile);
}

wrc_status wrc_profile_load_standard(wrc_profile* profile, const char* name) {
  return wrc::guard(profile, [&](wrc::ProfileObject& object) {
    wrc::require_pointer(name, "name");
    wrc::ReadResult read; // may run out of memory, taking it in does not
    read.profile = wrc::standard_profile(name);
    object.take(std::move(read));
    return WRC_OK;
  });
}

wrc_status wrc_profile_load_file(wrc_profile* profile, const char* path,
                                 const wrc_read_options* options) {
  return wrc::guard(profile, [&](wrc::ProfileObject& object) {
    wrc::require_pointer(path, "path");
    object.take(wrc::read_profile(path, options_from(options)));
    return WRC_OK;
  });
}

wrc_status wrc_profile_set_points(wrc_profile* profile, const char* name, const double* lateral,
                                  const double* height, int64_t count,
                                  const wrc_read_options* options) {
  return wrc::guard(profile, [&](wrc::ProfileObject& object) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(lateral, "lateral");
    wrc::require_pointer(height, "height");
    wrc::require_pointer(options, "options");
    constexpr auto most = static_cast<int64_t>(wrc::ReadLimits::max_points);
    if (count < 1 || count > most) {
      wrc::throw_invalid_argument("count", std::to_string(count),
                                  "must be between 1 and " + std::to_string(most));
    }
    const wrc::ReadOptions given = options_from(options);
    if (!given.kind) {
      wrc::throw_invalid_argument("kind_given", 0.0, "the kind of a profile must be given");
    }
    std::vector<wrc::Position> points;
    for (int64_t i = 0; i < count; ++i) {
      points.push_back({lateral[i], height[i]});
    }
    object.take(wrc::profile_through(points, name, given));
    return WRC_OK;
  });
}

wrc_status wrc_profile_write(wrc_profile* profile, const char* path, double spacing) {
  return with_profile(profile, [&](wrc::ProfileObject&, const wrc::Profile& loaded) {
    wrc::require_pointer(path, "path");
    wrc::write_profile(loaded, path, spacing);
    return WRC_OK;
  });
}

wrc_status wrc_profile_kind(wrc_profile* profile, int32_t* kind) {
  return with_profile(profile, [&](wrc::ProfileObject&, const wrc::Profile& loaded) {
    wrc::require_pointer(kind, "kind");
    *kind = loaded.kind == wrc::ProfileKind::wheel ? WRC_WHEEL : WRC_RAIL;
    return WRC_OK;
  });
}

wrc_status wrc_profile_text(wrc_profile* profile, const char* name, const char** value) {
  return with_profile(profile, [&](wrc::ProfileObject&, const wrc::Profile& loaded) {
    wrc::require_pointer(name, "name");
    wrc::require_pointer(value, "value");
    const std::string_view requested = name;
    if (requested == "name") {
      *value = loaded.name.c_str();
    } else if (requested == "title") {
      *value = loaded.title.c_str();
    } else if (requested == "source") {
      *value = loaded.source.c_str();
    } else if (requested == "confidence") {
      *value = loaded.confidence.c_str();
    } else {
      throw wrc::Error(wrc::ErrorCode::unknown_name,
                       "no text of a profile is named \"" + std::string(requested) +
                           "\"; there are name, title, source, confidence");
    }
    return WRC_OK;
  });
}

const char* wrc_profile_correction(const wrc_profile* profile, int64_t index) {
  return wrc::look_at<const char*>(profile, nullptr, [index](const wrc::ProfileObject& object) {
    return wrc::line_of(object.read.corrections, index);
  });
}

const char* wrc_profile_warning(const wrc_profile* profile, int64_t index) {
  return wrc::look_at<const char*>(profile, nullptr, [index](const wrc::ProfileObject& object) {
    return object.profile && index >= 0 &&
                   index < static_cast<std::int64_t>(object.profile->warnings.size())
               ? object.profile->warnings[static_cast<std::size_t>(index)].text.c_str()
               : nullptr;
  });
}

wrc_status wrc_profile_points(wrc_profile* profile, int32_t which, double* lateral, double* height,
                              int64_t capacity, int64_t* count) {
  return with_profile(profile, [&](wrc::ProfileObject& object, const wrc::Profile&) {
    if (which != WRC_POINTS_READ && which != WRC_POINTS_DROPPED) {
      wrc::throw_invalid_argument("which", which, "must be WRC_POINTS_READ or WRC_POINTS_DROPPED");
    }
    const std::vector<wrc::Position>& points =
        which == WRC_POINTS_READ ? object.read.measured : object.read.dropped;
    std::vector<double> values(points.size());
    wrc_status status = WRC_OK;
    for (std::size_t coordinate = 0; coordinate < 2 && status == WRC_OK; ++coordinate) {
      std::transform(points.begin(), points.end(), values.begin(),
                     [coordinate](const wrc::Position& point) { return point[coordinate]; });
      status = wrc::copy_values(values.data(), values.size(), coordinate == 0 ? lateral : height,
                                capacity, count, object.error);
    }
    return status;
  });
}

wrc_status wrc_profile_load_surface(wrc_profile* profile, const char* path,
                                    const wrc_read_options* options, double smoothing_length,
                                    int64_t* sheets) {
  return wrc::guard(profile, [&](wrc::ProfileObject& object) {
    wrc::require_pointer(path, "path");
    wrc::require_pointer(sheets, "sheets");
    if (!std::isfinite(smoothing_length)) {
      wrc::throw_invalid_argument("smoothing_length", smoothing_length, "a finite number");
    }
    wrc::ProfileSurface surface(path, options_from(options),
                                smoothing_length < 0.0 ? std::nullopt
                                                       : std::optional(smoothing_length));
    object.surface_lines = surface.summary();
    object.surface = std::move(surface);
    *sheets = static_cast<std::int64_t>(object.surface->sheets().size());
    return WRC_OK;
  });
}

const char* wrc_profile_surface_line(const wrc_profile* profile, int64_t index) {
  return wrc::look_at<const char*>(profile, nullptr, [index](const wrc::ProfileObject& object) {
    return wrc::line_of(object.surface_lines, index);
  });
}

wrc_status wrc_profile_surface_at(wrc_profile* profile, int64_t sheet, double across, double along,
                                  double* place, double* lateral, double* height) {
  return wrc::guard(profile, [&](wrc::ProfileObject& object) -> wrc_status {
    if (!object.surface) {
      object.error = "no surface has been loaded into the handle";
      return WRC_NO_RESULT;
    }
    const auto count = static_cast<std::int64_t>(object.surface->sheets().size());
    if (sheet < 0 || sheet >= count) {
      wrc::throw_invalid_argument("sheet", static_cast<double>(sheet),
                                  "must be between 0 and " + std::to_string(count - 1));
    }
    for (const double share : {across, along}) {
      if (!(share >= 0.0 && share <= 1.0)) {
        wrc::throw_invalid_argument("across or along", share, "must be between 0 and 1");
      }
    }
    const wrc::SurfaceSheet& of = object.surface->sheets()[static_cast<std::size_t>(sheet)];
    const wrc::Stretch range = of.across();
    const double x = of.place_at(along);
    const wrc::Position at = of.at(range.begin + across * (range.end - range.begin), x).at;
    store(place, x);
    store(lateral, at[0]);
    store(height, at[1]);
    return WRC_OK;
  });
}

wrc_status wrc_profile_length(wrc_profile* profile, double* length) {
  return with_profile(profile, [&](wrc::ProfileObject&, const wrc::Profile& loaded) {
    wrc::require_pointer(length, "length");
    *length = loaded.curve.length();
    return WRC_OK;
  });
}

wrc_status wrc_profile_nodes(wrc_profile* profile, double* arcs, int64_t capacity, int64_t* count) {
  return with_profile(profile, [&](wrc::ProfileObject& object, const wrc::Profile& loaded) {
    const auto starts = loaded.curve.starts();
    return wrc::copy_values(starts.data(), starts.size(), arcs, capacity, count, object.error);
  });
}

wrc_status wrc_profile_at(wrc_profile* profile, double arc, double* lateral, double* height,
                          double* angle, double* curvature) {
  return with_profile(profile, [&](wrc::ProfileObject&, const wrc::Profile& loaded) {
    if (!std::isfinite(arc)) {
      wrc::throw_invalid_argument("arc", arc, "a finite arc length, mm");
    }
    const wrc::CurvePoint point = loaded.curve.at(arc);
    store(lateral, point.lateral);
    store(height, point.height);
    store(angle, std::atan2(point.tangent_height, point.tangent_lateral));
    store(curvature, point.curvature());
    return WRC_OK;
  });
}
}
