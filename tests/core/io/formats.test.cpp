#include <doctest/doctest.h>

#include "core/io/samples.hpp"
#include "io/point_file.hpp"

using namespace snug;
using snug::io::read_points;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

io::PointFile read(const std::string& bytes, std::string_view name) {
  auto file = read_points(bytes, name);
  INFO(name << ": " << (file ? "" : file.error().message()));
  REQUIRE(file);
  return std::move(*file);
}

void check_tetra(const io::PointFile& file, bool faces) {
  CHECK(file.dim == 3);
  CHECK(file.points == samples::kTetra);
  CHECK(file.triangles == (faces ? samples::kTriangles : decltype(samples::kTriangles){}));
}

}  // namespace

TEST_CASE("a tetrahedron is the same in every format") {
  for (const auto& sample : samples::all()) {
    CAPTURE(sample.name);
    check_tetra(read(sample.bytes, sample.name), sample.faces);
  }
}

TEST_CASE("content decides the format where the name says nothing or something else") {
  for (const auto& sample : samples::all())
    for (const std::string name : {"-", "points", "points.", "folder.stl/points", "a.ply", "a.obj", "a.stl", "a.bin"}) {
      if (sample.name.find(".csv") != std::string::npos) continue;  // a header line and strict tabs are csv's own
      CAPTURE(sample.name);
      CAPTURE(name);
      check_tetra(read(sample.bytes, name), sample.faces);
    }
  check_tetra(read(samples::ply_binary(false), "T.PLY"), true);
  check_tetra(read("X,Y,Z\n" + samples::rows(","), "T.CSV"), false);
}

TEST_CASE("line ends, byte order marks, blank lines and comments change nothing") {
  for (const auto& sample : samples::all()) {
    if (sample.binary) continue;
    CAPTURE(sample.name);
    check_tetra(read(replaced(sample.bytes, "\n", "\r\n"), sample.name), sample.faces);
    check_tetra(read(replaced(sample.bytes, "\n", "\r"), sample.name), sample.faces);
    check_tetra(read("\xef\xbb\xbf" + sample.bytes, sample.name), sample.faces);
    check_tetra(read(sample.bytes.substr(0, sample.bytes.size() - 1), sample.name), sample.faces);
    check_tetra(read(sample.bytes + "\n \t\n", sample.name), sample.faces);
  }
  check_tetra(read("# first\n\n" + replaced(samples::rows(" "), "\n", " # why\n\n"), "t.xyz"), false);
}

TEST_CASE("a backslash at the end of a comment or of a name loses no vertex") {
  const std::string first = "v 0 0 0\nv 4 0 0\n", last = "v 9 9 9\n";
  for (const std::string_view between :
       {"# exported to D:\\scans\\\n", "o D:\\scans\\\n", "g left\\\n", "mtllib C:\\materials\\\n", "usemtl a\\\n",
        "v 1 1 \\\n1\n", "v 1 1 1 # here \\\n"}) {
    CAPTURE(between);
    const io::PointFile file = read(first + std::string(between) + last, "scan.obj");
    REQUIRE(file.points.size() == (between.starts_with("v") ? 4 : 3));
    CHECK(file.points.back() == Vector<double, 3>(9, 9, 9));
  }
}

TEST_CASE("a binary PLY's header may end its lines in any way, and its data may begin with a line end's byte") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nend_header\n";
    // After a lone CR, a first byte LF would belong to the line end.
    const std::string data = end == "\r" ? "\r\r" : "\n\r";
    const auto file = read(replaced(header, "\n", end) + data, "t.ply");
    CHECK(file.points[0] == Vector<double, 3>(data[0], data[1], 0));
  }
}

TEST_CASE("two numbers a line are 2-D points") {
  const std::vector<Vector<double, 3>> points{{1, 2, 0}, {3, -4, 0}};
  for (const auto& [file_name, text] : std::vector<std::pair<std::string, std::string>>{
           {"t.xyz", "1 2\n3 -4"},
           {"t.csv", "1,2\n3,-4"},
           {"quotes.csv", "\"x\",\"y\"\n\"1\",\"2\"\n\" 3\",\"-4 \""},
           {"t.ply",
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty int x\nproperty int y\nend_header\n1 2\n3 -4\n"}}) {
    const std::string name = file_name;  // clang 14 captures no part of a structured binding
    CAPTURE(name);
    const auto file = read(text, name);
    CHECK(file.dim == 2);
    CHECK(file.points == points);
  }
}

TEST_CASE("numbers are read to the nearest double") {
  const auto file = read("0.1 1e-320 8.3e152\n+1E+2 -.5e-1 5.\n1e-999 -0 9007199254740993\n", "t.xyz");
  CHECK(file.points[0] == Vector<double, 3>(0.1, 1e-320, 8.3e152));
  CHECK(file.points[1] == Vector<double, 3>(100, -0.05, 5));
  CHECK(file.points[2] == Vector<double, 3>(0, 0, 9007199254740992));
  CHECK(std::signbit(file.points[2][1]));
}

TEST_CASE("polygons become fans of triangles") {
  const std::vector<std::array<Index, 3>> fan{{4, 3, 2}, {4, 2, 1}, {4, 1, 0}};
  CHECK(read("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 2 0\nf 5 4 3 2 1\n", "t.obj").triangles == fan);
  CHECK(read("f 5 4 3 2 1\nv 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 2 0\n", "late.obj").triangles == fan);
  CHECK(read("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar uchar vertex_indices\nelement vertex 5\n"
             "property float x\nproperty float y\nend_header\n5 4 3 2 1 0\n0 0\n1 0\n2 1\n1 2\n0 2\n",
             "t.ply")
            .triangles == fan);
}

TEST_CASE("STL's corners are merged by their bits, so that -0 and 0 stay two points") {
  const auto file =
      read("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
           "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex -0 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"
           "SOLID second\nendsolid second\n",
           "t.stl");
  CHECK(file.points.size() == 4);
  CHECK(file.triangles == std::vector<std::array<Index, 3>>{{0, 1, 2}, {1, 3, 2}});
}

TEST_CASE("a point set is made of a file in the scalar and dimension asked for") {
  const auto flat = read("1 2\n3 -4", "t.xyz");
  const auto solid = read("1 2 3", "t.xyz");
  CHECK(std::holds_alternative<PointSet<double, 2>>(*io::to_point_set(flat, "t", 0, false)));
  CHECK(std::holds_alternative<PointSet<float, 2>>(*io::to_point_set(flat, "t", 2, true)));
  CHECK(std::holds_alternative<PointSet<double, 3>>(*io::to_point_set(flat, "t", 3, false)));
  const auto set = io::to_point_set(solid, "t", 0, true);
  REQUIRE(set);
  CHECK(std::get<PointSet<float, 3>>(*set)[0] == Vector<float, 3>(1, 2, 3));

  CHECK(io::to_point_set(solid, "t.xyz", 2, false).error().message() ==
        "t.xyz: the points are 3-D, and 2-D was asked for");
  CHECK(io::to_point_set(solid, "t.xyz", 4, false).error().message() == "t.xyz: the dimension must be 2 or 3");
  CHECK(io::to_point_set(read("0 0 0\n0 1e100 0", "t.xyz"), "t.xyz", 0, true).error().message() ==
        "t.xyz: point 1 is too far out for float: coordinates reach to 2^60, about 1.15e18");
}

TEST_CASE("binary PLY's integers keep their sign, in every width") {
  const auto file_of = [](const char* type, std::string_view bytes) {
    std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\n";
    for (const char* axis : {"x", "y", "z"}) header += std::string("property ") + type + " " + axis + "\n";
    return header + "end_header\n" + std::string(bytes);
  };
  using namespace std::literals;
  const std::vector<Vector<double, 3>> wanted{{-2, 1, -1}};
  CHECK(read(file_of("char", "\xfe\x01\xff"sv), "a.ply").points == wanted);
  CHECK(read(file_of("short", "\xfe\xff\x01\x00\xff\xff"sv), "a.ply").points == wanted);
  CHECK(read(file_of("int", "\xfe\xff\xff\xff\x01\x00\x00\x00\xff\xff\xff\xff"sv), "a.ply").points == wanted);
  const std::vector<Vector<double, 3>> high{{254, 1, 255}};
  CHECK(read(file_of("uchar", "\xfe\x01\xff"sv), "a.ply").points == high);
}
