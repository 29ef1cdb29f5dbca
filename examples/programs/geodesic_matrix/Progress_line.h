#ifndef GEODESIC_MATRIX_PROGRESS_LINE_H
#define GEODESIC_MATRIX_PROGRESS_LINE_H

#include "../command_line/Interruption.h"
#include "../command_line/Stopwatch.h"
#include "texts.h"

#include <CGAL/Geodesic_queries/Distance_matrix_types.h>

#include <unistd.h>

#include <cstddef>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

// Says how far the rows are, in one line that is written anew every second, and a line every ten
// seconds if that goes to a file. Ends the computation when the user wants it.
class Progress_line : public CGAL::Approximate_geodesics::Distance_matrix_visitor_base
{
  using Progress = CGAL::Approximate_geodesics::Distance_matrix_progress;

public:
  ~Progress_line()
  {
    if(m_width > 0 && m_is_terminal)
      std::clog << std::endl;
  }

  bool go_further()
  {
    if(m_interruption.signal() != 0)
      return false;
    ++m_number_begun;
    return true;
  }

  void on_progress(const Progress& progress)
  {
    m_number_done = progress.number_done;
    if(m_stopwatch.seconds() < (m_is_terminal ? 1 : 10))
      return;
    m_stopwatch.restart();
    std::ostringstream text;
    text << progress.number_done << " of " << progress.number_of_rows << " rows, "
         << text_of_number(progress.rows_per_second) << " per second, "
         << text_of_time(progress.seconds_left) << " left";
    print(text.str());
  }

  // Returns the number of rows that this process has computed, or begun.
  std::size_t number_begun() const { return m_number_begun; }

  // Returns the number of rows that are done, by any process and run, as far as was told.
  std::size_t number_done() const { return m_number_done; }

private:
  void print(const std::string& text)
  {
    if(m_is_terminal)
      std::clog << '\r' << std::left << std::setw(static_cast<int>(m_width)) << text << std::flush;
    else
      std::clog << text << std::endl;
    m_width = text.size(); // which is to be written over
  }

  Interruption m_interruption;
  Stopwatch m_stopwatch;
  bool m_is_terminal = isatty(STDERR_FILENO) != 0;
  std::size_t m_width = 0;
  std::size_t m_number_begun = 0;
  std::size_t m_number_done = 0;
};

#endif // GEODESIC_MATRIX_PROGRESS_LINE_H
