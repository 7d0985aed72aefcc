#include "model/record_file.h"

#include "common/hdf5_file.h"
#include "parameters/table_text.h"
#include "parameters/text.h"
#include "reduction/named_file.h"

#include <boost/algorithm/string.hpp>

#include <charconv>
#include <cmath>
#include <optional>

namespace vibroimpact::model {

namespace {

using parameters::cell_number;
using parameters::Cells;

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
    const std::optional<double> value = cell_number(cells[*position_]);
    if (!value || !std::isfinite(*value))
      throw RecordError(key_,
                        where + "has '" + cells[*position_] + "' there, which is no finite number");
    return *value;
  }

  bool holds_number(const Cells &cells) const {
    return position_ && *position_ < cells.size() && cell_number(cells[*position_]);
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

} // namespace

Samples read_text_record(const std::string &content, const RecordLayout &layout) {
  Column time(layout.time_key, layout.time_column);
  Column value("Value column", layout.value_column);
  if (content.find('\0') != std::string::npos)
    throw RecordError("File",
                      "must be plain text; this file holds NUL bytes, as binary files do and "
                      "texts in UTF-16");
  Samples samples;
  bool first = true;
  const auto read_line = [&](long number, const Cells &cells) {
    const bool header = first && (time.named() || value.named() ||
                                  !(time.holds_number(cells) || value.holds_number(cells)));
    first = false;
    if (!header) {
      append(samples, time.read(cells, number), value.read(cells, number),
             "line " + std::to_string(number));
      return;
    }
    for (Column *column : {&time, &value})
      if (column->named())
        column->find_in(cells);
  };
  parameters::for_each_table_line(content, layout.separator, read_line);
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
  const std::string file = reduction::named_file(section, file_folder);
  const std::string content = reduction::read_named_file(section, file_folder, file_checksums);
  try {
    return reduction::is_hdf5(file) ? read_hdf5_record(file, layout)
                                    : read_text_record(content, layout);
  } catch (const RecordError &error) {
    section.reject(error.key() == "Time column" ? layout.time_key : error.key(), error.what());
  }
}

double file_unit(const Values &section, const std::string &key,
                 const parameters::Dimension &dimension) {
  return section.has(key) ? section.part(key, "1 " + section.text(key), dimension) : 1;
}

} // namespace vibroimpact::model
