#include "reduction/named_file.h"

#include "reduction/body_file.h"

#include <boost/algorithm/string.hpp>

#include <filesystem>

namespace vibroimpact::reduction {

using parameters::Values;

namespace {

void check_content(const Values &section, const std::string &content,
                   const std::vector<std::string> &checksums) {
  const std::string start = section.text("File") + " ";
  for (const std::string &checksum : checksums)
    if (checksum.starts_with(start) && checksum != start + content_hash(content))
      section.reject("File", "its content is not what it was when the checksum '" + checksum +
                                 "' was noted in File checksums; it has " + content_hash(content) +
                                 " now");
}

} // namespace

std::string named_file(const Values &section, const std::string &file_folder) {
  return (std::filesystem::path(file_folder) / section.text("File")).string();
}

std::string read_named_file(const Values &section, const std::string &file_folder,
                            const std::vector<std::string> &checksums) {
  const std::string file = named_file(section, file_folder);
  std::string content = read_file(file).value_or("");
  if (content.empty())
    section.reject("File",
                   "must name a file that can be read and is not empty; there is none at " + file);
  check_content(section, content, checksums);
  return content;
}

std::string file_checksum(const Values &section, const std::string &file_folder) {
  if (!section.has("File"))
    return "";
  const std::string content = read_file(named_file(section, file_folder)).value_or("");
  return content.empty() ? "" : section.text("File") + " " + content_hash(content);
}

bool is_hdf5(const std::string &file) {
  const std::string suffix = boost::to_lower_copy(std::filesystem::path(file).extension().string());
  return suffix == ".h5" || suffix == ".hdf5";
}

} // namespace vibroimpact::reduction
