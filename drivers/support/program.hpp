/// What every driver's main function does: options, then the work, and failures in one line.
#pragma once

#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "wrcontact.h"

namespace driver {

/// The exit code, or 1 with a line on stderr if what was printed could not be written.
inline int printed(const std::string& program, int code) {
  std::cout.flush();
  if (std::cout) {
    return code;
  }
  std::cerr << program << ": cannot write to the standard output: is the disk full?\n";
  return 1;
}

/// Parses the options and does the work. Exit codes: that of the work; 1 if it throws, or if its
/// output is lost; 2 for wrong options. Failures are one line on stderr that starts with the
/// program's name.
template <class Work> int run_program(CLI::App& app, int argc, char** argv, Work work) {
  try {
    app.set_version_flag("--version", std::string("wrcontact ") + wrc_version());
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return printed(app.get_name(), app.exit(error));
    }
    std::cerr << app.get_name() << ": " << error.what() << " (see " << app.get_name()
              << " --help)\n";
    return 2;
  }
  try {
    return printed(app.get_name(), work());
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
    return 1;
  }
}

} // namespace driver
