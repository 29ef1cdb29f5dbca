// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_FAILING_ALLOCATION_H
#define APPROXIMATE_GEODESICS_TEST_FAILING_ALLOCATION_H

#include "oracles/test_oracles.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <vector>

namespace geodesics_test {

// What the operators `new` and `delete` of this program do: they count, and one allocation can be
// told to fail. The memory is that of `malloc()`, which sanitizers watch.
class Allocations
{
public:
  // the number of those that were not freed yet
  static std::ptrdiff_t number_alive() { return s_number_alive; }

  static void* allocate(const std::size_t size, const std::size_t alignment)
  {
    if(s_number_until_failure > 0 && --s_number_until_failure == 0)
      return nullptr;
    const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
    void* const result = alignment <= alignof(std::max_align_t)
                             ? std::malloc(rounded > 0 ? rounded : 1)
                             : std::aligned_alloc(alignment, rounded);
    s_number_alive += result != nullptr ? 1 : 0;
    return result;
  }

  static void* allocate_or_throw(const std::size_t size, const std::size_t alignment)
  {
    if(void* const result = allocate(size, alignment))
      return result;
    throw std::bad_alloc();
  }

  static void free(void* const memory)
  {
    s_number_alive -= memory != nullptr ? 1 : 0;
    std::free(memory);
  }

private:
  friend class Failing_allocation;

  inline static std::atomic<std::ptrdiff_t> s_number_alive{0};
  inline static std::atomic<std::ptrdiff_t> s_number_until_failure{0};
};

// While an object of this class lives, the allocation with the given number, counted from 1 on,
// fails; those after it do not.
class Failing_allocation
{
public:
  explicit Failing_allocation(const std::ptrdiff_t number) : m_number(number)
  {
    Allocations::s_number_until_failure = number;
  }

  Failing_allocation(const Failing_allocation&) = delete;
  Failing_allocation& operator=(const Failing_allocation&) = delete;

  ~Failing_allocation() { Allocations::s_number_until_failure = 0; }

  bool has_failed() const { return Allocations::s_number_until_failure <= 0; }

  // Returns how many have followed, if none has failed.
  std::ptrdiff_t number_of_allocations() const
  {
    return m_number - Allocations::s_number_until_failure;
  }

private:
  std::ptrdiff_t m_number;
};

template <typename Operation>
std::ptrdiff_t number_of_allocations(const Operation& operation)
{
  const Failing_allocation never((std::numeric_limits<std::ptrdiff_t>::max)());
  operation();
  return never.number_of_allocations();
}

// So small that there is time to let one allocation after the other fail.
inline Mesh small_terrain()
{
  Random random(test_seed());
  return to_mesh(terrain(9, 7, random));
}

using Values = std::vector<double>;

// Makes an object, and does something with it; values show whether it was done well.
template <typename Object>
struct Trial
{
  std::function<Object()> make;
  std::function<void(Object&)> operation;
  std::function<Values(Object&)> values;
  std::function<void(Object&)> check = [](Object&) {}; // what holds after a failure
  double deviation = 0;             // relative, from the values of the first object
  std::ptrdiff_t first_failure = 1; // the number of the allocation that fails first
};

inline void expect_values(const Values& found, const Values& expected, const double deviation)
{
  ASSERT_EQ(found.size(), expected.size());
  if(deviation == 0)
  {
    EXPECT_TRUE(have_same_bits(found, expected));
  }
  else
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_LE(found[i], (1 + deviation) * expected[i]);
      EXPECT_LE(expected[i], (1 + deviation) * found[i]);
    }
}

// Returns whether there was an allocation with this number.
template <typename Object>
bool fails(const Trial<Object>& trial, const std::ptrdiff_t number, const Values& expected)
{
  Object object = trial.make();
  bool has_failed = false;
  try
  {
    const Failing_allocation failing(number);
    trial.operation(object);
    has_failed = failing.has_failed(); // and could be done without
  }
  catch(const std::bad_alloc&)
  {
    has_failed = true;
    trial.check(object);
    trial.operation(object);
  }
  expect_values(trial.values(object), expected, trial.deviation);
  return has_failed;
}

// Lets one allocation of the operation after the other fail: the first ones all, and then fewer and
// fewer. The object can be used afterwards, and no memory is lost.
template <typename Object>
void expect_survival(const Trial<Object>& trial)
{
  Object first = trial.make();
  trial.operation(first);
  const Values expected = trial.values(first);
  std::ptrdiff_t number_of_failures = 0;
  bool is_last = false;
  const std::ptrdiff_t first_number = trial.first_failure;
  for(std::ptrdiff_t number = first_number; !is_last;
      number += number < first_number + 200 ? 1 : number / 8)
  {
    SCOPED_TRACE(testing::Message() << "allocation " << number);
    const std::ptrdiff_t before = Allocations::number_alive();
    const bool has_failed = fails(trial, number, expected);
    number_of_failures += has_failed ? 1 : 0;
    is_last = !has_failed || testing::Test::HasFailure();
    EXPECT_EQ(Allocations::number_alive(), before);
  }
  EXPECT_GT(number_of_failures, 0);
}

// What needs no object, and returns its values.
inline void expect_survival(const std::function<Values()>& operation)
{
  expect_survival<Values>({[] { return Values(); }, [&](Values& values) { values = operation(); },
                           [](Values& values) { return values; }});
}

template <typename Operation>
bool needs_no_allocation(const Operation& operation)
{
  const Failing_allocation first(1);
  operation();
  return !first.has_failed();
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_FAILING_ALLOCATION_H
