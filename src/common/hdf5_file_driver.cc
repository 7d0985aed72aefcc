#include "common/hdf5_file_driver.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <hdf5.h>
#include <map>
#include <new>
#include <unistd.h>

namespace vibroimpact {

namespace {

constexpr haddr_t page_size = 4096;
constexpr std::size_t large = std::size_t{1} << 20;

struct File : H5FD_t {
  int descriptor = -1;
  haddr_t allocated = 0; ///< end of what the library has given out
  haddr_t written = 0;   ///< end of what it has written
  WriteFailure *failure = nullptr;
  std::map<haddr_t, std::array<char, page_size>> pages{}; ///< by address, after a failure
};

File &file_of(H5FD_t *file) { return *static_cast<File *>(file); }
const File &file_of(const H5FD_t *file) { return *static_cast<const File *>(file); }

/// Zeros where the file ends. False: errno tells.
bool read_from_disk(const File &file, haddr_t address, std::size_t size, char *bytes) {
  while (size > 0) {
    const ssize_t read = ::pread(file.descriptor, bytes, size, static_cast<off_t>(address));
    if (read < 0 && errno == EINTR)
      continue;
    if (read < 0)
      return false;
    if (read == 0) {
      std::fill(bytes, bytes + size, '\0');
      return true;
    }
    address += static_cast<haddr_t>(read);
    bytes += read;
    size -= static_cast<std::size_t>(read);
  }
  return true;
}

bool write_to_disk(const File &file, haddr_t address, std::size_t size, const char *bytes) {
  while (size > 0) {
    const ssize_t written = ::pwrite(file.descriptor, bytes, size, static_cast<off_t>(address));
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0)
      return false;
    address += static_cast<haddr_t>(written);
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

/// Calls visit(page, offset in the page, offset in the bytes, size) for each page touched.
template <class Visit> void visit_pages(haddr_t address, std::size_t size, Visit visit) {
  for (std::size_t done = 0; done < size;) {
    const haddr_t offset = (address + done) % page_size;
    const std::size_t part = std::min<std::size_t>(size - done, page_size - offset);
    visit(address + done - offset, offset, done, part);
    done += part;
  }
}

void keep_in_memory(File &file, haddr_t address, std::size_t size, const char *bytes) {
  visit_pages(address, size, [&](haddr_t page, haddr_t offset, std::size_t done, std::size_t part) {
    const auto [kept, is_new] = file.pages.try_emplace(page);
    if (is_new && !read_from_disk(file, page, page_size, kept->second.data()))
      kept->second.fill('\0');
    std::memcpy(kept->second.data() + offset, bytes + done, part);
  });
}

H5FD_t *open_file(const char *name, unsigned flags, hid_t access, haddr_t /*highest*/) {
  const auto *const failure = static_cast<WriteFailure *const *>(H5Pget_driver_info(access));
  const int mode = O_RDWR | O_CLOEXEC | ((flags & H5F_ACC_CREAT) != 0 ? O_CREAT : 0) |
                   ((flags & H5F_ACC_TRUNC) != 0 ? O_TRUNC : 0);
  const int descriptor = failure == nullptr ? -1 : ::open(name, mode, 0666);
  if (descriptor < 0) {
    if (failure != nullptr)
      (*failure)->error = errno;
    return nullptr;
  }
  File *file = new (std::nothrow) File{};
  if (file == nullptr) {
    ::close(descriptor);
    return nullptr;
  }
  file->descriptor = descriptor;
  file->failure = *failure;
  return file;
}

herr_t close_file(H5FD_t *file) {
  if (::close(file_of(file).descriptor) != 0 && file_of(file).failure->error == 0)
    file_of(file).failure->error = errno;
  delete &file_of(file);
  return 0;
}

/// What the library may do with the file, as with one in memory or on a disk.
herr_t query(const H5FD_t * /*file*/, unsigned long *flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

haddr_t end_of_allocated(const H5FD_t *file, H5FD_mem_t /*kind*/) {
  return file_of(file).allocated;
}

herr_t set_end_of_allocated(H5FD_t *file, H5FD_mem_t /*kind*/, haddr_t address) {
  file_of(file).allocated = address;
  return 0;
}

haddr_t end_of_written(const H5FD_t *file, H5FD_mem_t /*kind*/) { return file_of(file).written; }

herr_t read(H5FD_t *opened, H5FD_mem_t /*kind*/, hid_t /*transfer*/, haddr_t address,
            std::size_t size, void *target) {
  const File &file = file_of(opened);
  auto *const bytes = static_cast<char *>(target);
  if (!read_from_disk(file, address, size, bytes))
    return -1;
  if (!file.pages.empty())
    visit_pages(address, size,
                [&](haddr_t page, haddr_t offset, std::size_t done, std::size_t part) {
                  if (const auto kept = file.pages.find(page); kept != file.pages.end())
                    std::memcpy(bytes + done, kept->second.data() + offset, part);
                });
  return 0;
}

herr_t write(H5FD_t *opened, H5FD_mem_t kind, hid_t /*transfer*/, haddr_t address, std::size_t size,
             const void *source) try {
  File &file = file_of(opened);
  const auto *const bytes = static_cast<const char *>(source);
  if (file.failure->error == 0 && !write_to_disk(file, address, size, bytes))
    file.failure->error = errno;
  if (file.failure->error != 0 && !(kind == H5FD_MEM_DRAW && size > large))
    keep_in_memory(file, address, size, bytes);
  file.written = std::max(file.written, address + size);
  return 0;
} catch (const std::bad_alloc &) {
  return -1;
}

herr_t truncate(H5FD_t *opened, hid_t /*transfer*/, hbool_t /*closing*/) {
  File &file = file_of(opened);
  if (file.failure->error == 0 &&
      ::ftruncate(file.descriptor, static_cast<off_t>(file.allocated)) != 0)
    file.failure->error = errno;
  file.written = file.allocated;
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
  driver.name = "vibroimpact";
  driver.maxaddr = (haddr_t{1} << 63) - 1;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(WriteFailure *);
  driver.open = open_file;
  driver.close = close_file;
  driver.query = query;
  driver.get_eoa = end_of_allocated;
  driver.set_eoa = set_end_of_allocated;
  driver.get_eof = end_of_written;
  driver.read = read;
  driver.write = write;
  driver.truncate = truncate;
  constexpr H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(kinds), std::end(kinds), driver.fl_map);
  return driver;
}

} // namespace

std::int64_t access_noting_failures(WriteFailure &failure) {
  static const H5FD_class_t driver = driver_class();
  static const hid_t identifier = H5FDregister(&driver);
  WriteFailure *const place = &failure;
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_driver(access, identifier, &place);
  return access;
}

} // namespace vibroimpact
