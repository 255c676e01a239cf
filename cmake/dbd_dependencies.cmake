# Every third-party package: the libraries' in a file of its own, the programs' here.
include(dbd_library_dependencies)

if(DBD_BUILD_APPS)
  find_package(CLI11 CONFIG REQUIRED)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
  find_package(OpenSSL 3 REQUIRED COMPONENTS Crypto)  # hashes of input files
  # Chart.js (MIT licence) is built into the program and from there into report.html.
  find_file(DBD_CHART_JS chart.min.js PATHS /usr/share/javascript/chart.js REQUIRED)
endif()
if(DBD_BUILD_TESTS)
  find_package(GTest CONFIG REQUIRED)
  find_path(DBD_VALIJSON valijson/validator.hpp REQUIRED)  # checks files against JSON Schemas
endif()
if(DBD_BUILD_BENCHMARKS)
  find_package(benchmark CONFIG REQUIRED)
  find_package(CLI11 CONFIG REQUIRED)
  # Optional: the comparisons with them are left out without them.
  find_package(Simbody QUIET)
  find_package(mujoco QUIET)
endif()
