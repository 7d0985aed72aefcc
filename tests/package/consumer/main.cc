// Uses a part of the library by itself, then the whole program on the arguments.
#include "parameters/units.h"
#include "program.h"

#include <iostream>

int main(int argc, char **argv) {
  std::cout << "7 mm = " << vibroimpact::parameters::find_unit("mm")->times(7) << " m" << std::endl;
  return vibroimpact::run_program(argc, argv);
}
