// MPI, PETSc and SLEPc for a program of its own, without reading anybody's options.
#pragma once

#include <slepcsys.h>

#include <stdexcept>
#include <string>

namespace vibroimpact::testing {

class SlepcSession {
public:
  /// std::runtime_error when SLEPc does not start.
  explicit SlepcSession(std::string program) {
    char skip[] = "-skip_petscrc";
    char *arguments[] = {program.data(), skip, nullptr};
    int count = 2;
    char **private_arguments = arguments;
    if (SlepcInitialize(&count, &private_arguments, nullptr, nullptr) != 0)
      throw std::runtime_error(program + ": SLEPc does not start");
  }
  ~SlepcSession() { SlepcFinalize(); }
  SlepcSession(const SlepcSession &) = delete;
  SlepcSession &operator=(const SlepcSession &) = delete;
};

} // namespace vibroimpact::testing
