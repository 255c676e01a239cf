#include "file_writers.h"

#include <dbd/planner/thread_count.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <utility>

#include "text.h"

namespace dbd {

struct FileWriters::Tasks {
  explicit Tasks(int threads) : arena(ThreadCount(threads)) {}

  tbb::task_arena arena;
  tbb::task_group group;
};

FileWriters::FileWriters(int threads) : tasks_(std::make_unique<Tasks>(threads)) {}

FileWriters::~FileWriters() {
  try {
    Wait();
  } catch (...) {
    // Whoever wanted to know has called Wait.
  }
}

void FileWriters::Run(std::function<void()> write) {
  tasks_->arena.execute([&] { tasks_->group.run(std::move(write)); });
}

void FileWriters::WriteText(std::filesystem::path file, std::function<std::string()> text) {
  Run([file = std::move(file), text = std::move(text)] { WriteTextFile(file, text()); });
}

void FileWriters::Wait() {
  tasks_->arena.execute([&] { tasks_->group.wait(); });
}

}  // namespace dbd
