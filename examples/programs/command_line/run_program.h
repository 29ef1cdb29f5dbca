#ifndef COMMAND_LINE_RUN_PROGRAM_H
#define COMMAND_LINE_RUN_PROGRAM_H

#include "Interruption.h"
#include "words_of_options.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <ios>
#include <iostream>
#include <new>
#include <string>

// Lets standard output throw when it cannot be written, as the reason is known only then.
inline void check_standard_output()
{
  std::cerr.tie(nullptr);          // or any message, of any thread, would write standard output
  if(std::cout.rdbuf() != nullptr) // or the program is to be silent
    std::cout.exceptions(std::ios::badbit);
}

// In one piece, as several processes can have messages at the same time.
inline void print_error(const std::string& program, const std::string& text)
{
  std::cerr << program + ": " + text + '\n';
}

// Thrown when all that was asked for has been printed.
struct Answered
{
};

// Returns the exit code of `run()`. What it throws, and that standard output cannot be written, is
// told in a message that begins with `name`.
template <typename F>
int run_program(const std::string& name, F run)
{
  try
  {
    check_standard_output();
    const int result = run();
    std::cout.flush();
    return result;
  }
  catch(const Answered&)
  {
    return EXIT_SUCCESS;
  }
  catch(const Interrupted& e)
  {
    print_error(name, e.what());
    return e.exit_code();
  }
  catch(const std::ios_base::failure&)
  {
    print_error(name, std::string("cannot write to standard output: ") + std::strerror(errno));
  }
  catch(const std::bad_alloc&)
  {
    print_error(name, "there is not enough memory");
  }
  catch(const std::filesystem::filesystem_error& e)
  {
    print_error(name, e.path1().string() + ": " + e.code().message());
  }
  catch(const std::exception& e)
  {
    print_error(name, in_words_of_options(e.what()));
  }
  std::cout.exceptions(std::ios::goodbit); // nothing more is expected of it
  return EXIT_FAILURE;
}

#endif // COMMAND_LINE_RUN_PROGRAM_H
