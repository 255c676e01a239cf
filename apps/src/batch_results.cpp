#include "batch_results.h"

#include <dbd/core/error.h>
#include <dbd/core/internal/json_object.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace dbd {
namespace {

constexpr char kSchema[] = "dbd.result/1";

struct Answer {
  std::size_t line = 0;
  std::string id;
};

Answer ReadAnswer(const std::string& text, const std::string& origin) {
  const auto object = internal::JsonObject::Parse(text, origin, kSchema);
  return {static_cast<std::size_t>(object.Number("line", 1, 1e15)), object.Text("id")};
}

}  // namespace

BatchResults::BatchResults(const std::string& path, bool resume) : path_(path) {
  const int flags = O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | (resume ? 0 : O_EXCL);
  file_ = open(path.c_str(), flags, 0666);
  if (file_ < 0 && errno == EEXIST) {
    throw InputError("--out " + path + ": exists; --resume goes on with it");
  }
  if (file_ < 0) Fail("cannot be opened");
  if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
    close(file_);
    throw InputError("--out " + path + ": is being written by another process");
  }
  try {
    ReadAnswers();
  } catch (...) {
    close(file_);
    throw;
  }
}

BatchResults::~BatchResults() { close(file_); }

void BatchResults::Fail(const std::string& what) const {
  throw InputError("--out " + path_ + ": " + what + ": " + std::strerror(errno));
}

/// Keeps all whole lines.
void BatchResults::ReadAnswers() {
  std::ifstream stream(path_, std::ios::binary);
  std::string text;
  off_t whole = 0;
  for (std::size_t number = 1; std::getline(stream, text) && !stream.eof(); ++number) {
    const Answer answer =
        ReadAnswer(text, "--out " + path_ + " (line " + std::to_string(number) + ")");
    answered_.emplace(answer.line, answer.id);
    whole += static_cast<off_t>(text.size()) + 1;
  }
  if (ftruncate(file_, whole) != 0) Fail("cannot be cut");
}

void BatchResults::Append(const std::string& line) {
  const std::string text = line + "\n";
  const off_t before = lseek(file_, 0, SEEK_END);
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t count = write(file_, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    written += static_cast<std::size_t>(count);
  }
  if (written == text.size() && fdatasync(file_) == 0) return;
  const int error = errno;
  if (ftruncate(file_, before) != 0) errno = error;
  errno = error;
  Fail("cannot be written");
}

void MergeBatchResults(const std::vector<std::string>& parts, const std::string& out) {
  std::map<std::size_t, std::string> lines;
  for (const std::string& part : parts) {
    std::ifstream stream(part, std::ios::binary);
    if (!stream) throw InputError(part + ": cannot be opened");
    std::string text;
    for (std::size_t number = 1; std::getline(stream, text); ++number) {
      const std::string origin = part + " (line " + std::to_string(number) + ")";
      const std::size_t line = ReadAnswer(text, origin).line;
      if (!lines.emplace(line, text).second) {
        throw InputError(origin + ": answers request line " + std::to_string(line) +
                         ", which another part answers too");
      }
    }
  }
  BatchResults merged(out, false);
  for (const auto& [line, text] : lines) merged.Append(text);
}

}  // namespace dbd
