#include "gdal_session.h"

#include <gdal.h>

#include <algorithm>
#include <mutex>

namespace dbd {

GdalSession::GdalSession() {
  static std::once_flag registered;
  std::call_once(registered, [] {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    GDALAllRegister();
    CPLPopErrorHandler();
  });
  CPLPushErrorHandlerEx(&GdalSession::Keep, this);
}

GdalSession::~GdalSession() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

std::string GdalSession::Reason(const std::string& otherwise) const {
  return error_.empty() ? otherwise : error_;
}

void GdalSession::Keep(CPLErr level, CPLErrorNum, const char* message) {
  if (level < CE_Failure) return;
  auto* session = static_cast<GdalSession*>(CPLGetErrorHandlerUserData());
  if (!session->error_.empty()) return;
  session->error_ = message;
  std::replace(session->error_.begin(), session->error_.end(), '\n', ' ');
}

}  // namespace dbd
