# Every third-party package: the libraries' in a file of its own, the programs' here.
include(dbd_library_dependencies)

if(DBD_BUILD_APPS)
  find_package(CLI11 CONFIG REQUIRED)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
endif()
if(DBD_BUILD_TESTS)
  find_package(GTest CONFIG REQUIRED)
endif()
if(DBD_BUILD_BENCHMARKS)
  find_package(benchmark CONFIG REQUIRED)
  find_package(CLI11 CONFIG REQUIRED)
  find_package(Simbody QUIET)  # optional: the comparison with it is left out without it
endif()
