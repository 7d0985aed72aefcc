// The declarations and the file that the tests of this folder read.
#pragma once

#include "parameters/values.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::parameters {

inline void declare_body(Section &body) {
  body.choice("Type", "beam", {"beam", "shell", "lumped"}, "What it is.");
  body.subsection("Geometry", "Shape and material.")
      .integer("Elements", "40", {.lower = 1, .upper = 1e6}, "", "Elements along the line.")
      .text("Section", "", "Cross-section.")
      .quantities("Start", "0, 0, 0", dimension::length, range::any, "x", "First end.", 3, 3);
  body.subsection("Modes", "Modes kept.")
      .quantity("Damping ratio", "1 %", dimension::none, range::fraction, "zeta", "Of critical.");
  Section &point = body.named_subsection("Point", "A place where things act.");
  point.quantity("Mass", "0 kg", dimension::mass, range::non_negative, "m", "Lumped mass.");
}

inline void declare_contact(Section &contact) {
  contact.names("Between", "", "Two points.")
      .quantity("Clearance", "0 m", dimension::length, range::non_negative, "", "Gap at rest.")
      .quantity("Stiffness", "", dimension::stiffness, range::positive, "k", "Penalty stiffness.")
      .required("Law = penalty")
      .quantity("Hertz stiffness", "", dimension::any, range::positive, "K", "Of the power law.")
      .boolean("Prestressed", "false", "May the clearance be negative?");
}

inline std::shared_ptr<const Section> sample_declarations() {
  auto file = std::make_shared<Section>("Sample", "A file for tests.");
  file->text("Title", "", "For people.").names("Bodies", "", "Bodies of the model.");
  file->subsection("Excitation", "What moves the model.")
      .quantity("Frequency", "3 Hz", dimension::frequency, range::positive, "Omega",
                "Of the force.")
      .quantity("Phase", "0 deg", dimension::angle, range::any, "phi", "Of the force.")
      .quantity("Amplitude", "1 N", dimension::force, range::any, "F", "Of the force.");
  declare_body(file->named_subsection("Body", "A body."));
  declare_contact(file->named_subsection("Contact", "A contact."));
  return file;
}

inline std::shared_ptr<const ParameterSet> parse_prm(const std::string &text,
                                                     const std::vector<Override> &overrides = {}) {
  return ParameterSet::parse(sample_declarations(), text, "params/beams.prm", false, overrides);
}

inline std::shared_ptr<const ParameterSet> parse_json(const std::string &text,
                                                      const std::vector<Override> &overrides = {}) {
  return ParameterSet::parse(sample_declarations(), text, "beams.json", true, overrides);
}

/// The message of the InputError that reading throws; "" if it throws none.
template <class Read> std::string error_of(const Read &read) {
  try {
    read();
  } catch (const InputError &error) {
    return error.what();
  }
  return "";
}

inline const std::string sample_text = R"(
set Title     = Two beams     # a comment
set Variables = lambda = 2, L = 0.3 m, twice = 2 * L
set Bodies    = left, right
subsection Excitation
  set Frequency = 2.95 Hz
end
subsection Body left
  subsection Geometry
    set Elements = 10 * lambda
    set Section  = rectangle, 30 mm, L / 400
    set Start    = 0 m, 1 cm -> twice
  end
  subsection Point head
    set Mass = 57.7114 g
  end
  subsection Point tail
  end
end
subsection Body right
  set Type = lumped
end
subsection Contact heads
  set Between     = left.head, \
                    right.head
  set Clearance   = 5 mm
  set Stiffness   = lambda * 1 kN/m
  set Prestressed = yes
end
)";

} // namespace vibroimpact::parameters
