// Reads two columns of a file as the samples of a record.
#pragma once

#include "model/recorded_history.h"
#include "parameters/values.h"

#include <stdexcept>
#include <string>

namespace vibroimpact::model {

/// Where the samples stand in a file.
struct RecordLayout {
  std::string time_column; ///< number from 1 or name of a column; path of a dataset in HDF5
  std::string value_column;
  std::string separator; ///< of a text file: "comma", "semicolon" or "space" (blanks and tabs)
  std::string time_key = "Time column"; ///< of the section that names the first column
};

/// What is wrong with a record, and the key of the section that says where to look.
class RecordError : public std::runtime_error {
public:
  RecordError(std::string key, const std::string &problem)
      : std::runtime_error(problem), key_(std::move(key)) {}
  const std::string &key() const { return key_; }

private:
  std::string key_; ///< "File", "Time column", "Value column"
};

/// The samples of a text file, whose whole text is `content`, as they stand there. Empty lines and
/// lines beginning with # or % do not count; the first other line may hold names of the columns.
/// Throws RecordError, with the number of the line, for a cell that is no finite number, for time
/// that does not increase, and for less than two samples.
Samples read_text_record(const std::string &content, const RecordLayout &layout);

/// The samples of two one-dimensional datasets of equal length. Throws RecordError likewise.
Samples read_hdf5_record(const std::string &file, const RecordLayout &layout);

/// The samples of the file that the key File of a section names, relative to `file_folder`.
/// reject()s a file that cannot be read, whose content differs from a checksum noted earlier, or
/// that is no record.
Samples read_record(const parameters::Values &section, const std::string &file_folder,
                    const std::vector<std::string> &file_checksums, const RecordLayout &layout);
/// What one unit of a column is in SI, which `key` names; 1 where the key is empty. reject()s a
/// unit of another dimension.
double file_unit(const parameters::Values &section, const std::string &key,
                 const parameters::Dimension &dimension);

} // namespace vibroimpact::model
