/// A command-line program: its options, its help, and failures in one line.
///
/// Options write into variables of the program, which must live until run() returns. program.cpp is
/// the only file that sees CLI11: a file that does takes seconds longer to compile.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace driver {

/// What else a program says about an option. Copies are of the same option.
class Option {
public:
  explicit Option(CLI::Option* option) : option_(option) {}

  /// The word that stands for the value in the help.
  Option& type(const std::string& word);
  /// The help shows the value that the variable has now.
  Option& show_default();
  Option& required();
  /// Of a list: the option's name comes before each value, not before several.
  Option& one_value_each();

  Option& within(int least, int greatest);
  Option& within(double least, double greatest);
  Option& positive();
  Option& not_negative();
  Option& one_of(const std::vector<std::string>& words);
  Option& existing_folder();
  /// `why_not` of a text is empty, or says why the text is refused.
  Option& check(const std::function<std::string(const std::string&)>& why_not);

  Option& excludes(const Option& other);
  Option& needs(const Option& other);

private:
  CLI::Option* option_;
};

class Program {
public:
  Program(const std::string& name, const std::string& purpose);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// An option with a value, "--name", or an argument without a name of its own, "NAME". A value is
  /// a number, a text or a list of texts: program.cpp lists the types.
  template <class Value>
  Option add(const std::string& name, Value& value, const std::string& meaning);
  /// An option that is there or not.
  Option flag(const std::string& name, bool& value, const std::string& meaning);
  /// The heading in the help of the options that follow.
  void group(const std::string& heading);
  /// What the help says below the options.
  void footer(const std::string& text);

  /// Whether an option was given.
  [[nodiscard]] bool has(const std::string& name) const;

  /// Parses the options and does the work. Exit codes: that of the work; 1 if it throws, or if its
  /// output is lost; 2 for wrong options. Failures are one line on stderr that starts with the
  /// program's name. A file that reaches a limit of its size is such a failure, not a signal.
  /// After --set any number of assignments may follow.
  int run(int argc, char** argv, const std::function<int()>& work);

private:
  std::unique_ptr<CLI::App> app_;
};

/// The number that a text is, read as those of options are.
std::optional<double> number_in(const std::string& text);

} // namespace driver
