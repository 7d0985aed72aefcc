// PETSc for a program of its own, without reading anybody's options.
#pragma once

#include <petscsys.h>

#include <stdexcept>
#include <string>

namespace vibroimpact::benchmarks {

class PetscSession {
public:
  /// std::runtime_error when PETSc does not start.
  explicit PetscSession(std::string program) {
    char skip[] = "-skip_petscrc";
    char *arguments[] = {program.data(), skip, nullptr};
    int count = 2;
    char **private_arguments = arguments;
    if (PetscInitialize(&count, &private_arguments, nullptr, nullptr) != 0)
      throw std::runtime_error(program + ": PETSc does not start");
  }
  ~PetscSession() { PetscFinalize(); }
  PetscSession(const PetscSession &) = delete;
  PetscSession &operator=(const PetscSession &) = delete;
};

} // namespace vibroimpact::benchmarks
