#ifndef GEODESIC_MATRIX_THREADS_H
#define GEODESIC_MATRIX_THREADS_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <stdexcept>

#ifdef CGAL_LINKED_WITH_TBB

// As many threads as are asked for, or one per core that this process may use.
class Threads
{
public:
  explicit Threads(const std::size_t number)
    : m_number(number > 0 ? number
                          : static_cast<std::size_t>(tbb::this_task_arena::max_concurrency())),
      m_control(tbb::global_control::max_allowed_parallelism, m_number),
      m_arena(static_cast<int>(m_number))
  {
  }

  std::size_t number() const { return m_number; }

  template <typename F>
  auto run(F f)
  {
    return m_arena.execute(f);
  }

private:
  std::size_t m_number;
  tbb::global_control m_control; // or more threads than cores would not come
  tbb::task_arena m_arena;
};

#else

// One thread, as the program was built without TBB.
class Threads
{
public:
  explicit Threads(const std::size_t number)
  {
    if(number > 1)
      throw std::invalid_argument("--threads: this program was built without TBB, for one thread");
  }

  std::size_t number() const { return 1; }

  template <typename F>
  auto run(F f)
  {
    return f();
  }
};

#endif

#endif // GEODESIC_MATRIX_THREADS_H
