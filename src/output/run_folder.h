// The folder of one run: decides whether it may be used, knows its files, and keeps a list of
// everything written there, so that only these are ever removed.
#pragma once

#include <filesystem>
#include <mpi.h>
#include <set>
#include <string>
#include <vector>

namespace vibroimpact::output {

enum class ExistingFolder {
  refuse,    ///< an error
  overwrite, ///< remove what an earlier run of this program wrote there, and nothing else
  resume     ///< go on; the parameters must be the same
};

class RunFolder {
public:
  /// Collective; rank 0 looks and acts, every rank gets the same decision. Makes the folder,
  /// removes or checks what is there, locks it against a second run, and writes `parameters`, the
  /// complete echo, to parameters.prm. InputError when the folder is not empty and `existing` is
  /// refuse, when there is nothing to resume, when the stored parameters differ from `parameters`
  /// (the message shows the lines), when another run is at work in it, or when it cannot be
  /// written.
  RunFolder(MPI_Comm communicator, std::filesystem::path folder, ExistingFolder existing,
            const std::string &parameters);
  RunFolder(const RunFolder &) = delete;
  RunFolder &operator=(const RunFolder &) = delete;
  ~RunFolder();

  const std::filesystem::path &path() const { return folder_; }
  bool resumed() const { return resumed_; }

  std::filesystem::path results_file() const { return folder_ / "results.h5"; }
  std::filesystem::path summary_file() const { return folder_ / "summary.txt"; }
  std::filesystem::path summary_json_file() const { return folder_ / "summary.json"; }
  std::filesystem::path log_file() const { return folder_ / "log.txt"; }
  /// The complete echo of a run's parameters.
  static std::filesystem::path parameters_file(const std::filesystem::path &folder) {
    return folder / "parameters.prm";
  }
  std::filesystem::path journal_file(int rank) const;
  /// Journals of all ranks of this and earlier runs, by rank.
  std::vector<std::filesystem::path> journal_files() const;

  /// Rank 0: full name of a further file, given relative to the folder. Its folder is made and the
  /// file is entered in the list of written ones. Throws std::runtime_error.
  std::filesystem::path claim(const std::filesystem::path &relative);

  /// Rank 0: makes again what a resumed run needs if it was removed meanwhile. Throws
  /// std::runtime_error.
  void restore() const;

private:
  void prepare(ExistingFolder existing, const std::string &parameters);
  void check_stored_parameters(const std::string &parameters) const;
  void make_folders() const;
  [[noreturn]] void refuse(const std::string &reason) const;
  void lock();

  std::filesystem::path folder_;
  std::string parameters_; ///< the complete echo
  bool resumed_;
  int lock_descriptor_ = -1;
  std::set<std::string> claimed_;
};

/// The lines in which two echoes differ, each with its section: "stored: Contact heads/Clearance =
/// 5 mm" and "given: ...". Empty when they agree.
std::string parameter_differences(const std::string &stored, const std::string &given);

} // namespace vibroimpact::output
