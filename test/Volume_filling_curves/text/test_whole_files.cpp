// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/curve_io_test_support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <locale>
#include <string>
#include <system_error>

#ifdef __unix__
#include <csignal>
#include <sys/resource.h>
#endif

namespace test_whole_files {

using namespace curve_io_test;

TEST(Writing, does_not_depend_on_the_locale)
{
  struct Decimal_comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale former =
      std::locale::global(std::locale(std::locale::classic(), new Decimal_comma));
  const Reading reading = read_obj("v 0.5 0 0\nv 1 0 0.25\nl 1 2");
  const std::string text = internal::to_obj(internal::Curve_paths(reading.network));
  std::locale::global(former);
  EXPECT_EQ(text, "v 0.5 0 0\nv 1 0 0.25\nl 1 2\n");
}

TEST(Writing, replaces_an_old_file_and_leaves_nothing_else)
{
  const Folder folder;
  const Reading reading = read_obj(square + "l 1 2 3 4 1\nfixed 3");
  write(folder.file("a.obj"), "old and longer than the new one" + std::string(1000, '.'));
  write(folder.file("a.obj.tmp0"), "of somebody else");
  fs::permissions(folder.file("a.obj"), fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(CGAL::IO::write_curve_network(folder.file("a.obj"), reading.network));
  EXPECT_EQ(content(folder.file("a.obj")), square + "l 1 2 3 4 1\nfixed 3\n");
  EXPECT_EQ(content(folder.file("a.obj.tmp0")), "of somebody else");
  EXPECT_EQ(folder.number_of_files(), 2u);
  EXPECT_EQ(fs::status(folder.file("a.obj")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(Writing, follows_a_link_to_the_file)
{
  const Folder folder;
  const Reading reading = read_obj(square + "l 1 2 3 4 1");
  write(folder.file("target.obj"), "old");
  fs::create_symlink("target.obj", folder.file("link.obj"));
  ASSERT_TRUE(CGAL::IO::write_curve_network(folder.file("link.obj"), reading.network));
  EXPECT_TRUE(fs::is_symlink(folder.file("link.obj")));
  EXPECT_EQ(content(folder.file("target.obj")), square + "l 1 2 3 4 1\n");
}

TEST(Writing, creates_the_file_to_which_a_link_leads)
{
  const Folder folder;
  const Reading reading = read_obj(square + "l 1 2 3 4 1");
  fs::create_symlink("second.obj", folder.file("first.obj"));
  fs::create_symlink(folder.file("target.obj"), folder.file("second.obj"));
  ASSERT_TRUE(CGAL::IO::write_curve_network(folder.file("first.obj"), reading.network));
  EXPECT_TRUE(fs::is_symlink(folder.file("first.obj")));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder.file("target.obj"))));
  EXPECT_EQ(folder.number_of_files(), 3u);
}

TEST(Writing, through_links_in_a_circle_is_an_error)
{
  const Folder folder;
  fs::create_symlink("b.obj", folder.file("a.obj"));
  fs::create_symlink("a.obj", folder.file("b.obj"));
  EXPECT_EQ(internal::write_whole_file(folder.file("a.obj"), "text"),
            std::errc::too_many_symbolic_link_levels);
  EXPECT_EQ(folder.number_of_files(), 2u);
}

TEST(Writing, that_fails_says_why_and_leaves_the_old_file)
{
  const Folder folder;
  const Reading reading = read_obj(square + "l 1 2 3 4 1");
  std::error_code error;
  EXPECT_FALSE(CGAL::IO::write_curve_network(folder.file("no/such/a.obj"), reading.network, error));
  EXPECT_EQ(error, std::errc::no_such_file_or_directory);
  EXPECT_FALSE(CGAL::IO::write_curve_network(folder.file("a.abc"), reading.network, error));
  EXPECT_EQ(error, std::errc::invalid_argument);
  fs::create_directory(folder.file("folder.obj"));
  EXPECT_FALSE(CGAL::IO::write_curve_network(folder.file("folder.obj"), reading.network, error));
  EXPECT_EQ(error, std::errc::is_a_directory);
  EXPECT_EQ(folder.number_of_files(), 1u);
}

#ifdef __unix__

TEST(Writing, that_runs_out_of_space_leaves_the_old_file)
{
  const Folder folder;
  write(folder.file("a.obj"), "old");
  rlimit former;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &former), 0);
  const auto former_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = former;
  small.rlim_cur = 10000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string large(100000, '.');
  const std::error_code error = internal::write_whole_file(folder.file("a.obj"), large);
  EXPECT_EQ(internal::write_whole_file(folder.file("new.obj"), large), std::errc::file_too_large);
  setrlimit(RLIMIT_FSIZE, &former);
  std::signal(SIGXFSZ, former_handler);
  EXPECT_EQ(error, std::errc::file_too_large);
  EXPECT_EQ(content(folder.file("a.obj")), "old");
  EXPECT_EQ(folder.number_of_files(), 1u);
}

#endif

TEST(Writing, to_a_full_device_is_an_error)
{
  if(!fs::exists("/dev/full")) GTEST_SKIP() << "the system has no /dev/full";
  EXPECT_EQ(internal::write_whole_file("/dev/full", "text"), std::errc::no_space_on_device);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

} // namespace test_whole_files
