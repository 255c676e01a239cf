#pragma once

namespace dbd {

// Roughness of roads and ground after ISO 8608, as plain functions. SI.

/// Road classes of ISO 8608, smooth to rough.
enum class RoadClass { kA, kB, kC, kD, kE, kF, kG, kH };

/// Geometric mean of the class' displacement spectrum G_d at 0.1 cycles/m [m^3]: 16 * 4^i * 1e-6.
double RoadSpectrum(RoadClass road);

/// The same per angular wave number at 1 rad/m [m^3]: about 4^i * 1e-6.
double AngularRoadSpectrum(RoadClass road);

/// Root mean square [m] of the waves between two wavelengths [m] of a spectrum that falls with the
/// square of the wave number: sqrt(G_d n_0^2 (1/n_1 - 1/n_2)).
double RoadRms(RoadClass road, double longest, double shortest);

}  // namespace dbd
