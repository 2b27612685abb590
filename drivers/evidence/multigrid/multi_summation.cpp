#include "multigrid/multi_summation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "base/vector_clones.hpp"

namespace multigrid {
namespace {

/// Outputs summed at once.
/// origin: reasoned: they stay in registers of any instruction set.
constexpr int block = 16;

double kernel_at(const wrc::InfluenceKernel& kernel, int rows, int columns) {
  return std::numbers::pi * wrc::influence_coefficient(columns, rows * kernel.aspect, 1.0,
                                                       kernel.aspect, 1.0, kernel.elements);
}

/// Lagrange's weights halfway between points at odd distances.
std::vector<double> halfway_weights(int order) {
  std::vector<double> weights;
  for (int i = 0; i < order; ++i) {
    double weight = 1.0;
    for (int k = 0; k < order; ++k) {
      weight *= k == i ? 1.0 : static_cast<double>(order - 1 - 2 * k) / (2.0 * (i - k));
    }
    weights.push_back(weight);
  }
  return weights;
}

struct Lines {
  const double* halves[2]; ///< of the element at row 0 and column 0
  std::ptrdiff_t pitch;
};

/// One row of outputs, at columns first + 2 k.
template <class Term>
WRC_VECTOR_BODY void correct_row(const Term* terms, std::size_t term_count, const Lines& lines,
                                 int row, int first, int count, double* out, std::ptrdiff_t pitch) {
  for (int start = 0; start < count; start += block) {
    double sum[block] = {};
    for (std::size_t t = 0; t < term_count; ++t) {
      const int column = first - terms[t].columns + 2 * start;
      const double* from = lines.halves[column & 1] + (row - terms[t].rows) * lines.pitch +
                           ((column - (column & 1)) / 2);
      const double factor = terms[t].factor;
#pragma omp simd
      for (int k = 0; k < block; ++k) {
        sum[k] += factor * from[k];
      }
    }
    const int end = std::min(block, count - start);
    for (int k = 0; k < end; ++k) {
      out[(start + k) * pitch] += sum[k];
    }
  }
}

template <class Term>
WRC_VECTOR_CLONES void correct_rows(const Term* terms, std::size_t term_count, const Lines& lines,
                                    int first_row, int rows, int first, int count, double* out,
                                    std::ptrdiff_t row_pitch, std::ptrdiff_t pitch) {
  for (int i = 0; i < rows; ++i) {
    correct_row(terms, term_count, lines, first_row + 2 * i, first, count, out + i * row_pitch,
                pitch);
  }
}

} // namespace

MultiSummation::MultiSummation(std::size_t rows, std::size_t columns,
                               const wrc::InfluenceKernel& kernel,
                               const SummationAccuracy& accuracy)
    : order_(accuracy.order), reach_(accuracy.reach),
      border_((accuracy.reach + 2 * accuracy.order + 2) / 2 * 2),
      weights_(halfway_weights(accuracy.order)) {
  const auto level = [](int level_rows, int level_columns) {
    return Level{{level_rows, level_columns}, {level_rows, level_columns}, {0, 0}, {}, {}};
  };
  levels_.push_back(level(static_cast<int>(rows), static_cast<int>(columns)));
  const auto half = [this](int count) { return (count + 1) / 2 + order_ - 1; };
  while (std::max(levels_.back().q.rows, levels_.back().q.columns) >
         static_cast<int>(longest_summed_side)) {
    Level& fine = levels_.back();
    fine.across = Field(fine.q.rows, half(fine.q.columns));
    levels_.push_back(level(half(fine.q.rows), half(fine.q.columns)));
  }
  add_levels(kernel);
}

void MultiSummation::add_levels(const wrc::InfluenceKernel& kernel) {
  int spacing = 1;
  for (std::size_t k = 0; k + 1 < levels_.size(); ++k, spacing *= 2) {
    constexpr bool classes[3][2] = {{false, true}, {true, false}, {true, true}};
    for (std::size_t c = 0; c < 3; ++c) {
      levels_[k].odd[c] = correction(kernel, spacing, classes[c]);
    }
    levels_[k].near = correction(kernel, spacing, nullptr);
  }
  const Field& last = levels_.back().q;
  for (int i = 1 - last.rows; i < last.rows; ++i) {
    for (int j = 1 - last.columns; j < last.columns; ++j) {
      all_.push_back(kernel_at(kernel, std::abs(i * spacing), std::abs(j * spacing)));
    }
  }
}

/// Where `odd` (across, along) is not given, d itself tells what is interpolated.
std::vector<MultiSummation::Term> MultiSummation::correction(const wrc::InfluenceKernel& kernel,
                                                             int spacing, const bool* odd) const {
  const int side = reach_ + order_;
  std::vector<double> table; // K at distances of a quadrant
  for (int i = 0; i <= side; ++i) {
    for (int j = 0; j <= side; ++j) {
      table.push_back(kernel_at(kernel, i * spacing, j * spacing));
    }
  }
  const auto at = [&](int i, int j) {
    const auto row = static_cast<std::size_t>(std::abs(i));
    return table[row * static_cast<std::size_t>(side + 1) + static_cast<std::size_t>(std::abs(j))];
  };
  std::vector<Term> terms;
  for (int i = -reach_; i <= reach_; ++i) {
    for (int j = -reach_; j <= reach_; ++j) {
      const bool odd_row = odd != nullptr ? odd[0] : (i & 1) != 0;
      const bool odd_column = odd != nullptr ? odd[1] : (j & 1) != 0;
      if (!odd_row && !odd_column) {
        continue;
      }
      double interpolated = 0.0;
      for (int a = 0; a < (odd_row ? order_ : 1); ++a) {
        for (int b = 0; b < (odd_column ? order_ : 1); ++b) {
          const int row = odd_row ? i + 2 * a - order_ + 1 : i;
          const int column = odd_column ? j + 2 * b - order_ + 1 : j;
          interpolated += (odd_row ? weights_[static_cast<std::size_t>(a)] : 1.0) *
                          (odd_column ? weights_[static_cast<std::size_t>(b)] : 1.0) *
                          at(row, column);
        }
      }
      terms.push_back({i, j, at(i, j) - interpolated});
    }
  }
  return terms;
}

/// Step 1. Element i = 2k of the finer level is element k + order/2 - 1 of the coarser one.
void MultiSummation::coarsen(Level& fine, Level& coarse) {
  const int before = order_ / 2 - 1;
  std::fill(fine.across.values.begin(), fine.across.values.end(), 0.0);
  std::fill(coarse.q.values.begin(), coarse.q.values.end(), 0.0);
  for (int i = 0; i < fine.q.rows; ++i) {
    const double* from = fine.q.row(i);
    double* to = fine.across.row(i);
    for (int j = 0; j < fine.q.columns; j += 2) {
      to[j / 2 + before] += from[j];
    }
    for (int a = 0; a < order_; ++a) {
      const double weight = weights_[static_cast<std::size_t>(a)];
      for (int j = 1; j < fine.q.columns; j += 2) {
        to[j / 2 + a] += weight * from[j];
      }
    }
    for (int a = 0; a < ((i & 1) != 0 ? order_ : 1); ++a) {
      const double weight = (i & 1) != 0 ? weights_[static_cast<std::size_t>(a)] : 1.0;
      double* sum = coarse.q.row(i / 2 + ((i & 1) != 0 ? a : before));
      for (int j = 0; j < fine.across.columns; ++j) {
        sum[j] += weight * to[j];
      }
    }
  }
}

void MultiSummation::interpolate(Level& coarse, Level& fine) {
  const int before = order_ / 2 - 1;
  for (int i = 0; i < fine.u.rows; ++i) {
    double* line = fine.across.row(i);
    std::fill_n(line, fine.across.columns, 0.0);
    for (int a = 0; a < ((i & 1) != 0 ? order_ : 1); ++a) {
      const double weight = (i & 1) != 0 ? weights_[static_cast<std::size_t>(a)] : 1.0;
      const double* from = coarse.u.row(i / 2 + ((i & 1) != 0 ? a : before));
      for (int j = 0; j < fine.across.columns; ++j) {
        line[j] += weight * from[j];
      }
    }
    double* to = fine.u.row(i);
    for (int j = 0; j < fine.u.columns; ++j) {
      to[j] = (j & 1) != 0 ? 0.0 : line[j / 2 + before];
    }
    for (int a = 0; a < order_; ++a) {
      const double weight = weights_[static_cast<std::size_t>(a)];
      for (int j = 1; j < fine.u.columns; j += 2) {
        to[j] += weight * line[j / 2 + a];
      }
    }
  }
}

/// Into even and odd columns, between zeros.
void MultiSummation::split(const Field& field) {
  half_pitch_ = (field.columns + 2 * border_) / 2 + 2 * block;
  const auto size = static_cast<std::size_t>(half_pitch_ * (field.rows + 2 * border_));
  for (std::vector<double>& half : halves_) {
    half.assign(size, 0.0);
  }
  for (int i = 0; i < field.rows; ++i) {
    const double* from = field.values.data() + static_cast<std::ptrdiff_t>(i) * field.columns;
    const std::ptrdiff_t start = (i + border_) * half_pitch_ + border_ / 2;
    for (int j = 0; j < field.columns; ++j) {
      halves_[j & 1][static_cast<std::size_t>(start + j / 2)] = from[j];
    }
  }
}

void MultiSummation::correct(const std::vector<Term>& terms, const Every& rows,
                             const Every& columns, double* out, std::ptrdiff_t row_pitch,
                             std::ptrdiff_t pitch) const {
  const std::ptrdiff_t origin = border_ * half_pitch_ + border_ / 2;
  correct_rows(terms.data(), terms.size(),
               {{halves_[0].data() + origin, halves_[1].data() + origin}, half_pitch_}, rows.first,
               rows.count, columns.first, columns.count, out, row_pitch, pitch);
}

void MultiSummation::sum_directly(Level& level) const {
  for (int i = 0; i < level.u.rows; ++i) {
    double* to = level.u.row(i);
    std::fill_n(to, level.u.columns, 0.0);
    for (int k = 0; k < level.q.rows; ++k) {
      const double* from = level.q.row(k);
      const double* kernel = all_.data() + static_cast<std::ptrdiff_t>(i - k + level.q.rows - 1) *
                                               (2 * level.q.columns - 1);
      for (int l = 0; l < level.q.columns; ++l) {
        const double* line = kernel + (level.q.columns - 1 - l);
        for (int j = 0; j < level.u.columns; ++j) {
          to[j] += line[j] * from[l];
        }
      }
    }
  }
}

void MultiSummation::apply(const double* from, double* to) {
  std::copy_n(from, levels_.front().q.values.size(), levels_.front().q.values.begin());
  for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
    coarsen(levels_[k], levels_[k + 1]);
  }
  sum_directly(levels_.back());
  for (std::size_t k = levels_.size() - 1; k-- > 0;) {
    Level& fine = levels_[k];
    Level& coarse = levels_[k + 1];
    split(fine.q);
    const int first = 2 - order_; // where the first coarser point lies
    correct(fine.near, {first, coarse.u.rows}, {first, coarse.u.columns}, coarse.u.row(0),
            coarse.u.columns, 1);
    interpolate(coarse, fine);
    const std::ptrdiff_t pitch = fine.u.columns;
    const Every even_rows{0, (fine.u.rows + 1) / 2};
    const Every odd_rows{1, fine.u.rows / 2};
    const Every even_columns{0, (fine.u.columns + 1) / 2};
    const Every odd_columns{1, fine.u.columns / 2};
    double* u = fine.u.row(0);
    correct(fine.odd[0], even_rows, odd_columns, u + 1, 2 * pitch, 2);
    correct(fine.odd[1], odd_rows, even_columns, u + pitch, 2 * pitch, 2);
    correct(fine.odd[2], odd_rows, odd_columns, u + pitch + 1, 2 * pitch, 2);
  }
  std::copy(levels_.front().u.values.begin(), levels_.front().u.values.end(), to);
}

double MultiSummation::operations() const {
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
    const Level& fine = levels_[k];
    const auto count = static_cast<double>(fine.u.values.size());
    const auto coarse = static_cast<double>(levels_[k + 1].u.values.size());
    sum += 2.0 * coarse * static_cast<double>(fine.near.size());
    for (const std::vector<Term>& terms : fine.odd) {
      sum += 0.5 * count * static_cast<double>(terms.size());
    }
    // Along half of the elements, across half of half as many; down and up.
    sum += 2.0 * 2.0 * order_ * (0.5 * count + 0.25 * count);
  }
  const auto last = static_cast<double>(levels_.back().q.values.size());
  return sum + 2.0 * last * last;
}

} // namespace multigrid
