#include "random_models/run_model.h"

#include "analyses/analysis.h"
#include "common/error.h"
#include "reduction/reduce_body.h"
#include "simulation.h"

#include <ctime>
#include <optional>

namespace vibroimpact::testing {

namespace {

using namespace analyses;
using reduction::ReducedBody;

// Keeps the only point.
class OnePoint : public LineContext {
public:
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return nullptr;
  }
  void store(PointResult result) override { point = std::move(result); }
  void skip() override {}

  PointResult point;
};

System system_of(const parameters::Values &root, const std::string &folder) {
  std::vector<std::shared_ptr<const ReducedBody>> bodies;
  for (const std::string &name : root.instances("Body")) {
    auto body = std::make_shared<ReducedBody>(
        reduction::reduce_body(root.instance("Body", name), name, folder, MPI_COMM_SELF));
    body->name = name;
    bodies.push_back(std::move(body));
  }
  return build_system(root, root.instance("Analysis", "a"), bodies);
}

PointResult point_of(const std::string &text, const std::string &folder,
                     const std::vector<parameters::Override> &overrides) {
  const auto set =
      parameters::ParameterSet::parse(declare_parameters(), text, "model.prm", false, overrides);
  const parameters::Values root = set->root();
  System system = system_of(root, folder);
  const auto analysis = create_analysis(root.instance("Analysis", "a"));
  analysis->check(system);
  OnePoint context;
  analysis->run_line(0, system, context);
  return context.point;
}

} // namespace

ModelRun run_model(const std::string &text, const std::string &folder,
                   std::vector<parameters::Override> overrides) {
  overrides.push_back({.path = "File folder", .value = folder, .origin = "test"});
  const std::clock_t start = std::clock();
  ModelRun run;
  try {
    PointResult point = point_of(text, folder, overrides);
    run.status =
        point.status == Status::finished ? ModelRun::Status::finished : ModelRun::Status::failed;
    run.reason = point.reason;
    run.fields = std::move(point.fields);
  } catch (const InputError &error) {
    run.reason = error.what();
  } catch (const NumericalError &error) { // of the reduction
    run.status = ModelRun::Status::failed;
    run.reason = error.what();
  }
  run.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return run;
}

} // namespace vibroimpact::testing
