// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXPECT_MESSAGE_H
#define APPROXIMATE_GEODESICS_TEST_EXPECT_MESSAGE_H

#include <gtest/gtest.h>

#include <string>

namespace geodesics_test {

// Expects an exception of the given type whose message contains all of the given texts.
template <typename Exception, typename F, typename... Texts>
void expect_message(F f, const Texts&... texts)
{
  try
  {
    f();
    ADD_FAILURE() << "nothing was thrown";
  }
  catch(const Exception& e)
  {
    const std::string message = e.what();
    for(const std::string& text : {std::string(texts)..., std::string("Approximate_geodesics")})
      EXPECT_NE(message.find(text), std::string::npos) << '"' << text << "\" in: " << message;
  }
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_EXPECT_MESSAGE_H
