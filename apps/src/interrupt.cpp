#include "interrupt.h"

namespace dbd {
namespace {

// Ends the watcher; otherwise without meaning.
constexpr int kWakeSignal = SIGUSR2;

sigset_t WatchedSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, kWakeSignal}) sigaddset(&signals, signal);
  return signals;
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t watched = WatchedSignals();
  pthread_sigmask(SIG_BLOCK, &watched, &previous_mask_);
  watcher_ = std::thread([this, watched] {
    int signal = 0;
    while (sigwait(&watched, &signal) == 0 && signal != kWakeSignal) stop_.request_stop();
  });
}

Interrupt::~Interrupt() {
  pthread_kill(watcher_.native_handle(), kWakeSignal);
  watcher_.join();
  pthread_sigmask(SIG_SETMASK, &previous_mask_, nullptr);
}

}  // namespace dbd
