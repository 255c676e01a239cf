#include <dbd/core/error.h>
#include <dbd/core/scene_scenario.h>

#include <fstream>

namespace dbd {

void WriteSceneRows(const std::string& file, const std::vector<SceneRow>& rows) {
  std::ofstream stream(file);
  stream << "t,vehicle,x,y,z,yaw,pitch,roll,speed,gap,bumper_force,drawbar_force,drawbar_stretch\n";
  stream.precision(9);
  for (const SceneRow& r : rows) {
    stream << r.t << ',' << r.vehicle;
    for (const double value : {r.p_WB.x(), r.p_WB.y(), r.p_WB.z(), r.yaw, r.pitch, r.roll, r.speed,
                               r.gap, r.bumper_force, r.drawbar_force, r.drawbar_stretch}) {
      stream << ',' << value;
    }
    stream << '\n';
  }
  if (!stream.flush()) throw InputError(file + ": cannot be written");
}

}  // namespace dbd
