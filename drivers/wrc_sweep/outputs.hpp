/// The results of a finished study as files, written aside and then renamed.
#pragma once

#include <filesystem>

#include "wrc_sweep/journal.hpp"

namespace driver {

/// One line a scene: its number, the keys that vary, status, message, results. Fields are not in
/// it.
void write_csv(const Study& study, Journal& journal, const std::filesystem::path& path);
/// NetCDF-4 (HDF5): a dimension for each key that varies, a variable for each result; fields of all
/// patches one after the other, as a contiguous ragged array of the CF conventions.
void write_netcdf(const Study& study, Journal& journal, const std::filesystem::path& path);

} // namespace driver
