#include "model/record_file.h"

#include "common/hdf5_file.h"
#include "parameters/text.h"
#include "reduction/body_file.h"

#include <boost/algorithm/string.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

namespace vibroimpact::model {

namespace {

using Cells = std::vector<std::string>;

Cells split(const std::string &line, const std::string &separator) {
  Cells cells;
  if (separator == "space")
    boost::split(cells, line, boost::is_any_of(" \t"), boost::token_compress_on);
  else
    boost::split(cells, line, boost::is_any_of(separator == "comma" ? "," : ";"));
  for (std::string &cell : cells) {
    boost::trim(cell);
    boost::trim_if(cell, boost::is_any_of("\""));
  }
  return cells;
}

std::optional<double> number(const std::string &text) {
  const char *begin = text.data() + (text.starts_with("+") ? 1 : 0);
  const char *end = text.data() + text.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || rest != end)
    return std::nullopt;
  return value;
}

/// One column of a text file, by its number or its name.
class Column {
public:
  Column(std::string key, std::string name) : key_(std::move(key)), name_(std::move(name)) {
    std::size_t position = 0;
    const auto [rest, error] = std::from_chars(name_.data(), name_.data() + name_.size(), position);
    if (error == std::errc() && rest == name_.data() + name_.size()) {
      if (position == 0)
        throw RecordError(key_, "a number from 1 or the name of a column");
      position_ = position - 1;
    }
  }

  bool named() const { return !position_; }

  void find_in(const Cells &header) {
    for (std::size_t i = 0; i < header.size(); ++i)
      if (header[i] == name_)
        position_ = i;
    if (!position_)
      throw RecordError(key_, "the number of a column, or one of the names in the first line: " +
                                  parameters::join(header, ", ") +
                                  parameters::suggestion(name_, header));
  }

  double read(const Cells &cells, long line) const {
    const std::string where = "line " + std::to_string(line) + " of the record ";
    if (*position_ >= cells.size())
      throw RecordError(key_, where + "has only " + std::to_string(cells.size()) +
                                  (cells.size() == 1 ? " column; is the separator right?"
                                                     : " columns; is the separator right?"));
    const std::optional<double> value = number(cells[*position_]);
    if (!value || !std::isfinite(*value))
      throw RecordError(key_,
                        where + "has '" + cells[*position_] + "' there, which is no finite number");
    return *value;
  }

  bool holds_number(const Cells &cells) const {
    return position_ && *position_ < cells.size() && number(cells[*position_]);
  }

private:
  std::string key_;
  std::string name_;
  std::optional<std::size_t> position_;
};

void append(Samples &samples, double time, double value, const std::string &where) {
  if (!samples.time.empty() && !(time > samples.time.back()))
    throw RecordError("Time column", "its values must increase, but in " + where +
                                         " of the record " + parameters::number_text(time) +
                                         " follows " +
                                         parameters::number_text(samples.time.back()));
  samples.time.push_back(time);
  samples.value.push_back(value);
}

void require_two(const Samples &samples) {
  if (samples.time.size() < 2)
    throw RecordError("File", "must hold two samples at least; this one has " +
                                  std::to_string(samples.time.size()));
}

std::vector<double> dataset(const Hdf5File &file, const std::string &key, const std::string &path) {
  if (!path.starts_with("/") || !file.contains(path) || file.is_group(path))
    throw RecordError(key, "the path of a dataset in the HDF5 file, such as /time");
  if (file.shape(path).size() != 1)
    throw RecordError(key, "a dataset of one dimension; this one has " +
                               std::to_string(file.shape(path).size()));
  std::vector<double> values = file.read_numbers(path);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw RecordError(key, "sample " + std::to_string(i + 1) + " of the record is not finite");
  return values;
}

using parameters::Values;

std::string file_name(const Values &section, const std::string &file_folder) {
  return (std::filesystem::path(file_folder) / section.text("File")).string();
}

// The whole file, of either kind.
std::string file_content(const Values &section, const std::string &file) {
  std::string content = reduction::read_file(file).value_or("");
  if (content.empty())
    section.reject("File",
                   "must name a file that can be read and is not empty; there is none at " + file);
  return content;
}

void check_content(const Values &section, const std::string &content,
                   const std::vector<std::string> &checksums) {
  const std::string start = section.text("File") + " ";
  for (const std::string &checksum : checksums)
    if (checksum.starts_with(start) && checksum != start + reduction::content_hash(content))
      section.reject("File", "its content is not what it was when the checksum '" + checksum +
                                 "' was noted in File checksums; it has " +
                                 reduction::content_hash(content) + " now");
}

} // namespace

bool is_hdf5(const std::string &file) {
  const std::string suffix = boost::to_lower_copy(std::filesystem::path(file).extension().string());
  return suffix == ".h5" || suffix == ".hdf5";
}

Samples read_text_record(const std::string &content, const RecordLayout &layout) {
  Column time(layout.time_key, layout.time_column);
  Column value("Value column", layout.value_column);
  if (content.find('\0') != std::string::npos)
    throw RecordError("File",
                      "must be plain text; this file holds NUL bytes, as binary files do and "
                      "texts in UTF-16");
  Samples samples;
  std::istringstream text(content);
  std::string line;
  bool first = true;
  for (long number = 1; std::getline(text, line); ++number) {
    if (number == 1 && line.starts_with("\xEF\xBB\xBF")) // byte order mark
      line.erase(0, 3);
    boost::trim(line);
    if (line.empty() || line[0] == '#' || line[0] == '%')
      continue;
    const Cells cells = split(line, layout.separator);
    const bool header = first && (time.named() || value.named() ||
                                  !(time.holds_number(cells) || value.holds_number(cells)));
    first = false;
    if (header) {
      for (Column *column : {&time, &value})
        if (column->named())
          column->find_in(cells);
      continue;
    }
    append(samples, time.read(cells, number), value.read(cells, number),
           "line " + std::to_string(number));
  }
  require_two(samples);
  return samples;
}

Samples read_hdf5_record(const std::string &file, const RecordLayout &layout) {
  try {
    const Hdf5File record = Hdf5File::open(file);
    const auto time = dataset(record, "Time column", layout.time_column);
    const auto value = dataset(record, "Value column", layout.value_column);
    if (time.size() != value.size())
      throw RecordError("Value column", "a dataset as long as that of the time; it has " +
                                            std::to_string(value.size()) + " values for " +
                                            std::to_string(time.size()) + " instants");
    Samples samples;
    for (std::size_t i = 0; i < time.size(); ++i)
      append(samples, time[i], value[i], "sample " + std::to_string(i + 1));
    require_two(samples);
    return samples;
  } catch (const RecordError &) {
    throw;
  } catch (const std::runtime_error &error) {
    throw RecordError("File",
                      std::string("must be an HDF5 file that can be read: ") + error.what());
  }
}

Samples read_record(const Values &section, const std::string &file_folder,
                    const std::vector<std::string> &file_checksums, const RecordLayout &layout) {
  const std::string file = file_name(section, file_folder);
  const std::string content = file_content(section, file);
  check_content(section, content, file_checksums);
  try {
    return is_hdf5(file) ? read_hdf5_record(file, layout) : read_text_record(content, layout);
  } catch (const RecordError &error) {
    section.reject(error.key() == "Time column" ? layout.time_key : error.key(), error.what());
  }
}

double file_unit(const Values &section, const std::string &key,
                 const parameters::Dimension &dimension) {
  return section.has(key) ? section.part(key, "1 " + section.text(key), dimension) : 1;
}

std::string file_checksum(const Values &section, const std::string &file_folder) {
  if (!section.has("File"))
    return "";
  const std::string content = reduction::read_file(file_name(section, file_folder)).value_or("");
  return content.empty() ? "" : section.text("File") + " " + reduction::content_hash(content);
}

} // namespace vibroimpact::model
