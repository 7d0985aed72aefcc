// Parameter files with one body, as text.
#pragma once

#include "reduction/body_parameters.h"
#include "reduction/reduce_body.h"

#include <string>

namespace vibroimpact::examples {

/// The body of case S, complete; `more` is added inside, after what it may override.
inline std::string head_beam(const std::string &more = "") {
  return "subsection Body left\n"
         "  subsection Geometry\n"
         "    set Line = 0 m, 0 m, 0 m -> 0 m, 0 m, 30 cm\n"
         "    set Elements = 20\n"
         "  end\n"
         "  subsection Section\n"
         "    set Width = 30 mm\n"
         "    set Thickness = 0.75 mm\n"
         "  end\n"
         "  subsection Material\n"
         "    set Young modulus = 206 GPa\n"
         "    set Density = 7850 kg/m^3\n"
         "  end\n"
         "  subsection Support root\n"
         "    set At = start\n"
         "    set Fix = all\n"
         "  end\n"
         "  subsection Support plane\n"
         "    set At = all\n"
         "    set Fix = y, z, rx, rz\n"
         "  end\n"
         "  subsection Point head\n"
         "    set At = end\n"
         "    set Mass = 57.7114 g\n"
         "  end\n" +
         more + "end\n";
}

/// A subsection inside a body.
inline std::string section(const std::string &name, const std::string &lines) {
  return "  subsection " + name + "\n" + lines + "  end\n";
}

inline parameters::Values body_values(const std::string &text) {
  const auto root = std::make_shared<parameters::Section>("", "");
  reduction::declare_body(*root);
  const auto set = parameters::ParameterSet::parse(root, text, "test.prm", false);
  return set->root().instance("Body", "left");
}

inline reduction::ReducedBody reduced_text(const std::string &text, const std::string &folder = ".",
                                           MPI_Comm communicator = MPI_COMM_WORLD) {
  return reduction::reduce_body(body_values(text), "left", folder, communicator);
}

} // namespace vibroimpact::examples
