#ifndef COMMAND_LINE_STOPWATCH_H
#define COMMAND_LINE_STOPWATCH_H

#include <chrono>

class Stopwatch
{
public:
  void restart() { m_start = Clock::now(); }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point m_start = Clock::now();
};

#endif // COMMAND_LINE_STOPWATCH_H
