#pragma once

#include <dbd/core/scene.h>

#include <memory>
#include <string>
#include <vector>

namespace dbd {

/// A vehicle without powertrain and the bar that tows it. The bar's hitch is the towing vehicle's:
/// `MakeRoadTrain` sets it.
struct TrailerModel {
  std::shared_ptr<const VehicleModel> vehicle;
  DrawbarModel drawbar;
};

/// Names of the trailers that are built into the library.
std::vector<std::string> BuiltInTrailerNames();

/// The JSON text of a built-in trailer. Throws InputError that lists the names.
std::string BuiltInTrailerText(const std::string& name);

/// A built-in trailer by name, or a trailer file by path (anything that contains '/' or ends in
/// ".json"; schema dbd.trailer/1: a vehicle file with a drawbar instead of a powertrain). Throws
/// InputError that names the file, the key, the value and the rule.
TrailerModel LoadTrailer(const std::string& name_or_file);

/// The same from JSON text; `origin` is what messages call it.
TrailerModel ParseTrailer(const std::string& text, const std::string& origin);

/// The tractor and `trailers` of one kind behind it in a straight line, drawbars without force on
/// level ground. The hitch of each towing vehicle is at the middle of its outline's rear, as high
/// as the trailer's pivot. `tractor`: with its place, heading and driver, ahead of all others.
std::vector<SceneVehicle> MakeRoadTrain(const SceneVehicle& tractor, const TrailerModel& trailer,
                                        int trailers);

}  // namespace dbd
