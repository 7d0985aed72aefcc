// Bodies of this program written as matrices, as another program would.
#pragma once

#include "reduction/body_definition.h"
#include "structure/assembly.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace vibroimpact::examples {

/// What of a body stands in files: the unit system they have, and its damping
/// C = alpha M + beta K.
struct Given {
  structure::UnitSystem units{};
  double alpha = 0; ///< [1/s]
  double beta = 0;  ///< [s]
};

/// Files k, m, c and t in the folder; nodes are numbered from 11 on, and every direction of every
/// node that no support holds has a row. The definition has no supports and no points yet.
/// Written by this rank alone.
inline structure::MatrixDefinition write_matrices(const structure::BodyModel &model,
                                                  const std::filesystem::path &folder,
                                                  const Given &given = {}) {
  const structure::AssembledBody body = structure::assemble(model, MPI_COMM_SELF);
  const structure::UnitSystem &u = given.units;
  const int size = body.free.size;
  std::vector<double> unit(size);
  std::vector<std::string> lines(size);
  std::ostringstream out;
  out.precision(17);
  for (std::size_t node = 0; node < body.free.number.size(); ++node)
    for (int component = 0; component < 6; ++component)
      if (const int dof = body.free.number[node][component]; dof >= 0) {
        const Vector3 place = body.model.mesh.nodes[node] / u.length;
        out.str("");
        out << node + 11 << " " << component + 1 << " " << place.transpose() << "\n";
        lines[dof] = out.str();
        unit[dof] = component < 3 ? u.length : 1;
      }
  std::ofstream table(folder / "t");
  for (const std::string &line : lines)
    table << line;
  const double energy = u.mass * u.length * u.length;
  const auto write = [&](const char *name, double time, auto value) {
    std::ofstream file(folder / name);
    file.precision(17);
    for (int row = 0; row < size; ++row)
      for (int column = 0; column <= row; ++column) {
        double k = 0;
        double m = 0;
        MatGetValues(body.stiffness.get(), 1, &row, 1, &column, &k);
        MatGetValues(body.mass.get(), 1, &row, 1, &column, &m);
        if (const double entry = value(k, m) * unit[row] * unit[column] * time / energy; entry != 0)
          file << row + 1 << " " << column + 1 << " " << entry << "\n";
      }
  };
  write("k", u.time * u.time, [](double k, double) { return k; });
  write("m", 1, [](double, double m) { return m; });
  write("c", u.time, [&](double k, double m) { return given.alpha * m + given.beta * k; });
  return {.stiffness_file = folder / "k",
          .mass_file = folder / "m",
          .damping_file = {},
          .table_name = "t",
          .table_content = {},
          .units = u,
          .plane_normal = {},
          .supports = {},
          .points = {},
          .interfaces = {},
          .loads = {}};
}

} // namespace vibroimpact::examples
