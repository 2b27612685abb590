#include "rolling/normal_displacement.hpp"

#include "half_space/traction_convolution.hpp"

namespace wrc {

std::vector<double> normal_displacement(const RollingProblem& problem,
                                        std::span<const double> traction_x,
                                        std::span<const double> traction_y, LinePlans& plans) {
  const Grid& grid = problem.grid;
  const std::size_t count = grid.element_count();
  std::vector<double> opened(count);
  // Rows of constant y serve as those of constant x: the roles of x and y are exchanged, and rows
  // are counted from large y.
  const TractionShape shape{grid.lateral_count, grid.longitudinal_count};
  const TractionConvolution<double> convolution(
      shape, shape.columns, {0.0, 1.0, 0.0, 0.0},
      cross_table(grid.longitudinal_step / grid.lateral_step, shape.table_rows(),
                  shape.table_columns()),
      plans);
  std::vector<double> in(2 * count);
  std::vector<double> out(2 * count);
  const auto place = [&](std::size_t at) {
    const std::size_t row = at / shape.columns;
    return (shape.rows - 1 - row) * shape.columns + at % shape.columns;
  };
  for (std::size_t at = 0; at < count; ++at) {
    in[place(at)] = traction_y[at];
    in[count + place(at)] = traction_x[at];
  }
  ConvolutionWorkspace<double> workspace;
  convolution.apply(in.data(), in.data() + count, out.data(), out.data() + count, workspace);
  const double scale = problem.difference_parameter / problem.shear_modulus * grid.lateral_step;
  for (std::size_t at = 0; at < count; ++at) {
    opened[at] = scale * out[place(at)];
  }
  return opened;
}

} // namespace wrc
