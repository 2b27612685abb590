#include "mechanics/coupled_influence.hpp"

#include <algorithm>
#include <numbers>

namespace wrc {

Grid grid_in_mean_plane(const Grid& grid, const PatchInteraction::Place& place,
                        const ElementBox& box) {
  return {box.rows(),
          box.columns(),
          grid.lateral_step,
          grid.longitudinal_step,
          place.lateral + grid.lateral(box.first_row),
          place.longitudinal + grid.longitudinal(box.first_column)};
}

std::vector<CoupledInfluence::Box> CoupledInfluence::boxes_of(std::span<const SolvedPatch> patches,
                                                              double combined_modulus) {
  std::vector<Box> boxes;
  for (const SolvedPatch& patch : patches) {
    Box& box = boxes.emplace_back();
    box.size = {patch.grid.lateral_count, patch.grid.longitudinal_count};
    find_pressure_box(box.size, patch.pressure, 0, box.elements);
    box.unit = patch.grid.longitudinal_step / (std::numbers::pi * combined_modulus);
  }
  return boxes;
}

std::vector<Grid> CoupledInfluence::coupled_boxes(std::span<const SolvedPatch> patches,
                                                  const PatchInteraction& interaction,
                                                  const std::vector<Box>& boxes) {
  std::vector<Grid> coupled;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    coupled.push_back(
        grid_in_mean_plane(patches[k].grid, interaction.places[k], boxes[k].elements));
  }
  return coupled;
}

CoupledInfluence::CoupledInfluence(std::span<const SolvedPatch> patches,
                                   const PatchInteraction& interaction, double combined_modulus)
    : boxes_(boxes_of(patches, combined_modulus)),
      coupling_(coupled_boxes(patches, interaction, boxes_), interaction.coupling_weight),
      field_(coupling_.field()) {}

void CoupledInfluence::add(std::span<const std::vector<double>> pressure,
                           std::span<std::vector<double>> displacement) {
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    Box& box = boxes_[k];
    copy_box(box.size, box.elements, pressure[k], box.values);
    coupling_.gather(k, box.values.data(), field_.load);
  }
  coupling_.transfer(field_);
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    Box& box = boxes_[k];
    std::fill(box.values.begin(), box.values.end(), 0.0);
    coupling_.add_others(field_, k, box.values.data());
    copy_box(box.size, box.elements, displacement[k], sum_);
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      sum_[i] += box.unit * box.values[i];
    }
    put_box(box.size, box.elements, sum_, displacement[k]);
  }
}

} // namespace wrc
