#ifndef COMMAND_LINE_IGNORED_SIGNAL_H
#define COMMAND_LINE_IGNORED_SIGNAL_H

#include <csignal>

// Keeps a signal from ending the program, as long as an object lives. What has caused it fails
// then, with a reason.
class Ignored_signal
{
public:
  explicit Ignored_signal(const int number)
    : m_number(number), m_before(std::signal(number, SIG_IGN))
  {
  }

  Ignored_signal(const Ignored_signal&) = delete;
  Ignored_signal& operator=(const Ignored_signal&) = delete;

  ~Ignored_signal() { std::signal(m_number, m_before); }

private:
  int m_number;
  void (*m_before)(int);
};

#endif // COMMAND_LINE_IGNORED_SIGNAL_H
