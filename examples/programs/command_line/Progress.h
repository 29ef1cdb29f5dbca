#ifndef COMMAND_LINE_PROGRESS_H
#define COMMAND_LINE_PROGRESS_H

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

// Says what the program is at, and for how long, as long as an object lives and that is more than a
// second. A thread of its own does that, whatever the others are busy with.
class Progress
{
public:
  explicit Progress(std::string name) : m_name(std::move(name)), m_thread([this] { tell(); }) {}

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  ~Progress()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_done = true;
    }
    m_condition.notify_one();
    m_thread.join();
  }

  // If that is known.
  void set_part(const std::size_t done, const std::size_t all)
  {
    m_percent = all == 0 ? 0 : int(100 * done / all);
  }

private:
  void tell()
  {
    const bool is_terminal = isatty(STDERR_FILENO) != 0;
    std::unique_lock<std::mutex> lock(m_mutex);
    int seconds = 1;
    while(!m_condition.wait_until(lock, m_start + std::chrono::seconds(seconds),
                                  [&] { return m_is_done; }))
    {
      std::cerr << (is_terminal ? "\r" : "") << m_name << ": " << seconds << " s";
      if(m_percent >= 0)
        std::cerr << ", " << m_percent << " %";
      std::cerr << (is_terminal ? " " : "\n") << std::flush;
      seconds += is_terminal || seconds < 5 ? 1 : 10;
    }
    if(is_terminal && seconds > 1)
      std::cerr << '\n';
  }

  std::string m_name;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
  std::atomic<int> m_percent{-1};
  bool m_is_done = false;
  std::mutex m_mutex;
  std::condition_variable m_condition;
  std::thread m_thread; // the last member, as it uses the others
};

#endif // COMMAND_LINE_PROGRESS_H
