# What the libraries need, with the cures that the packaged versions need: read by the build and,
# where dbd is installed, by find_package(dbd).
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
