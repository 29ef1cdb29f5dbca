#ifndef GEODESIC_MATRIX_INTERRUPTION_H
#define GEODESIC_MATRIX_INTERRUPTION_H

#include <atomic>
#include <csignal>

// Notes Ctrl-C and the signal with which systems end programs, as long as an object lives. A second
// one ends the program at once.
class Interruption
{
public:
  Interruption()
  {
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
  }

  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  ~Interruption()
  {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }

  // Returns its number, or 0 if there was none.
  static int signal() { return noted; }

private:
  static_assert(std::atomic<int>::is_always_lock_free, "signal handlers must not wait");

  static void note(const int number)
  {
    noted = number;
    std::signal(number, SIG_DFL);
  }

  inline static std::atomic<int> noted{0};
};

#endif // GEODESIC_MATRIX_INTERRUPTION_H
