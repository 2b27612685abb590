/// A NetCDF-4 file being written, with failures as exceptions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace driver {

/// Does work that writes a NetCDF file in a process of its own. HDF5, which writes it, does not get
/// over a full disk: it fails again when the file is closed or the program ends, by a fault. Throws
/// Failure with the text of what the work throws, or if its process ends in another way.
void in_own_process(const std::filesystem::path& path, const std::function<void()>& work);

/// Not closed by its destructor, see there.
class NetcdfFile {
public:
  explicit NetcdfFile(const std::filesystem::path& path);
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  int dimension(const std::string& name, std::size_t length);
  /// Variables over dimensions.
  int numbers(const std::string& name, const std::vector<int>& dimensions);
  int integers(const std::string& name, const std::vector<int>& dimensions);
  int texts(const std::string& name, const std::vector<int>& dimensions);
  /// Compresses a variable of many numbers.
  void compress(int variable);
  void attribute(int variable, const std::string& name, const std::string& value);
  void attribute(int variable, const std::string& name, const std::vector<int>& values);
  static constexpr int whole_file = -1; ///< as a variable: attributes of the file

  /// Whole variables.
  void put(int variable, const std::vector<double>& values);
  void put(int variable, const std::vector<std::int64_t>& values);
  void put(int variable, const std::vector<std::string>& values);
  /// Part of a variable with one dimension.
  void put_part(int variable, std::size_t first, const std::vector<double>& values);
  void close();

private:
  void check(int status) const;
  int variable(const std::string& name, int type, const std::vector<int>& dimensions);

  std::string path_;
  int file_ = -1;
};

} // namespace driver
