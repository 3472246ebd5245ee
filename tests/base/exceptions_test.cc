#include <rift/base/checked_cast.h>
#include <rift/base/exceptions.h>

#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <cstdint>
#include <new>

using namespace rift;

TEST(ToError, KeepsErrorsAndExplainsOthers)
{
  const Error disk = to_error(DiskError("full"));
  EXPECT_EQ(disk.exit_code, ExitCode::disk_error);
  EXPECT_STREQ(disk.what(), "full");

  const Error memory = to_error(std::bad_alloc());
  EXPECT_EQ(memory.exit_code, ExitCode::run_error);
  EXPECT_STREQ(memory.what(),
               "the memory of this machine is too small for this scene. Use "
               "larger elements.");

  const Error other = to_error(std::runtime_error("x"));
  EXPECT_EQ(other.exit_code, ExitCode::run_error);
  EXPECT_STREQ(other.what(),
               "rift has failed in a way that it does not foresee. Please "
               "report this: x");
}

TEST(CallAll, CallsAlsoBehindOneThatThrows)
{
  std::string called;
  const auto  call = [&] {
    call_all({[&] { called += 'a'; },
              [&] {
                called += 'b';
                throw DiskError("first");
              },
              [&] {
                called += 'c';
                throw std::out_of_range("second");
              },
              [&] { called += 'd'; }});
  };
  EXPECT_EQ(message_of<Error>(call), "first");
  EXPECT_EQ(called, "abcd");
  call_all({[&] { called += 'e'; }});
  EXPECT_EQ(called, "abcde");
}

TEST(CheckedCast, RefusesTheIndexOfNothing)
{
  EXPECT_EQ(checked_cast<std::uint16_t>(65534, "things"), 65534);
  EXPECT_EQ(checked_cast<std::uint32_t>(4294967294, "things"), 4294967294);
  EXPECT_EQ(
    message_of<InputError>(
      [] { checked_cast<std::uint32_t>(4294967295, "cells"); }),
    "there are 4294967295 cells, but rift counts fewer than 4294967295. "
    "Use larger elements, or more ranks.");
  // Which a plain cast makes 1.
  EXPECT_THROW(checked_cast<std::uint16_t>(65537, "things"), InputError);
}
