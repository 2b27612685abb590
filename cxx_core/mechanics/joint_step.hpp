/// How far an iteration of several boxes goes in each of them.
///
/// Each box k has a direction v_k and its pressures p_k. The step goes to the least energy over all
/// sums of alpha_k v_k + gamma_k p_k, with the load kept if it is given: boxes whose contacts
/// differ in stiffness or load then converge each at its own pace, and load passes from one to the
/// other by scaling. K p_k is known, so that costs no convolution more than one step length for
/// all. (Several directions at once: O'Leary, The block conjugate gradient algorithm, Linear
/// Algebra Appl. 29, 1980; Bridson & Greif, A multipreconditioned conjugate gradient algorithm,
/// SIAM J. Matrix Anal. 27, 2006.)
///
/// With x = (alpha, gamma), A the energies, b the work of the residual r and c the loads:
///   A x = b - lambda c,  c x = 0
/// All in units of its caller. Thread rule: one object serves one thread at a time.
#pragma once

#include <cstddef>
#include <vector>

namespace wrc {

class JointStep {
public:
  /// A, b and c as zeros.
  void begin(std::size_t boxes);

  /// What A, b and c are made of: index k for v_k, boxes + k for p_k. Energies are symmetric; set
  /// either of the two.
  void set_energy(std::size_t i, std::size_t j, double energy);
  void set_work(std::size_t i, double work) { work_[i] = work; }
  void set_load(std::size_t i, double load) { load_[i] = load; }

  /// False if the energies have no least value that is right to rounding.
  bool solve(bool keep_load);

  [[nodiscard]] double step(std::size_t box) const { return answer_[box]; }            ///< alpha
  [[nodiscard]] double growth(std::size_t box) const { return answer_[boxes_ + box]; } ///< gamma

private:
  [[nodiscard]] std::size_t order() const { return 2 * boxes_; }

  std::size_t boxes_ = 0;
  std::vector<double> energy_; ///< upper triangle by column, as LAPACK has it
  std::vector<double> work_;
  std::vector<double> load_;
  std::vector<double> scale_;
  std::vector<double> right_sides_; ///< of b and c
  std::vector<double> answer_;
};

} // namespace wrc
