# Every third-party package in one place, with the cures that the packaged versions need.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(spdlog CONFIG REQUIRED)
find_package(TBB 2021 CONFIG REQUIRED)
find_package(GDAL 3.6 CONFIG REQUIRED)

# OMPL 1.5's own package names Boost libraries that are not installed with it, and exports no
# target; newer versions export ompl::ompl.
find_package(ompl 1.5 CONFIG REQUIRED)
if(NOT TARGET ompl::ompl)
  find_library(DBD_OMPL_LIBRARY NAMES ompl REQUIRED)
  add_library(ompl::ompl SHARED IMPORTED)
  set_target_properties(ompl::ompl PROPERTIES
    IMPORTED_LOCATION "${DBD_OMPL_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OMPL_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES Eigen3::Eigen)
endif()

# OctoMap exports targets without a namespace.
find_package(octomap 1.9 CONFIG REQUIRED)

# Reads PLY and OBJ meshes.
find_package(assimp 5.2 CONFIG REQUIRED)

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
endif()
if(DBD_BUILD_BENCHMARKS)
  find_package(benchmark CONFIG REQUIRED)
  find_package(CLI11 CONFIG REQUIRED)
  find_package(Simbody QUIET)  # optional: the comparison with it is left out without it
endif()
