#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace dbd {

/// Gives every unknown cell the height of a nearest known cell (chamfer distance, two sweeps), so
/// that heights are finite everywhere. `known`, `heights`: rows x columns; `cell_size` [m].
/// At least one cell must be known.
void ContinueFromNearest(int columns, int rows, const Eigen::Vector2d& cell_size,
                         const std::vector<std::uint8_t>& known, std::vector<float>* heights);

}  // namespace dbd
