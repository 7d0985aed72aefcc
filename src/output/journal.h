// The append-only file in which a rank keeps what it has finished. A record is durable when
// append() returns, and is complete or absent after a kill at any moment.
//
// Record: length of the payload (8 bytes), checksum over length and payload (CRC-32, 4 bytes),
// payload. All numbers in the byte order of the machine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace vibroimpact {

/// Calls `visit` for each complete record in the order they were appended and stops at the first
/// one that is torn or damaged. Returns the size of the readable part [bytes]. A file that does not
/// exist is empty. Throws std::runtime_error when the file cannot be read.
std::uintmax_t read_journal(const std::filesystem::path &file,
                            const std::function<void(const std::string &payload)> &visit);

/// Appends to a journal. Every failure (full disk, folder not writable) is a std::runtime_error
/// that names the file and the reason; the records before it stay readable.
class JournalWriter {
public:
  /// Opens or creates the file; an unfinished last record of a killed run is cut off first.
  explicit JournalWriter(std::filesystem::path file);
  JournalWriter(const JournalWriter &) = delete;
  JournalWriter &operator=(const JournalWriter &) = delete;
  ~JournalWriter();

  void append(std::string_view payload);

private:
  void cut_off_unfinished_record();

  std::filesystem::path file_;
  int descriptor_;
  std::uintmax_t size_ = 0;
};

} // namespace vibroimpact
