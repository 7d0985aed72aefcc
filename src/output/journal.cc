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

/// The first complete record of the bytes, with its prefix; empty when there is none.
std::string_view first_record(std::string_view bytes) {
  if (bytes.size() < prefix_size)
    return {};
  std::uint64_t length = 0;
  std::uint32_t sum = 0;
  std::memcpy(&length, bytes.data(), sizeof length);
  std::memcpy(&sum, bytes.data() + length_size, sizeof sum);
  if (length > bytes.size() - prefix_size ||
      checksum(length, bytes.substr(prefix_size, length)) != sum)
    return {};
  return bytes.substr(0, prefix_size + length);
}

} // namespace

std::string journal_bytes(const std::filesystem::path &file) {
  if (!std::filesystem::is_regular_file(file))
    return {};
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    fail_with_reason(file, "read the file");
  std::string bytes(std::filesystem::file_size(file), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

std::size_t visit_records(std::string_view bytes,
                          const std::function<void(std::string_view)> &visit) {
  std::size_t position = 0;
  for (std::string_view record = first_record(bytes); !record.empty();
       record = first_record(bytes.substr(position))) {
    position += record.size();
    visit(record.substr(prefix_size));
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
  size_ = visit_records(journal_bytes(file_), [](std::string_view) {});
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
    synchronised_ = false;
    if (Clock::now() >= next_synchronisation_)
      synchronise();
  } catch (...) {
    // A half-written record would hide all later ones. If even this fails, the reader stops here.
    [[maybe_unused]] const int failed = ::ftruncate(descriptor_, static_cast<off_t>(size_));
    throw;
  }
  size_ += record.size();
}

void JournalWriter::synchronise() {
  if (synchronised_)
    return;
  if (::fsync(descriptor_) != 0)
    fail_with_reason(file_, "synchronise with the disk");
  synchronised_ = true;
  next_synchronisation_ = Clock::now() + synchronisation_interval;
}

} // namespace vibroimpact
