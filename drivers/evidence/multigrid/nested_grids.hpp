/// Grids from the finest to one of at most 8 elements a side, and the state of an iteration on
/// each.
///
/// What conjugate gradients and multigrid share, so that only the method differs: the grids of the
/// library's cascade, elimination on the coarsest one, pressures refined by p^2 (cascade.hpp), one
/// estimate of the error to stop by (z, below), and one way to cut pressures below 0.
/// Thread rule: one object serves one thread at a time.
#pragma once

#include <memory>
#include <vector>

#include "multigrid/problems.hpp"
#include "multigrid/product.hpp"

namespace multigrid {

/// Longest side of the coarsest grid.
/// origin: reasoned: elimination costs next to nothing there.
inline constexpr std::size_t coarsest_side = 8;
/// As in the library's solver: the error at which coarser grids are left, and the fraction of the
/// tolerance at which the iteration stops before its free step.
/// origin: reasoned: those of the library's solver (mechanics/constants.hpp).
inline constexpr double coarse_tolerance = 1e-2;
inline constexpr double stop_share = 0.75;

struct Answer {
  std::vector<double> q;
  int iterations = 0;      ///< or cycles, or exchanges; on the finest grid
  int products = 0;        ///< on the finest grid
  double operations = 0.0; ///< on all grids
  double estimate = 0.0;   ///< of the error when it stopped; relative to the largest pressure
};

/// What belongs to a size of grid, computed before anything is timed.
struct GridTools {
  std::unique_ptr<Product> product;
  std::unique_ptr<Product> preconditioner; ///< periodic inverse
  std::shared_ptr<const wrc::InfluenceTable> table;
  std::vector<double> mirrored; ///< K along rows, both ways
};
using MakeProduct = std::unique_ptr<Product> (*)(std::size_t rows, std::size_t columns,
                                                 const wrc::InfluenceKernel& kernel,
                                                 wrc::InfluenceCache& cache);
std::vector<GridTools> make_tools(const Problem& finest, MakeProduct make_product,
                                  wrc::InfluenceCache& cache);

/// An iteration on one grid.
class ContactState {
public:
  ContactState(const Problem& problem, GridTools& tools, std::vector<double> start, Answer& tally);

  /// Approach, by least squares over q > 0; C = {q > 0 or r > 0}; r = approach - h - u on C.
  void form_residual();
  /// z = M r on C less its mean, M the periodic inverse. Returns max|z| / max q.
  double estimate();
  /// q += step v, u += step K v; what falls below 0 is cut, and taken out of u; scaled to the load.
  void move(const std::vector<double>& v, const std::vector<double>& response, double step);
  /// The free step: q = max(0, q + z).
  std::vector<double> finish();
  void apply(const std::vector<double>& from, std::vector<double>& to);

  std::vector<double> q;
  std::vector<double> u;
  std::vector<double> r;
  std::vector<double> z;
  std::vector<double> contact; ///< 1 on C, 0 elsewhere

private:
  void cut();

  const Problem& problem_;
  GridTools& tools_;
  Answer& tally_;
};

/// q on the next finer grid.
std::vector<double> refined(const Problem& coarse, const std::vector<double>& q,
                            const Problem& fine);

/// Grids of a problem, finest first.
std::vector<Problem> coarsened(const Problem& finest);

/// Takes the mean over contact off, and sets 0 outside. Returns the largest absolute value left.
double keep_load(std::vector<double>& values, const std::vector<double>& contact);

double dot(const std::vector<double>& one, const std::vector<double>& other);

} // namespace multigrid
