// Parameter files with one body, as text.
#pragma once

#include "common/error.h"
#include "reduction/body_parameters.h"
#include "reduction/reduce_body.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

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

inline reduction::BodyDefinition definition_of(const std::string &text) {
  return reduction::read_body(body_values(text), "left", ".", MPI_COMM_SELF);
}

/// Of a file that is refused; "accepted" when it is not.
inline std::string message_of(const std::string &text, const std::string &folder = ".") {
  try {
    reduced_text(text, folder, MPI_COMM_SELF);
  } catch (const InputError &error) {
    return error.what();
  }
  return "accepted";
}

inline void expect_message(const std::string &text, const std::vector<std::string> &words) {
  const std::string message = message_of(text);
  for (const std::string &word : words)
    EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
}

inline std::string without(std::string text, const std::string &line) {
  const std::size_t at = text.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  return text.erase(at, line.size());
}

/// `lines` inside a subsection that the text already has.
inline std::string inside(std::string text, const std::string &section_name,
                          const std::string &lines) {
  const std::string begin = "subsection " + section_name + "\n";
  const std::size_t at = text.find(begin);
  EXPECT_NE(at, std::string::npos) << section_name;
  return text.insert(at + begin.size(), lines);
}

} // namespace vibroimpact::examples
