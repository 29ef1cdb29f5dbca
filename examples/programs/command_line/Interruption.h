#ifndef COMMAND_LINE_INTERRUPTION_H
#define COMMAND_LINE_INTERRUPTION_H

#include <array>
#include <atomic>
#include <csignal>
#include <stdexcept>

// That the user, or the system, has ended the program.
class Interrupted : public std::runtime_error
{
public:
  explicit Interrupted(const int signal) : std::runtime_error("interrupted"), m_signal(signal) {}

  int exit_code() const { return 128 + m_signal; } // as shells do

private:
  int m_signal;
};

// Notes Ctrl-C and the signals with which systems end programs, as long as an object lives. A
// second one ends the program at once.
class Interruption
{
public:
  Interruption()
  {
    for(const int number : SIGNALS)
      if(std::signal(number, note) == SIG_IGN)
        std::signal(number, SIG_IGN); // as in the background, or by nohup
  }

  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  ~Interruption()
  {
    for(const int number : SIGNALS)
      if(std::signal(number, SIG_DFL) == SIG_IGN)
        std::signal(number, SIG_IGN);
  }

  // Returns its number, or 0 if there was none.
  static int signal() { return noted; }

  // Throws if there was one.
  static void check()
  {
    if(signal() != 0)
      throw Interrupted(signal());
  }

private:
  static_assert(std::atomic<int>::is_always_lock_free, "signal handlers must not wait");

  static constexpr std::array<int, 3> SIGNALS{SIGINT, SIGTERM, SIGHUP};

  static void note(const int number)
  {
    noted = number;
    std::signal(number, SIG_DFL);
  }

  inline static std::atomic<int> noted{0};
};

#endif // COMMAND_LINE_INTERRUPTION_H
