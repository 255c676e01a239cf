#pragma once

#include <cpl_error.h>

#include <cstdint>
#include <string>
#include <vector>

namespace dbd {

/// While it lives, GDAL's messages on this thread are kept here instead of printed, and GDAL's
/// drivers are registered.
class GdalSession {
 public:
  GdalSession();
  ~GdalSession();
  GdalSession(const GdalSession&) = delete;
  GdalSession& operator=(const GdalSession&) = delete;

  /// First error since the session began or since ForgetError, as one line; empty when none.
  const std::string& error() const { return error_; }
  void ForgetError() { error_.clear(); }

  /// The first few different warnings, each as one line.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// error(), or `otherwise` when GDAL gave no reason.
  std::string Reason(const std::string& otherwise) const;

 private:
  static void Keep(CPLErr level, CPLErrorNum number, const char* message);
  void KeepWarning(std::string line);

  std::string error_;
  std::vector<std::string> warnings_;
};

/// While it lives, GDAL's cache of blocks is no larger than this. Without it GDAL takes a twentieth
/// of the machine's memory. The cache is the process's own; its former size comes back.
class GdalCacheLimit {
 public:
  explicit GdalCacheLimit(std::int64_t bytes);
  ~GdalCacheLimit();
  GdalCacheLimit(const GdalCacheLimit&) = delete;
  GdalCacheLimit& operator=(const GdalCacheLimit&) = delete;

 private:
  std::int64_t former_;
};

}  // namespace dbd
