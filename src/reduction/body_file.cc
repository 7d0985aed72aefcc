#include "reduction/body_file.h"

#include "common/bytes.h"
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

void members(auto &visit, As<BodyPoint> auto &point) {
  visit(point.name, point.interface, point.node, point.position, point.rows,
        point.static_displacement, point.flexibility, point.inverse_mass, point.stress,
        point.stress_components);
}
void members(auto &visit, As<CellStress> auto &stress) {
  visit(stress.rows, stress.components, stress.first);
}
void members(auto &visit, As<Recovery> auto &recovery) {
  visit(recovery.nodes, recovery.lines, recovery.cells, recovery.shapes,
        recovery.static_displacement, recovery.line_stress, recovery.cell_stress);
}
void members(auto &visit, As<SpinMatrices> auto &spin) {
  visit(spin.axis, spin.rotating_frame, spin.gyroscopic, spin.centrifugal, spin.centrifugal_load,
        spin.turning, spin.crosswise, spin.circulatory);
}
void members(auto &visit, As<ReducedBody> auto &body) {
  visit(body.name, body.type, body.mass, body.stiffness, body.damping, body.base_participation,
        body.total_mass, body.eigen_residual, body.orthogonality_residual, body.points,
        body.recovery, body.spin);
}

namespace {

const std::string title = "vibroimpact reduced body 10\n";

} // namespace

std::string content_hash(std::string_view content) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char byte : content)
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

std::string to_bytes(const ReducedBody &body, const std::string &fingerprint) {
  const std::string content = packed(fingerprint, body);
  return title + content_hash(content) + content;
}

std::optional<ReducedBody> from_bytes(const std::string &bytes, const std::string &fingerprint,
                                      std::string &reason) try {
  reason = "has another format";
  if (!bytes.starts_with(title))
    return std::nullopt;
  reason = "is damaged";
  Cursor cursor(std::string_view(bytes).substr(title.size()));
  if (const auto hash = cursor.take(content_hash("").size()); hash != content_hash(cursor.rest()))
    return std::nullopt;
  reason = "belongs to another definition of the body";
  if (cursor.take<std::string>() != fingerprint)
    return std::nullopt;
  ReducedBody body;
  unpack(cursor.rest(), body);
  return body;
} catch (const BytesError &) {
  return std::nullopt;
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
