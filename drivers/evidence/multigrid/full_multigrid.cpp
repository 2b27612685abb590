/// Full multigrid over the complementarity problem, one V-cycle for each contact set.
///
/// After the idea of Zhao, Vollebregt & Oosterlee (Mathematical Modelling and Analysis 19 (2014)
/// 216-240), of which the abstract was at hand: on each grid, coarsest first, the contact set is
/// taken from pressures and overlaps, one cycle improves the pressures on it, and those below 0 are
/// cut; residual and contact set go to the coarser grids, where all that is outside contact is 0. K
/// is of the first kind: its eigenvalues fall with the wave number, so plain relaxation leaves
/// exactly what coarser grids cannot see. The smoother therefore relaxes second differences
/// (distributive relaxation, Brandt & Lubrecht 1990, Venner & Lubrecht, Multilevel Methods in
/// Lubrication, 2000): z = -(second differences of r), on contact. It is a variant of our own:
/// relaxation is of Jacobi's kind, one DC-FFT product a sweep, and sweeps and corrections go as far
/// as the energy falls (exact line search), which costs no further product and makes each cycle
/// converge on its contact set. Units mm (problems.hpp).
#include <algorithm>
#include <cmath>

#include "mechanics/cascade.hpp"
#include "multigrid/methods.hpp"

namespace multigrid {
namespace {

/// origin: bound: ends what does not converge.
constexpr int most_cycles = 100;
/// Before and after the coarser grids.
/// origin: measured (this program, 64 and 256 elements a side): 0 + 1, 1 + 0 and 0 + 2 take up to
/// 30 % more operations, on one of four problems 5 % less.
constexpr int sweeps = 1;

/// One grid of a cycle.
struct CycleGrid {
  const Problem& problem;
  GridTools& tools;
  std::vector<double> contact;
  std::vector<double> r;
  std::vector<double> e;      ///< correction found
  std::vector<double> change; ///< K e, everywhere
};

class Cycle {
public:
  Cycle(const std::vector<Problem>& problems, std::vector<GridTools>& tools, std::size_t finest,
        Answer& answer)
      : answer_(answer), finest_(finest) {
    for (std::size_t k = 0; k < problems.size(); ++k) {
      grids_.push_back({problems[k], tools[k], {}, {}, {}, {}});
    }
  }

  /// The correction of pressures for the residual on contact.
  CycleGrid& run(const std::vector<double>& contact, const std::vector<double>& r) {
    grids_[finest_].contact = contact;
    grids_[finest_].r = r;
    descend(finest_);
    return grids_[finest_];
  }

private:
  void descend(std::size_t k) {
    CycleGrid& grid = grids_[k];
    if (k + 1 == grids_.size()) {
      grid.e = solve_correction(*grid.tools.table, grid.contact, grid.r, grid.problem.columns(),
                                answer_);
      return;
    }
    grid.e.assign(grid.r.size(), 0.0);
    grid.change.assign(grid.r.size(), 0.0);
    for (int i = 0; i < sweeps; ++i) {
      smooth(grid, k == finest_);
    }
    restrict_to(grid, grids_[k + 1]);
    descend(k + 1);
    prolong(grids_[k + 1], grid);
    go(grid, k == finest_);
    for (int i = 0; i < sweeps; ++i) {
      smooth(grid, k == finest_);
    }
  }

  /// Along step_: without load, as far as the energy falls.
  void go(CycleGrid& grid, bool on_finest) {
    keep_load(step_, grid.contact);
    response_.resize(step_.size());
    grid.tools.product->apply(step_.data(), response_.data());
    answer_.products += on_finest ? 1 : 0;
    answer_.operations +=
        grid.tools.product->operations() + 25.0 * static_cast<double>(step_.size());
    const double energy = dot(step_, response_);
    const double length = energy > 0.0 ? dot(grid.r, step_) / energy : 0.0;
    for (std::size_t i = 0; i < step_.size(); ++i) {
      grid.e[i] += length * step_[i];
      grid.change[i] += length * response_[i];
      grid.r[i] -= grid.contact[i] * length * response_[i];
    }
  }

  void smooth(CycleGrid& grid, bool on_finest) {
    keep_load(grid.r, grid.contact); // a constant belongs to the approach
    const std::size_t rows = grid.problem.rows();
    const std::size_t columns = grid.problem.columns();
    const double aspect = grid.problem.kernel().aspect;
    const double across = 1.0 / (aspect * aspect);
    const auto at = [&](std::size_t i) { return grid.r[i]; };
    step_.assign(grid.r.size(), 0.0);
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        const std::size_t i = row * columns + column;
        if (grid.contact[i] > 0.0) {
          const double along =
              (column > 0 ? at(i - 1) : 0.0) + (column + 1 < columns ? at(i + 1) : 0.0);
          const double beside =
              (row > 0 ? at(i - columns) : 0.0) + (row + 1 < rows ? at(i + columns) : 0.0);
          step_[i] = (2.0 + 2.0 * across) * at(i) - along - across * beside;
        }
      }
    }
    go(grid, on_finest);
  }

  /// Means over elements in contact; two of four make a coarser element one in contact.
  static void restrict_to(const CycleGrid& fine, CycleGrid& coarse) {
    const std::size_t columns = fine.problem.columns();
    const std::size_t half = coarse.problem.columns();
    coarse.r.assign(coarse.problem.count(), 0.0);
    coarse.contact.assign(coarse.problem.count(), 0.0);
    for (std::size_t i = 0; i < fine.r.size(); ++i) {
      const std::size_t to = (i / columns / 2) * half + i % columns / 2;
      coarse.r[to] += fine.r[i];
      coarse.contact[to] += fine.contact[i];
    }
    for (std::size_t i = 0; i < coarse.r.size(); ++i) {
      const bool enough = coarse.contact[i] >= 2.0;
      coarse.r[i] = enough ? coarse.r[i] / coarse.contact[i] : 0.0;
      coarse.contact[i] = enough ? 1.0 : 0.0;
    }
  }

  /// The coarser correction, bilinear, as a step on the finer grid; q counts half as much there.
  void prolong(const CycleGrid& coarse, const CycleGrid& fine) {
    wrc::interpolate(coarse.problem.grid, coarse.e, fine.problem.grid, step_);
    for (double& value : step_) {
      value *= 0.5;
    }
  }

  Answer& answer_;
  std::size_t finest_;
  std::vector<CycleGrid> grids_;
  std::vector<double> step_;
  std::vector<double> response_;
};

std::vector<double> iterate(const std::vector<Problem>& problems, std::vector<GridTools>& tools,
                            std::size_t index, std::vector<double> start, double tolerance,
                            Answer& answer) {
  ContactState state(problems[index], tools[index], std::move(start), answer);
  Cycle cycle(problems, tools, index, answer);
  for (answer.iterations = 0;; ++answer.iterations) {
    state.form_residual();
    answer.estimate = state.estimate();
    if (answer.estimate <= tolerance || answer.iterations == most_cycles) {
      return state.finish();
    }
    const CycleGrid& done = cycle.run(state.contact, state.r);
    state.move(done.e, done.change, 1.0);
  }
}

} // namespace

Answer solve_by_full_multigrid(const Problem& problem, std::vector<GridTools>& tools,
                               double tolerance) {
  const std::vector<Problem> problems = coarsened(problem);
  Answer answer;
  eliminate(problems.back(), *tools.back().table, {}, answer);
  for (std::size_t k = problems.size() - 1; k-- > 0;) {
    answer.products = 0;
    answer.q =
        iterate(problems, tools, k, refined(problems[k + 1], answer.q, problems[k]),
                stop_share * (k > 0 ? std::max(tolerance, coarse_tolerance) : tolerance), answer);
  }
  return answer;
}

} // namespace multigrid
