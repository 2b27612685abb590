/// Makes a table of contact forces from solutions of the library, and measures its error.
///
/// Nodes are solved at an accuracy of forces of 1e-3. Then random states are drawn in each cell of
/// the map of errors, with creepages from a twentieth to ten times what slides in linear theory,
/// and compared with the full theory; the largest error of a cell is that of the map. A second
/// sample sets one factor of the map, a third tells how often it is exceeded. The result does not
/// depend on the number of threads. Thread rule: starts threads of its own.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scene/solve_scene.hpp"
#include "table/contact_table.hpp"
#include "table/table_options.hpp"

namespace wrc {

/// A table of the scene's wheels, rails and materials; its position, loads and motion do not
/// matter, and its friction is that of states without one. Throws Error(invalid_argument) that
/// names the key or the option, those of FinishedTasks, Error(no_contact) where the ranges reach
/// beyond the rail, and what `progress` throws.
ContactTable build_table(const Scene& scene, const TableOptions& options,
                         const SceneSolver& solver);

/// A random state in a cell of the map, the same for the same number.
TableState random_state(const ContactTable& table, std::size_t cell, std::uint64_t number);

} // namespace wrc
