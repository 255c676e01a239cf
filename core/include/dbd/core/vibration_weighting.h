#pragma once

namespace dbd {

/// Frequency weightings of ISO 2631-1 for whole-body vibration: gain at `frequency` [Hz]. W_k:
/// vertical, W_d: horizontal, seated. Confidence: gains agree with the standard's table.
double VerticalWeighting(double frequency);
double HorizontalWeighting(double frequency);

}  // namespace dbd
