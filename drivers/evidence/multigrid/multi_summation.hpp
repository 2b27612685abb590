/// u = K q by multi-level multi-summation.
///
///   u_i = sum_j K(i - j) q_j
/// (Brandt & Lubrecht, J. Comput. Phys. 90 (1990) 348-370). Away from its centre K is smooth, and
/// interpolated from every other element along and across, first in j, then in i:
///   1. Q = transposed interpolation of q;              on the coarser points, recursively:
///   2. U_I = sum_J K(2I - 2J) Q_J + sum_{|d| <= m} C(d) q_j,   d = 2I - j
///   3. u_i = interpolation of U at i + sum_{|d| <= m} C_i(d) q_j,   d = i - j
/// with C = K less K interpolated at d: 0 where an element coincides with a coarser one, and what
/// it leaves beyond m is the error. Interpolation is Lagrange's, of even order, always central: the
/// coarser grids reach beyond the finer ones, so no border needs a rule of its own. On the coarsest
/// points the sum is taken as it stands. The error of a level at its own wavelengths is a fixed
/// fraction of K(0), so one order and one reach serve every size.
/// Units: those of K. Thread rule: one object serves one thread at a time.
#pragma once

#include <vector>

#include "half_space/influence_coefficients.hpp"
#include "multigrid/product.hpp"

namespace multigrid {

/// Up to this number of points along the longer side, the sum is taken as it stands. (Grids reach
/// beyond each other by the order less one, so they do not shrink for ever.)
/// origin: reasoned: about where coarser grids stop being smaller.
inline constexpr std::size_t longest_summed_side = 24;

struct SummationAccuracy {
  int order = 6; ///< of interpolation, even
  int reach = 6; ///< m, elements
};

class MultiSummation : public Product {
public:
  MultiSummation(std::size_t rows, std::size_t columns, const wrc::InfluenceKernel& kernel,
                 const SummationAccuracy& accuracy);
  void apply(const double* from, double* to) override;
  [[nodiscard]] double operations() const override;

private:
  struct Term {
    int rows;
    int columns;
    double factor;
  };
  /// Values of one level, rows after one another.
  struct Field {
    int rows = 0;
    int columns = 0;
    std::vector<double> values;
    Field(int row_count, int column_count)
        : rows(row_count), columns(column_count),
          values(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(column_count)) {}
    [[nodiscard]] double* row(int index) {
      return values.data() + static_cast<std::ptrdiff_t>(index) * columns;
    }
  };
  struct Level {
    Field q;
    Field u;
    Field across;             ///< between interpolation along and across
    std::vector<Term> near;   ///< C of step 2
    std::vector<Term> odd[3]; ///< C_i of step 3: odd along, odd across, odd both
  };
  /// Elements of a level: from `first`, every other one, `count` of them.
  struct Every {
    int first;
    int count;
  };

  void add_levels(const wrc::InfluenceKernel& kernel);
  [[nodiscard]] std::vector<Term> correction(const wrc::InfluenceKernel& kernel, int spacing,
                                             const bool* odd) const;
  void coarsen(Level& fine, Level& coarse);
  void interpolate(Level& coarse, Level& fine);
  void split(const Field& field);
  void correct(const std::vector<Term>& terms, const Every& rows, const Every& columns, double* out,
               std::ptrdiff_t row_pitch, std::ptrdiff_t pitch) const;
  void sum_directly(Level& level) const;

  int order_;
  int reach_;
  int border_;                    ///< zeros around a level's q when it is split
  std::vector<double> weights_;   ///< of the coarser points around one halfway between them
  std::vector<Level> levels_;     ///< finest first
  std::vector<double> all_;       ///< K on the coarsest points
  std::vector<double> halves_[2]; ///< even and odd columns of a level's q
  std::ptrdiff_t half_pitch_ = 0;
};

} // namespace multigrid
