#include "wrc_sweep/netcdf_file.hpp"

#include <netcdf.h>

#include "support/scene.hpp"

namespace driver {

NetcdfFile::NetcdfFile(const std::filesystem::path& path) : path_(path.string()) {
  check(nc_create(path_.c_str(), NC_NETCDF4 | NC_CLOBBER, &file_));
}

NetcdfFile::~NetcdfFile() {
  if (file_ >= 0) {
    nc_abort(file_);
  }
}

void NetcdfFile::check(int status) const {
  if (status != NC_NOERR) {
    throw Failure("cannot write " + path_ + ": " + nc_strerror(status));
  }
}

int NetcdfFile::dimension(const std::string& name, std::size_t length) {
  int id = -1;
  check(nc_def_dim(file_, name.c_str(), length, &id));
  return id;
}

int NetcdfFile::variable(const std::string& name, int type, const std::vector<int>& dimensions) {
  int id = -1;
  check(nc_def_var(file_, name.c_str(), type, static_cast<int>(dimensions.size()),
                   dimensions.data(), &id));
  return id;
}

int NetcdfFile::numbers(const std::string& name, const std::vector<int>& dimensions) {
  return variable(name, NC_DOUBLE, dimensions);
}

int NetcdfFile::integers(const std::string& name, const std::vector<int>& dimensions) {
  return variable(name, NC_INT64, dimensions);
}

int NetcdfFile::texts(const std::string& name, const std::vector<int>& dimensions) {
  return variable(name, NC_STRING, dimensions);
}

void NetcdfFile::compress(int variable) {
  constexpr int shuffle = 1;
  constexpr int deflate = 1;
  constexpr int level = 1;
  check(nc_def_var_deflate(file_, variable, shuffle, deflate, level));
}

void NetcdfFile::attribute(int variable, const std::string& name, const std::string& value) {
  const int id = variable == whole_file ? NC_GLOBAL : variable;
  check(nc_put_att_text(file_, id, name.c_str(), value.size(), value.c_str()));
}

void NetcdfFile::attribute(int variable, const std::string& name, const std::vector<int>& values) {
  check(nc_put_att_int(file_, variable, name.c_str(), NC_INT64, values.size(), values.data()));
}

void NetcdfFile::put(int variable, const std::vector<double>& values) {
  check(nc_put_var_double(file_, variable, values.data()));
}

void NetcdfFile::put(int variable, const std::vector<std::int64_t>& values) {
  static_assert(sizeof(long long) == sizeof(std::int64_t));
  const std::vector<long long> copy(values.begin(), values.end());
  check(nc_put_var_longlong(file_, variable, copy.data()));
}

void NetcdfFile::put(int variable, const std::vector<std::string>& values) {
  std::vector<const char*> texts;
  for (const std::string& value : values) {
    texts.push_back(value.c_str());
  }
  check(nc_put_var_string(file_, variable, texts.data()));
}

void NetcdfFile::put_part(int variable, std::size_t first, const std::vector<double>& values) {
  const std::size_t count = values.size();
  check(nc_put_vara_double(file_, variable, &first, &count, values.data()));
}

void NetcdfFile::close() {
  const int file = file_;
  file_ = -1;
  check(nc_close(file));
}

} // namespace driver
