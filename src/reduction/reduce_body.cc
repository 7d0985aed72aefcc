#include "reduction/reduce_body.h"

#include "common/error.h"
#include "common/log.h"
#include "reduction/body_file.h"
#include "reduction/body_parameters.h"
#include "reduction/reduce.h"
#include "structure/matrix_file.h"

#include <filesystem>

namespace vibroimpact::reduction {

namespace {

using parameters::Values;

[[noreturn]] void reject(const Values &body, const structure::DefinitionError &error) {
  const Values section = error.kind() == "Body" ? body
                         : error.name().empty() ? body.subsection(error.kind())
                                                : body.instance(error.kind(), error.name());
  if (error.key().empty())
    section.reject_section(error.problem());
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

/// Collective.
std::string fingerprint_of(const Values &body, const BodyDefinition &definition,
                           MPI_Comm communicator) {
  const structure::MatrixDefinition &given = definition.matrices;
  std::string text =
      body.fingerprint() + "mesh = " +
      content_hash(definition.beam.mesh_content + definition.shell.mesh_content +
                   definition.solid.mesh_content + given.deck_content + given.table_content) +
      "\n";
  for (const std::string &file : {given.stiffness_file, given.mass_file, given.damping_file})
    if (!file.empty())
      text += "matrix = " + std::to_string(structure::file_hash(file, communicator)) + "\n";
  return text;
}

ReducedBody stored_body(const Values &body, const BodyDefinition &definition,
                        const std::string &folder, MPI_Comm communicator) {
  const Values modes = body.subsection("Modes");
  const std::string file = (std::filesystem::path(folder) / modes.text("Store")).string();
  const std::string fingerprint = fingerprint_of(body, definition, communicator);
  if (auto loaded = load(definition.name, file, fingerprint, communicator))
    return std::move(*loaded);
  ReducedBody computed = reduce(definition, communicator);
  save(modes, file, computed, fingerprint, communicator);
  return computed;
}

// A cache that cannot be written costs time, not the run.
void fill_cache(const std::string &file, const ReducedBody &body, const std::string &fingerprint,
                MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  std::string problem;
  if (rank == 0)
    try {
      std::error_code ignored; // the file then cannot be written either
      std::filesystem::create_directories(std::filesystem::path(file).parent_path(), ignored);
      save_body(file, body, fingerprint);
    } catch (const InputError &error) {
      problem = error.what();
    }
  problem = broadcast(std::move(problem), communicator);
  if (problem.empty())
    log::info("body " + body.name + ": made and kept in " + file);
  else
    log::warning("body " + body.name + ": made, but the body cache fails: " + problem);
}

ReducedBody cached_body(const Values &body, const BodyDefinition &definition,
                        const BodyCache &cache, MPI_Comm communicator) {
  int ranks = 1;
  MPI_Comm_size(communicator, &ranks);
  const std::string fingerprint = fingerprint_of(body, definition, communicator) +
                                  "program = " + cache.program +
                                  "\nranks = " + std::to_string(ranks) + "\n";
  const std::string file =
      (std::filesystem::path(cache.folder) / (content_hash(fingerprint) + ".body")).string();
  if (auto loaded = load(definition.name, file, fingerprint, communicator)) {
    loaded->name = definition.name;
    return std::move(*loaded);
  }
  ReducedBody computed = reduce(definition, communicator);
  fill_cache(file, computed, fingerprint, communicator);
  return computed;
}

} // namespace

ReducedBody reduce_body(const Values &body, const std::string &name, const std::string &folder,
                        MPI_Comm communicator, const BodyCache &cache) {
  const BodyDefinition definition = read_body(body, name, folder, communicator);
  const bool meshed = definition.type != BodyDefinition::Type::lumped &&
                      definition.type != BodyDefinition::Type::rotor;
  try {
    if (meshed && body.subsection("Modes").has("Store"))
      return stored_body(body, definition, folder, communicator);
    if (meshed && !cache.folder.empty())
      return cached_body(body, definition, cache, communicator);
    return reduce(definition, communicator);
  } catch (const structure::DefinitionError &error) {
    reject(body, error);
  } catch (const NumericalError &error) {
    body.reject_section(std::string("the modes of the body cannot be computed: ") + error.what() +
                        ". Check the magnitudes and units of its lengths, stiffness and density, "
                        "and look for parts without stiffness or without mass");
  }
}

} // namespace vibroimpact::reduction
