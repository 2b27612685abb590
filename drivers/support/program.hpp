/// What every driver's main function does: options, then the work, and failures in one line.
#pragma once

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/output_file.hpp"
#include "support/scene.hpp"

namespace driver {

/// The exit code, or 1 with a line on stderr if what was printed could not be written.
inline int printed(const std::string& program, int code) {
  std::cout.flush();
  if (std::cout) {
    return code;
  }
  std::cerr << program << ": cannot write to the standard output: " << is_disk_full << '\n';
  return 1;
}

/// The arguments, the last first as CLI11 takes them, with --set before each of several assignments
/// that follow one. What contains = and is no file is an assignment.
inline std::vector<std::string> arguments_of(int argc, char** argv) {
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    std::error_code is_no_name; // an assignment may be longer than any file's name
    const bool follows = arguments.size() > 1 && arguments.end()[-2] == "--set";
    if (follows && !text.starts_with('-') && text.find('=') != std::string::npos &&
        !std::filesystem::exists(text, is_no_name)) {
      arguments.emplace_back("--set");
    }
    arguments.push_back(text);
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

/// Parses the options and does the work. Exit codes: that of the work; 1 if it throws, or if its
/// output is lost; 2 for wrong options. Failures are one line on stderr that starts with the
/// program's name. A file that reaches a limit of its size is such a failure, not a signal.
template <class Work> int run_program(CLI::App& app, int argc, char** argv, Work work) {
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    app.set_version_flag("--version", std::string("wrcontact ") + wrc_version());
    app.parse(arguments_of(argc, argv));
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
    std::cerr << app.get_name() << ": " << one_line(error.what()) << '\n';
    return 1;
  }
}

} // namespace driver
