/* The F77 layer from a program that its compiler did not link. */
#include <stdint.h>
#include <stdio.h>

void wrcnew_(int64_t* handle, const char* what, int32_t* kind, int32_t* error, size_t length);
void wrcset_(int64_t* handle, const char* key, double* value, int32_t* error, size_t length);
void wrcsol_(int64_t* handle, int32_t* error);
void wrcnum_(int64_t* handle, const char* name, double* value, int32_t* error, size_t length);
void wrcdel_(int64_t* handle, int32_t* error);

int main(void) {
  int64_t scene = 0;
  int32_t kind = 4, error[5] = {1, 1, 1, 1, 1}; /* integers of 4 bytes */
  double lateral = 3.0, pmax = 0.0;
  wrcnew_(&scene, "SCENE", &kind, error, 5);
  wrcset_(&scene, "pose.lateral", &lateral, error + 1, 12);
  wrcsol_(&scene, error + 2);
  wrcnum_(&scene, "left.pmax", &pmax, error + 3, 9);
  wrcdel_(&scene, error + 4);
  printf("%.17g\n", pmax);
  return error[0] || error[1] || error[2] || error[3] || error[4];
}
