#include <dbd/core/error.h>
#include <ogrsf_frmts.h>

#include <utility>

#include "file_formats.h"
#include "gdal_session.h"
#include "raster_file.h"
#include "vector_file.h"
#include "xml_oddities.h"

namespace dbd {
namespace {

VectorFileInfo::Layer DescribeLayer(OGRLayer* layer) {
  VectorFileInfo::Layer result;
  result.name = layer->GetName();
  result.geometry = OGRGeometryTypeToName(wkbFlatten(layer->GetGeomType()));
  const OGRSpatialReference* crs = layer->GetSpatialRef();
  if (crs != nullptr && !crs->IsEmpty()) result.crs_name = CrsNameOf(*crs);
  for (const auto& feature : layer) {
    ++result.features;
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr || geometry->IsEmpty()) continue;
    OGREnvelope3D box;
    geometry->getEnvelope(&box);
    result.extent.Add({box.MinX, box.MinY, box.MinZ});
    result.extent.Add({box.MaxX, box.MaxY, box.MaxZ});
  }
  return result;
}

}  // namespace

FileInfo DescribeVectorFile(const std::string& file) {
  const GDALDatasetUniquePtr dataset = OpenVector(file);
  const GdalSession gdal;
  FileInfo info;
  info.format = dataset->GetDriverName();
  VectorFileInfo content;
  bool has_places = false;
  for (OGRLayer* layer : dataset->GetLayers()) {
    VectorFileInfo::Layer described = DescribeLayer(layer);
    if (!gdal.error().empty()) throw InputError(file + ": is corrupt: " + gdal.error());
    has_places = has_places || !described.extent.empty();
    if (described.features > 0) content.layers.push_back(std::move(described));
  }
  info.warnings = XmlOddities(file, info.format);
  if (!has_places) {
    const std::string reason = info.warnings.empty() ? "" : ": " + info.warnings.front();
    throw InputError(file + ": holds no point, line or area" + reason);
  }
  info.warnings.insert(info.warnings.end(), gdal.warnings().begin(), gdal.warnings().end());
  info.content = std::move(content);
  return info;
}

}  // namespace dbd
