// Which files of a result folder are this program's own.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace vibroimpact::output {

/// Folder of the journals, and of the list of written files, below the result folder.
inline constexpr const char *journal_folder = "journal";

/// "rank-00003.journal": the order of the names is the order of the ranks.
std::string journal_name(int rank);
bool is_journal_name(const std::string &name);

/// Files entered so far, relative to the folder. A list that does not exist is empty.
std::set<std::string> written_files(const std::filesystem::path &folder);
/// Enters one; before it is written, so that a killed run leaves nothing unlisted behind.
void add_written_file(const std::filesystem::path &folder, const std::filesystem::path &relative);

/// Removes the files every run writes, the journals, the listed files, and the folders that these
/// leave empty. Nothing else is touched. Throws std::runtime_error when one cannot be removed.
void remove_written_files(const std::filesystem::path &folder);

} // namespace vibroimpact::output
