#include "gdal_session.h"

#include <gdal.h>

#include <algorithm>
#include <mutex>
#include <utility>

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
  if (level < CE_Warning) return;
  auto* session = static_cast<GdalSession*>(CPLGetErrorHandlerUserData());
  std::string line = message;
  std::replace(line.begin(), line.end(), '\n', ' ');
  if (level == CE_Warning) {
    session->KeepWarning(std::move(line));
  } else if (session->error_.empty()) {
    session->error_ = std::move(line);
  }
}

void GdalSession::KeepWarning(std::string line) {
  constexpr std::size_t kEnough = 5;
  if (warnings_.size() >= kEnough) return;
  if (std::find(warnings_.begin(), warnings_.end(), line) != warnings_.end()) return;
  warnings_.push_back(std::move(line));
}

GdalCacheLimit::GdalCacheLimit(std::int64_t bytes) : former_(GDALGetCacheMax64()) {
  GDALSetCacheMax64(std::min<std::int64_t>(bytes, former_));
}

GdalCacheLimit::~GdalCacheLimit() { GDALSetCacheMax64(former_); }

}  // namespace dbd
