#include "reduction/body_file.h"

#include "common/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

namespace vibroimpact::reduction {

static_assert(std::endian::native == std::endian::little, "the format is little-endian");

namespace {

const std::string title = "vibroimpact reduced body 5";

class Writer {
public:
  void text(const std::string &name, const std::string &value) {
    bytes_ += name + " text " + std::to_string(value.size()) + "\n" + value + "\n";
  }
  void matrix(const std::string &name, const Matrix &value) {
    bytes_ += name + " matrix " + std::to_string(value.rows()) + " " +
              std::to_string(value.cols()) + "\n";
    bytes_.append(reinterpret_cast<const char *>(value.data()), value.size() * sizeof(double));
    bytes_ += "\n";
  }
  const std::string &bytes() const { return bytes_; }

private:
  std::string bytes_;
};

/// Records must come in the order they were written in. Throws std::runtime_error otherwise.
class Reader {
public:
  explicit Reader(const std::string &bytes) : bytes_(bytes) {}

  std::string line() {
    const std::size_t end = bytes_.find('\n', position_);
    if (end == std::string::npos)
      throw std::runtime_error("breaks off");
    std::string text = bytes_.substr(position_, end - position_);
    position_ = end + 1;
    return text;
  }
  std::string text(const std::string &name) {
    const auto [size, unused] = header(name, "text");
    return data(size);
  }
  Matrix matrix(const std::string &name) {
    const auto [rows, columns] = header(name, "matrix");
    Matrix value(rows, columns);
    const std::string content = data(rows * columns * sizeof(double));
    std::copy(content.begin(), content.end(), reinterpret_cast<char *>(value.data()));
    return value;
  }
  std::string rest() const { return bytes_.substr(position_); }

private:
  std::array<std::size_t, 2> header(const std::string &name, const std::string &kind) {
    std::istringstream words(line());
    std::string found_name;
    std::string found_kind;
    std::array<std::size_t, 2> sizes{};
    words >> found_name >> found_kind >> sizes[0] >> sizes[1];
    if (found_name != name || found_kind != kind)
      throw std::runtime_error("has no " + name + " where it belongs");
    return sizes;
  }
  std::string data(std::size_t size) {
    if (size >= bytes_.size() - position_)
      throw std::runtime_error("breaks off");
    std::string content = bytes_.substr(position_, size);
    position_ += size + 1;
    return content;
  }

  const std::string &bytes_;
  std::size_t position_ = 0;
};

Matrix line_matrix(const std::vector<std::array<int, 2>> &lines) {
  Matrix matrix(2, static_cast<Index>(lines.size()));
  for (std::size_t j = 0; j < lines.size(); ++j)
    matrix.col(static_cast<Index>(j)) << lines[j][0], lines[j][1];
  return matrix;
}

Matrix surface_matrix(const std::vector<std::array<int, 4>> &surfaces) {
  Matrix matrix(4, static_cast<Index>(surfaces.size()));
  for (std::size_t j = 0; j < surfaces.size(); ++j)
    for (int i = 0; i < 4; ++i)
      matrix(i, static_cast<Index>(j)) = surfaces[j][i];
  return matrix;
}

/// Places are counted by doubles, exact up to 2^53.
Matrix place_matrix(const std::vector<int> &first) {
  return Eigen::Map<const Eigen::VectorXi>(first.data(), static_cast<Index>(first.size()))
      .cast<double>();
}

void write(Writer &out, const CellStress &stress) {
  out.matrix("stress", stress.rows);
  out.matrix("places", place_matrix(stress.first));
}

CellStress read_stress(Reader &in) {
  CellStress stress{.rows = in.matrix("stress"), .first = {}};
  const Matrix places = in.matrix("places");
  for (const double place : places.reshaped())
    stress.first.push_back(static_cast<int>(place));
  return stress;
}

void write(Writer &out, const ReducedBody &body) {
  out.text("name", body.name);
  out.text("type", body.type);
  out.matrix("mass", body.mass);
  out.matrix("stiffness", body.stiffness);
  out.matrix("damping", body.damping);
  out.matrix("base_participation", body.base_participation);
  out.matrix("total_mass", body.total_mass);
  out.matrix("eigen_residual", body.eigen_residual);
  out.matrix("orthogonality_residual", Matrix::Constant(1, 1, body.orthogonality_residual));
  out.matrix("points", Matrix::Constant(1, 1, static_cast<double>(body.points.size())));
  for (const BodyPoint &point : body.points) {
    out.text("point", point.name);
    out.text("interface", point.interface);
    out.matrix("node", Matrix::Constant(1, 1, point.node));
    out.matrix("position", point.position);
    out.matrix("rows", point.rows);
    out.matrix("static_displacement", point.static_displacement);
    out.matrix("flexibility", point.flexibility);
    out.matrix("inverse_mass", point.inverse_mass);
    out.matrix("stress", point.stress);
  }
  out.matrix("nodes", body.recovery.nodes);
  out.matrix("lines", line_matrix(body.recovery.lines));
  out.matrix("surfaces", surface_matrix(body.recovery.surfaces));
  out.matrix("shapes", body.recovery.shapes);
  out.matrix("static_displacement", body.recovery.static_displacement);
  write(out, body.recovery.line_stress);
  write(out, body.recovery.surface_stress);
}

ReducedBody read(Reader &in) {
  ReducedBody body;
  body.name = in.text("name");
  body.type = in.text("type");
  body.mass = in.matrix("mass");
  body.stiffness = in.matrix("stiffness");
  body.damping = in.matrix("damping");
  body.base_participation = in.matrix("base_participation");
  body.total_mass = in.matrix("total_mass");
  body.eigen_residual = in.matrix("eigen_residual");
  body.orthogonality_residual = in.matrix("orthogonality_residual")(0, 0);
  const auto points = static_cast<std::size_t>(in.matrix("points")(0, 0));
  for (std::size_t i = 0; i < points; ++i) {
    BodyPoint point;
    point.name = in.text("point");
    point.interface = in.text("interface");
    point.node = static_cast<int>(in.matrix("node")(0, 0));
    point.position = in.matrix("position");
    point.rows = in.matrix("rows");
    point.static_displacement = in.matrix("static_displacement");
    point.flexibility = in.matrix("flexibility");
    point.inverse_mass = in.matrix("inverse_mass");
    point.stress = in.matrix("stress");
    body.points.push_back(std::move(point));
  }
  body.recovery.nodes = in.matrix("nodes");
  const Matrix lines = in.matrix("lines");
  for (Index j = 0; j < lines.cols(); ++j)
    body.recovery.lines.push_back({static_cast<int>(lines(0, j)), static_cast<int>(lines(1, j))});
  const Matrix surfaces = in.matrix("surfaces");
  for (Index j = 0; j < surfaces.cols(); ++j) {
    std::array<int, 4> nodes{};
    for (int i = 0; i < 4; ++i)
      nodes[i] = static_cast<int>(surfaces(i, j));
    body.recovery.surfaces.push_back(nodes);
  }
  body.recovery.shapes = in.matrix("shapes");
  body.recovery.static_displacement = in.matrix("static_displacement");
  body.recovery.line_stress = read_stress(in);
  body.recovery.surface_stress = read_stress(in);
  return body;
}

} // namespace

std::string content_hash(const std::string &content) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char byte : content)
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

std::string to_bytes(const ReducedBody &body, const std::string &fingerprint) {
  Writer out;
  out.text("fingerprint", fingerprint);
  write(out, body);
  return title + "\nchecksum " + content_hash(out.bytes()) + "\n" + out.bytes();
}

std::optional<ReducedBody> from_bytes(const std::string &bytes, const std::string &fingerprint,
                                      std::string &reason) {
  try {
    Reader in(bytes);
    if (in.line() != title)
      throw std::runtime_error("has another format");
    if (const std::string checksum = in.line(); checksum != "checksum " + content_hash(in.rest()))
      throw std::runtime_error("is damaged");
    if (in.text("fingerprint") != fingerprint)
      throw std::runtime_error("belongs to another definition of the body");
    return read(in);
  } catch (const std::runtime_error &error) {
    reason = error.what();
    return std::nullopt;
  }
}

void save_body(const std::string &file, const ReducedBody &body, const std::string &fingerprint) {
  const std::string neighbour = file + ".part" + std::to_string(getpid());
  std::ofstream out(neighbour, std::ios::binary);
  const std::string bytes = to_bytes(body, fingerprint);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code problem;
  if (out)
    std::filesystem::rename(neighbour, file, problem);
  if (!out || problem) {
    std::filesystem::remove(neighbour, problem);
    throw InputError("cannot write the reduced body to " + file);
  }
}

std::optional<std::string> read_file(const std::string &file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) // a device or a pipe may have no end
    return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::ostringstream content;
  if (!in || !(content << in.rdbuf()))
    return std::nullopt;
  return content.str();
}

std::string broadcast(std::string text, MPI_Comm communicator) {
  auto size = static_cast<std::uint64_t>(text.size());
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, communicator);
  text.resize(size);
  constexpr std::uint64_t most = 1U << 30U; // MPI counts are ints
  for (std::uint64_t begin = 0; begin < size; begin += most)
    MPI_Bcast(text.data() + begin, static_cast<int>(std::min(most, size - begin)), MPI_CHAR, 0,
              communicator);
  return text;
}

ReducedBody broadcast(const ReducedBody &body, MPI_Comm communicator) {
  std::string reason;
  auto copy = from_bytes(broadcast(to_bytes(body, ""), communicator), "", reason);
  if (!copy)
    throw std::logic_error("a broadcast reduced body " + reason);
  return std::move(*copy);
}

} // namespace vibroimpact::reduction
