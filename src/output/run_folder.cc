#include "output/run_folder.h"

#include "common/durable_file.h"
#include "common/error.h"
#include "output/collective.h"
#include "output/written_files.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace vibroimpact::output {

namespace fs = std::filesystem;

namespace {

std::string content_of(const fs::path &file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream)
    fail_with_reason(file, "read the file");
  return content.str();
}

/// "Contact heads/Clearance = 5 mm" for every entry of a .prm text.
std::vector<std::string> qualified_lines(const std::string &text) {
  const auto value_of = [](const std::string &line, const std::string &keyword) {
    return line.substr(line.find(keyword) + keyword.size());
  };
  std::vector<std::string> lines;
  std::vector<std::string> sections;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    line.erase(0, line.find_first_not_of(" \t"));
    if (line.rfind("subsection ", 0) == 0)
      sections.push_back(value_of(line, "subsection ") + "/");
    else if (line == "end" && !sections.empty())
      sections.pop_back();
    else if (line.rfind("set ", 0) == 0) {
      std::string qualified;
      for (const std::string &section : sections)
        qualified += section;
      lines.push_back(qualified + value_of(line, "set "));
    }
  }
  return lines;
}

std::string lines_missing_from(const std::vector<std::string> &others,
                               const std::vector<std::string> &lines, const std::string &label) {
  std::string text;
  for (const std::string &line : lines)
    if (std::find(others.begin(), others.end(), line) == others.end())
      text.append("\n  ").append(label).append(line);
  return text;
}

} // namespace

std::string parameter_differences(const std::string &stored, const std::string &given) {
  const std::vector<std::string> old_lines = qualified_lines(stored);
  const std::vector<std::string> new_lines = qualified_lines(given);
  return lines_missing_from(new_lines, old_lines, "stored: ") +
         lines_missing_from(old_lines, new_lines, "given:  ");
}

RunFolder::RunFolder(MPI_Comm communicator, fs::path folder, ExistingFolder existing,
                     const std::string &parameters)
    : folder_(std::move(folder)), parameters_(parameters),
      resumed_(existing == ExistingFolder::resume) {
  run_on_first_rank(communicator, [&] {
    try {
      prepare(existing, parameters);
    } catch (const InputError &) {
      throw;
    } catch (const fs::filesystem_error &error) {
      refuse(error.code().message());
    } catch (const std::runtime_error &error) {
      refuse(error.what());
    }
  });
}

RunFolder::~RunFolder() {
  if (lock_descriptor_ >= 0)
    ::close(lock_descriptor_);
}

// Nothing is computed yet, and another folder may do.
void RunFolder::refuse(const std::string &reason) const {
  throw InputError("the result folder " + folder_.string() + " cannot be used: " + reason +
                   "\n  choose another one with --output.");
}

void RunFolder::prepare(ExistingFolder existing, const std::string &parameters) {
  if (existing == ExistingFolder::resume)
    check_stored_parameters(parameters);
  if (fs::exists(folder_) && !fs::is_directory(folder_))
    throw InputError("the result folder " + folder_.string() + " is a file; choose another name");
  if (existing == ExistingFolder::refuse && fs::exists(folder_) && !fs::is_empty(folder_))
    throw InputError("the result folder " + folder_.string() +
                     " exists and is not empty; use --overwrite or --resume");
  make_folders();
  lock();
  if (existing == ExistingFolder::overwrite)
    remove_written_files(folder_);
  make_folders();
  claimed_ = written_files(folder_);
  if (existing != ExistingFolder::resume)
    replace_file(parameters_file(folder_), parameters);
}

void RunFolder::check_stored_parameters(const std::string &parameters) const {
  const fs::path file = parameters_file(folder_);
  if (!fs::is_regular_file(file))
    throw InputError("nothing to resume: " + folder_.string() + " holds no parameters.prm");
  const std::string stored = content_of(file);
  const std::string differences = parameter_differences(stored, parameters);
  if (!differences.empty())
    throw InputError("cannot resume " + folder_.string() +
                     ", it was computed with other parameters:" + differences);
}

void RunFolder::make_folders() const {
  std::error_code error;
  fs::create_directories(journal_file(0).parent_path(), error);
  if (error)
    throw std::runtime_error(folder_.string() +
                             ": cannot create the result folder: " + error.message());
}

void RunFolder::lock() {
  lock_descriptor_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // Some network file systems cannot lock a folder; only a lock held by another run is an error.
  if (::flock(lock_descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw InputError("another run is at work in the result folder " + folder_.string());
}

void RunFolder::restore() const {
  make_folders();
  if (!fs::exists(parameters_file(folder_)))
    replace_file(parameters_file(folder_), parameters_);
}

fs::path RunFolder::journal_file(int rank) const {
  return folder_ / journal_folder / journal_name(rank);
}

std::vector<fs::path> RunFolder::journal_files() const {
  std::vector<fs::path> files;
  for (const fs::directory_entry &entry : fs::directory_iterator(folder_ / journal_folder))
    if (is_journal_name(entry.path().filename().string()))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

fs::path RunFolder::claim(const fs::path &relative) {
  if (claimed_.insert(relative.string()).second)
    add_written_file(folder_, relative);
  fs::path file = folder_ / relative;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error)
    throw std::runtime_error(file.parent_path().string() +
                             ": cannot create the folder: " + error.message());
  return file;
}

} // namespace vibroimpact::output
