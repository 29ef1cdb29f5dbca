#ifndef COMMAND_LINE_QUOTED_FOR_SHELL_H
#define COMMAND_LINE_QUOTED_FOR_SHELL_H

#include <string>

inline std::string quoted_for_shell(const std::string& text)
{
  std::string result = "'";
  for(const char c : text)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

#endif // COMMAND_LINE_QUOTED_FOR_SHELL_H
