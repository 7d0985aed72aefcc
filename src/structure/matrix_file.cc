#include "structure/matrix_file.h"

#include "structure/beam_definition.h"
#include "structure/text_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <tuple>

namespace vibroimpact::structure {

namespace {

constexpr long none = std::numeric_limits<long>::max();

/// What stands before the entries.
struct Header {
  bool general = false;
  long rows = 0; ///< 0: not said
  long columns = 0;
  long entries = -1;     ///< -1: not said
  long begin = 0;        ///< of the entries, in bytes
  long lines = 0;        ///< before the entries
  std::string problem{}; ///< what is wrong with it
};

std::string small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  return text;
}

void read_banner(const std::string &line, Header &header) {
  const auto parts = parts_of(line);
  const bool known = parts.size() == 5 && parts[1] == "matrix" && parts[2] == "coordinate" &&
                     (parts[3] == "real" || parts[3] == "integer") &&
                     (parts[4] == "symmetric" || parts[4] == "general");
  if (!known)
    header.problem = "must be a Matrix Market file with the first line \"%%MatrixMarket matrix "
                     "coordinate real symmetric\" (or integer, general)";
  header.general = parts.size() == 5 && parts[4] == "general";
}

void read_sizes(const std::string &line, const std::string &file, Header &header) {
  const auto parts = parts_of(line);
  std::array<std::optional<long>, 3> numbers;
  for (std::size_t i = 0; i < 3 && i < parts.size(); ++i)
    numbers[i] = number_of<long>(parts[i]);
  if (parts.size() != 3 || !numbers[0] || !numbers[1] || !numbers[2])
    header.problem = "must have a line ROWS COLUMNS ENTRIES behind its comments, but " +
                     quoted_line(static_cast<std::size_t>(header.lines), file, line);
  else
    std::tie(header.rows, header.columns, header.entries) =
        std::tuple(*numbers[0], *numbers[1], *numbers[2]);
}

/// Local.
Header read_header(const std::string &path, const std::string &file) {
  Header header;
  std::ifstream in(path, std::ios::binary);
  std::string line;
  if (!std::getline(in, line) || !line.starts_with("%%")) {
    if (!in && line.empty())
      header.problem =
          "must name a file that can be read and is not empty; there is none at " + path;
    return header;
  }
  ++header.lines;
  read_banner(small_letters(line), header);
  while (header.problem.empty() && header.entries < 0) {
    if (!std::getline(in, line)) {
      header.problem = "must have a line ROWS COLUMNS ENTRIES, but " + file + " ends before it";
      break;
    }
    ++header.lines;
    if (!line.starts_with("%") && !parts_of(line).empty())
      read_sizes(line, file, header);
  }
  header.begin = in ? static_cast<long>(in.tellg()) : 0;
  return header;
}

/// Lines that begin in this rank's part of the file.
std::string own_lines(const std::string &path, long begin, MPI_Comm communicator) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &ranks);
  std::error_code unreadable;
  const auto end = static_cast<long>(std::filesystem::file_size(path, unreadable));
  if (unreadable || end <= begin)
    return "";
  std::ifstream in(path, std::ios::binary);
  const auto cut = [&](int part) {
    long at = begin + (end - begin) / ranks * part;
    if (part == 0 || part == ranks)
      return part == 0 ? begin : end;
    in.seekg(at - 1);
    for (char letter = 0; in.get(letter) && letter != '\n';)
      ++at;
    in.clear();
    return std::min(at, end);
  };
  const long first = cut(rank);
  std::string text(static_cast<std::size_t>(std::max(0L, cut(rank + 1) - first)), '\0');
  in.seekg(first);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

/// The lines of one rank.
class EntryReader {
public:
  EntryReader(const Header &header, int size, std::string file)
      : general_(header.general), size_(size), file_(std::move(file)) {}

  /// `before`: number of the line before the first.
  void read(const std::string &text, long before) {
    line_ = before;
    for (std::size_t position = 0; position < text.size() && problem_.empty();) {
      const std::string_view line = take_line(text, position);
      ++line_;
      if (const auto parts = parts_of(line); !parts.empty())
        take(line, parts);
    }
  }

  std::vector<MatrixEntry> entries{};
  long count = 0;    ///< lines with an entry
  long upper = none; ///< first line with an entry above the diagonal
  long lower = none;
  const std::string &problem() const { return problem_; }

private:
  void take(std::string_view line, const std::vector<std::string_view> &parts) {
    const bool three = parts.size() == 3;
    const std::optional<int> row = three ? number_of<int>(parts[0]) : std::nullopt;
    const std::optional<int> column = three ? number_of<int>(parts[1]) : std::nullopt;
    const std::optional<double> value = three ? number_of<double>(parts[2]) : std::nullopt;
    const auto number = static_cast<std::size_t>(line_);
    if (!row || !column || !value)
      problem_ = "must have lines ROW COLUMN VALUE, but " + quoted_line(number, file_, line);
    else if (*row < 1 || *column < 1 || *row > size_ || *column > size_)
      problem_ = "must have rows and columns from 1 to " + std::to_string(size_) +
                 ", as many as the Table has lines, but " + quoted_line(number, file_, line);
    else if (!std::isfinite(*value))
      problem_ = "must have finite values, but " + quoted_line(number, file_, line);
    else
      add(*row - 1, *column - 1, *value);
  }

  void add(int row, int column, double value) {
    ++count;
    if (row < column)
      upper = std::min(upper, line_);
    if (row > column)
      lower = std::min(lower, line_);
    if (row == column) {
      entries.push_back({row, column, value});
      return;
    }
    const double part = general_ ? value / 2 : value;
    const double skew = general_ ? value / 2 : 0;
    entries.push_back({row, column, part, skew});
    entries.push_back({column, row, part, -skew});
  }

  bool general_;
  int size_;
  std::string file_;
  long line_ = 0;
  std::string problem_;
};

long over_ranks(long value, MPI_Op operation, MPI_Comm communicator) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_LONG, operation, communicator);
  return value;
}

/// Of the lines of all ranks together.
std::string common_problem(const Header &header, const EntryReader &reader, const std::string &file,
                           MPI_Comm communicator) {
  const long count = over_ranks(reader.count, MPI_SUM, communicator);
  const long upper = over_ranks(reader.upper, MPI_MIN, communicator);
  const long lower = over_ranks(reader.lower, MPI_MIN, communicator);
  if (header.entries >= 0 && count != header.entries)
    return "must have as many entries as its line of sizes says, " +
           std::to_string(header.entries) + ", but " + file + " has " + std::to_string(count);
  if (count == 0)
    return "must have entries, but " + file + " has none";
  if (!header.general && upper != none && lower != none)
    return "must have one triangle of the matrix only, unless its first line is \"%%MatrixMarket "
           "matrix coordinate real general\", but line " +
           std::to_string(upper) + " of " + file + " is above the diagonal and line " +
           std::to_string(lower) + " below";
  return "";
}

} // namespace

void agree_on(const std::string &problem, const std::string &key, MPI_Comm communicator) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &ranks);
  int first = problem.empty() ? ranks : rank;
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator);
  if (first == ranks)
    return;
  auto size = static_cast<int>(problem.size());
  MPI_Bcast(&size, 1, MPI_INT, first, communicator);
  std::string text = problem;
  text.resize(static_cast<std::size_t>(size));
  MPI_Bcast(text.data(), size, MPI_CHAR, first, communicator);
  throw DefinitionError("Matrices", "", key, text);
}

std::vector<MatrixEntry> read_matrix_file(const std::string &path, const std::string &key, int size,
                                          MPI_Comm communicator) {
  const std::string file = std::filesystem::path(path).filename().string();
  Header header = read_header(path, file); // short: every rank for itself
  if (header.problem.empty() && header.entries >= 0 &&
      (header.rows != size || header.columns != size))
    header.problem = "must have as many rows and columns as the Table has lines, " +
                     std::to_string(size) + ", but " + file + " has " +
                     std::to_string(header.rows) + " x " + std::to_string(header.columns);
  agree_on(header.problem, key, communicator);
  const std::string text = own_lines(path, header.begin, communicator);
  const long own = std::count(text.begin(), text.end(), '\n');
  long before = 0;
  MPI_Exscan(&own, &before, 1, MPI_LONG, MPI_SUM, communicator);
  EntryReader reader(header, size, file);
  reader.read(text, header.lines + before);
  agree_on(reader.problem(), key, communicator);
  agree_on(common_problem(header, reader, file, communicator), key, communicator);
  return std::move(reader.entries);
}

std::uint64_t file_hash(const std::string &path, MPI_Comm communicator) {
  constexpr std::size_t chunk = 1 << 20;
  constexpr std::uint64_t start = 14695981039346656037U; // FNV-1a, of words
  constexpr std::uint64_t prime = 1099511628211U;
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &ranks);
  std::ifstream in(path, std::ios::binary);
  std::vector<std::uint64_t> words(chunk / sizeof(std::uint64_t));
  std::uint64_t sum = 0;
  for (std::uint64_t number = static_cast<std::uint64_t>(rank); in; number += ranks) {
    std::fill(words.begin(), words.end(), 0);
    in.seekg(static_cast<std::streamoff>(number * chunk));
    in.read(reinterpret_cast<char *>(words.data()), chunk);
    std::uint64_t hash = start + number;
    for (const std::uint64_t word : words)
      hash = (hash ^ word) * prime;
    if (in.gcount() > 0)
      sum += (hash ^ static_cast<std::uint64_t>(in.gcount())) * prime;
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, communicator);
  return sum;
}

} // namespace vibroimpact::structure
