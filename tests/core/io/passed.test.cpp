// What the readers pass over: each odd file gives the right points, and what was passed over is counted.
#include <doctest/doctest.h>

#include <algorithm>

#include "core/io/samples.hpp"
#include "io/point_file.hpp"

using namespace snug;

namespace {

struct Odd {
  std::string file, bytes;
  std::size_t points;
  std::string passed = {};  // without "passed over: "
  std::size_t triangles = 0;
};

void check(const std::vector<Odd>& files, const io::Wanted& wanted = {}) {
  for (const Odd& odd : files) {
    CAPTURE(odd.file);
    const auto file = io::read_points(odd.bytes, odd.file, wanted);
    INFO((file ? "" : file.error().message()));
    REQUIRE(file);
    CHECK(file->points.size() == odd.points);
    CHECK(file->triangles.size() == odd.triangles);
    CHECK(io::passed_text(file->passed) == (odd.passed.empty() ? "" : "passed over: " + odd.passed));
  }
}

void check_refusals(const std::vector<std::array<std::string, 3>>& cases) {
  for (const auto& [name, bytes, message] : cases) {
    const auto file = io::read_points(bytes, name);
    REQUIRE(!file);
    CHECK(file.error().message() == name + message);
  }
}

std::string zeros(std::size_t n) { return std::string(n, '\0'); }
const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
std::string facet_of(const std::string& corner) {
  return "facet normal 0 0 1\nouter loop\nvertex " + corner + "\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
}
const std::string kPly = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n";

}  // namespace

TEST_CASE("tables with more columns, headers and other punctuation") {
  check({
      {"rgb.xyz", "1 2 3 255 0 0\n4 5 6 red x\n", 2, "2 lines with more columns than three"},
      {"rgb.csv", "x,y,z,r\n1,2,3,nan\n", 1, "1 line with more columns than three"},
      {"trailing.csv", "x,y,z,\n1,2,3,\n4,5,6,\n", 2},
      {"cloud.txt", "//X Y Z\n1 2 3\n", 1},
      {"header.txt", "x y z\n1 2 3\n", 1, "1 header line"},
      {"sep.csv", "sep=;\nx;y\n1;2\n", 1},
      {"uv.csv", "u,v\n1,2\n", 1},
      {"padded.xyz", "1 2 3\n" + zeros(9), 1, "9 bytes after the data"},
      {"dos.xyz", "1 2 3\n\x1a", 1, "1 byte after the data"},
      {"empty_field.csv", "X,Y,Z,Intensity\n0,0,0,1\n9,9,9,\n", 2, "1 line with more columns than three"},
      {"empty_field.csv", "0,0,0,\n9,9,9,1\n8,8,8,\n", 3, "1 line with more columns than three"},
      {"cr.xyz", "1 2 3\r4 5 6\r", 2},
      {"tabs.xyz", "1,\t2,\t3\n", 1},
      {"lfcr.xyz", "1 2 3\n\r4 5 6\n\r", 2},
  });
  check_refusals({
      {"order.csv", "id,x,y,z\n7,1,2,3\n", ":1: column 1 is \"id\": the first columns must be x, y and z"},
      {"radius.csv", "x,y,r\n1,2,3\n", ":1: column 3 is \"r\": the first columns must be x, y and z"},
      {"intensity.xyz", "x y intensity\n1 2 3\n",
       ":1: column 3 is \"intensity\": the first columns must be x, y and z"},
      {"fewer.csv", "0,0,0,1\n9,9,9\n", ":2: there are 3 numbers on the line, and on line 1 there were more than 3"},
      {"swapped.csv", "y,x\n1,2\n", ":1: column 1 is \"y\": the first columns must be x, y and z"},
      {"radius.csv", "x,r\n1,2\n", ":1: column 2 is \"r\": the first columns must be x, y and z"},
      {"comma.csv", "1,5;2,5\n", ":1: \"1,5\" is not a number: write decimals with a point, not a comma"},
      {"comma.xyz", "1,5 2,5 3,5\n", ":1: \"5 2\" is not a number: write decimals with a point, not a comma"},
      {"zero.xyz", "1 2 3\n4 " + zeros(1) + "5 6\n", ":2: there is a zero byte in the text"},
      {"utf16.stl", std::string("s\0o\0l\0i\0d\0", 10), ":byte 0: the text is UTF-16: save it as UTF-8"},
      {"lfcr.xyz", "1 2 3\n\rx 5 6\n\r", ":2: \"x\" is not a number"},
  });
}

TEST_CASE("OBJ: what points do not need") {
  check({
      {"colour.obj", "v 0 0 0 nan nan nan\nv 1 1 1 1 1 1 1 1 1\nv 2 2 2\n", 3, "2 lines with more columns than three"},
      {"padded.obj", "v 0 0 0\n" + zeros(9), 1, "9 bytes after the data"},
      {"slashes.obj", kThree + "f 1// 2// 3//\nf 1/ 2/ 3/\n", 3, "", 2},
      {"faces.obj", kThree + "f\nf 1\nf 1 2\n", 3, "3 faces of fewer than three vertices"},
      {"words.obj", kThree + "vw 1\nt 0 0\nKa 1 1 1\n", 3, "3 statements unknown to OBJ"},
      {"lone.obj", "v 0 0 0\rv 1 0 0\r", 2},
  });
  check_refusals({
      {"joined.obj", "v 0 0 0\nvt 0 0 \\\nv 9 9 9\n",
       ":2: the line ends in a backslash, and the next line is a statement of its own"},
      {"joined.obj", "v 0 0 0 \\\nv 9 9 9\n",
       ":1: the line ends in a backslash, and the next line is a statement of its own"},
      {"start.obj", zeros(2) + kThree, ":1: there is a zero byte in the text"},
      {"first.obj", "v 0 " + zeros(2) + " 0\n" + kThree, ":1: there is a zero byte in the text"},
      {"zero.obj", kThree + "v 1 " + zeros(3) + "\nv 0 0 1\n", ":4: there is a zero byte in the text"},
  });
}

TEST_CASE("PLY: what points do not need") {
  const std::string bytes =
      "ply\rformat binary_little_endian 1.0\relement vertex 1\rproperty uchar x\rproperty uchar y\r"
      "end_header\r";
  check({
      {"blank.ply", "ply \n" + kPly.substr(4) + "end_header\n1 2\n3 4\n", 2},
      {"int64.ply", kPly + "property int64 id\nend_header\n1 2 x\n3 4 5\n", 2},
      {"wrapped.ply", kPly + "end_header\n1\n2\n3\n4\n", 2},
      {"more.ply", kPly + "end_header\n1 2\n3 4\n5 6\n7 8\n", 2, "2 lines after the data"},
      {"list.ply",
       kPly + "element face 2\nproperty list uchar int vertex_indices\nend_header\n1 2\n3 4\n3.0 0 1 0\n2 0 1\n", 2,
       "1 face of fewer than three vertices", 1},
      {"capitals.ply", "PLY\n" + kPly.substr(4) + "end_header\n1 2\n3 4\n", 2},
      {"padded.ply", kPly + "end_header\n1 2\n3 4" + zeros(9), 2, "9 bytes after the data"},
      {"unused.ply",
       kPly + "element a 1\nproperty quux b\nproperty list float quux c\nproperty list quux int d\n"
              "end_header\n1 2\n3 4\nx 2.0 x x 1 5\n",
       2},
      {"last.ply", bytes.substr(0, bytes.size() - 11) + "element a 1\rproperty quux b\rend_header\r\n\rabc", 1,
       "3 bytes after the data"},
      {"cr.ply", bytes + "\n\r", 1},
      {"more_bytes.ply", bytes + "\n\rabc", 1, "3 bytes after the data"},
  });
  CHECK(io::read_points(bytes + "\n\r", "cr.ply")->points[0] == Vector<double, 3>(10, 13, 0));
  check_refusals({{"first.ply",
                   "ply\nformat binary_little_endian 1.0\nelement a 1\nproperty quux b\nelement vertex 1\n"
                   "property uchar x\nproperty uchar y\nend_header\nabc",
                   ":4: \"quux\" is not a type of PLY"},
                  {"short.ply", kPly + "end_header\n1\n2 3\n4\n",
                   ":7: the line has fewer values than the header says, and the next line has more"}});
}

TEST_CASE("STL: what points do not need") {
  const std::string binary = samples::stl_binary("x");
  std::string line = "solid a " + kFacet + "endsolid a";
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::string normal = kFacet;
  normal.replace(normal.find("0 0 1"), 5, "-1.#IND nan x");
  std::string quad = kFacet;
  quad.insert(quad.find("endloop"), "vertex 1 1 0\n");
  check({
      {"lf.stl", binary + "\n", 4, "1 byte after the data", 4},
      {"zeros.stl", binary + zeros(512), 4, "512 bytes after the data", 4},
      {"padded.stl", "solid a\n" + kFacet + "endsolid\n" + zeros(100), 3, "100 bytes after the data", 1},
      {"wrapped.stl", "solid a\n" + facet_of("1\n0\n\n0") + "endsolid\n", 2, "", 1},
      {"after.stl", "solid a\n" + kFacet + "endsolid a\nmade by hand\n\non paper\n", 3, "2 lines after the data", 1},
      {"between.stl", "solid a\n" + kFacet + "endsolid a\nnext\nsolid b\n" + kFacet + "endsolid", 3,
       "1 line after the data", 2},
      {"two_words.stl", "solid a\n" + kFacet + "end solid a\n", 3, "", 1},
      {"one_word.stl", "SOLID a\n" + kFacet + "endsolidName\n", 3, "", 1},
      {"open.stl", "solid a\n" + kFacet, 3, "1 missing endsolid", 1},
      {"line.stl", line, 3, "", 1},
      {"two_lines.stl", line + " " + line, 3, "", 2},
      {"normal.stl", "solid a\n" + normal + "endsolid a\n", 3, "", 1},
      {"quad.stl", "solid a\n" + quad + "endsolid a\n", 4, "", 2},
      {"facet.stl", "solid my facet normal\n" + kFacet + "endsolid my facet normal\n", 3, "", 1},
  });
  check_refusals(
      {{"start.stl", zeros(1) + "solid a\n" + kFacet + "endsolid a\n", ":byte 0: there is a zero byte in the text"}});
  check_refusals({{"zeros.stl", "solid a\n" + kFacet + zeros(80) + kFacet + "endsolid\n",
                   ":9: there is a zero byte in the text"}});
}

TEST_CASE("where no faces are wanted, damaged ones are counted; where they are, they are errors") {
  const std::string faces = "3 0 1 9\n3 0 a c\n3 0 1 1\n", list = "element face 3\nproperty list uchar ";
  const std::vector<Odd> files{
      {"t.obj", kThree + "f 1 2 9\nf a b c\nf 0 1 2\nf 1 2 3\nf 1 2 4 5\nv 0 0 1\n", 4, "4 damaged faces"},
      {"t.ply", kPly + list + "int vertex_indices\nend_header\n0 0\n1 1\n" + faces, 2, "2 damaged faces"},
      {"float.ply", kPly + list + "float vertex_indices\nend_header\n0 0\n1 1\n" + faces, 2, "3 damaged faces"},
      {"bytes.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nelement face 1\n"
       "property list uchar uchar vertex_index\nend_header\nab\3" +
           zeros(2) + "\1",
       1, "1 damaged face"},
      {"t.off", "OFF\n2 3 0\n0 0 0\n1 0 0\n" + faces, 2, "2 damaged faces"},
  };
  check(files, {.faces = false});
  for (const Odd& odd : files) CHECK(!io::read_points(odd.bytes, odd.file));
}

TEST_CASE("# begins a comment at the start of a line or after a blank only") {
  const std::string nan = "1 point with a coordinate that is not finite";
  for (const std::string word :
       {"-1.#IND", "1.#QNAN", "1.#SNAN", "1.#INF", "-1.#INF00", "1.#IND00", "inf", "-nan(ind)"}) {
    CAPTURE(word);
    const std::vector<Odd> files{
        {"t.xyz", "0 0 0 # a\n9 9 " + word + "\n# b\n1 1 1\t#c\n", 2, nan},
        {"t.csv", "0,0,0\n9,9," + word + "\n1,1,1\n", 2, nan},
        {"t.obj", "v 0 0 0 # a\nv 9 9 " + word + "\n#b\nv 1 1 1\n", 2, nan},
        {"t.off", "OFF # a\n3 0 0\n9 9 " + word + "\n# b\n0 0 0\n1 1 1 # c\n", 2, nan},
        {"t.ply", kPly + "end_header\n9 " + word + "\n3 4\n", 1, nan},
        {"t.stl", "solid\n" + kFacet + facet_of("9 9 " + word) + "endsolid\n", 3, nan, 1},
    };
    check(files, {.skip_nan = true});
    for (const Odd& odd : files) {
      const auto file = io::read_points(odd.bytes, odd.file);
      REQUIRE(!file);
      CHECK(file.error().what == "\"" + word + "\" is not a finite number");
      CHECK(file.error().unit == InputError::Unit::kLine);
    }
  }
  check_refusals({{"t.xyz", "0 0 1#a\n", ":1: \"1#a\" is not a number"}});
}

TEST_CASE("decimal commas are named in every text") {
  const std::string hint = "\"1,5\" is not a number: write decimals with a point, not a comma";
  check_refusals({
      {"t.obj", "v 1,5 2,5 3,5\n", ":1: " + hint},
      {"t.ply", kPly + "end_header\n1,5 2,5\n3 4\n", ":7: " + hint},
      {"t.stl", "solid\n" + facet_of("1,5 2,5 3,5"), ":4: " + hint},
      {"t.off", "OFF\n1 0 0\n1,5 2,5 3,5\n", ":3: " + hint},
      {"t.csv", "1,5;2,5\n", ":1: " + hint},
      {"t.csv", "1,5\t2,5\n", ":1: " + hint},
      {"t.xyz", "0\t0\t0\n1,5\t2,5\t3,5\n", ":2: " + hint},
      {"t.csv", "2\t1,5\n", ":1: " + hint},
      {"note.csv", "1\t2\ta,b\n", ":1: \"a,b\" is not a number"},
      {"list.obj", "v 1,5,2\n", ":1: \"1,5,2\" is not a number"},
  });
}

TEST_CASE("OFF is read; its variants, PCD and JSON are named") {
  check({
      {"t.off", "OFF # a\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n", 3, "", 1},
      {"t.off", "off\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", 3},
      {"t.txt", "off\n1 0 0\n0 0 0\n", 1},
      {"bare.off", "# a\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", 3},
      {"t.off", "OFF 4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n2 0 1\n5\n", 4,
       "1 face of fewer than three vertices, 1 line after the data", 2},
  });
  check_refusals({
      {"t.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n", ":4: the file ends before all that it claims"},
      {"t.off", "OFF\n999999999 0 0\n0 0 0\n", ":2: the file claims 999999999 vertices, and is too short for that"},
      {"t.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", ":4: the face names vertex 1, counted from 0, and there are 1"},
      {"rows.off", "0 0 0.5\n1 1 1\n", ": there are no points"},
      {"words.off", "hello\n", ":1: \"hello\" is not a count"},
      {"t.off", "coff\n1 0 0\n0 0 0 1 1 1 1\n",
       ": only plain OFF is read, without colours or normals: save the points as OFF, PLY or OBJ"},
      {"t.off", "COFF\n1 0 0\n0 0 0 1 1 1 1\n",
       ": only plain OFF is read, without colours or normals: save the points as OFF, PLY or OBJ"},
      {"t.pcd", "VERSION .7\n", ": PCD is not read: save the points as PLY or xyz"},
      {"t.txt", "# .PCD v.7\nVERSION .7\n", ": PCD is not read: save the points as PLY or xyz"},
      {"t.json", "{\n", ": JSON is not read: give a point file: xyz, csv, obj, ply, stl or off"},
      {"be-ritter-5.json", "{\n \"snug_result\": 1,\n \"version\": \"1\",\n", ": this is a result file: hand it in"},
  });
}

TEST_CASE("points and points passed over add up to the file, in every format") {
  const std::string nan = "1 point with a coordinate that is not finite";
  std::string binary = samples::stl_binary("x");
  binary.replace(84 + 12, 4, samples::Bytes().f32(std::numeric_limits<float>::quiet_NaN()).take());
  check(
      {
          {"t.xyz", "0 0 0\nnan 0 0\n1 1 1\n", 2, nan},
          {"t.csv", "0,0\n1,NaN\n", 1, nan},
          {"t.obj", kThree + "v nan 0 0\nv 1 1 1\nf 1 2 5\nf 1 2 4\n", 4, nan, 1},
          {"t.ply", kPly + "end_header\n1 nan\n3 4\n", 1, nan},
          {"t.stl",
           "solid\n" + kFacet +
               "facet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
               "endloop\nendfacet\nendsolid\n",
           3, nan, 1},
          {"binary.stl", binary, 4, nan, 3},
          {"t.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", 2, nan},
      },
      {.skip_nan = true});
  check_refusals({{"t.off", "OFF\n2 0 0\n0 0 0\n1 0 nan\n", ":4: \"nan\" is not a finite number"},
                  {"t.xyz", "0 0 0\nnan 0 0\n", ":2: \"nan\" is not a finite number"}});
}
