#pragma once

// Everything that the wide lanes use and that is not written over lane types. A translation unit
// for a wide instruction set includes this first, for any processor, and only then switches the
// instruction set on for the engine's templates. Otherwise the linker might keep its copy of, say,
// std::vector's functions, compiled for a processor that is not there, for the whole program.

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include <dbd/core/ground.h>
#include <dbd/core/simulation_lanes.h>
#include <dbd/core/units.h>
#include <dbd/core/vehicle_model.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "corners.h"
#include "engine_model.h"
#include "facet_search.h"
#include "joined_bodies.h"
#include "tire_pattern.h"

// GCC alone lets a pragma choose the instruction set of templates; without optimisation GCC 12
// fails on constructors that it writes itself, so that debug builds have the narrow lanes only.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__)
#define DBD_WIDE_LANES
#endif
