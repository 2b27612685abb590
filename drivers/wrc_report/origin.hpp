/// Where a report comes from: when, by which program and command, and of which files.
#pragma once

#include <string>
#include <vector>

namespace driver {

/// The date and time in UTC: now, or, for pages that can be made again, that of the variable
/// SOURCE_DATE_EPOCH (reproducible-builds.org).
std::string date_text();

/// The command as a shell takes it, with the name of the program only.
std::string command_text(int argc, char** argv);

/// A file with its SHA-256 checksum, or that a profile is built in.
std::string origin_text(const std::string& subject, const std::string& name);

} // namespace driver
