// Tables of contact forces for C++; part of wrcontact.hpp, which includes it.
#ifndef WRCONTACT_TABLE_HPP
#define WRCONTACT_TABLE_HPP

#include <functional>

#include "wrcontact.hpp"

namespace wrcontact {

/// What a table has beside forces, of both wheels (wrc_step_arguments). Since 0.4.
struct TableOutputs {
  std::array<double, 4> likely_errors{};
  std::array<double, 2 * WRC_TABLE_OUTPUTS> outputs{};
  std::array<double, 2 * WRC_TABLE_OUTPUTS> output_errors{};
};

/// Contact forces from a table that states its error (wrc_table). Since 0.3.
class Table
    : public detail::Owner<wrc_table, wrc_table_create, wrc_table_destroy, wrc_table_error> {
public:
  /// Made of a scene; members of the options that are 0 have their defaults. `progress(fraction)`
  /// returns false to stop.
  void build(Scene& scene, wrc_table_options options = {},
             std::function<bool(double)> progress = {}) {
    options.struct_size = sizeof options;
    const auto call = [](void* context, double fraction) -> std::int32_t {
      return (*static_cast<std::function<bool(double)>*>(context))(fraction) ? 0 : 1;
    };
    check(wrc_table_build(handle(), scene.handle(), &options,
                          progress ? static_cast<std::int32_t (*)(void*, double)>(call) : nullptr,
                          &progress));
  }
  void save(const std::string& path) { check(wrc_table_save(handle(), path.c_str())); }
  void load(const std::string& path) { check(wrc_table_load(handle(), path.c_str())); }
  /// The same table for another thread.
  Table share() const {
    Table other;
    check(wrc_table_share(handle(), other.handle()));
    return other;
  }
  /// What it is of: profiles, dimensions, units, reach.
  std::vector<std::string> lines() const { return texts_of(wrc_table_line); }
  wrc_table_facts facts() const {
    wrc_table_facts known{};
    known.struct_size = sizeof known;
    check(wrc_table_get_facts(handle(), &known));
    return known;
  }
  /// Forces of a wheelset and how far those of each wheel may be off, over its load. `solver` and
  /// `scene`: for the exact solution, or both null.
  std::array<double, 2> step(const std::array<double, 6>& position,
                             const std::array<double, 6>& velocity, Step& result,
                             StepArguments& arguments, Solver* solver = nullptr,
                             Scene* scene = nullptr, TableOutputs* outputs = nullptr) {
    wrc_history* history = nullptr;
    const wrc_step_arguments passed = passed_on(arguments, result, history, outputs);
    std::array<double, 2> error{};
    check(wrc_table_step(handle(), solver != nullptr ? solver->handle() : nullptr,
                         scene != nullptr ? scene->handle() : nullptr, position.data(),
                         velocity.data(), &passed, result.force.data(), error.data()));
    return error;
  }
  /// Sets height and roll of the position such that the wheels carry these loads
  /// (wrc_table_equilibrium). Since 0.4.
  std::array<double, 2> equilibrium(std::int32_t kind, const std::array<double, 2>& loads,
                                    std::array<double, 6>& position,
                                    const std::array<double, 6>& velocity, Step& result,
                                    StepArguments& arguments, TableOutputs* outputs = nullptr) {
    wrc_history* history = nullptr;
    const wrc_step_arguments passed = passed_on(arguments, result, history, outputs);
    std::array<double, 2> error{};
    check(wrc_table_equilibrium(handle(), kind, loads.data(), velocity.data(), &passed,
                                position.data(), result.force.data(), error.data()));
    return error;
  }

private:
  static wrc_step_arguments passed_on(StepArguments& arguments, Step& result, wrc_history*& history,
                                      TableOutputs* outputs) {
    wrc_step_arguments passed = Solver::passed_on(arguments, result, history);
    if (outputs != nullptr) {
      passed.likely_errors = outputs->likely_errors.data();
      passed.outputs = outputs->outputs.data();
      passed.output_errors = outputs->output_errors.data();
    }
    return passed;
  }
};

} // namespace wrcontact

#endif
