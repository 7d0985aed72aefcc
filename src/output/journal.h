// The append-only file in which a rank keeps what it has finished. A record is in the hands of the
// operating system when append() returns, so that no death of the program loses it, and is complete
// or absent after a kill at any moment. It is on the disk after synchronise(). append() sets that
// going in the background when the last time was a fifth of a second ago: only a power cut can take
// what came since.
//
// Record: length of the payload (8 bytes), checksum over length and payload (CRC-32, 4 bytes),
// payload. All numbers in the byte order of the machine.
#pragma once

#include <aio.h>
#include <boost/interprocess/mapped_region.hpp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace vibroimpact::output {

/// The complete records of a journal as they are when it is opened. They are mapped, not copied:
/// the operating system takes their memory back when it is short.
class JournalRecords {
public:
  /// Goes through the file up to the first record that is torn or damaged. A file that does not
  /// exist has no records. Throws std::runtime_error when the file cannot be read.
  explicit JournalRecords(const std::filesystem::path &file);

  /// Calls `visit` for the payload of each record in the order they were appended. A payload stays
  /// where it is as long as this object.
  void visit(const std::function<void(std::string_view payload)> &visit) const;
  /// What the records take [bytes].
  std::size_t size() const { return size_; }

private:
  std::size_t size_;
  boost::interprocess::mapped_region region_;
};

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
  /// Everything appended so far has reached the disk when this returns. A journal that was removed
  /// meanwhile is written again: the open file still holds its records.
  void synchronise();

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds synchronisation_interval{200};

  void cut_off_unfinished_record();
  void restore_if_removed();
  void begin_synchronisation();
  void end_synchronisation();

  std::filesystem::path file_;
  int descriptor_;
  std::uintmax_t size_ = 0;
  std::string record_; ///< the newest
  bool synchronised_ = true;
  bool synchronising_ = false;
  aiocb request_{};                        ///< of the synchronisation in the background
  Clock::time_point next_synchronisation_; ///< the epoch: at once
};

} // namespace vibroimpact::output
