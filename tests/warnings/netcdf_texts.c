/* Prints a variable of texts of a NetCDF file, one line each. */
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** arguments) {
  int file = -1;
  int variable = -1;
  int rank = 0;
  int dimensions[NC_MAX_VAR_DIMS];
  size_t length = 1;
  if (count != 3 || nc_open(arguments[1], NC_NOWRITE, &file) != NC_NOERR ||
      nc_inq_varid(file, arguments[2], &variable) != NC_NOERR ||
      nc_inq_varndims(file, variable, &rank) != NC_NOERR ||
      nc_inq_vardimid(file, variable, dimensions) != NC_NOERR) {
    fprintf(stderr, "usage: netcdf_texts FILE VARIABLE\n");
    return 1;
  }
  for (int i = 0; i < rank; ++i) {
    size_t extent = 0;
    nc_inq_dimlen(file, dimensions[i], &extent);
    length *= extent;
  }
  char** texts = calloc(length, sizeof *texts);
  if (texts == NULL || nc_get_var_string(file, variable, texts) != NC_NOERR) {
    return 1;
  }
  for (size_t i = 0; i < length; ++i) {
    puts(texts[i]);
  }
  nc_free_string(length, texts);
  free(texts);
  nc_close(file);
  return 0;
}
