/// The methods compared, beside the library's own solver. Each starts from the same coarse grids
/// (nested_grids.hpp) and stops at the same estimate of its error.
#pragma once

#include "mechanics/normal_solver.hpp"
#include "multigrid/nested_grids.hpp"

namespace multigrid {

/// Projected, preconditioned conjugate gradients as in the library (mechanics/projected_cg.hpp), on
/// whole grids and in double precision, with products of any kind.
Answer solve_by_gradients(const Problem& problem, std::vector<GridTools>& tools, double tolerance);

/// The library's solver as it is. Counts iterations and products over all grids, no operations.
Answer solve_by_library(const Problem& problem, wrc::NormalSolver& solver, double tolerance);

/// Changes these counts to iterations and products on the finest grid, and operations on all: those
/// on a grid are those of its problem less those of the next coarser one. Products are on boxes
/// around contact, with the preconditioner once an iteration.
void count_library(const Problem& problem, wrc::NormalSolver& solver, double tolerance,
                   Answer& answer);

/// Full multigrid (full_multigrid.cpp).
Answer solve_by_full_multigrid(const Problem& problem, std::vector<GridTools>& tools,
                               double tolerance);

/// Dense Cholesky factors and exchanges of the contact set (elimination.cpp), from coarser grids.
Answer solve_by_elimination(const Problem& problem, std::vector<GridTools>& tools);

/// The same on one grid. Elements with pressure in `start` are the first contact set; none: those
/// at the least distance. Operations and exchanges are added to the answer's.
void eliminate(const Problem& problem, const wrc::InfluenceTable& table,
               const std::vector<double>& start, Answer& answer);

/// K e = r + constant on the elements in contact, sum e = 0; 0 elsewhere.
std::vector<double> solve_correction(const wrc::InfluenceTable& table,
                                     const std::vector<double>& contact,
                                     const std::vector<double>& r, std::size_t columns,
                                     Answer& answer);

} // namespace multigrid
