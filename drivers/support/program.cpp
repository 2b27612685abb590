#include "support/program.hpp"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>

#include <CLI/CLI.hpp>

#include "support/output_file.hpp"
#include "support/scene.hpp"

namespace driver {
namespace {

/// The exit code, or 1 with a line on stderr if what was printed could not be written.
int printed(const std::string& program, int code) {
  std::cout.flush();
  if (std::cout) {
    return code;
  }
  std::cerr << program << ": cannot write to the standard output: " << is_disk_full << '\n';
  return 1;
}

/// The arguments, the last first as CLI11 takes them, with --set before each of several assignments
/// that follow one. What contains = and is no file is an assignment.
std::vector<std::string> arguments_of(int argc, char** argv) {
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

} // namespace

Option& Option::type(const std::string& word) {
  option_->type_name(word);
  return *this;
}

Option& Option::show_default() {
  option_->capture_default_str();
  return *this;
}

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::one_value_each() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::within(int least, int greatest) {
  option_->check(CLI::Range(least, greatest));
  return *this;
}

Option& Option::within(double least, double greatest) {
  option_->check(CLI::Range(least, greatest));
  return *this;
}

Option& Option::positive() {
  option_->check(CLI::PositiveNumber);
  return *this;
}

Option& Option::not_negative() {
  option_->check(CLI::NonNegativeNumber);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}

Option& Option::existing_folder() {
  option_->check(CLI::ExistingDirectory);
  return *this;
}

Option& Option::check(const std::function<std::string(const std::string&)>& why_not) {
  option_->check(CLI::Validator(why_not, ""));
  return *this;
}

Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}

Program::Program(const std::string& name, const std::string& purpose)
    : app_(std::make_unique<CLI::App>(purpose, name)) {}

Program::~Program() = default;

template <class Value>
Option Program::add(const std::string& name, Value& value, const std::string& meaning) {
  return Option(app_->add_option(name, value, meaning));
}
template Option Program::add(const std::string&, std::string&, const std::string&);
template Option Program::add(const std::string&, std::vector<std::string>&, const std::string&);
template Option Program::add(const std::string&, double&, const std::string&);
template Option Program::add(const std::string&, std::optional<double>&, const std::string&);
template Option Program::add(const std::string&, int&, const std::string&);
template Option Program::add(const std::string&, std::optional<int>&, const std::string&);
template Option Program::add(const std::string&, std::int64_t&, const std::string&);
template Option Program::add(const std::string&, std::uint64_t&, const std::string&);

Option Program::flag(const std::string& name, bool& value, const std::string& meaning) {
  return Option(app_->add_flag(name, value, meaning));
}

void Program::group(const std::string& heading) {
  app_->option_defaults()->group(heading);
}

void Program::footer(const std::string& text) {
  app_->footer(text);
}

bool Program::has(const std::string& name) const {
  return app_->count(name) > 0;
}

int Program::run(int argc, char** argv, const std::function<int()>& work) {
  const std::string name = app_->get_name();
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    app_->set_version_flag("--version", std::string("wrcontact ") + wrc_version());
    app_->parse(arguments_of(argc, argv));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return printed(name, app_->exit(error));
    }
    std::cerr << name << ": " << error.what() << " (see " << name << " --help)\n";
    return 2;
  }
  try {
    return printed(name, work());
  } catch (const std::exception& error) {
    std::cerr << name << ": " << one_line(error.what()) << '\n';
    return 1;
  }
}

std::optional<double> number_in(const std::string& text) {
  double value = 0.0;
  return CLI::detail::lexical_cast(text, value) ? std::optional(value) : std::nullopt;
}

} // namespace driver
