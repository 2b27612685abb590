#include <cstdio>
#include <wrcontact.hpp>

int main() {
  try {
    wrcontact::Scene scene;
    scene.set("pose.yaw", 0); // a whole number, no null pointer
    scene.set("pose.lateral", 3.0);
    scene.solve();
    std::printf("%.17g\n", scene.number("left.pmax"));
  } catch (const wrcontact::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
