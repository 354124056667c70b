// What is refused, and the sentence that says so.
#include <doctest/doctest.h>

#include "core/io/samples.hpp"
#include "io/point_file.hpp"

using namespace snug;
using snug::samples::Bytes;

namespace {

struct Case {
  std::string file;
  std::string bytes;
  std::string message;  // without the file's name
};

void check_refused(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    CAPTURE(c.message);
    const auto read = io::read_points(c.bytes, c.file);
    REQUIRE(!read);
    CHECK(read.error().message() == c.file + c.message);
  }
}

std::string ply(const std::string& header, const std::string& body = {}) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "property list uchar int vertex_indices\n";

std::string little_ply(const std::string& header, const std::string& body) {
  return "ply\nformat binary_little_endian 1.0\n" + header + "end_header\n" + body;
}

const std::string kNoPointFile = ": this is not a point file: xyz, csv, obj, ply, stl or off";
const std::string kTooLarge = " is too large: coordinates reach to 2^508, about 8.3e152";

}  // namespace

TEST_CASE("rows that are refused") {
  check_refused({
      {"empty.xyz", "", ": there are no points"},
      {"blank.xyz", "\n \n", ": there are no points"},
      {"comments.txt", "# a\n#b\n", ": there are no points"},
      {"header_only.csv", "x,y,z\n", ": there are no points"},
      {"word.xyz", "1 2 3\n4 five 6\n", ":2: \"five\" is not a number"},
      {"two_headers.csv", "x,y\na,b\n1,2\n", ":2: \"a\" is not a number"},
      {"one.xyz", "1\n", ":1: there is one number on the line: a point has two or three"},
      {"four.xyz", "1 2 3\n\n1 2 3 4\n", ":3: there are more than 3 numbers on the line, and on line 1 there were 3"},
      {"mixed.xyz", "# c\n1 2 3\n1 2\n", ":3: there are 2 numbers on the line, and on line 2 there were 3"},
      {"mixed.csv", "1,2\n1,2,3\n", ":2: there are 3 numbers on the line, and on line 1 there were 2"},
      {"gap.csv", "1,,3\n", ":1: field 2 is empty"},
      {"tab_gap.csv", "1\t\t3\n", ":1: field 2 is empty"},
      {"decimal_comma.csv", "1,5;2,5\n", ":1: \"1,5\" is not a number: write decimals with a point, not a comma"},
      {"nan.xyz", "1 2 3\nnan 0 0\n", ":2: \"nan\" is not a finite number"},
      {"nan_first.csv", "nan,nan,nan\n1,2,3\n", ":1: \"nan\" is not a finite number"},
      {"infinite.csv", "0,-inf\n", ":1: \"-inf\" is not a finite number"},
      {"infinite.xyz", "0 Infinity 0\n", ":1: \"Infinity\" is not a finite number"},
      {"overflow.xyz", "0 1e999 0\n", ":1: \"1e999\"" + kTooLarge},
      {"beyond_the_door.xyz", "0 -1e153 0\n", ":1: \"-1e153\"" + kTooLarge},
      {"signs.xyz", "+-1 0 0\n", ":1: \"+-1\" is not a number"},
      {"plus.xyz", "+ 0 0\n", ":1: \"+\" is not a number"},
      {"hex.xyz", "0x10 0 0\n", ":1: \"0x10\" is not a number"},
      {"unit.xyz", "1m 0 0\n", ":1: \"1m\" is not a number"},
      {"exponent.xyz", "1e 0 0\n", ":1: \"1e\" is not a number"},
      {"long.xyz", std::string(100, 'x') + " 0 0\n", ":1: \"" + std::string(32, 'x') + "...\" is not a number"},
      {"strange.xyz", "1\x01 0 0\n", ":1: \"1?\" is not a number"},
      {"utf16.csv",
       std::string("\xff\xfe"
                   "1\0,\0"
                   "2\0",
                   8),
       ":byte 0: the text is UTF-16: save it as UTF-8"},
      {"picture.xyz", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16),
       ":byte 8: the data is binary, but neither PLY nor STL"},
      {"pic.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), kNoPointFile},
      {"pic.png", "\x89PNG\r\n\x1a\n", kNoPointFile},
      {"zip", "PK\x03\x04\x14", kNoPointFile},
      {"words.dat", "1 2 3\n\xe9t\xe9 2 3\n", ":2: \"?t?\" is not a number"},
  });
}

TEST_CASE("OBJ that is refused") {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  check_refused({
      {"empty.obj", "", ": there are no points"},
      {"no_vertices.obj", "o nothing\n", ": there are no points"},
      {"word.obj", "v 0 zero 0\n", ":1: \"zero\" is not a number"},
      {"flat.obj", "v 0 0\n", ":1: a vertex has three coordinates, and there are 2 numbers"},
      {"short.obj", "v 0\n", ":1: a vertex has three coordinates, and there are 1 number"},
      {"nan.obj", "v 0 0 nan\n", ":1: \"nan\" is not a finite number"},
      {"overflow.obj", "v 0 0 1e400\n", ":1: \"1e400\"" + kTooLarge},
      {"above.obj", three + "f 1 2 4\n", ":4: the face names vertex 4, and there are 3"},
      {"below.obj", three + "f 1 2 -4\n", ":4: the face names vertex -4, and there are 3"},
      {"zero.obj", three + "f 0 1 2\n", ":4: the face names vertex 0, and counting starts at 1"},
      {"huge.obj", three + "f 1 2 9999999999\n", ":4: the face names vertex 9999999999, and there are 3"},
      {"beyond.obj", three + "f 1 2 99999999999999999999\n", ":4: \"99999999999999999999\" does not name a vertex"},
      {"fraction.obj", three + "f 1.5 2 3\n", ":4: \"1.5\" does not name a vertex"},
      {"joined.obj", three + "f 1 2 \\\n\\\n9\nv 0 0 0\n", ":4: the face names vertex 9, and there are 4"},
      {"not_obj.obj", "hello\n", ":1: \"hello\" is not a statement of OBJ"},
  });
}

TEST_CASE("a PLY header that is refused") {
  const std::string vertex = "element vertex 1\n" + kXyz;
  check_refused({
      {"no_magic.ply", "plyx\n", ":1: the file does not begin with \"ply\""},
      {"cut.ply", "ply\nformat ascii 1.0\nelement ver", ":3: \"\" is not a count of elements"},
      {"endless.ply", "ply\nformat ascii 1.0\n", ":2: the file ends within its header"},
      {"no_format.ply", "ply\n" + vertex + "end_header\n0 0 0\n", ":6: the header names no format"},
      {"two_formats.ply", ply("format ascii 1.0\n"), ":3: the header names a format twice"},
      {"format.ply", "ply\nformat utf8 1.0\n", ":2: \"utf8\" is not a format of PLY"},
      {"version.ply", "ply\nformat ascii 2.0\n", ":2: \"2.0\" is not a known version of PLY"},
      {"keyword.ply", ply("elephant vertex 1\n"), ":3: \"elephant\" is not a line of a PLY header"},
      {"count.ply", ply("element vertex many\n"), ":3: \"many\" is not a count of elements"},
      {"negative.ply", ply("element vertex -1\n"), ":3: \"-1\" is not a count of elements"},
      {"no_element.ply", ply(kXyz), ":3: the property belongs to no element"},
      {"type.ply", ply("element vertex 1\nproperty real x\nproperty int y\n", "0 0\n"),
       ":4: \"real\" is not a type of PLY"},
      {"face_type.ply", ply(vertex + "element face 1\nproperty list real int vertex_indices\n", "0 0 0\n0\n"),
       ":8: \"real\" is not a type of PLY"},
      {"no_name.ply", ply("element vertex 1\nproperty float\n"), ":4: the property has no name"},
      {"twice.ply", ply(vertex + vertex), ":7: the header has the element \"vertex\" twice"},
      {"x_twice.ply", ply(vertex + "property float x\n"), ":7: the element has the property \"x\" twice"},
      {"no_vertex.ply", ply("element point 1\n" + kXyz, "0 0 0\n"), ":7: the header has no element \"vertex\""},
      {"no_y.ply", ply("element vertex 1\nproperty float x\n", "0\n"), ":3: the vertices have no x and y"},
      {"list_x.ply", ply("element vertex 1\nproperty list uchar float x\n", "1 0\n"),
       ":3: a coordinate of the vertices is a list"},
      {"none.ply", ply("element vertex 0\n" + kXyz), ":3: there are no points"},
      {"nothing_in_it.ply", ply(vertex + "element void 1000000000000\n", "0 0 0\n"),
       ":7: the element \"void\" has no properties"},
      {"too_many.ply", ply("element vertex 3000000000\n" + kXyz, "0 0 0\n"),
       ":3: there are more than 2147483647 points"},
  });
}

TEST_CASE("PLY text that is refused") {
  const std::string two = "element vertex 2\n" + kXyz;
  const std::string mesh = "element vertex 3\n" + kXyz + "element face 1\n" + kFaces;
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
  check_refused({
      {"lies.ply", ply("element vertex 1000000\n" + kXyz, "0 0 0\n"),
       ":3: the header claims 1000000 of \"vertex\", and the file is too short for that"},
      {"cut_short.ply", ply(two, "0.25 0.25 0.25\n"), ":8: the file ends after 1 of 2 lines of \"vertex\""},
      {"fewer.ply", ply(two, "0 0 0\n1.5 1.5\n"), ":9: the line has fewer values than the header says"},
      {"more.ply", ply(two, "0 0 0\n1 1 1 1\n"), ":9: the line has more values than the header says"},
      {"word.ply", ply(two, "0 0 0\n1 one 1\n"), ":9: \"one\" is not a number"},
      {"nan.ply", ply(two, "0 0 0\n1 1 nan\n"), ":9: \"nan\" is not a finite number"},
      {"overflow.ply", ply(two, "0 0 0\n1 1 1e309\n"), ":9: \"1e309\"" + kTooLarge},
      {"above.ply", ply(mesh, corners + "3 0 1 3\n"), ":13: the face names vertex 3, counted from 0, and there are 3"},
      {"below.ply", ply(mesh, corners + "3 0 1 -1\n"),
       ":13: the face names vertex -1, counted from 0, and there are 3"},
      {"fraction.ply", ply(mesh, corners + "3 0 1 1.5\n"), ":13: \"1.5\" is not an integer"},
      {"negative_list.ply", ply(mesh, corners + "-1 0 1\n"), ":13: a list has -1 items"},
      {"long_list.ply", ply(mesh, corners + "1000000000000 0 1 2\n"),
       ":13: the line has fewer values than the header says"},
      {"float_faces.ply",
       ply("element vertex 3\n" + kXyz + "element face 1\nproperty list uchar float vertex_indices\n",
           corners + "3 0 1 2\n"),
       ":13: the faces name vertices by numbers that are not integers"},
  });
}

TEST_CASE("PLY bytes that are refused") {
  const std::string two = "element vertex 2\n" + kXyz;
  const std::string mesh = "element vertex 1\n" + kXyz + "element face 1\n" + kFaces;
  const std::string xyz = Bytes().f32(0).f32(1).f32(2).take();
  const std::string nan = Bytes().f32(0).f32(std::numeric_limits<float>::quiet_NaN()).f32(2).take();
  const auto two_start = std::to_string(little_ply(two, "").size());
  const std::size_t mesh_start = little_ply(mesh, "").size();
  const auto face = [&](int count, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return little_ply(mesh, xyz + Bytes().u8(count).u32(a).u32(b).u32(c).take());
  };
  const auto in_face = [&](std::size_t byte) { return ":byte " + std::to_string(mesh_start + 12 + byte); };
  check_refused({
      {"lies.ply", little_ply("element vertex 2147483647\n" + kXyz, xyz),
       ":3: the header claims 2147483647 of \"vertex\", and the file is too short for that"},
      {"cut_short.ply", little_ply(two, xyz + xyz.substr(1)),
       ":3: the header claims 2 of \"vertex\", and the file is too short for that"},
      {"nan.ply", little_ply(two, xyz + nan),
       ":byte " + std::to_string(std::stoi(two_start) + 16) + ": the coordinate is not a finite number"},
      {"above.ply", face(3, 0, 0, 1), in_face(9) + ": the face names vertex 1, counted from 0, and there is 1"},
      {"below.ply", face(3, 0, ~0u, 0), in_face(5) + ": the face names vertex -1, counted from 0, and there is 1"},
      {"long_list.ply", face(4, 0, 0, 0), in_face(13) + ": the file is cut short: the header says that there is more"},
      {"long_skip.ply",
       little_ply("element skip 1\nproperty list uint double x\n" + two, Bytes().u32(~0u).take() + xyz + xyz),
       ":byte " + std::to_string(little_ply("element skip 1\nproperty list uint double x\n" + two, "").size() + 28) +
           ": the file is cut short: the header says that there is more"},
  });
}

TEST_CASE("STL that is refused") {
  const std::string binary = samples::stl_binary("solid tetra");
  std::string infinite = binary;
  infinite.replace(84 + 50 + 12 + 4, 4, Bytes().f32(std::numeric_limits<float>::infinity()).take());
  std::string nothing = binary.substr(0, 80) + Bytes().u32(0).take();
  std::string lies = binary;
  lies.replace(80, 4, Bytes().u32(0xffffffffu).take());
  const std::string loop = "solid\nfacet normal 0 0 1\nouter loop\n";
  check_refused({
      {"none.stl", "solid\nendsolid\n", ": there are no points"},
      {"none_binary.stl", nothing, ": there are no points"},
      {"cut_short.stl", binary.substr(0, 283),
       ":byte 80: the header claims 4 triangles, which is 284 bytes, and the file has 283"},
      {"lies.stl", lies,
       ":byte 80: the header claims 4294967295 triangles, which is 214748364834 bytes, and the file has 284"},
      {"no_count.stl", std::string("solid\0tetra", 11),
       ":byte 11: the file is cut short: a binary STL has at least 84 bytes"},
      {"infinite.stl", infinite, ":byte 150: the coordinate is not a finite number"},
      {"not_stl.stl", "hello\n", ":1: a solid does not begin with \"solid\""},
      {"after.stl", "solid a\nendsolid a\nvertex 0 0 0\n", ":3: a solid does not begin with \"solid\""},
      {"loose.stl", "solid a\nvertex 0 0 0\n", ":2: there is \"vertex\" where \"facet\" or \"endsolid\" should be"},
      {"short.stl", loop + "vertex 0 0\n", ":4: a vertex has three coordinates, and there are 2"},
      {"long.stl", loop + "vertex 0 0 0 0\n", ":4: there is \"0\" where \"vertex\" should be"},
      {"nan.stl", loop + "vertex 0 0 nan\n", ":4: \"nan\" is not a finite number"},
      {"two_corners.stl", loop + "vertex 0 0 0\nvertex 1 0 0\nendloop\n",
       ":6: there is \"endloop\" where \"vertex\" should be"},
      {"four_corners.stl", loop + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\n",
       ":7: the file ends within a facet"},
      {"open_facet.stl", loop + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n",
       ":7: the file ends within a facet"},
  });
}
