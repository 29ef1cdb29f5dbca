// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include "questions/questions_of_all_kinds.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

// A workspace answers as a new object does, whatever it was asked before.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

// Asks about small meshes until there are so many answers for each kind of graph.
void expect_answers_of_new_objects(const std::size_t number_for_each_kind)
{
  Random random(test_seed());
  std::size_t number = 0, number_wrong = 0;
  const auto on_answer = [&](const char* kind, const std::string& difference) {
    ++number;
    if(difference.empty() || ++number_wrong > 20)
      return;
    ADD_FAILURE() << kind << ", question " << number << ": " << difference;
  };
  using Questions = Questions_of_all_kinds<Random, decltype(on_answer)>;
  Questions questions(random, on_answer);
  for(std::size_t kind = 0; kind < Questions::number_of_kinds; ++kind)
  {
    const std::size_t last = number + number_for_each_kind;
    while(number < last)
      questions.ask(kind, chosen_mesh(random), 60);
  }
  std::cout << number << " questions, " << number_wrong << " wrong answers" << std::endl;
}

TEST(Workspaces, answer_10000_questions_as_new_objects) { expect_answers_of_new_objects(1250); }

TEST(Workspaces, answer_many_questions_as_new_objects) { expect_answers_of_new_objects(25000); }

} // namespace
