// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/IO/polylines.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <list>
#include <locale>
#include <random>
#include <string>
#include <utility>
#include <vector>

#ifdef __unix__
#include <csignal>
#include <sys/resource.h>
#endif

namespace {

using namespace CGAL::Volume_filling_curves;
namespace fs = std::filesystem;

using Network = Curve_network_3<>;
using Point_3 = Network::Point_3;
using Edges = std::vector<std::array<std::size_t, 2>>;

struct Reading
{
  bool is_accepted = false;
  Network network;
  std::vector<Curve_defect> defects;

  // the vertices of the file along the curve
  std::vector<std::size_t> origins() const
  {
    std::vector<std::size_t> result;
    for(std::size_t v = 0; v < network.number_of_nodes(); ++v) result.push_back(network.origin(v));
    return result;
  }
};

Reading read(internal::Curve_file file, Junctions junctions)
{
  Reading reading;
  reading.is_accepted = internal::make_network(file, reading.network, reading.defects, junctions);
  return reading;
}

Reading read_obj(const std::string& text, Junctions junctions = Junctions::FORBIDDEN)
{
  return read(internal::read_obj(text, junctions), junctions);
}

Reading read_txt(const std::string& text, Junctions junctions = Junctions::FORBIDDEN)
{
  return read(internal::read_polylines_txt(text, junctions), junctions);
}

// A folder that disappears with its files.
class Folder
{
public:
  Folder()
  {
    static int count = 0;
    m_path =
        fs::temp_directory_path() / ("test_polylines_io_" + std::to_string(std::random_device()()) +
                                     "_" + std::to_string(count++));
    fs::create_directory(m_path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(m_path); }

  std::string file(const std::string& name) const { return (m_path / name).string(); }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(m_path), fs::directory_iterator()));
  }

private:
  fs::path m_path;
};

std::string content(const std::string& filename)
{
  std::ifstream file(filename, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& filename, const std::string& text)
{
  std::ofstream(filename, std::ios::binary) << text;
}

void expect_same(const Network& a, const Network& b)
{
  ASSERT_EQ(a.number_of_nodes(), b.number_of_nodes());
  ASSERT_EQ(a.number_of_edges(), b.number_of_edges());
  ASSERT_EQ(a.number_of_components(), b.number_of_components());
  for(std::size_t v = 0; v < a.number_of_nodes(); ++v) {
    const std::array<double, 3> p{a.point(v).x(), a.point(v).y(), a.point(v).z()};
    const std::array<double, 3> q{b.point(v).x(), b.point(v).y(), b.point(v).z()};
    EXPECT_EQ(std::memcmp(p.data(), q.data(), sizeof(p)), 0) << "node " << v;
    EXPECT_EQ(a.component(v), b.component(v));
  }
  for(std::size_t e = 0; e < a.number_of_edges(); ++e) {
    EXPECT_EQ(a.source(e), b.source(e));
    EXPECT_EQ(a.target(e), b.target(e));
  }
  for(std::size_t c = 0; c < a.number_of_components(); ++c)
    EXPECT_EQ(a.is_closed(c), b.is_closed(c));
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

// Four corners and a closed curve, in every way of writing that OBJ knows.
class Every_form_of_a_square : public testing::TestWithParam<std::string>
{};

TEST_P(Every_form_of_a_square, is_the_same_closed_curve)
{
  const Reading reading = read_obj(GetParam());
  EXPECT_TRUE(reading.is_accepted);
  EXPECT_TRUE(reading.defects.empty()) << to_string(reading.defects.front(), "");
  ASSERT_EQ(reading.network.number_of_components(), 1u);
  EXPECT_TRUE(reading.network.is_closed(0));
  EXPECT_EQ(reading.origins(), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(reading.network.point(2), Point_3(1, 1, 0));
}

INSTANTIATE_TEST_SUITE_P(
    Obj,
    Every_form_of_a_square,
    testing::Values(square + "l 1 2 3 4 1\n",
                    square + "l 1 2 3 4 1", // no newline at the end
                    square + "l 1 2\nl 2 3\nl 3 4\nl 4 1\n",
                    square + "l 1 2\nl 4 3\nl 4 1\nl 3 2\n",
                    square + "l 1/7 2/8 3/9 4/1 1/7\n",
                    square + "l 1/ 2/ 3/ 4/ 1/\n",
                    square + "l -4 -3 -2 -1 -4\n",
                    square + "l 1 -3 3 -1 1\n",
                    square + "l 01 2 3 4 1\n",
                    "l 1 2 3 4 1\n" + square,
                    "v 0 0 0\nv 1 0 0\nl -2 -1\nv 1 1 0\nl -2 -1\nv 0 1 0\nl -2 -1 1\n",
                    square + "l 1 2 \\\n3 4 \\\n 1\n",
                    square + "l 1 2\\\n3 4\\\r\n1\n",
                    "v 0 0 0 1\nv 1 0 0 0.5\nv 1 1 0 1 0 0\nv 0 1 0 .2 .3 .4\nl 1 2 3 4 1",
                    "v +0 0.0 0.\nv 1e0 .0 -0\nv 1E+0 1e-0 0\nv 0 1 1e-999\nl 1 2 3 4 1",
                    "\xEF\xBB\xBF" + square + "l 1 2 3 4 1",
                    "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nl 1 2 3 4 1\r\n",
                    "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rl 1 2 3 4 1\r",
                    "\tv\t0 0\t0 \n v 1 0 0\t\nv  1  1  0\n\n\nv 0 1 0\n \t\nl\t1 2 3  4 1 ",
                    "# v 9 9 9\nv 0 0 0 # here\nv 1 0 0 #\nv 1 1 0\nv 0 1 0\nl 1 2 3 4 1 # 5",
                    "# \xC3\xA4 \xE4 C:\\\no \xE4\ng a b\ns off\nmtllib x\nusemtl y\nvt 0 0\n" +
                        square + "vn 0 0 1\np 1\nl 1 2 3 4 1\nf 1 2 3\n"));

TEST(Obj, index_with_a_plus_sign_is_no_index)
{
  EXPECT_FALSE(read_obj(square + "l +1 2 3 4 1\n").is_accepted);
}

TEST(Obj, record_that_does_not_repeat_its_first_index_is_open)
{
  const Reading reading = read_obj(square + "l 1 2 3 4");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_FALSE(reading.network.is_closed(0));
  EXPECT_EQ(reading.network.number_of_edges(), 3u);
}

TEST(Obj, vertices_without_lines_are_one_closed_curve_with_a_warning)
{
  const Reading reading = read_obj(square);
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_TRUE(reading.network.is_closed(0));
  ASSERT_EQ(reading.defects.size(), 1u);
  EXPECT_EQ(reading.defects[0].kind, Curve_defect_kind::NO_LINES);
}

TEST(Obj, components_keep_the_order_of_their_first_edges)
{
  const Reading reading =
      read_obj("v 0 0 0\nv 1 0 0\nv 0 0 5\nv 1 0 5\nv 2 0 5\nl 3 4\nl 1 2\nl 4 5\n");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.origins(), (std::vector<std::size_t>{2, 3, 4, 0, 1}));
}

TEST(Obj, fixed_pins_vertices)
{
  const Reading reading = read_obj("fixed 2\n" + square + "l 1 2 3 4 1\nfixed 4 -4\n");
  ASSERT_TRUE(reading.is_accepted);
  const std::vector<bool> expected{true, true, false, true};
  for(std::size_t v = 0; v < 4; ++v) EXPECT_EQ(reading.network.is_pinned(v), expected[v]);
}

TEST(Obj, pin_of_a_merged_node_holds_for_the_node_that_stays)
{
  const Reading reading = read_obj(square + "v 0 1 0\nl 1 2 3 4 5 1\nfixed 5\n");
  ASSERT_TRUE(reading.is_accepted);
  ASSERT_EQ(reading.network.number_of_nodes(), 4u);
  EXPECT_EQ(reading.origins().back(), 3u);
  EXPECT_TRUE(reading.network.is_pinned(3));
}

TEST(Polylines_txt, repeated_first_point_closes)
{
  const Reading reading = read_txt("4 0 0 0 1 0 0 0 1 0 0 0 -0\n\n# arc\n2 0 0 1 5 5 5\n1 9 9 9");
  ASSERT_TRUE(reading.is_accepted);
  ASSERT_EQ(reading.network.number_of_components(), 2u);
  EXPECT_TRUE(reading.network.is_closed(0));
  EXPECT_FALSE(reading.network.is_closed(1));
  EXPECT_EQ(reading.origins(), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  ASSERT_EQ(reading.defects.size(), 1u);
  EXPECT_EQ(reading.defects[0].kind, Curve_defect_kind::ISOLATED_VERTEX);
  EXPECT_EQ(reading.defects[0].nodes, std::vector<std::size_t>{6});
}

TEST(Polylines_txt, numbers_may_continue_on_the_next_line)
{
  const Reading reading = read_txt("3 0 0 0\n1 0 0\n1 1\n0\n2 0 0 5 1 1 5\n");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.network.number_of_nodes(), 5u);
}

TEST(Polylines_txt, equal_ends_are_one_node_of_a_network_only)
{
  const std::string text = "2 0 0 0 1 0 0\n2 1 0 0 0 1 0\n2 1 0 0 0 0 1\n";
  EXPECT_FALSE(read_txt(text).is_accepted);
  const Reading reading = read_txt(text, Junctions::ALLOWED);
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.network.number_of_nodes(), 4u);
  EXPECT_TRUE(reading.network.has_junction());
}

TEST(Polylines_txt, wrong_number_of_points_is_an_error)
{
  for(const std::string text :
      {"3 0 0 0 1 0 0", "1 0 0 0 1 0 0", "2 0 0 0 1 0\n", "99999999999 0 0 0 1 1 1"}) {
    const Reading reading = read_txt(text);
    EXPECT_FALSE(reading.is_accepted);
    ASSERT_FALSE(reading.defects.empty());
    EXPECT_EQ(reading.defects[0].kind, Curve_defect_kind::WRONG_POINT_COUNT) << text;
  }
}

TEST(Numbers, tell_overflow_from_underflow)
{
  double x = 0;
  const std::string zeros(400, '0');
  for(const std::string word : {"1e400", "1e99999999999999999999", "100e307"}) {
    EXPECT_TRUE(internal::parse_number(word, x));
    EXPECT_EQ(x, std::numeric_limits<double>::infinity()) << word;
  }
  EXPECT_TRUE(internal::parse_number("1" + zeros + "e-1", x));
  EXPECT_EQ(x, std::numeric_limits<double>::infinity());
  for(const std::string word : {"1e-400", "-1e-99999999999999999999", "0.0001e-330"}) {
    EXPECT_TRUE(internal::parse_number(word, x));
    EXPECT_EQ(x, 0) << word;
    EXPECT_EQ(std::signbit(x), word[0] == '-');
  }
  EXPECT_TRUE(internal::parse_number("." + zeros + "1", x));
  EXPECT_EQ(x, 0);
  for(const std::string word : {"", "+", "+-1", "1,5", "1e", "0x10", "1 ", "--1", "1.2.3"})
    EXPECT_FALSE(internal::parse_number(word, x)) << word;
}

// Doubles of all magnitudes that a curve may have.
std::vector<Point_3> random_points(std::size_t count, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::vector<Point_3> points;
  const auto coordinate = [&]() {
    for(;;) {
      const std::uint64_t bits = random();
      double x = 0;
      std::memcpy(&x, &bits, sizeof(x));
      if(std::abs(x) <= internal::Curve_file::max_coordinate) return x;
    }
  };
  while(points.size() < count) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}

TEST(Round_trip, is_exact_to_the_last_bit)
{
  const Folder folder;
  std::vector<Point_3> points = random_points(200, 1);
  points.emplace_back(std::numeric_limits<double>::denorm_min(), -0., 0.1);
  points.emplace_back(1e150, -1e150, std::numeric_limits<double>::min());
  Edges edges;
  for(std::size_t v = 0; v < points.size(); ++v)
    if(v != 99) edges.push_back({v, v == 201 ? 100 : v + 1});
  Network network(points, edges);
  network.set_pinned(7);
  network.set_pinned(150);
  for(const std::string name : {"a.obj", "a.polylines.txt", "A.OBJ", "a.Polylines.TXT"}) {
    Network copy;
    ASSERT_TRUE(CGAL::IO::write_curve_network(folder.file(name), network));
    ASSERT_TRUE(CGAL::IO::read_curve_network(folder.file(name), copy)) << name;
    expect_same(network, copy);
    const bool has_pins = name == "a.obj" || name == "A.OBJ";
    EXPECT_EQ(copy.is_pinned(150), has_pins);
  }
  EXPECT_EQ(folder.number_of_files(), 4u);
}

TEST(Round_trip, keeps_a_network_with_junctions)
{
  std::mt19937 random(5);
  for(int repetition = 0; repetition < 50; ++repetition) {
    const std::size_t n = 12;
    std::vector<Point_3> points;
    for(std::size_t i = 0; i < n; ++i) {
      const double t = double(i + 1); // on the moment curve no two edges meet
      points.emplace_back(t, t * t, t * t * t);
    }
    Edges edges;
    for(std::size_t v = 0; v < n; ++v)
      for(std::size_t w = v + 1; w < n; ++w)
        if(random() % 5 == 0) edges.push_back({v, w});
    std::shuffle(edges.begin(), edges.end(), random);
    for(auto& edge : edges)
      if(random() % 2 == 0) std::swap(edge[0], edge[1]);
    if(edges.empty()) continue;
    const Network network(points, edges);
    const internal::Curve_strands strands(network);
    const Reading obj = read_obj(internal::to_obj(strands), Junctions::ALLOWED);
    ASSERT_TRUE(obj.is_accepted);
    expect_same(network, obj.network);
    const Reading txt = read_txt(internal::to_polylines_txt(strands), Junctions::ALLOWED);
    ASSERT_TRUE(txt.is_accepted);
    EXPECT_EQ(txt.network.number_of_nodes(), network.number_of_nodes());
    EXPECT_EQ(txt.network.number_of_edges(), network.number_of_edges());
  }
}

TEST(Writing, does_not_depend_on_the_locale)
{
  struct Decimal_comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale former =
      std::locale::global(std::locale(std::locale::classic(), new Decimal_comma));
  const Reading reading = read_obj("v 0.5 0 0\nv 1 0 0.25\nl 1 2");
  const std::string text = internal::to_obj(internal::Curve_strands(reading.network));
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

TEST(Writing, that_fails_says_why_and_leaves_the_old_file)
{
  const Folder folder;
  const Reading reading = read_obj(square + "l 1 2 3 4 1");
  std::error_code error;
  EXPECT_FALSE(CGAL::IO::write_curve_network(folder.file("no/such/a.obj"), reading.network, error));
  EXPECT_EQ(error, std::errc::no_such_file_or_directory);
  EXPECT_FALSE(CGAL::IO::write_curve_network(folder.file("a.xyz"), reading.network, error));
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
  const std::error_code error =
      internal::write_whole_file(folder.file("a.obj"), std::string(100000, '.'));
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

TEST(Reading, of_a_missing_file_or_an_unknown_format_is_an_error)
{
  const Folder folder;
  Network network;
  std::vector<Curve_defect> defects;
  EXPECT_FALSE(CGAL::IO::read_curve_network(folder.file("a.obj"), network, defects));
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Curve_defect_kind::UNREADABLE_FILE);
  EXPECT_FALSE(CGAL::IO::read_curve_network(folder.file("a.stl"), network, defects));
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Curve_defect_kind::UNKNOWN_FORMAT);
}

TEST(Reading, that_fails_leaves_the_network)
{
  Network network = read_obj(square + "l 1 2 3 4 1").network;
  std::vector<Curve_defect> defects;
  internal::Curve_file file = internal::read_obj("v 0 0", Junctions::FORBIDDEN);
  EXPECT_FALSE(internal::make_network(file, network, defects, Junctions::FORBIDDEN));
  EXPECT_EQ(network.number_of_nodes(), 4u);
}

TEST(Polylines, become_a_network_and_come_back)
{
  const std::list<std::vector<Point_3>> polylines = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, {{0, 0, 1}, {1, 0, 1}}, {}};
  Network network;
  std::vector<Curve_defect> defects;
  ASSERT_TRUE(polylines_to_curve_network(polylines, network, defects));
  EXPECT_TRUE(defects.empty());
  std::vector<std::vector<Point_3>> result;
  curve_network_to_polylines(network, std::back_inserter(result));
  ASSERT_EQ(result.size(), 2u);
  EXPECT_EQ(result[0], polylines.front());
  EXPECT_EQ(result[1], *std::next(polylines.begin()));
}

TEST(Polylines, have_a_point_map_and_any_kernel)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_point = Exact_kernel::Point_3;
  using Item = std::pair<int, Exact_point>;
  const std::vector<std::vector<Item>> polylines = {
      {{1, Exact_point(0, 0, 0)}, {2, Exact_point(1, 0, 0)}, {3, Exact_point(1, 1, 2)}}};
  Curve_network_3<Curve_flow_traits_3<Exact_kernel>> network;
  std::vector<Curve_defect> defects;
  const auto np = CGAL::parameters::point_map(CGAL::Second_of_pair_property_map<Item>());
  ASSERT_TRUE(polylines_to_curve_network(polylines, network, defects, Junctions::FORBIDDEN, np));
  EXPECT_EQ(network.number_of_nodes(), 3u);
  EXPECT_EQ(network.point(2), Exact_point(1, 1, 2));
}

TEST(Polylines, that_meet_are_refused_with_the_numbers_of_their_points)
{
  const std::vector<std::vector<Point_3>> polylines = {{{-1, 0, 0}, {1, 0, 0}},
                                                       {{0, -1, 0}, {0, 1, 0}}};
  Network network;
  std::vector<Curve_defect> defects;
  EXPECT_FALSE(polylines_to_curve_network(polylines, network, defects));
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Curve_defect_kind::SELF_CONTACT);
  EXPECT_EQ(defects[0].nodes, (std::vector<std::size_t>{1, 2, 3, 4}));
}

} // namespace
