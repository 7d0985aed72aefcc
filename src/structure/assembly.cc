#include "structure/assembly.h"

#include "common/decompositions.h"
#include "structure/given_assembly.h"
#include "structure/nodal_blocks.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

FreeDofs number_free(Elimination elimination, const Discretisation &space) {
  const std::size_t nodes = elimination.zero.size();
  std::vector<int> number(6 * nodes, 0);
  for (std::size_t node = 0; node < nodes; ++node)
    for (int component = 0; component < 6; ++component)
      number[space.dofs[node][component]] = elimination.zero[node][component] ? -1 : 0;
  FreeDofs free;
  for (std::size_t dof = 0; dof < number.size(); ++dof) {
    if (static_cast<int>(dof) == space.own_begin)
      free.own_begin = free.size;
    if (number[dof] == 0)
      number[dof] = free.size++;
    if (static_cast<int>(dof) + 1 == space.own_end)
      free.own_end = free.size;
  }
  if (space.own_begin == space.own_end)
    free.own_begin = free.own_end = 0;
  free.number.resize(nodes);
  for (std::size_t node = 0; node < nodes; ++node)
    for (int component = 0; component < 6; ++component)
      free.number[node][component] = number[space.dofs[node][component]];
  free.linked = std::move(elimination.nodes);
  return free;
}

NodalBlock diagonal_block(const std::array<double, 6> &entries) {
  return Eigen::Map<const Eigen::Matrix<double, 6, 1>>(entries.data()).asDiagonal();
}

/// What is assembled, in terms of the nodes that rigid links leave.
struct Parts {
  Elements elements;
  std::map<int, LumpedMass> masses;
};

void add_elements(const AssembledBody &body, const Elements &elements, const Discretisation &space,
                  NodalBlocks &blocks) {
  auto own = space.own_elements.begin();
  for (std::size_t number = 0; number < elements.size(); ++number) {
    const std::shared_ptr<const Element> &element = elements[number];
    const bool is_own = own != space.own_elements.end() && *own == static_cast<int>(number);
    const bool touches = blocks.touched_by(element->nodes());
    if (!is_own && !touches)
      continue;
    const NodalMatrix stiffness = element->stiffness();
    if (touches)
      blocks.add(element->nodes(), stiffness, element->mass());
    if (is_own) {
      body.accurate_stiffness->add(element, stiffness, body.free.of(*element));
      ++own;
    }
  }
}

void add_nodes(const AssembledBody &body, const Parts &parts, NodalBlocks &blocks) {
  for (std::size_t node = 0; node < body.model.mesh.nodes.size(); ++node)
    if (!body.free.linked.contains(static_cast<int>(node)))
      blocks.add_stiffness(static_cast<int>(node), diagonal_block(body.model.spring[node]));
  for (const auto &[node, mass] : parts.masses)
    blocks.add_mass(node, mass);
}

vibroimpact::Matrix summed(vibroimpact::Matrix rows, MPI_Comm communicator) {
  MPI_Allreduce(MPI_IN_PLACE, rows.data(), static_cast<int>(rows.size()), MPI_DOUBLE, MPI_SUM,
                communicator);
  return rows;
}

void assemble_matrices(AssembledBody &body, const Parts &parts, const Discretisation &space,
                       MPI_Comm communicator) {
  NodalBlocks blocks(space);
  body.accurate_stiffness = std::make_unique<StiffnessOperator>(body.free);
  add_elements(body, parts.elements, space, blocks);
  add_nodes(body, parts, blocks);
  AssembledMatrices matrices = blocks.matrices(body.free, communicator);
  body.stiffness = std::move(matrices.stiffness);
  body.mass = std::move(matrices.mass);
  body.base_inertia = summed(blocks.base_inertia(body.free), communicator);
  body.accurate_stiffness->add_springs(body.model.spring);
  body.accurate_stiffness->finish(communicator);
}

} // namespace

void check_free(const FreeDofs &free) {
  if (free.size == 0)
    throw DefinitionError("Modes", "", "Number",
                          "cannot be met: the supports hold every degree of freedom");
}

namespace {

vibroimpact::Vector static_load(const AssembledBody &body) {
  vibroimpact::Vector load = body.base_inertia * body.model.acceleration;
  for (std::size_t node = 0; node < body.model.load.size(); ++node)
    for (int component = 0; component < 6; ++component)
      for (const auto &[dof, factor] : body.free.terms(static_cast<int>(node), component))
        load[dof] += factor * body.model.load[node][component];
  return load;
}

/// Rank of a lumped mass over the components of its node that are not held.
int rank_of(const LumpedMass &mass, const std::array<int, 6> &dofs) {
  std::vector<int> free;
  for (int component = 0; component < 6; ++component)
    if (dofs[component] >= 0 && mass(component, component) > 0)
      free.push_back(component);
  const vibroimpact::Matrix own = mass(free, free);
  const vibroimpact::Vector scale = own.diagonal().array().rsqrt();
  const vibroimpact::Matrix scaled = scale.asDiagonal() * own * scale.asDiagonal();
  return free.empty() ? 0
                      : static_cast<int>((symmetric_eigen(scaled).values.array() > 1e-12).count());
}

// The mass matrix of an element with density is positive definite; elsewhere only lumped masses
// count.
int count_massive(const Parts &parts, const FreeDofs &free) {
  std::vector<bool> heavy(free.number.size(), false);
  for (const auto &element : parts.elements)
    if (element->total_mass() > 0)
      for (const int node : element->nodes())
        heavy[node] = true;
  int count = 0;
  for (std::size_t node = 0; node < heavy.size(); ++node)
    for (int component = 0; heavy[node] && component < 6; ++component)
      count += free.number[node][component] >= 0;
  for (const auto &[node, mass] : parts.masses)
    if (!heavy[node])
      count += rank_of(mass, free.number[node]);
  return count;
}

} // namespace

AssembledBody assemble(BodyModel model, MPI_Comm communicator) {
  AssembledBody body;
  body.model = std::move(model);
  if (body.model.given) {
    assemble_given(body, communicator);
  } else {
    Elimination elimination = eliminate(body.model);
    const Parts parts{eliminated_elements(body.model, elimination),
                      eliminated_masses(body.model, elimination)};
    const Discretisation space =
        discretise(body.model.mesh.nodes.size(), parts.elements, communicator);
    body.free = number_free(std::move(elimination), space);
    check_free(body.free);
    assemble_matrices(body, parts, space, communicator);
    body.massive_dofs = count_massive(parts, body.free);
    body.total_mass.setConstant(body.model.total_mass());
  }
  body.load = static_load(body);
  return body;
}

} // namespace vibroimpact::structure
