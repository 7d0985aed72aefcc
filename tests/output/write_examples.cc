// write_examples FOLDER: a result folder as a run leaves it, for the tests of what reads one.
#include "output/example_results.h"
#include "output/result_files.h"
#include "output/vtu_writer.h"

#include <iostream>

int main(int argc, char **argv) {
  using namespace vibroimpact;
  using namespace vibroimpact::output;
  if (argc != 2)
    return 2;
  MPI_Init(&argc, &argv);
  int code = 0;
  try {
    RunFolder folder(MPI_COMM_SELF, argv[1], ExistingFolder::overwrite, "set Title = example\n");
    FileSink sink(MPI_COMM_SELF, folder, testing::example_information(), testing::example_bodies());
    for (const testing::Example &example : testing::all_examples()) {
      sink.begin(example.header);
      for (const PointResult &point : example.points)
        sink.store(point);
      sink.end();
    }
    write_mode_files(folder, testing::example_bodies());
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    code = 1;
  }
  MPI_Finalize();
  return code;
}
