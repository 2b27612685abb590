#include "support/text_table.hpp"

#include <algorithm>

namespace driver {

void TextTable::print(std::ostream& out) const {
  std::vector<std::size_t> widths = widths_;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      // What stands last in a row may reach as far as it likes.
      const bool free = i + 1 == row.size() && sides_[std::min(i, sides_.size() - 1)] == 'l';
      widths[i] = std::max(widths[i], free ? 0 : row[i].size() + (i > 0 ? 2 : 0));
    }
  }
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::size_t gap = i > 0 ? 2 : 0;
      const std::string blanks(widths[i] - std::min(widths[i], row[i].size() + gap), ' ');
      const bool left = sides_[std::min(i, sides_.size() - 1)] == 'l';
      line += std::string(gap, ' ') + (left ? row[i] + blanks : blanks + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

} // namespace driver
