// A creep curve of the left wheel, by Kalker's full theory.
#include <cstdio>
#include <string>
#include <vector>

#include <wrcontact.hpp>

int main() {
  try {
    wrcontact::Scene scene;
    wrcontact::Solver solver;
    scene.set("solve.side", "left");
    scene.set("solve.accuracy", 1e-2);
    for (double creepage = 0.0005; creepage < 0.0045; creepage += 0.0005) {
      scene.set("creepage.longitudinal", creepage);
      solver.solve(scene);
      const double bound = 0.3 * scene.number("left.patches.0.normal_force");
      std::printf("%.4f %.4f\n", creepage,
                  -scene.number("left.patches.0.creep_force.longitudinal") / bound);
    }
  } catch (const wrcontact::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
