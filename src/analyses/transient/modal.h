// Modal analysis: what the reduction kept of each body, and what the contacts see of it.
#pragma once

#include "analyses/analysis.h"

namespace vibroimpact::analyses {

class Modal : public Analysis {
public:
  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "modal"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System & /*system*/) const override {}
  void run_line(std::size_t line, System &system, LineContext &context) const override;
};

} // namespace vibroimpact::analyses
