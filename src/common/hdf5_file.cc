#include "common/hdf5_file.h"

#include "common/durable_file.h"
#include "common/hdf5_file_driver.h"

#include <cerrno>
#include <functional>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace vibroimpact {

static_assert(sizeof(hid_t) == sizeof(std::int64_t), "identifiers are kept as 64-bit integers");

namespace {

/// An open object of the library, closed when it goes out of scope.
class Handle {
public:
  Handle(hid_t identifier, herr_t (*close)(hid_t)) : identifier_(identifier), close_(close) {}
  Handle(const Handle &) = delete;
  Handle &operator=(const Handle &) = delete;
  ~Handle() {
    if (identifier_ >= 0)
      close_(identifier_);
  }
  operator hid_t() const { return identifier_; }

private:
  hid_t identifier_;
  herr_t (*close_)(hid_t);
};

herr_t keep_innermost(unsigned position, const H5E_error2_t *error, void *reason) {
  if (position == 0 && error->desc != nullptr)
    *static_cast<std::string *>(reason) = error->desc;
  return 0;
}

[[noreturn]] void fail(const std::filesystem::path &file, const std::string &action) {
  std::string reason = "unknown reason";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  H5Eclear2(H5E_DEFAULT);
  throw std::runtime_error(file.string() + ": cannot " + action + ": " + reason);
}

template <class Result>
Result check(Result result, const std::filesystem::path &file, const std::string &action) {
  if (result < 0)
    fail(file, action);
  return result;
}

void throw_noted(const WriteFailure &failure, const std::filesystem::path &file,
                 const std::string &action) {
  errno = failure.error;
  if (failure.error != 0)
    fail_with_reason(file, action);
}

Handle string_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose};
}

Handle simple_space(const Shape &shape) {
  const std::vector<hsize_t> lengths(shape.begin(), shape.end());
  if (lengths.empty())
    return {H5Screate(H5S_SCALAR), H5Sclose};
  return {H5Screate_simple(static_cast<int>(lengths.size()), lengths.data(), nullptr), H5Sclose};
}

std::vector<const char *> c_strings(const std::vector<std::string> &values) {
  std::vector<const char *> pointers;
  pointers.reserve(values.size());
  for (const std::string &value : values)
    pointers.push_back(value.c_str());
  return pointers;
}

void write_array(hid_t file_identifier, const std::filesystem::path &file, const std::string &path,
                 const Shape &shape, std::size_t count, hid_t type, const void *data) {
  if (count != number_of_values(shape))
    throw std::logic_error(path + ": the values do not fill the shape of the dataset");
  const std::string action = "write " + path;
  const Handle space = simple_space(shape);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  H5Pset_attr_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const Handle dataset(check(H5Dcreate2(file_identifier, path.c_str(), type, space, H5P_DEFAULT,
                                        properties, H5P_DEFAULT),
                             file, action),
                       H5Dclose);
  if (count > 0)
    check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), file, action);
}

void write_attribute(hid_t file_identifier, const std::filesystem::path &file,
                     const std::string &path, const std::string &name, hid_t space, hid_t type,
                     const void *data) {
  const std::string action = "write attribute " + name + " of " + path;
  const Handle object(check(H5Oopen(file_identifier, path.c_str(), H5P_DEFAULT), file, action),
                      H5Oclose);
  const Handle attribute(
      check(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), file, action),
      H5Aclose);
  if (data != nullptr) // an empty list has no data
    check(H5Awrite(attribute, type, data), file, action);
}

Handle open_dataset(hid_t file_identifier, const std::filesystem::path &file,
                    const std::string &path) {
  return {check(H5Dopen2(file_identifier, path.c_str(), H5P_DEFAULT), file, "open " + path),
          H5Dclose};
}

/// Strings of variable length belong to the library: copied, then handed back.
std::vector<std::string> copy_strings(std::vector<char *> &pointers, hid_t type, hid_t space) {
  std::vector<std::string> values;
  values.reserve(pointers.size());
  for (const char *pointer : pointers)
    values.emplace_back(pointer == nullptr ? "" : pointer);
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
  return values;
}

} // namespace

std::size_t number_of_values(const Shape &shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

Hdf5File::Hdf5File(std::int64_t identifier, std::filesystem::path file,
                   std::unique_ptr<WriteFailure> failure)
    : identifier_(identifier), file_(std::move(file)), failure_(std::move(failure)) {}

Hdf5File::Hdf5File(Hdf5File &&other) noexcept
    : identifier_(std::exchange(other.identifier_, -1)), file_(std::move(other.file_)),
      failure_(std::move(other.failure_)) {}

Hdf5File::~Hdf5File() {
  if (identifier_ >= 0)
    H5Fclose(identifier_);
}

Hdf5File Hdf5File::create(const std::filesystem::path &file) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // errors become exceptions, not printed stacks
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_attr_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  auto failure = std::make_unique<WriteFailure>();
  const Handle access(access_noting_failures(*failure), H5Pclose);
  const hid_t created = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, access);
  throw_noted(*failure, file, "create the file");
  return {check(created, file, "create the file"), file, std::move(failure)};
}

Hdf5File Hdf5File::open(const std::filesystem::path &file) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return {check(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), file, "open the file"), file,
          nullptr};
}

void Hdf5File::close() {
  check(H5Fclose(std::exchange(identifier_, -1)), file_, "close the file");
  if (failure_)
    throw_noted(*failure_, file_, "write");
}

void Hdf5File::create_group(const std::string &path) {
  if (path.empty() || path == "/" || contains(path))
    return;
  create_parent(path);
  const Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_attr_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const Handle group(
      check(H5Gcreate2(identifier_, path.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), file_,
            "create group " + path),
      H5Gclose);
}

void Hdf5File::create_parent(const std::string &path) {
  create_group(path.substr(0, path.rfind('/')));
}

void Hdf5File::write(const std::string &path, const Shape &shape,
                     const std::vector<double> &values) {
  create_parent(path);
  write_array(identifier_, file_, path, shape, values.size(), H5T_NATIVE_DOUBLE, values.data());
}

void Hdf5File::write(const std::string &path, const Shape &shape,
                     const std::vector<std::int64_t> &values) {
  create_parent(path);
  write_array(identifier_, file_, path, shape, values.size(), H5T_NATIVE_INT64, values.data());
}

void Hdf5File::write(const std::string &path, const Shape &shape,
                     const std::vector<std::string> &values) {
  create_parent(path);
  const std::vector<const char *> pointers = c_strings(values);
  write_array(identifier_, file_, path, shape, values.size(), string_type(), pointers.data());
}

void Hdf5File::set_attribute(const std::string &path, const std::string &name,
                             const std::string &value) {
  const char *pointer = value.c_str();
  write_attribute(identifier_, file_, path, name, simple_space({}), string_type(), &pointer);
}

void Hdf5File::set_attribute(const std::string &path, const std::string &name, std::int64_t value) {
  write_attribute(identifier_, file_, path, name, simple_space({}), H5T_NATIVE_INT64, &value);
}

void Hdf5File::set_attribute(const std::string &path, const std::string &name,
                             const std::vector<std::string> &values) {
  const std::vector<const char *> pointers = c_strings(values);
  write_attribute(identifier_, file_, path, name, simple_space({values.size()}), string_type(),
                  pointers.data());
}

void Hdf5File::make_scale(const std::string &path) {
  const Handle dataset = open_dataset(identifier_, file_, path);
  const std::string name = path.substr(path.rfind('/') + 1);
  check(H5DSset_scale(dataset, name.c_str()), file_, "make a dimension scale of " + path);
}

void Hdf5File::attach_scale(const std::string &path, std::size_t dimension,
                            const std::string &scale) {
  const std::string action = "attach " + scale + " to " + path;
  const Handle dataset = open_dataset(identifier_, file_, path);
  const Handle coordinate = open_dataset(identifier_, file_, scale);
  const std::string name = scale.substr(scale.rfind('/') + 1);
  const auto position = static_cast<unsigned>(dimension);
  check(H5DSattach_scale(dataset, coordinate, position), file_, action);
  check(H5DSset_label(dataset, position, name.c_str()), file_, action);
}

bool Hdf5File::contains(const std::string &path) const {
  for (std::size_t end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1))
    if (H5Lexists(identifier_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
      return false;
  return path == "/" || H5Lexists(identifier_, path.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::members(const std::string &group) const {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char *name, const H5L_info_t *, void *list) -> herr_t {
    static_cast<std::vector<std::string> *>(list)->emplace_back(name);
    return 0;
  };
  const std::string action = "list " + group;
  const Handle opened(check(H5Gopen2(identifier_, group.c_str(), H5P_DEFAULT), file_, action),
                      H5Gclose);
  // Files of other programs may not have kept the order of creation.
  if (H5Literate(opened, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, collect, &names) < 0)
    check(H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), file_, action);
  return names;
}

bool Hdf5File::is_group(const std::string &path) const {
  const Handle object(check(H5Oopen(identifier_, path.c_str(), H5P_DEFAULT), file_, "open " + path),
                      H5Oclose);
  return H5Iget_type(object) == H5I_GROUP;
}

Shape Hdf5File::shape(const std::string &path) const {
  const Handle dataset = open_dataset(identifier_, file_, path);
  const Handle space(H5Dget_space(dataset), H5Sclose);
  std::vector<hsize_t> lengths(static_cast<std::size_t>(
      check(H5Sget_simple_extent_ndims(space), file_, "read the shape of " + path)));
  H5Sget_simple_extent_dims(space, lengths.data(), nullptr);
  return {lengths.begin(), lengths.end()};
}

std::vector<double> Hdf5File::read_numbers(const std::string &path) const {
  std::vector<double> values(number_of_values(shape(path)));
  const Handle dataset = open_dataset(identifier_, file_, path);
  check(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), file_,
        "read " + path);
  return values;
}

std::vector<std::string> Hdf5File::read_strings(const std::string &path) const {
  std::vector<char *> pointers(number_of_values(shape(path)), nullptr);
  const Handle dataset = open_dataset(identifier_, file_, path);
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const Handle type = string_type();
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), file_,
        "read " + path);
  return copy_strings(pointers, type, space);
}

std::string Hdf5File::read_attribute(const std::string &path, const std::string &name) const {
  const std::string action = "read attribute " + name + " of " + path;
  const Handle attribute(
      check(H5Aopen_by_name(identifier_, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
            file_, action),
      H5Aclose);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  const Handle type = string_type();
  std::vector<char *> pointers(1, nullptr);
  check(H5Aread(attribute, type, pointers.data()), file_, action);
  return copy_strings(pointers, type, space).front();
}

} // namespace vibroimpact
