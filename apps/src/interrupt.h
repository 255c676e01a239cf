#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace dbd {

/// While it lives, SIGINT and SIGTERM ask for a stop instead of ending the process. Create it
/// before any other thread, since threads inherit which signals they leave alone.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return stop_.get_token(); }

 private:
  sigset_t previous_mask_;
  std::stop_source stop_;
  std::thread watcher_;
};

}  // namespace dbd
