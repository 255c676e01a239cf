# Settings that every dbd target shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Compilation goes through ccache where it is installed and can write to its cache.
find_program(DBD_CCACHE ccache)
mark_as_advanced(DBD_CCACHE)
if(DBD_CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  file(WRITE ${PROJECT_BINARY_DIR}/CMakeFiles/empty.cpp "")
  execute_process(COMMAND ${DBD_CCACHE} ${CMAKE_CXX_COMPILER} -c empty.cpp
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/CMakeFiles
    RESULT_VARIABLE ccache_result OUTPUT_QUIET ERROR_QUIET)
  if(ccache_result EQUAL 0)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${DBD_CCACHE} CACHE STRING "What compiles through")
  endif()
endif()

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# -ffp-contract=off: fused multiply-adds only where core/src/pack.h writes them, so that one request
# gives the same bits in every instantiation of the engine. -fno-math-errno lets sqrt be one
# instruction. GCC takes buffers that are filled up to a run-time count for uninitialised (bug 101361
# and others): that warning is off.
function(dbd_target_settings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    -Wno-sign-conversion -Wno-maybe-uninitialized -ffp-contract=off -fno-math-errno -fno-trapping-math)
  if(DBD_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(DBD_SANITIZE)
    string(REPLACE ";" "," sanitizers "${DBD_SANITIZE}")
    target_compile_options(${target} PRIVATE -fsanitize=${sanitizers} -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${sanitizers})
  endif()
endfunction()

# One library per module: dbd_<name>, known to users as dbd::<name>.
function(dbd_add_library name)
  add_library(dbd_${name} ${ARGN})
  add_library(dbd::${name} ALIAS dbd_${name})
  # Without a symbol of its own, an object of a shared library is compiled as one of a static library
  # is, so that ccache knows it. Before 1.0 a minor version may change the binary layout.
  set_target_properties(dbd_${name} PROPERTIES EXPORT_NAME ${name} DEFINE_SYMBOL ""
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH "\$ORIGIN")
  target_include_directories(dbd_${name}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_compile_features(dbd_${name} PUBLIC cxx_std_20)
  dbd_target_settings(dbd_${name})
endfunction()

# Generates <output>.cpp that holds the named text files, so that the program needs no data
# directory: a function `std::span<const EmbeddedFile> <function>()` in namespace dbd.
function(dbd_embed_files target function)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp")
  set(rows "")
  foreach(file IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(READ "${file}" text)
    get_filename_component(name "${file}" NAME_WE)
    string(APPEND rows "    {\"${name}\", R\"__dbd__(${text})__dbd__\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT
"#include <dbd/core/embedded_file.h>

namespace dbd {

std::span<const EmbeddedFile> @function@() {
  static const EmbeddedFile files[] = {
@rows@  };
  return files;
}

}  // namespace dbd
")
  target_sources(${target} PRIVATE "${source}")
endfunction()
