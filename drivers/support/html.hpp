/// A page for a browser that holds all it shows: texts, tables, pictures.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace driver {

/// A text as content of an element or value of an attribute in quotes. Every text that is not part
/// of the source of a program goes through here: it cannot begin an element, a character reference
/// or another attribute. Control characters become blanks.
std::string html_text(const std::string& text);

/// Elements below each other. The page may load and run nothing, whatever its texts are: img runs
/// no script within a picture, and the policy of report_head.html forbids all others.
class HtmlPage {
public:
  explicit HtmlPage(const std::string& title);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void list(const std::vector<std::string>& items);
  /// The first row has the titles. Numbers stand to the right, texts to the left, "fail" in red.
  void table(const std::vector<std::vector<std::string>>& rows);
  /// A .png or .svg file becomes part of the page; `meaning` is for those who cannot see it.
  void picture(const std::filesystem::path& file, const std::string& meaning);

  [[nodiscard]] std::string text() const;

private:
  std::ostringstream out_;
};

} // namespace driver
