# The libraries, each as one imported or interface target.
find_package(PkgConfig REQUIRED)
find_package(MPI REQUIRED COMPONENTS C CXX)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED COMPONENTS program_options)
find_package(deal.II 9.4 REQUIRED)
pkg_check_modules(PETSC REQUIRED IMPORTED_TARGET PETSc)
pkg_check_modules(SLEPC REQUIRED IMPORTED_TARGET SLEPc)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3)
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
find_package(ZLIB REQUIRED)

# deal.II's own macro fixes build types and flags for a whole target; its library and headers are
# enough here. The release library is used throughout: the debug one refuses branching line meshes.
include(${DEAL_II_TARGET_CONFIG})
set(DEAL_II_TARGET_CONFIG_INCLUDED TRUE)
add_library(vibroimpact_dealii INTERFACE)
target_include_directories(vibroimpact_dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
target_compile_definitions(vibroimpact_dealii INTERFACE
  ${DEAL_II_USER_DEFINITIONS} ${DEAL_II_USER_DEFINITIONS_RELEASE})
target_link_libraries(vibroimpact_dealii INTERFACE ${DEAL_II_TARGET_RELEASE})

# HDF5 is the parallel build that deal.II and PETSc link too; mixing in the serial one would clash.
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-openmpi)
find_library(HDF5_HL_LIBRARY hdf5_openmpi_hl REQUIRED)
add_library(vibroimpact_hdf5 INTERFACE)
target_link_libraries(vibroimpact_hdf5 INTERFACE ${HDF5_HL_LIBRARY} PkgConfig::HDF5)

# These packages hand on the flags they were built with themselves; one set of flags for all
# sources is what lets them share precompiled headers.
foreach(package PETSC SLEPC)
  set_target_properties(PkgConfig::${package} PROPERTIES INTERFACE_COMPILE_OPTIONS "")
endforeach()
