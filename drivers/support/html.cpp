#include "support/html.hpp"

#include <charconv>
#include <fstream>
#include <iterator>

#include "support/report_head_html.hpp"
#include "support/scene.hpp"

namespace driver {
namespace {

std::string base64(const std::string& bytes) {
  constexpr const char* letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? letters[group >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

bool reads_as_number(const std::string& cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return cell == "-" || (error == std::errc() && end == cell.data() + cell.size());
}

} // namespace

std::string html_text(const std::string& text) {
  std::string out;
  for (const char letter : one_line(text)) {
    switch (letter) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    case '\'':
      out += "&#39;";
      break;
    default:
      out += letter;
    }
  }
  return out;
}

HtmlPage::HtmlPage(const std::string& title) {
  out_ << report_head_html << "<title>" << html_text(title) << "</title>\n<h1>" << html_text(title)
       << "</h1>\n";
}

void HtmlPage::heading(const std::string& text) {
  out_ << "<h2>" << html_text(text) << "</h2>\n";
}

void HtmlPage::paragraph(const std::string& text) {
  out_ << "<p>" << html_text(text) << "</p>\n";
}

void HtmlPage::list(const std::vector<std::string>& items) {
  out_ << "<ul>\n";
  for (const std::string& item : items) {
    out_ << "<li>" << html_text(item) << "</li>\n";
  }
  out_ << "</ul>\n";
}

void HtmlPage::table(const std::vector<std::vector<std::string>>& rows) {
  out_ << "<table>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const char* const cell = i == 0 ? "th" : "td";
    out_ << "<tr>";
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      // A title stands as the first cell below it does.
      const std::string& kind = i == 0 && rows.size() > 1 ? rows[1].at(k) : rows[i][k];
      out_ << '<' << cell
           << (reads_as_number(kind)  ? " class=\"number\">"
               : rows[i][k] == "fail" ? " class=\"fail\">"
                                      : ">")
           << html_text(rows[i][k]) << "</" << cell << '>';
    }
    out_ << "</tr>\n";
  }
  out_ << "</table>\n";
}

void HtmlPage::picture(const std::filesystem::path& file, const std::string& meaning) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty()) {
    throw Failure("cannot read the picture " + file.string());
  }
  out_ << "<img alt=\"" << html_text(meaning) << "\" src=\"data:image/"
       << (file.extension() == ".svg" ? "svg+xml" : "png") << ";base64," << base64(bytes)
       << "\">\n";
}

std::string HtmlPage::text() const {
  return out_.str() + "</html>\n";
}

} // namespace driver
