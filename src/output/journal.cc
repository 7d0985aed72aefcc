#include "output/journal.h"

#include "common/durable_file.h"
#include "common/log.h"

#include <algorithm>
#include <array>
#include <boost/interprocess/exceptions.hpp>
#include <boost/interprocess/file_mapping.hpp>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <unistd.h>
#include <utility>
#include <vector>
#include <zlib.h>

namespace vibroimpact::output {

namespace {

constexpr std::size_t length_size = sizeof(std::uint64_t);
constexpr std::size_t prefix_size = length_size + sizeof(std::uint32_t);
using Prefix = std::array<char, prefix_size>;

uLong checksum(uLong before, std::string_view bytes) {
  return ::crc32_z(before, reinterpret_cast<const Bytef *>(bytes.data()), bytes.size());
}

/// The length takes part, so that a run of zeros is no valid record.
uLong checksum_of_length(std::uint64_t length) {
  return checksum(0, {reinterpret_cast<const char *>(&length), length_size});
}

Prefix prefix_of(std::string_view payload) {
  const std::uint64_t length = payload.size();
  const auto sum = static_cast<std::uint32_t>(checksum(checksum_of_length(length), payload));
  Prefix prefix;
  std::memcpy(prefix.data(), &length, sizeof length);
  std::memcpy(prefix.data() + length_size, &sum, sizeof sum);
  return prefix;
}

std::uint64_t length_in(const char *prefix) {
  std::uint64_t length = 0;
  std::memcpy(&length, prefix, sizeof length);
  return length;
}

/// Goes through a journal that may be cut off meanwhile: by reading, not by mapping.
class Scan {
public:
  explicit Scan(const std::filesystem::path &file) : buffer_(std::size_t{1} << 20) {
    stream_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    stream_.open(file, std::ios::binary);
    if (!stream_)
      fail_with_reason(file, "read the file");
    left_ = std::filesystem::file_size(file);
  }

  /// The size of the next record with its prefix; 0 when there is no complete one.
  std::size_t next() {
    Prefix prefix;
    if (!read(prefix.data(), prefix.size()))
      return 0;
    const std::uint64_t length = length_in(prefix.data());
    std::uint32_t sum = 0;
    std::memcpy(&sum, prefix.data() + length_size, sizeof sum);
    return length <= left_ && checksum_of_payload(length) == sum ? prefix_size + length : 0;
  }

private:
  bool read(char *target, std::size_t size) {
    stream_.read(target, static_cast<std::streamsize>(size));
    left_ -= std::min<std::uint64_t>(left_, size);
    return stream_.gcount() == static_cast<std::streamsize>(size);
  }

  uLong checksum_of_payload(std::uint64_t length) {
    uLong sum = checksum_of_length(length);
    std::array<char, 4096> piece;
    for (std::uint64_t rest = length; rest > 0;) {
      const std::size_t size = std::min<std::uint64_t>(rest, piece.size());
      if (!read(piece.data(), size))
        return ~std::uint64_t{0}; // no checksum
      sum = checksum(sum, {piece.data(), size});
      rest -= size;
    }
    return sum;
  }

  std::vector<char> buffer_;
  std::ifstream stream_;
  std::uint64_t left_ = 0;
};

std::size_t size_of_records(const std::filesystem::path &file) {
  if (!std::filesystem::is_regular_file(file))
    return 0;
  Scan scan(file);
  std::size_t total = 0;
  for (std::size_t size = scan.next(); size > 0; size = scan.next())
    total += size;
  return total;
}

boost::interprocess::mapped_region mapped(const std::filesystem::path &file, std::size_t size) try {
  using namespace boost::interprocess;
  return size == 0 ? mapped_region()
                   : mapped_region(file_mapping(file.c_str(), read_only), read_only, 0, size);
} catch (const boost::interprocess::interprocess_exception &error) {
  throw std::runtime_error(file.string() + ": cannot read the file: " + error.what());
}

} // namespace

JournalRecords::JournalRecords(const std::filesystem::path &file)
    : size_(size_of_records(file)), region_(mapped(file, size_)) {}

void JournalRecords::visit(const std::function<void(std::string_view)> &visit) const {
  const char *const bytes = static_cast<const char *>(region_.get_address());
  for (std::size_t position = 0; position < size_;) {
    const std::size_t length = length_in(bytes + position);
    visit({bytes + position + prefix_size, length});
    position += prefix_size + length;
  }
}

JournalWriter::JournalWriter(std::filesystem::path file)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0)
    fail_with_reason(file_, "open the file for writing");
  cut_off_unfinished_record();
}

JournalWriter::~JournalWriter() {
  try {
    synchronise();
  } catch (const std::exception &error) {
    log::warning(error.what());
  }
  ::close(descriptor_);
}

void JournalWriter::cut_off_unfinished_record() {
  if (!std::filesystem::is_regular_file(file_))
    return;
  size_ = size_of_records(file_);
  const std::uintmax_t surplus = std::filesystem::file_size(file_) - size_;
  if (surplus == 0)
    return;
  log::warning(file_.string() + ": cut off " + std::to_string(surplus) +
               " bytes of a record that was not finished");
  if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0)
    fail_with_reason(file_, "cut off an unfinished record");
}

void JournalWriter::append(std::string_view payload) {
  const Prefix prefix = prefix_of(payload);
  record_.assign(prefix.data(), prefix.size());
  record_.append(payload);
  try {
    write_completely(descriptor_, record_, file_);
    synchronised_ = false;
    if (Clock::now() >= next_synchronisation_)
      begin_synchronisation();
  } catch (...) {
    // A half-written record would hide all later ones. If even this fails, the reader stops here.
    [[maybe_unused]] const int failed = ::ftruncate(descriptor_, static_cast<off_t>(size_));
    throw;
  }
  size_ += record_.size();
}

// The disk takes milliseconds, in which other points can be computed.
void JournalWriter::begin_synchronisation() {
  next_synchronisation_ = Clock::now() + synchronisation_interval;
  if (synchronising_ && ::aio_error(&request_) == EINPROGRESS)
    return;
  end_synchronisation();
  request_ = {};
  request_.aio_fildes = descriptor_;
  request_.aio_sigevent.sigev_notify = SIGEV_NONE;
  if (::aio_fsync(O_SYNC, &request_) != 0)
    fail_with_reason(file_, "synchronise with the disk");
  synchronising_ = true;
}

// Waits for it.
void JournalWriter::end_synchronisation() {
  if (!std::exchange(synchronising_, false))
    return;
  const aiocb *const requests[] = {&request_};
  while (::aio_error(&request_) == EINPROGRESS)
    ::aio_suspend(requests, 1, nullptr);
  errno = ::aio_error(&request_);
  if (::aio_return(&request_) != 0)
    fail_with_reason(file_, "synchronise with the disk");
}

void JournalWriter::restore_if_removed() {
  if (std::filesystem::exists(file_))
    return;
  std::filesystem::create_directories(file_.parent_path());
  const int fresh = ::open(file_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  if (fresh < 0)
    fail_with_reason(file_, "open the file for writing");
  const int removed = std::exchange(descriptor_, fresh);
  std::vector<char> bytes(std::size_t{1} << 20);
  for (off_t position = 0; position < static_cast<off_t>(size_);) {
    const ssize_t read = ::pread(removed, bytes.data(), bytes.size(), position);
    if (read <= 0)
      fail_with_reason(file_, "restore the removed file");
    write_completely(fresh, {bytes.data(), static_cast<std::size_t>(read)}, file_);
    position += read;
  }
  ::close(removed);
  synchronised_ = false;
  log::warning(file_.string() + ": was removed, and is written again");
}

void JournalWriter::synchronise() {
  end_synchronisation();
  restore_if_removed();
  if (synchronised_)
    return;
  if (::fsync(descriptor_) != 0)
    fail_with_reason(file_, "synchronise with the disk");
  synchronised_ = true;
  next_synchronisation_ = Clock::now() + synchronisation_interval;
}

} // namespace vibroimpact::output
