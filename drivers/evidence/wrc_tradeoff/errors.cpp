#include "wrc_tradeoff/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tradeoff {
namespace {

using Vector = std::array<double, 3>;

Vector vector_of(const driver::Scene& scene, const std::string& before) {
  return {scene.number(before + 'x'), scene.number(before + 'y'), scene.number(before + 'z')};
}

double relative(double value, double truth) {
  return std::abs(value / truth - 1.0);
}

double square(double value) {
  return value * value;
}

/// About a point of one's own choice: M_P = M_R + (R - P) x F.
Vector moment_about(const Vector& point, const Figures& figures) {
  Vector arm{};
  for (std::size_t i = 0; i < 3; ++i) {
    arm[i] = figures.reference[i] - point[i];
  }
  Vector moment = figures.moment;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    moment[i] += arm[j] * figures.force[k] - arm[k] * figures.force[j];
  }
  return moment;
}

/// Semi-axes of all patches together.
void join_axes(const driver::Scene& scene, const std::string& side, Figures& figures) {
  double along = 0.0;
  double across = 0.0;
  double force = 0.0;
  for (int i = 0; i < scene.count_of(side + ".patches"); ++i) {
    const std::string patch = side + ".patches." + std::to_string(i) + '.';
    const double share = scene.number(patch + "normal_force");
    const Vector centre = vector_of(scene, patch + "centroid.");
    along += share * (square(scene.number(patch + "semi_axes.longitudinal")) +
                      5.0 * square(centre[0] - figures.centre[0]));
    across +=
        share *
        (square(scene.number(patch + "semi_axes.lateral")) +
         5.0 * (square(centre[1] - figures.centre[1]) + square(centre[2] - figures.centre[2])));
    force += share;
  }
  figures.semi_axis_along = std::sqrt(along / force);
  figures.semi_axis_across = std::sqrt(across / force);
}

} // namespace

double area_in_accuracies(double accuracy) {
  return 11.0 * std::pow(std::min(accuracy, 1e-2) / 1e-2, -0.2);
}

double WheelError::counted(Quantity quantity) const {
  const double error = of(quantity) / (quantity == Quantity::area ? area_share : 1.0);
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

Quantity WheelError::largest(const std::string& label) const {
  Quantity worst = Quantity::depth;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto quantity = static_cast<Quantity>(i);
    if ((quantity != Quantity::pmax || label != "forces") && counted(quantity) > counted(worst)) {
      worst = quantity;
    }
  }
  return worst;
}

Figures figures_of(const driver::Scene& scene, const std::string& side) {
  const std::string in = side + '.';
  Figures figures;
  figures.pmax = scene.number(in + "pmax");
  figures.depth = scene.number(in + "depth");
  figures.area = scene.number(in + "area");
  figures.normal_force = scene.number(in + "normal_force");
  figures.force = {scene.number(in + "longitudinal_force"), scene.number(in + "lateral_force"),
                   scene.number(in + "vertical_force")};
  figures.centre = vector_of(scene, in + "centroid.");
  figures.reference = vector_of(scene, in + "patches.0.");
  figures.moment = vector_of(scene, in + "pressure_moment.");
  join_axes(scene, side, figures);
  return figures;
}

WheelError error_of(const Figures& found, const Figures& truth) {
  WheelError error;
  const auto set = [&error](Quantity quantity, double value) {
    error.values[static_cast<std::size_t>(quantity)] = value;
  };
  set(Quantity::pmax, relative(found.pmax, truth.pmax));
  set(Quantity::depth, relative(found.depth, truth.depth));
  set(Quantity::area, relative(found.area, truth.area));
  set(Quantity::normal_force, relative(found.normal_force, truth.normal_force));
  set(Quantity::lateral_force, std::abs(found.force[1] - truth.force[1]) / truth.normal_force);
  set(Quantity::centre_longitudinal,
      std::abs(found.centre[0] - truth.centre[0]) / truth.semi_axis_along);
  set(Quantity::centre_lateral,
      std::hypot(found.centre[1] - truth.centre[1], found.centre[2] - truth.centre[2]) /
          truth.semi_axis_across);
  const Vector moment = moment_about(truth.reference, found);
  const Vector axes{truth.semi_axis_across, truth.semi_axis_along, truth.semi_axis_along};
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    worst = std::max(worst, std::abs(moment[i] - truth.moment[i]) / (truth.normal_force * axes[i]));
  }
  set(Quantity::moment, worst);
  return error;
}

WheelError error_of(const driver::Scene& scene, const std::string& side, const Figures& truth) {
  WheelError error = error_of(figures_of(scene, side), truth);
  for (auto [name, value] : {std::pair{".discretisation_error", &error.estimate},
                             std::pair{".validity", &error.validity}}) {
    if (scene.has_number(side + name)) {
      *value = scene.number(side + name);
    }
  }
  for (const std::string& warning : driver::texts_of(scene, side + ".warnings")) {
    error.warnings += (error.warnings.empty() ? "" : "; ") + warning;
  }
  return error;
}

} // namespace tradeoff
