#include "output/journal.h"

#include "common/durable_file.h"
#include "common/log.h"

#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>
#include <utility>

namespace vibroimpact {

namespace {

constexpr std::size_t length_size = sizeof(std::uint64_t);
constexpr std::size_t prefix_size = length_size + sizeof(std::uint32_t);
using Prefix = std::array<char, prefix_size>;

/// The length takes part, so that a stretch of zeros is no valid record.
std::uint32_t checksum(std::uint64_t length, std::string_view payload) {
  boost::crc_32_type crc;
  crc.process_bytes(&length, length_size);
  crc.process_bytes(payload.data(), payload.size());
  return crc.checksum();
}

Prefix prefix_of(std::string_view payload) {
  const std::uint64_t length = payload.size();
  const std::uint32_t sum = checksum(length, payload);
  Prefix prefix;
  std::memcpy(prefix.data(), &length, sizeof length);
  std::memcpy(prefix.data() + length_size, &sum, sizeof sum);
  return prefix;
}

/// The next payload, or false at the end of the readable part. `left` is what the file still has.
bool read_record(std::istream &stream, std::uintmax_t left, std::string &payload) {
  Prefix prefix;
  if (left < prefix_size || !stream.read(prefix.data(), prefix_size))
    return false;
  std::uint64_t length = 0;
  std::uint32_t sum = 0;
  std::memcpy(&length, prefix.data(), sizeof length);
  std::memcpy(&sum, prefix.data() + length_size, sizeof sum);
  if (length > left - prefix_size)
    return false;
  payload.resize(length);
  if (!stream.read(payload.data(), static_cast<std::streamsize>(length)))
    return false;
  return checksum(length, payload) == sum;
}

} // namespace

std::uintmax_t read_journal(const std::filesystem::path &file,
                            const std::function<void(const std::string &)> &visit) {
  if (!std::filesystem::is_regular_file(file))
    return 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    fail_with_reason(file, "read the file");
  const std::uintmax_t size = std::filesystem::file_size(file);
  std::uintmax_t position = 0;
  std::string payload;
  while (read_record(stream, size - position, payload)) {
    position += prefix_size + payload.size();
    visit(payload);
  }
  return position;
}

JournalWriter::JournalWriter(std::filesystem::path file)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0)
    fail_with_reason(file_, "open the file for writing");
  cut_off_unfinished_record();
}

JournalWriter::~JournalWriter() { ::close(descriptor_); }

void JournalWriter::cut_off_unfinished_record() {
  if (!std::filesystem::is_regular_file(file_))
    return;
  size_ = read_journal(file_, [](const std::string &) {});
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
  std::string record(prefix.data(), prefix.size());
  record.append(payload);
  try {
    write_completely(descriptor_, record, file_);
    if (::fsync(descriptor_) != 0)
      fail_with_reason(file_, "synchronise with the disk");
  } catch (...) {
    // A half-written record would hide all later ones. If even this fails, the reader stops here.
    [[maybe_unused]] const int failed = ::ftruncate(descriptor_, static_cast<off_t>(size_));
    throw;
  }
  size_ += record.size();
}

} // namespace vibroimpact
