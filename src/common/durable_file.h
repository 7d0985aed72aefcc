// Files that are whole or absent, and errors that name the path and the reason.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace vibroimpact {

/// std::runtime_error "PATH: cannot ACTION: REASON", the reason taken from errno.
[[noreturn]] void fail_with_reason(const std::filesystem::path &path, const std::string &action);

/// Writes all bytes to an open descriptor. Throws std::runtime_error.
void write_completely(int descriptor, std::string_view bytes, const std::filesystem::path &path);

/// Creates or empties the file and writes the bytes. Throws std::runtime_error.
void write_file(const std::filesystem::path &file, std::string_view bytes);

/// Lets `write` fill a temporary file beside `file`, makes it durable and renames it into place, so
/// that `file` always is a complete old or a complete new one. On any error the temporary file is
/// removed and `file` left alone. Throws std::runtime_error.
void replace_file(const std::filesystem::path &file,
                  const std::function<void(const std::filesystem::path &temporary)> &write);

/// The same with the text as content.
void replace_file(const std::filesystem::path &file, const std::string &text);

/// The name replace_file() uses for the temporary file.
std::filesystem::path temporary_name(const std::filesystem::path &file);

} // namespace vibroimpact
