/// The panel of stresses below the surface in the picture of a scene.
#pragma once

#include <string>

#include "support/gnuplot.hpp"
#include "support/scene.hpp"

namespace driver {

/// Draws the section with the greatest stress of a side, which has one.
void plot_stress(Gnuplot& gnuplot, const Scene& scene, const std::string& side);
/// Letters beside the colours of a panel, for their numbers and label.
inline constexpr int colour_box_margin = 15;

} // namespace driver
