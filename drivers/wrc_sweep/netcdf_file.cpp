#include "wrc_sweep/netcdf_file.hpp"

#include <array>
#include <sys/wait.h>
#include <unistd.h>

#include <netcdf.h>

#include "support/scene.hpp"

namespace driver {

void in_own_process(const std::filesystem::path& path, const std::function<void()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    throw Failure("cannot write " + path.string() + ": no pipe could be made");
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    std::string text;
    try {
      work();
    } catch (const std::exception& error) {
      text = error.what();
    }
    const bool told = write(ends[1], text.data(), text.size()) >= 0;
    _exit(told && text.empty() ? 0 : 1); // nothing of the parent's is ended or written here
  }
  close(ends[1]);
  std::string text;
  std::array<char, 256> part{};
  for (ssize_t count = 0; (count = read(ends[0], part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  close(ends[0]);
  int status = -1;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
    throw Failure(text.empty() ? "cannot write " + path.string() + " whole: is the disk full?"
                               : text);
  }
}

NetcdfFile::NetcdfFile(const std::filesystem::path& path) : path_(path.string()) {
  check(nc_create(path_.c_str(), NC_NETCDF4 | NC_CLOBBER, &file_));
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
