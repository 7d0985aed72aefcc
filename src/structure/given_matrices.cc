#include "structure/given_matrices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace vibroimpact::structure {

namespace {

using Entries = std::vector<MatrixEntry>;

// Programs write 7 digits or more: halves of a matrix differ by less than this, relative to the
// geometric mean of their diagonal entries.
constexpr double symmetry_tolerance = 1e-6;
constexpr double rounding = 1e-9;

/// Rows first ... first of the next rank are a rank's.
int first_row(int size, int rank, int ranks) {
  return static_cast<int>(static_cast<long>(size) * rank / ranks);
}

bool before(const MatrixEntry &a, const MatrixEntry &b) {
  return std::pair(a.row, a.column) < std::pair(b.row, b.column);
}

bool same_place(const MatrixEntry &a, const MatrixEntry &b) {
  return a.row == b.row && a.column == b.column;
}

/// Each entry to the rank that has its row, sorted. Collective.
Entries to_owners(Entries entries, int size, MPI_Comm communicator) {
  int ranks = 1;
  MPI_Comm_size(communicator, &ranks);
  std::stable_sort(entries.begin(), entries.end(), before);
  if (ranks == 1)
    return entries;
  std::vector<int> out(ranks), in(ranks), out_begin(ranks), in_begin(ranks);
  for (int rank = 0; rank < ranks; ++rank) {
    const auto at = [&](int r) {
      return std::lower_bound(entries.begin(), entries.end(),
                              MatrixEntry{first_row(size, r, ranks), 0}, before) -
             entries.begin();
    };
    out_begin[rank] = static_cast<int>(at(rank));
    out[rank] = static_cast<int>(at(rank + 1)) - out_begin[rank];
  }
  MPI_Alltoall(out.data(), 1, MPI_INT, in.data(), 1, MPI_INT, communicator);
  for (int rank = 1; rank < ranks; ++rank)
    in_begin[rank] = in_begin[rank - 1] + in[rank - 1];
  Entries own(static_cast<std::size_t>(in_begin.back() + in.back()));
  MPI_Datatype type = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(sizeof(MatrixEntry), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Alltoallv(entries.data(), out.data(), out_begin.data(), type, own.data(), in.data(),
                in_begin.data(), type, communicator);
  MPI_Type_free(&type);
  std::stable_sort(own.begin(), own.end(), before);
  return own;
}

/// Neighbours at the same place become their sum.
void sum_up(Entries &entries) {
  std::size_t last = 0;
  for (std::size_t k = 1; k < entries.size(); ++k)
    if (same_place(entries[last], entries[k])) {
      entries[last].value += entries[k].value;
      entries[last].skew += entries[k].skew;
    } else {
      entries[++last] = entries[k];
    }
  if (!entries.empty())
    entries.resize(last + 1);
}

class MatrixReader {
public:
  MatrixReader(const UnitSystem &units, const std::vector<TableRow> &table, const RowGroups &groups,
               MPI_Comm communicator)
      : units_(units), table_(table), groups_(groups), communicator_(communicator),
        size_(static_cast<int>(table.size())) {}

  /// `times`: the power of time in its unit, mass / time^power.
  Entries read(const std::string &path, const std::string &key, int times) const {
    Entries entries =
        to_owners(read_matrix_file(path, key, size_, communicator_), size_, communicator_);
    agree_on(repeated(entries), key, communicator_);
    sum_up(entries);
    const std::vector<double> diagonal = diagonal_of(entries);
    agree_on(asymmetric(entries, diagonal), key, communicator_);
    if (key != "Stiffness")
      agree_on(indefinite(entries, diagonal), key, communicator_);
    else
      agree_on(without_stiffness(diagonal), key, communicator_);
    scale(entries, times);
    if (!groups_.any)
      return entries;
    entries = to_owners(grouped(entries), size_, communicator_);
    sum_up(entries);
    return entries;
  }

private:
  std::string named(int row) const {
    const TableRow &at = table_[row];
    return std::to_string(row + 1) + " (node " + std::to_string(at.node) + ", direction " +
           std::to_string(at.component + 1) + ")";
  }

  /// A place may stand once, its two halves of a general file once each.
  std::string repeated(const Entries &entries) const {
    for (std::size_t k = 1; k < entries.size(); ++k) {
      const bool halves = entries[k].row != entries[k].column &&
                          entries[k - 1].skew * entries[k].skew <= 0 && entries[k].skew != 0;
      const bool third = k > 1 && same_place(entries[k - 2], entries[k]);
      if (same_place(entries[k - 1], entries[k]) && (!halves || third) &&
          (entries[k].value != 0 || entries[k - 1].value != 0))
        return "must have each entry once, but row " + named(entries[k].row) + " and column " +
               named(entries[k].column) + " stand more than once";
    }
    return "";
  }

  /// Of all rows, on every rank; a missing entry is 0.
  std::vector<double> diagonal_of(const Entries &entries) const {
    std::vector<double> diagonal(table_.size(), 0);
    for (const MatrixEntry &entry : entries)
      if (entry.row == entry.column)
        diagonal[entry.row] = entry.value;
    MPI_Allreduce(MPI_IN_PLACE, diagonal.data(), size_, MPI_DOUBLE, MPI_SUM, communicator_);
    return diagonal;
  }

  std::string asymmetric(const Entries &entries, const std::vector<double> &diagonal) const {
    for (const MatrixEntry &entry : entries) {
      const double scale =
          std::sqrt(std::abs(diagonal[entry.row]) * std::abs(diagonal[entry.column]));
      if (2 * std::abs(entry.skew) > symmetry_tolerance * scale) {
        std::ostringstream text;
        text << "must be symmetric, but row " << named(entry.row) << " and column "
             << named(entry.column) << " have " << entry.value + entry.skew << ", and "
             << entry.value - entry.skew << " the other way round";
        return text.str();
      }
    }
    return "";
  }

  /// What two rows alone show: A_ii >= 0 and A_ij^2 <= A_ii A_jj.
  std::string indefinite(const Entries &entries, const std::vector<double> &diagonal) const {
    for (const MatrixEntry &entry : entries) {
      const double product = diagonal[entry.row] * diagonal[entry.column];
      std::ostringstream text;
      if (entry.row == entry.column && entry.value < 0)
        text << "must be positive semidefinite, but the diagonal of row " << named(entry.row)
             << " is " << entry.value;
      else if (entry.row != entry.column &&
               std::abs(entry.value) > (1 + rounding) * std::sqrt(std::max(product, 0.0)))
        text << "must be positive semidefinite, but row " << named(entry.row) << " and column "
             << named(entry.column) << " have " << entry.value << ", more than the mean of "
             << "their diagonal entries, " << diagonal[entry.row] << " and "
             << diagonal[entry.column] << ", allows";
      if (!text.str().empty())
        return text.str();
    }
    return "";
  }

  std::string without_stiffness(const std::vector<double> &diagonal) const {
    for (int row = 0; row < size_; ++row)
      if (!(diagonal[row] > 0)) {
        std::ostringstream text;
        text << "must have a diagonal greater than 0, but that of row " << named(row) << " is "
             << diagonal[row];
        return text.str();
      }
    return "";
  }

  void scale(Entries &entries, int times) const {
    const double energy = units_.mass * std::pow(units_.length, 2) / std::pow(units_.time, times);
    const auto unit = [&](int row) { return table_[row].component < 3 ? units_.length : 1.0; };
    for (MatrixEntry &entry : entries)
      entry.value *= energy / (unit(entry.row) * unit(entry.column));
  }

  /// T^T A T, see RowGroups.
  Entries grouped(const Entries &entries) const {
    Entries result;
    for (const MatrixEntry &entry : entries)
      for (const auto &[row, row_sign] : parts(entry.row))
        for (const auto &[column, column_sign] : parts(entry.column))
          result.push_back({row, column, row_sign * column_sign * entry.value});
    return result;
  }

  /// Row of T: the coordinates that u of a row consists of.
  std::vector<std::pair<int, int>> parts(int row) const {
    const int first = groups_.first[row];
    std::vector<std::pair<int, int>> all = {{first, 1}};
    if (row != first)
      all.emplace_back(row, 1);
    else
      for (const int other : groups_.others[row])
        all.emplace_back(other, -1);
    return all;
  }

  UnitSystem units_;
  const std::vector<TableRow> &table_;
  const RowGroups &groups_;
  MPI_Comm communicator_;
  int size_;
};

/// Both sorted lists and the diagonal; entries that are 0 in both are left out.
void merge_rows(const Entries &stiffness, const Entries &mass, GivenMatrices &given) {
  auto k = stiffness.begin();
  auto m = mass.begin();
  for (int row = given.own_begin; row < given.own_end; ++row) {
    while ((k != stiffness.end() && k->row == row) || (m != mass.end() && m->row == row)) {
      const bool has_k = k != stiffness.end() && k->row == row;
      const bool has_m = m != mass.end() && m->row == row;
      const int column = std::min(has_k ? k->column : given.size, has_m ? m->column : given.size);
      const double k_value = has_k && k->column == column ? (k++)->value : 0;
      const double m_value = has_m && m->column == column ? (m++)->value : 0;
      if (k_value == 0 && m_value == 0 && column != row)
        continue;
      given.rows.columns.push_back(column);
      given.stiffness.push_back(k_value);
      given.mass.push_back(m_value);
    }
    given.rows.begins.push_back(static_cast<int>(given.rows.columns.size()));
  }
}

void damping_rows(const Entries &damping, GivenMatrices &given) {
  auto at = damping.begin();
  for (int row = given.own_begin; row < given.own_end; ++row) {
    for (; at != damping.end() && at->row == row; ++at) {
      given.damping_rows.columns.push_back(at->column);
      given.damping.push_back(at->value);
    }
    given.damping_rows.begins.push_back(static_cast<int>(given.damping_rows.columns.size()));
  }
}

} // namespace

RowGroups group_rows(const std::vector<TableRow> &table) {
  RowGroups groups;
  groups.others.resize(table.size());
  std::map<std::array<int, 2>, int> known;
  for (int row = 0; row < static_cast<int>(table.size()); ++row) {
    const auto [at, is_new] = known.emplace(std::array{table[row].node, table[row].component}, row);
    groups.first.push_back(at->second);
    if (!is_new)
      groups.others[at->second].push_back(row);
    groups.any = groups.any || !is_new;
  }
  return groups;
}

GivenMatrices read_given_matrices(const MatrixDefinition &definition,
                                  const std::vector<TableRow> &table, const RowGroups &groups,
                                  MPI_Comm communicator) {
  GivenMatrices given{.size = static_cast<int>(table.size())};
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &ranks);
  given.own_begin = first_row(given.size, rank, ranks);
  given.own_end = first_row(given.size, rank + 1, ranks);
  const MatrixReader reader(definition.units, table, groups, communicator);
  {
    const Entries stiffness = reader.read(definition.stiffness_file, "Stiffness", 2);
    merge_rows(stiffness, reader.read(definition.mass_file, "Mass", 0), given);
  }
  if (!definition.damping_file.empty())
    damping_rows(reader.read(definition.damping_file, "Damping", 1), given);
  return given;
}

} // namespace vibroimpact::structure
