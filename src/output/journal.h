// The append-only file in which a rank keeps what it has finished. A record is in the hands of the
// operating system when append() returns, so that no death of the program loses it, and is complete
// or absent after a kill at any moment. It is on the disk after synchronise(), which append() calls
// by itself when the last time was a fifth of a second ago: only a power cut can take what came
// since.
//
// Record: length of the payload (8 bytes), checksum over length and payload (CRC-32, 4 bytes),
// payload. All numbers in the byte order of the machine.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace vibroimpact {

/// The content of a journal. A file that does not exist is empty. Throws std::runtime_error when
/// the file cannot be read.
std::string journal_bytes(const std::filesystem::path &file);

/// Calls `visit` for the payload of each complete record in the order they were appended and stops
/// at the first one that is torn or damaged. Returns the size of the readable part [bytes].
std::size_t visit_records(std::string_view bytes,
                          const std::function<void(std::string_view payload)> &visit);

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
  /// Everything appended so far has reached the disk when this returns.
  void synchronise();

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds synchronisation_interval{200};

  void cut_off_unfinished_record();

  std::filesystem::path file_;
  int descriptor_;
  std::uintmax_t size_ = 0;
  bool synchronised_ = true;
  Clock::time_point next_synchronisation_; ///< the epoch: at once
};

} // namespace vibroimpact
