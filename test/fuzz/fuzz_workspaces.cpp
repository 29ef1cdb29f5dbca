// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Fuzzed_data.h"
#include "questions/questions_of_all_kinds.h"
#include "require.h"

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>

// Workspaces that are asked questions of all kinds, one after the other: each answers as a new
// object does.

namespace {

using namespace geodesics_test;

// The bytes that the fuzzer thinks up, and then random numbers that follow from them.
class Fuzzed_choices
{
public:
  Fuzzed_choices(const std::uint8_t* data, const std::size_t size)
    : m_data(data, size), m_random(seed(data, size))
  {
  }

  std::size_t below(const std::size_t size)
  {
    return m_data.is_empty() ? m_random.below(size) : m_data.below(size);
  }

private:
  static std::uint64_t seed(const std::uint8_t* data, const std::size_t size)
  {
    std::uint64_t result = 0;
    for(std::size_t i = 0; i < size; ++i)
      result = result * 257 + data[i];
    return result;
  }

  Fuzzed_data m_data;
  Random m_random;
};

// Says at the end how many questions there were.
struct Number_of_questions
{
  ~Number_of_questions() { print(); }

  void add_one()
  {
    constexpr std::size_t questions_between_lines = 100000;
    if(++value % questions_between_lines == 0)
      print();
  }

  void print() const { std::cerr << value << " questions, no wrong answer" << std::endl; }

  std::size_t value = 0;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, const std::size_t size)
{
  static Number_of_questions number;
  Fuzzed_choices choices(bytes, size);
  const auto on_answer = [](const char* kind, const std::string& difference) {
    require(difference.empty(), kind, difference, "after", number.value, "questions");
    number.add_one();
  };
  using Questions = Questions_of_all_kinds<Fuzzed_choices, decltype(on_answer)>;
  Questions questions(choices, on_answer);
  const std::size_t kind = choices.below(Questions::number_of_kinds);
  questions.ask(kind, chosen_mesh(choices), 20);
  return 0;
}
