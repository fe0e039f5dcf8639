// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Many runs of the program vfc: options, files, and what is refused. Kills and processes that share
// the work are in test_batch.py.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_command_line_batch {

namespace fs = std::filesystem;
using program_test::Finished;
using program_test::Json;

class Command_line_batch : public program_test::Program_test
{
protected:
  // a.obj, b.obj and a list of them
  void make_curves() const
  {
    ASSERT_EQ(run("generate torus-knot --nodes 40 -o a.obj").status, 0);
    ASSERT_EQ(run("generate random-polygon --nodes 12 -o b.obj").status, 0);
    write("list", "a.obj\nb.obj\n");
  }

  std::set<std::string> files(const std::string& folder) const
  {
    std::set<std::string> names;
    for(const auto& entry : fs::directory_iterator(path(folder)))
      names.insert(entry.path().filename().string());
    return names;
  }

  std::vector<Json> results(const std::string& folder) const
  {
    std::vector<Json> lines;
    std::istringstream text(read(folder + "/results.jsonl"));
    for(std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
    return lines;
  }

  void expect_refused(const std::string& arguments, int status, const std::string& why) const
  {
    const Finished refused = run(arguments);
    EXPECT_EQ(refused.status, status) << arguments;
    EXPECT_NE(refused.err.find(why), std::string::npos) << arguments << '\n' << refused.err;
  }
};

TEST_F(Command_line_batch, options_hold_for_each_run)
{
  make_curves();
  const std::string options = " --strategy flow --max-iterations 3 --pin 1";
  EXPECT_EQ(run("untangle --batch list -o out_of_batch --map map --certificate cert.txt "
                "--frames film --format polylines.txt" +
                options)
                .status,
            2);
  EXPECT_EQ(
      files("out_of_batch"),
      std::set<std::string>({"a.polylines.txt", "a.map", "a.cert.txt", "a.film", "b.polylines.txt",
                             "b.map", "b.cert.txt", "b.film", "results.jsonl"}));
  EXPECT_EQ(run("untangle b.obj -o b.polylines.txt --map b.map --certificate b.cert.txt" + options)
                .status,
            2);
  for(const std::string name : {"b.polylines.txt", "b.map", "b.cert.txt"})
    EXPECT_EQ(read("out_of_batch/" + name), read(name)) << name;
  const std::vector<Json> lines = results("out_of_batch");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0]["input"], "a.obj");
  EXPECT_EQ(lines[1]["status"], "limit");
  EXPECT_EQ(lines[1]["exit_status"], 2);
}

TEST_F(Command_line_batch, tells_what_each_run_came_to)
{
  make_curves();
  const Finished batch = run("simplify --batch list -o simple");
  EXPECT_EQ(batch.status, 0);
  EXPECT_NE(batch.err.find("1 of 2: a.obj: done, "), std::string::npos) << batch.err;
  EXPECT_NE(batch.err.find("2 of 2: b.obj: done, "), std::string::npos) << batch.err;
  EXPECT_EQ(batch.out, "runs 2, done 2, reports in simple/results.jsonl\n");
  const Finished quiet = run("simplify --batch list -o quiet --quiet");
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(Command_line_batch, a_shard_takes_each_nth_line)
{
  make_curves();
  EXPECT_EQ(run("simplify --batch list -o out_of_shard --shard 2/2").status, 0);
  EXPECT_EQ(files("out_of_shard"), std::set<std::string>({"b.obj", "results.jsonl"}));
  EXPECT_EQ(run("simplify --batch list -o out_of_shard --shard 3/3").status, 0);
  EXPECT_EQ(run("simplify --batch list -o last --shard 2/18446744073709551615").status, 0);
  EXPECT_EQ(files("last"), std::set<std::string>({"b.obj", "results.jsonl"}));
  for(const std::string shard : {"0/2", "3/2", "1", "1/", "/2", "a/b", "-1/2", "1/2/3"})
    expect_refused("simplify --batch list -o x --shard " + shard, 1, "--shard");
}

TEST_F(Command_line_batch, fills_meshes)
{
  write("tetrahedron.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                           "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write("list", "open.off\ntetrahedron.off\n");
  EXPECT_EQ(run("fill --batch list -o filled --thickness 0.2 --max-iterations 5").status, 4);
  EXPECT_EQ(files("filled"), std::set<std::string>({"tetrahedron.obj", "results.jsonl"}));
  EXPECT_EQ(results("filled")[0]["error"]["file"], "open.off");
  EXPECT_EQ(results("filled")[1]["input"], "tetrahedron.off");
}

TEST_F(Command_line_batch, identifies_curves)
{
  make_curves();
  fs::create_directory(path("more"));
  ASSERT_EQ(run("generate braid --word '1 -2 1 -2' -o more/a.obj").status, 0);
  write("open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 0 0\nv 6 0 0\nl 1 2 3 1\nl 4 5\n");
  write("list", "a.obj\nopen.obj\nmore/a.obj\n");
  const Finished batch = run("identify --batch list -o names --codes gauss");
  EXPECT_EQ(batch.status, 4);
  EXPECT_EQ(batch.out, "runs 3, done 2, error 1, reports in names/results.jsonl\n");
  EXPECT_EQ(files("names"), std::set<std::string>({"results.jsonl"}));
  const std::vector<Json> lines = results("names");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0]["name"], "3_1");
  EXPECT_EQ(lines[1]["error"]["file"], "open.obj");
  EXPECT_EQ(lines[2]["input"], "more/a.obj");
  EXPECT_EQ(lines[2]["name"], "4_1");
  ASSERT_EQ(run("identify more/a.obj --codes gauss --report single.json").status, 0);
  for(const std::string key : {"is_proved", "chirality", "codes", "homfly_polynomial"})
    EXPECT_EQ(lines[2][key], json("single.json")[key]) << key;
}

TEST_F(Command_line_batch, identifies_no_curve_twice_and_all_in_shards)
{
  make_curves();
  const std::string command = "identify --batch list -o names";
  EXPECT_EQ(run(command + " --shard 2/2").status, 0);
  ASSERT_EQ(results("names").size(), 1u);
  EXPECT_EQ(results("names")[0]["input"], "b.obj");
  EXPECT_EQ(run(command).status, 0);
  ASSERT_EQ(results("names").size(), 2u);
  EXPECT_EQ(results("names")[1]["input"], "a.obj");
  const std::string before = read("names/results.jsonl");
  EXPECT_EQ(run(command).status, 0);
  EXPECT_EQ(read("names/results.jsonl"), before);
}

TEST_F(Command_line_batch, draws_a_fingerprint_of_each_chain)
{
  make_curves();
  write("list", "a.obj\nb.obj\n");
  const std::string options = " --open --closures 5 --stride 10 --fingerprint ";
  EXPECT_EQ(run("identify --batch list -o chains" + options + "csv").status, 0);
  EXPECT_EQ(files("chains"), std::set<std::string>({"a.csv", "b.csv", "results.jsonl"}));
  ASSERT_EQ(run("identify a.obj" + options + "single.csv").status, 0);
  EXPECT_EQ(read("chains/a.csv"), read("single.csv"));
}

TEST_F(Command_line_batch, the_gravest_status_counts_also_of_earlier_runs)
{
  make_curves();
  EXPECT_EQ(run("untangle --batch list -o x --strategy flow --max-iterations 1").status, 2);
  EXPECT_EQ(run("untangle --batch list -o x").status, 2) << "nothing is done twice";
  EXPECT_EQ(run("untangle --batch list -o y --thickness 1e9").status, 1);
  EXPECT_EQ(results("y").size(), 2u);
}

TEST_F(Command_line_batch, a_folder_of_others_is_refused)
{
  make_curves();
  fs::create_directory(path("there"));
  write("there/a.obj", "mine");
  expect_refused("simplify --batch list -o there", 1, "--force");
  EXPECT_EQ(read("there/a.obj"), "mine");
  EXPECT_EQ(files("there").size(), 1u);
  EXPECT_EQ(run("simplify --batch list -o there --force").status, 0);
  expect_refused("untangle --batch list -o there", 1,
                 "results.jsonl:1: is no result of vfc untangle");
  expect_refused("simplify --batch list -o list", 1, "list: is not a folder");
  expect_refused("simplify --batch list -o none/x", 1, "none/x");
}

TEST_F(Command_line_batch, a_list_is_checked_before_work_starts)
{
  make_curves();
  fs::create_directory(path("more"));
  write("twice", "a.obj\nmore/a.polylines.txt\n");
  expect_refused("simplify --batch twice -o x", 4,
                 "twice:2: error: second result of the same name");
  write("within", "b.obj\nmore/a.obj\n");
  expect_refused("simplify --batch within -o more", 4, "within:2: error: input in the folder");
  write("latin", "b.obj\na\xe9.obj\n");
  expect_refused("simplify --batch latin -o x", 4, "latin:2: error: name that is not UTF-8");
  expect_refused("simplify --batch none -o x", 4, "none: error: unreadable file");
  EXPECT_FALSE(exists("x"));
  EXPECT_TRUE(files("more").empty());
}

// Another file would overwrite the reports, or the file of another input.
TEST_F(Command_line_batch, files_that_would_overwrite_others_are_refused)
{
  make_curves();
  fs::rename(path("a.obj"), path("results.obj"));
  write("list", "b.obj\nresults.obj\n");
  const std::string refusal = "list:2: error: second result of the same name";
  for(const std::string option : {"--map jsonl", "--certificate jsonl", "--frames jsonl"})
    expect_refused("untangle --batch list -o x " + option, 4, refusal);
  write("list", "b.off\nb.cert.start.off\n");
  expect_refused("fill --batch list -o x --certificate cert", 4, refusal);
  write("list", "b.obj\n");
  expect_refused("untangle --batch list -o x --map map --certificate map", 4, "list:1: error");
  expect_refused("untangle --batch list -o x --map obj", 4, "list:1: error");
  EXPECT_FALSE(exists("x"));
  write("list", "b.obj\nresults.obj\n");
  EXPECT_EQ(run("simplify --batch list -o y").status, 0);
}

// The file of the results would have taken the place of the closed stream.
TEST_F(Command_line_batch, messages_to_closed_streams_do_not_enter_the_results)
{
  make_curves();
  for(const std::string closed : {"2>&-", "<&-", "<&- 2>&-"}) {
    fs::remove_all(path("closed"));
    const std::string command =
        "cd '" + path(".").string() +
        "' && '" VFC_PROGRAM "' simplify --batch list -o closed >out 2>err " + closed;
    EXPECT_EQ(std::system(command.c_str()), 0) << closed;
    EXPECT_EQ(results("closed").size(), 2u) << closed;
  }
}

TEST_F(Command_line_batch, an_exit_status_that_there_is_not_is_refused)
{
  make_curves();
  EXPECT_EQ(run("simplify --batch list -o x").status, 0);
  const std::string line = read("x/results.jsonl").substr(0, read("x/results.jsonl").find('\n'));
  const std::string status = "\"exit_status\":";
  const std::size_t begin = line.find(status) + status.size(), end = line.find(',', begin);
  for(const std::string wrong : {"99999999999999", "18446744073709551615", "-1", "256", "0.5"}) {
    write("x/results.jsonl", line.substr(0, begin) + wrong + line.substr(end) + '\n');
    expect_refused("simplify --batch list -o x", 1, "results.jsonl:1: is no result of");
  }
}

TEST_F(Command_line_batch, takes_the_place_of_input_and_report)
{
  make_curves();
  expect_refused("simplify -o x", 1, "CURVE is required");
  expect_refused("simplify a.obj --batch list -o x", 1, "excludes");
  expect_refused("simplify --batch list", 1, "--output");
  expect_refused("simplify --batch list -o x --report y", 1, "excludes");
  expect_refused("untangle --batch list -o x --checkpoint y", 1, "excludes");
  expect_refused("untangle --batch list -o x --resume y", 1, "excludes");
  expect_refused("simplify a.obj -o x.obj --shard 1/2", 1, "--batch");
  expect_refused("simplify a.obj -o x.obj --format vtp", 1, "--batch");
  expect_refused("simplify --batch list -o x --map y/z", 1, "y/z");
  expect_refused("identify a.obj -o x", 1, "--batch");
  expect_refused("identify a.obj --batch list -o x", 1, "excludes");
  expect_refused("identify --batch list", 1, "--output");
  EXPECT_FALSE(exists("x"));
}

} // namespace test_command_line_batch

#endif // json.hpp
