#include "gnuplot.h"

#include <dbd/core/error.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

#include "text.h"

namespace fs = std::filesystem;

namespace dbd {
namespace {

fs::path FindInPath(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream directories(path ? path : "");
  for (std::string directory; std::getline(directories, directory, ':');) {
    const fs::path file = fs::path(directory) / name;
    if (access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

/// What a child process says on standard error, and how it ended.
struct ChildEnd {
  std::string errors;
  int exit_code = -1;
};

std::string ReadAll(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer;
  ssize_t count = 0;
  while ((count = read(descriptor, buffer.data(), buffer.size())) > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

ChildEnd RunIn(const fs::path& directory, const fs::path& program, std::string argument) {
  std::array<int, 2> pipe_ends;
  if (pipe(pipe_ends.data()) != 0) throw std::runtime_error("pipe failed");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDERR_FILENO);
  posix_spawn_file_actions_addclose(&actions, pipe_ends[0]);
  std::string name = program.filename();
  char* argv[] = {name.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawn(&child, program.c_str(), &actions, nullptr, argv, environ);
  posix_spawn_file_actions_destroy(&actions);
  close(pipe_ends[1]);
  ChildEnd end;
  if (!failed) {
    end.errors = ReadAll(pipe_ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  }
  close(pipe_ends[0]);
  return end;
}

/// The last line that says something: gnuplot repeats the script's line above it.
std::string LastLine(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t^\r") != std::string::npos) last = line;
  }
  return last;
}

}  // namespace

Gnuplot::Gnuplot(const std::string& flag) : flag_(flag), program_(FindInPath("gnuplot")) {
  if (program_.empty()) {
    throw InputError(flag + ": needs the program gnuplot (Debian package gnuplot-nox)");
  }
}

void Gnuplot::Run(const fs::path& script) const {
  const ChildEnd end = RunIn(script.parent_path(), program_, script.filename());
  if (end.exit_code == 0) return;
  throw InputError(Format("%s: %s failed on %s: %s", flag_.c_str(), program_.c_str(),
                          script.filename().c_str(), LastLine(end.errors).c_str()));
}

std::string QuoteForGnuplot(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += c;
    quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return quoted + "'";
}

}  // namespace dbd
