# One object library per source folder; a folder sees only what stands above it in the line of work.
add_library(vibroimpact_warnings INTERFACE)
# g++ 12 sees overlaps and lengths in std::string's operator+ that cannot be (GCC bug 105651).
set(VIBROIMPACT_GCC_12 $<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>)
target_compile_options(vibroimpact_warnings INTERFACE -Wall -Wextra
  $<${VIBROIMPACT_GCC_12}:-Wno-restrict> $<${VIBROIMPACT_GCC_12}:-Wno-stringop-overflow>
  $<${VIBROIMPACT_GCC_12}:-Wno-array-bounds>)
if(VIBROIMPACT_SANITIZE)
  target_compile_options(vibroimpact_warnings INTERFACE
    -fsanitize=${VIBROIMPACT_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(vibroimpact_warnings INTERFACE -fsanitize=${VIBROIMPACT_SANITIZE})
endif()

# g++ looks for memory to reclaim again and again while it instantiates templates, a seventh of its time.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=300>
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=2000000>)

# What nearly every source includes, parsed once; a source with other definitions does without.
set(CMAKE_PCH_WARN_INVALID OFF)
add_library(vibroimpact_headers OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cc)
target_link_libraries(vibroimpact_headers PRIVATE Eigen3::Eigen MPI::MPI_CXX vibroimpact_warnings)
target_precompile_headers(vibroimpact_headers PRIVATE
  <Eigen/Dense> <algorithm> <array> <cmath> <complex> <filesystem> <functional> <limits> <map>
  <memory> <numbers> <numeric> <optional> <set> <span> <sstream> <stdexcept> <string> <utility>
  <vector>)

# Sources of a folder are compiled several at once: headers are read and templates instantiated once for
# all of them, which is a half of the time. Names in unnamed namespaces are therefore unique in a folder.
# -D VIBROIMPACT_UNITY=OFF compiles each source by itself.
option(VIBROIMPACT_UNITY "Compile several sources of a folder at once" ON)

# vibroimpact_folder(NAME SOURCES a.cc ... LIBRARIES target ... [BATCH 8])
function(vibroimpact_folder name)
  cmake_parse_arguments(ARG "" "BATCH" "SOURCES;LIBRARIES" ${ARGN})
  add_library(vibroimpact_${name} OBJECT ${ARG_SOURCES})
  if(NOT ARG_BATCH)
    set(ARG_BATCH 10)
  endif()
  set_target_properties(vibroimpact_${name} PROPERTIES
    UNITY_BUILD ${VIBROIMPACT_UNITY} UNITY_BUILD_BATCH_SIZE ${ARG_BATCH})
  target_include_directories(vibroimpact_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(vibroimpact_${name}
    PUBLIC Eigen3::Eigen Boost::boost MPI::MPI_CXX ${ARG_LIBRARIES}
    PRIVATE vibroimpact_warnings)
  target_precompile_headers(vibroimpact_${name} REUSE_FROM vibroimpact_headers)
  target_link_libraries(vibroimpact PRIVATE vibroimpact_${name})
endfunction()
