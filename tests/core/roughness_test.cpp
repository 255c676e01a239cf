#include <dbd/core/roughness.h>

#include <gtest/gtest.h>

#include <utility>

#include "support/core_printed.h"

namespace dbd {
namespace {

TEST(Roughness, RmsOfTheRoadClasses) {
  // Waves between 60 ft and 0.3 m: sqrt(256e-6 * 0.01 * (18.288 - 0.3)) for class C.
  const std::pair<RoadClass, double> rows[] = {{RoadClass::kC, 0.00678596},
                                               {RoadClass::kD, 0.0135719},
                                               {RoadClass::kE, 0.0271438},
                                               {RoadClass::kF, 0.0542877},
                                               {RoadClass::kG, 0.108575}};
  for (const auto& [road, rms] : rows) ExpectPrinted(RoadRms(road, 18.288, 0.3), rms);
  ExpectPrinted(RoadRms(RoadClass::kC, 18.288, 0.3) / 0.0254, 0.267164);
  ExpectPrinted(RoadRms(RoadClass::kG, 18.288, 0.3) / 0.0254, 4.27462);
}

TEST(Roughness, AngularFormOfClassA) {
  ExpectPrinted(AngularRoadSpectrum(RoadClass::kA), 1.00531e-6);
}

}  // namespace
}  // namespace dbd
