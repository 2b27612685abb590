#include "mechanics/joint_step.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/constants.hpp"

extern "C" {
/// LAPACK: solves A x = b with A symmetric positive definite.
void dposv_(const char* uplo, const int* n, const int* nrhs, double* a, const int* lda, double* b,
            const int* ldb, int* info);
}

namespace wrc {

void JointStep::begin(std::size_t boxes) {
  boxes_ = boxes;
  energy_.assign(order() * order(), 0.0);
  for (std::vector<double>* values : {&work_, &load_, &scale_, &answer_}) {
    values->assign(order(), 0.0);
  }
}

void JointStep::set_energy(std::size_t i, std::size_t j, double energy) {
  energy_[std::min(i, j) + std::max(i, j) * order()] = energy;
}

bool JointStep::solve(bool keep_load) {
  const std::size_t n = order();
  // What has no energy takes no part.
  for (std::size_t i = 0; i < n; ++i) {
    const double own = energy_[i + i * n];
    scale_[i] = own > 0.0 ? 1.0 / std::sqrt(own) : 0.0;
  }
  right_sides_.assign(2 * n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      energy_[i + j * n] *= scale_[i] * scale_[j];
    }
    energy_[j + j * n] = 1.0 + joint_step_ridge;
    right_sides_[j] = scale_[j] * work_[j];
    right_sides_[n + j] = scale_[j] * load_[j];
  }
  const std::vector<double> loads(right_sides_.begin() + static_cast<std::ptrdiff_t>(n),
                                  right_sides_.end());
  const char upper = 'U';
  const int order = static_cast<int>(n);
  const int count = 2;
  int info = 0;
  dposv_(&upper, &order, &count, energy_.data(), &order, right_sides_.data(), &order, &info);
  if (info != 0) {
    return false;
  }
  double moved = 0.0;
  double moved_by_load = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    moved += loads[i] * right_sides_[i];
    moved_by_load += loads[i] * right_sides_[n + i];
  }
  const double lambda = keep_load && moved_by_load > 0.0 ? moved / moved_by_load : 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    answer_[i] = scale_[i] * (right_sides_[i] - lambda * right_sides_[n + i]);
    if (!std::isfinite(answer_[i])) {
      return false;
    }
  }
  return true;
}

} // namespace wrc
