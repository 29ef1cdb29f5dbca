// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXPECT_MESSAGE_H
#define APPROXIMATE_GEODESICS_TEST_EXPECT_MESSAGE_H

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace geodesics_test {

template <typename Exception>
void expect_texts(const std::function<void()>& f, const std::vector<std::string>& texts)
{
  try
  {
    f();
    ADD_FAILURE() << "nothing was thrown";
  }
  catch(const Exception& e)
  {
    const std::string message = e.what();
    for(const std::string& text : texts)
      EXPECT_NE(message.find(text), std::string::npos) << '"' << text << "\" in: " << message;
  }
}

// Expects an exception of the given type whose message contains all of the given texts.
template <typename Exception, typename F, typename... Texts>
void expect_message(const F& f, const Texts&... texts)
{
  expect_texts<Exception>(f, {texts..., "Approximate_geodesics"});
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_EXPECT_MESSAGE_H
