#include "reduction/reduce_body.h"

#include "common/log.h"
#include "reduction/body_file.h"
#include "reduction/body_parameters.h"
#include "reduction/reduce.h"

#include <filesystem>

namespace vibroimpact {

namespace {

using parameters::Values;

[[noreturn]] void reject(const Values &body, const structure::DefinitionError &error) {
  const Values section = error.kind() == "Body" ? body
                         : error.name().empty() ? body.subsection(error.kind())
                                                : body.instance(error.kind(), error.name());
  section.reject(error.key(), error.problem());
}

std::optional<ReducedBody> load(const std::string &name, const std::string &file,
                                const std::string &fingerprint, MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  const std::string bytes =
      broadcast(rank == 0 ? read_file(file).value_or("") : std::string(), communicator);
  if (bytes.empty())
    return std::nullopt;
  std::string reason;
  auto body = from_bytes(bytes, fingerprint, reason);
  log::info(body ? "body " + name + ": loaded from " + file
                 : "body " + name + ": " + file + " " + reason + "; computed anew");
  return body;
}

void save(const Values &modes, const std::string &file, const ReducedBody &body,
          const std::string &fingerprint, MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  int saved = 1;
  if (rank == 0)
    try {
      save_body(file, body, fingerprint);
    } catch (const InputError &) {
      saved = 0;
    }
  MPI_Bcast(&saved, 1, MPI_INT, 0, communicator);
  if (saved == 0)
    modes.reject("Store", "must name a file that can be written; this one cannot: " + file);
}

} // namespace

ReducedBody reduce_body(const Values &body, const std::string &name, const std::string &folder,
                        MPI_Comm communicator) {
  const BodyDefinition definition = read_body(body, name, folder, communicator);
  try {
    const Values modes = body.subsection("Modes");
    if (!modes.has("Store"))
      return reduce(definition, communicator);
    const std::string file = (std::filesystem::path(folder) / modes.text("Store")).string();
    const std::string fingerprint =
        body.fingerprint() +
        "mesh = " + content_hash(definition.beam.mesh_content + definition.shell.mesh_content) +
        "\n";
    if (auto loaded = load(name, file, fingerprint, communicator))
      return std::move(*loaded);
    ReducedBody computed = reduce(definition, communicator);
    save(modes, file, computed, fingerprint, communicator);
    return computed;
  } catch (const structure::DefinitionError &error) {
    reject(body, error);
  }
}

} // namespace vibroimpact
