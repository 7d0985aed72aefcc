#include "output/record.h"

#include "output/journal.h"

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array_wrapper.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace boost::serialization {

template <class Archive> void serialize(Archive &archive, vibroimpact::Axis &axis, unsigned) {
  archive &axis.name &axis.values &axis.labels &axis.unit &axis.description;
}

template <class Archive> void serialize(Archive &archive, vibroimpact::Field &field, unsigned) {
  archive &field.name &field.unit &field.description &field.dimensions &field.shape &field.values;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::SummaryLine &line, unsigned) {
  archive &line.name &line.value &line.unit;
}

template <class Archive> void serialize(Archive &archive, vibroimpact::Matrix &matrix, unsigned) {
  vibroimpact::Index rows = matrix.rows();
  vibroimpact::Index columns = matrix.cols();
  archive &rows &columns;
  matrix.resize(rows, columns); // keeps the values of the right size, so it serves both ways
  archive &make_array(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

template <class Archive> void serialize(Archive &archive, vibroimpact::Motion &motion, unsigned) {
  archive &motion.time &motion.coordinates &motion.base_displacement;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::PointResult &result, unsigned) {
  archive &result.index &result.status &result.reason &result.fields &result.summary &result.motion;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::AnalysisHeader &header, unsigned) {
  archive &header.name &header.type &header.axes &header.grid;
}

} // namespace boost::serialization

namespace vibroimpact {

namespace {

enum class Kind : char { header = 'h', point = 'p' };

template <class Content>
std::string record(Kind kind, const std::string &analysis, const Content &content) {
  std::ostringstream stream(std::ios::binary);
  boost::archive::binary_oarchive archive(stream);
  archive << kind << analysis << content;
  return stream.str();
}

using Reader =
    std::function<void(Kind, const std::string &analysis, boost::archive::binary_iarchive &)>;

void read_records(const std::filesystem::path &journal, const Reader &read) {
  try {
    read_journal(journal, [&](const std::string &payload) {
      std::istringstream stream(payload, std::ios::binary);
      boost::archive::binary_iarchive archive(stream);
      Kind kind{};
      std::string analysis;
      archive >> kind >> analysis;
      read(kind, analysis, archive);
    });
  } catch (const boost::archive::archive_exception &error) {
    throw std::runtime_error(journal.string() + ": cannot read the journal, another version of " +
                             "the program may have written it (" + error.what() + ")");
  }
}

} // namespace

std::string header_record(const AnalysisHeader &header) {
  return record(Kind::header, header.name, header);
}

std::string point_record(const std::string &analysis, const PointResult &result) {
  return record(Kind::point, analysis, result);
}

std::vector<AnalysisHeader> read_headers(const std::vector<std::filesystem::path> &journals) {
  std::vector<AnalysisHeader> headers;
  for (const auto &journal : journals)
    read_records(journal, [&](Kind kind, const std::string &, auto &archive) {
      if (kind == Kind::header)
        archive >> headers.emplace_back();
    });
  return headers;
}

PointMap read_points(const std::vector<std::filesystem::path> &journals,
                     const std::string &analysis) {
  PointMap points;
  for (const auto &journal : journals)
    read_records(journal, [&](Kind kind, const std::string &name, auto &archive) {
      if (kind != Kind::point || name != analysis)
        return;
      PointResult result;
      archive >> result;
      std::vector<std::size_t> index = result.index;
      points.try_emplace(std::move(index), std::move(result));
    });
  return points;
}

} // namespace vibroimpact
