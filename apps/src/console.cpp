#include "console.h"

#include <cpl_error.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdio>

#include "text.h"

namespace dbd {
namespace {

spdlog::logger& Log() {
  static spdlog::logger log = [] {
    spdlog::logger made("dbd", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    made.set_pattern("dbd: %v");
    return made;
  }();
  return log;
}

void LogGdalMessage(CPLErr, CPLErrorNum, const char* message) {
  PrintDetail(std::string("GDAL: ") + message);
}

}  // namespace

void ConfigureConsole(Verbosity verbosity) {
  const auto level = verbosity == Verbosity::kQuiet    ? spdlog::level::err
                     : verbosity == Verbosity::kNormal ? spdlog::level::info
                                                       : spdlog::level::debug;
  Log().set_level(level);
  CPLSetErrorHandler(LogGdalMessage);
}

void PrintError(const std::string& text) { Log().error(OneLine(text)); }
void PrintNote(const std::string& text) { Log().info(OneLine(text)); }
void PrintDetail(const std::string& text) { Log().debug(OneLine(text)); }

ProgressLine::ProgressLine()
    : enabled_(isatty(STDERR_FILENO) && Log().should_log(spdlog::level::info)) {}

ProgressLine::~ProgressLine() { Clear(); }

void ProgressLine::Show(const std::string& stage, int done, int total) {
  if (!enabled_) return;
  std::fprintf(stderr, "\r\033[K%s %d/%d", stage.c_str(), done, total);
  std::fflush(stderr);
  shown_ = true;
}

void ProgressLine::Clear() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

}  // namespace dbd
