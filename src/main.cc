#include "program.h"

int main(int argc, char **argv) { return vibroimpact::run_program(argc, argv); }
