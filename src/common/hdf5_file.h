// An HDF5 file as groups, row-major arrays, attributes and dimension scales. The only place that
// knows the HDF5 library; used by one process at a time.
//
// Paths are absolute ("/analysis/release/time"); missing groups on the way are created. Nothing in
// the file depends on the time of writing. A dataset whose dimensions all carry a scale opens as a
// labelled array in h5py, netCDF4 and xarray.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vibroimpact {

struct WriteFailure;

/// Lengths of the dimensions, last one fastest; empty for a scalar.
using Shape = std::vector<std::size_t>;

/// Number of values in an array of this shape (1 for a scalar).
std::size_t number_of_values(const Shape &shape);

/// Every failure of the library is a std::runtime_error that names the file, the object and the
/// reason; values that do not fill their shape are a std::logic_error.
class Hdf5File {
public:
  /// For writing, replacing a file that is there. It is of use after close() only.
  static Hdf5File create(const std::filesystem::path &file);
  /// For reading.
  static Hdf5File open(const std::filesystem::path &file);
  Hdf5File(Hdf5File &&other) noexcept;
  Hdf5File(const Hdf5File &) = delete;
  Hdf5File &operator=(const Hdf5File &) = delete;
  Hdf5File &operator=(Hdf5File &&) = delete;
  ~Hdf5File();
  /// Completes a created file: failures to write it show here. The object is of no use afterwards.
  void close();

  void create_group(const std::string &path);
  void write(const std::string &path, const Shape &shape, const std::vector<double> &values);
  void write(const std::string &path, const Shape &shape, const std::vector<std::int64_t> &values);
  void write(const std::string &path, const Shape &shape, const std::vector<std::string> &values);

  /// Attributes of a group or dataset, "/" for the file itself.
  void set_attribute(const std::string &path, const std::string &name, const std::string &value);
  void set_attribute(const std::string &path, const std::string &name, std::int64_t value);
  void set_attribute(const std::string &path, const std::string &name,
                     const std::vector<std::string> &values);

  /// Makes a one-dimensional dataset the coordinate of a dimension called like the dataset.
  void make_scale(const std::string &path);
  /// Gives dimension `dimension` of a dataset that coordinate, and its name as label.
  void attach_scale(const std::string &path, std::size_t dimension, const std::string &scale);

  bool contains(const std::string &path) const;
  /// Names in a group, in the order they were written.
  std::vector<std::string> members(const std::string &group) const;
  bool is_group(const std::string &path) const;
  Shape shape(const std::string &path) const;
  /// All values, row-major. Integers are converted to double without a message.
  std::vector<double> read_numbers(const std::string &path) const;
  std::vector<std::string> read_strings(const std::string &path) const;
  std::string read_attribute(const std::string &path, const std::string &name) const;

private:
  Hdf5File(std::int64_t identifier, std::filesystem::path file,
           std::unique_ptr<WriteFailure> failure);
  void create_parent(const std::string &path);

  std::int64_t identifier_;
  std::filesystem::path file_;
  std::unique_ptr<WriteFailure> failure_; ///< of a created file
};

} // namespace vibroimpact
