#include "common/durable_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <unistd.h>

namespace vibroimpact {

namespace {

/// What was written to a file or a folder has reached the disk when this returns.
void synchronise(const std::filesystem::path &path, int flags) {
  const int descriptor = ::open(path.c_str(), flags);
  if (descriptor < 0)
    fail_with_reason(path, "open for synchronisation");
  const int failed = ::fsync(descriptor);
  ::close(descriptor);
  if (failed != 0)
    fail_with_reason(path, "synchronise with the disk");
}

} // namespace

void fail_with_reason(const std::filesystem::path &path, const std::string &action) {
  const std::string reason = std::strerror(errno);
  throw std::runtime_error(path.string() + ": cannot " + action + ": " + reason);
}

void write_completely(int descriptor, std::string_view bytes, const std::filesystem::path &path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0)
      fail_with_reason(path, "write");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void write_file(const std::filesystem::path &file, std::string_view bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
    fail_with_reason(file, "create the file");
  try {
    write_completely(descriptor, bytes, file);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0)
    fail_with_reason(file, "close the file");
}

std::filesystem::path temporary_name(const std::filesystem::path &file) {
  return file.string() + ".unfinished";
}

void replace_file(const std::filesystem::path &file,
                  const std::function<void(const std::filesystem::path &)> &write) {
  const std::filesystem::path temporary = temporary_name(file);
  try {
    write(temporary);
    synchronise(temporary, O_RDWR);
    if (::rename(temporary.c_str(), file.c_str()) != 0)
      fail_with_reason(file, "rename " + temporary.string() + " to it");
    synchronise(std::filesystem::absolute(file).parent_path(), O_RDONLY | O_DIRECTORY);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

void replace_file(const std::filesystem::path &file, const std::string &text) {
  replace_file(file,
               [&text](const std::filesystem::path &temporary) { write_file(temporary, text); });
}

} // namespace vibroimpact
