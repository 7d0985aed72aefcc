#include "output/written_files.h"

#include "common/durable_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace vibroimpact::output {

namespace fs = std::filesystem;

namespace {

constexpr std::array files_of_every_run = {"results.h5", "summary.txt", "summary.json", "log.txt",
                                           "parameters.prm"};

fs::path list_file(const fs::path &folder) { return folder / journal_folder / "written_files.txt"; }

/// A damaged or foreign list must not lead out of the folder.
bool stays_inside(const fs::path &relative) {
  return relative.is_relative() &&
         std::find(relative.begin(), relative.end(), "..") == relative.end();
}

std::set<fs::path> own_files(const fs::path &folder) {
  std::set<fs::path> files = {list_file(folder)};
  for (const char *name : files_of_every_run)
    files.insert(folder / name);
  for (const std::string &relative : written_files(folder))
    if (stays_inside(relative))
      files.insert(folder / relative);
  if (fs::is_directory(folder / journal_folder))
    for (const fs::directory_entry &entry : fs::directory_iterator(folder / journal_folder))
      if (is_journal_name(entry.path().filename().string()))
        files.insert(entry.path());
  return files;
}

void remove_file(const fs::path &file) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(file)))
    fs::remove(file, error);
  if (error)
    throw std::runtime_error(file.string() + ": cannot remove the file: " + error.message());
}

} // namespace

std::string journal_name(int rank) {
  std::array<char, 32> name;
  std::snprintf(name.data(), name.size(), "rank-%05d.journal", rank);
  return name.data();
}

bool is_journal_name(const std::string &name) {
  const std::string prefix = "rank-";
  const std::string suffix = ".journal";
  if (name.size() <= prefix.size() + suffix.size() || name.rfind(prefix, 0) != 0 ||
      name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
    return false;
  return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()),
                     name.end() - static_cast<std::ptrdiff_t>(suffix.size()),
                     [](unsigned char letter) { return std::isdigit(letter) != 0; });
}

std::set<std::string> written_files(const fs::path &folder) {
  std::set<std::string> files;
  std::ifstream stream(list_file(folder));
  for (std::string line; std::getline(stream, line);)
    if (!line.empty())
      files.insert(line);
  return files;
}

void add_written_file(const fs::path &folder, const fs::path &relative) {
  std::ofstream stream(list_file(folder), std::ios::app);
  stream << relative.string() << std::endl;
  if (!stream)
    fail_with_reason(list_file(folder), "write");
}

void remove_written_files(const fs::path &folder) {
  std::set<fs::path> folders;
  for (const fs::path &file : own_files(folder)) {
    remove_file(file);
    remove_file(temporary_name(file));
    if (file.parent_path() != folder)
      folders.insert(file.parent_path());
  }
  for (const fs::path &emptied : folders)
    if (fs::is_directory(emptied) && fs::is_empty(emptied))
      fs::remove(emptied);
}

} // namespace vibroimpact::output
