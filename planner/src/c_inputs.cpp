#include <dbd/core/vehicle_database.h>

#include "c_handles.h"

#ifndef DBD_VERSION
#error "DBD_VERSION is set by the build"
#endif

namespace dbd {
namespace {

std::string& LastError() {
  thread_local std::string text;
  return text;
}

std::string TextOf(const char* text) { return text == nullptr ? "" : text; }

TerrainFiles FilesOf(const dbd_terrain_files& given) {
  TerrainFiles files;
  files.elevation = given.elevation;
  files.crs = TextOf(given.crs);
  files.materials = TextOf(given.materials);
  files.material_table = TextOf(given.material_table);
  files.obstacles = TextOf(given.obstacles);
  files.surface_model = TextOf(given.surface_model);
  if (given.moisture != nullptr) {
    files.moisture = MoistureStateOf(given.moisture);
    if (!files.moisture) {
      throw InputError("dbd_terrain_load: moisture is \"" + TextOf(given.moisture) +
                       "\", must be dry, moist or wet");
    }
  }
  if (files.materials.empty() != files.material_table.empty()) {
    throw InputError("dbd_terrain_load: materials and material_table need each other");
  }
  return files;
}

}  // namespace

dbd_error Failed(dbd_error code, const char* text) noexcept {
  try {
    LastError() = text;
  } catch (...) {
    LastError().clear();
  }
  return code;
}

}  // namespace dbd

const char* dbd_last_error(void) { return dbd::LastError().c_str(); }

const char* dbd_version(void) { return DBD_VERSION; }

dbd_error dbd_terrain_load(const dbd_terrain_files* files, dbd_terrain** terrain) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_terrain_load", files, terrain);
    dbd::RequireAll("dbd_terrain_load: elevation", files->elevation);
    *terrain = new dbd_terrain{dbd::LoadTerrain(dbd::FilesOf(*files))};
    return DBD_OK;
  });
}

void dbd_terrain_free(dbd_terrain* terrain) { delete terrain; }

dbd_error dbd_vehicle_load(const char* name_or_file, dbd_vehicle** vehicle) {
  return dbd::Guarded([&] {
    dbd::RequireAll("dbd_vehicle_load", name_or_file, vehicle);
    *vehicle = new dbd_vehicle{dbd::LoadVehicle(name_or_file)};
    return DBD_OK;
  });
}

void dbd_vehicle_free(dbd_vehicle* vehicle) { delete vehicle; }
