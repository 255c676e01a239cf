#include "output_directory.h"

#include <dbd/core/error.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "text.h"

namespace fs = std::filesystem;

namespace dbd {
namespace {

fs::path Normalized(const std::string& directory) {
  const fs::path path = fs::absolute(directory).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

std::vector<std::string> OutputDirectory::AnswerFiles() {
  return {"plan.json",          "report.html", "simulate.json", "map.png",
          "candidates.geojson", "trace.csv",   "route.geojson", "route.gpx",
          "route.kml",          "route.gpkg",  "route.csv"};
}

OutputDirectory::OutputDirectory(const std::string& directory, const std::string& flag,
                                 std::vector<std::string> stale)
    : name_(directory), flag_(flag), stale_(std::move(stale)) {
  if (directory.empty()) throw InputError(flag_ + ": the directory has no name");
  directory_ = Normalized(directory);
  std::error_code error;
  const fs::file_status status = fs::status(directory_, error);
  if (fs::exists(status) && !fs::is_directory(status)) Refuse("is not a directory");
  // A directory that exists is staged inside, since its parent need not be writable; a new one is
  // staged beside, so that it appears complete, in one rename.
  const std::string suffix = Format(".partial-%d", getpid());
  staging_ = fs::is_directory(status)
                 ? directory_ / suffix
                 : directory_.parent_path() /
                       Format(".%s%s", directory_.filename().c_str(), suffix.c_str());
  try {
    CreateStaging();
  } catch (...) {
    RemoveStaging();
    throw;
  }
  RemoveStaging();
}

OutputDirectory::~OutputDirectory() { RemoveStaging(); }

fs::path OutputDirectory::Stage(const std::string& name) {
  if (staged_.empty()) CreateStaging();
  staged_.push_back(name);
  return staging_ / name;
}

void OutputDirectory::Commit() {
  std::error_code error;
  if (!fs::exists(directory_)) {
    fs::rename(staging_, directory_, error);
  } else {
    for (const std::string& name : stale_) {
      if (std::find(staged_.begin(), staged_.end(), name) == staged_.end()) {
        fs::remove(directory_ / name, error);
      }
    }
    for (const std::string& name : staged_) {
      if (!error) fs::rename(staging_ / name, directory_ / name, error);
    }
  }
  if (error) Refuse("cannot be written: " + error.message());
  created_parents_.clear();
  RemoveStaging();
}

void OutputDirectory::CreateStaging() {
  std::error_code error;
  std::vector<fs::path> missing;
  for (fs::path p = staging_.parent_path(); !fs::exists(p, error); p = p.parent_path()) {
    if (error && error != std::errc::no_such_file_or_directory) break;
    missing.push_back(p);
  }
  for (auto p = missing.rbegin(); p != missing.rend(); ++p) {
    if (!fs::create_directory(*p, error)) Refuse("cannot be created: " + error.message());
    created_parents_.push_back(*p);
  }
  fs::create_directory(staging_, error);
  if (error) Refuse("cannot be created or written: " + error.message());
}

void OutputDirectory::Refuse(const std::string& reason) const {
  throw InputError(flag_ + " " + name_ + ": " + reason);
}

void OutputDirectory::RemoveStaging() {
  std::error_code error;
  fs::remove_all(staging_, error);
  for (auto p = created_parents_.rbegin(); p != created_parents_.rend(); ++p) fs::remove(*p, error);
  created_parents_.clear();
}

}  // namespace dbd
