// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_CHILD_PROCESS_H
#define APPROXIMATE_GEODESICS_TEST_CHILD_PROCESS_H

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/types.h>
#include <sys/wait.h>

#include <stdexcept>
#include <string>
#include <vector>

extern char** environ;

namespace geodesics_test {

/*
 * A program that runs beside the test, and does not survive it. What it prints goes to a file.
 */
class Child_process
{
public:
  // The program is searched for where a shell would.
  explicit Child_process(std::vector<std::string> words, const std::string& output = "/dev/null")
  {
    std::vector<char*> arguments;
    for(std::string& word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    const int error =
        posix_spawnp(&m_id, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if(error != 0)
      throw std::runtime_error(words[0] + " cannot be run");
  }

  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  ~Child_process()
  {
    if(!m_has_ended)
      kill();
  }

  // Waits for its end. Returns whether it went well.
  bool succeeds()
  {
    wait(0);
    return WIFEXITED(m_status) && WEXITSTATUS(m_status) == 0;
  }

  // Waits until it has halted itself. Returns whether it did.
  bool halts()
  {
    wait(WUNTRACED);
    return WIFSTOPPED(m_status);
  }

  // Waits for its end. Returns whether somebody killed it.
  bool was_killed()
  {
    wait(0);
    return WIFSIGNALED(m_status) && WTERMSIG(m_status) == SIGKILL;
  }

  bool has_ended()
  {
    if(!m_has_ended)
      wait(WNOHANG);
    return m_has_ended;
  }

  // Returns whether it had not ended before.
  bool kill()
  {
    if(has_ended())
      return false;
    ::kill(m_id, SIGKILL);
    return was_killed();
  }

private:
  void wait(const int options)
  {
    if(!m_has_ended && ::waitpid(m_id, &m_status, options) == m_id)
      m_has_ended = !WIFSTOPPED(m_status);
  }

  pid_t m_id = -1;
  int m_status = 0;
  bool m_has_ended = false;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_CHILD_PROCESS_H
