#pragma once

#include <dbd/planner/terrain_spread.h>
#include <dbd/terrain/terrain.h>

#include <cstdint>
#include <stop_token>

namespace dbd {

/// The terrain as it may be instead: draw `draw` of those that belong to `seed`, the same whoever
/// asks. Each material has a strength factor of its own, log-normal with mean 1, that its cone
/// index and its plate moduli share; heights get Gaussian noise: white noise on a lattice of the
/// correlation's spacing, smoothed by bicubic B-splines, of the same variance everywhere.
/// Throws StopRequested soon after `stop` was asked to.
/// Throws InputError for an elevation error where the wheels touch a TIN's triangles.
Terrain DrawTerrain(const Terrain& terrain, const TerrainSpread& spread, std::uint64_t seed,
                    int draw, const std::stop_token& stop = {});

}  // namespace dbd
