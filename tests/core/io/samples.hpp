// One tetrahedron in every format, and the means to make a file's bytes by hand.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/point_file.hpp"
#include "number/bits.hpp"

namespace snug::samples {

/// Bytes one after another, numbers in either order.
class Bytes {
 public:
  explicit Bytes(std::string start = {}, bool big_endian = false) : bytes_(std::move(start)), big_endian_(big_endian) {}

  template <class Integer>
  Bytes& integer(Integer value) {
    auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(Integer); ++i)
      bytes_ += static_cast<char>(bits >> 8 * (big_endian_ ? sizeof(Integer) - 1 - i : i));
    return *this;
  }
  Bytes& u8(int value) { return integer(static_cast<std::uint8_t>(value)); }
  Bytes& u16(int value) { return integer(static_cast<std::uint16_t>(value)); }
  Bytes& u32(std::uint32_t value) { return integer(value); }
  // As in number/bits.hpp, for a float, which only tests take apart.
  Bytes& f32(float value) { return integer(__builtin_bit_cast(std::uint32_t, value)); }
  Bytes& f64(double value) { return integer(bits_of(value)); }
  [[nodiscard]] std::string take() const { return bytes_; }

 private:
  std::string bytes_;
  bool big_endian_;
};

struct Sample {
  std::string name;
  std::string bytes;
  bool binary = false;
  bool faces = false;
};

/// The corners, all of them floats, in the order that the triangles first name them.
inline const std::vector<Vector<double, 3>> kTetra{{0.5, -0.25, 1}, {1.5, 0, 0.125}, {-1, 2, 0.75}, {0, 0.5, -3}};
inline const std::vector<std::array<Index, 3>> kTriangles{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};

inline std::string rows(const std::string& separator, const std::string& end = "\n") {
  std::string text;
  for (const std::string row : {"0.5,-.25,1", "1.5,0,0.125", "-1,2,0.75", "0,+5e-1,-3."}) {
    for (const char c : row) text += c == ',' ? separator : std::string(1, c);
    text += end;
  }
  return text;
}

inline std::string obj() {
  return "# a tetrahedron\nmtllib none.mtl\no tetra\nv 0.5 -0.25 1\nv 1.5 0 0.125 1.0\nv -1 2 0.75 0.1 0.2 0.3\n"
         "vt 0 0\nvn 0 0 1\nv 0 0.5 -3\ng faces\nusemtl none\ns off\nf 1 2 3\nf 1/1 4/1 2/1\nf 1//1 3//1 4//1\n"
         "f -3/1/1 -1/1/1 \\\n-2/1/1\n";
}

/// With properties that are of no use in between, and an element to be skipped before the faces.
inline std::string ply_text() {
  return "ply\nformat ascii 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty float quality\nproperty double y\n"
         "property float x\nproperty float z\nelement edge 2\nproperty list uchar int ends\nproperty uchar kind\n"
         "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
         "nan -0.25 0.5 1\n0 0 1.5 0.125\n7 2 -1 0.75\n1 0.5 0 -3\n2 0 1 9\n0 9\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";
}

inline std::string ply_binary(bool big_endian) {
  Bytes bytes(std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                  "_endian 1.0\nobj_info by hand\nelement edge 2\nproperty list ushort double ends\n"
                  "element vertex 4\nproperty float32 z\nproperty uint8 red\nproperty float64 x\nproperty float y\n"
                  "property list uint8 int8 extra\nelement face 4\nproperty int flags\n"
                  "property list uint8 uint16 vertex_index\nend_header\n",
              big_endian);
  bytes.u16(2).f64(0).f64(1).u16(0);
  for (const auto& p : kTetra)
    bytes.f32(static_cast<float>(p[2])).u8(200).f64(p[0]).f32(static_cast<float>(p[1])).u8(1).u8(7);
  for (const auto& t : kTriangles) bytes.u32(~0u).u8(3).u16(t[0]).u16(t[1]).u16(t[2]);
  return bytes.take();
}

inline std::string stl_text() {
  std::string text = "solid tetra\n";
  for (const auto& t : kTriangles) {
    text += "  facet normal nan 0 0\n    outer loop\n";
    for (const Index i : t) {
      const auto& p = kTetra[i];
      text += "      vertex " + std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) + '\n';
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid tetra\n";
}

inline std::string off() {
  std::string text = "OFF\n4 4 6\n" + rows(" ");
  for (const auto& t : kTriangles)
    text += "3 " + std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' + std::to_string(t[2]) + '\n';
  return text;
}

/// header: up to 80 bytes, filled with blanks.
inline std::string stl_binary(std::string header) {
  header.resize(80, ' ');
  Bytes bytes(header);
  bytes.u32(4);
  for (const auto& t : kTriangles) {
    bytes.f32(0).f32(0).f32(0);
    for (const Index i : t)
      for (const double x : kTetra[i]) bytes.f32(static_cast<float>(x));
    bytes.u16(0);
  }
  return bytes.take();
}

inline std::vector<Sample> all() {
  return {{"t.xyz", rows(" ")},
          {"t.txt", rows(" \t ")},
          {"t.csv", "x,y,z\n" + rows(",")},
          {"semicolons.csv", rows("; ")},
          {"tabs.csv", "x\ty\tz\n" + rows("\t")},
          {"t.obj", obj(), false, true},
          {"t.off", off(), false, true},
          {"t.ply", ply_text(), false, true},
          {"little.ply", ply_binary(false), true, true},
          {"big.ply", ply_binary(true), true, true},
          {"text.stl", stl_text(), false, true},
          {"binary.stl", stl_binary("made by hand"), true, true},
          {"solid.stl", stl_binary("solid tetra\nfacet"), true, true}};
}

}  // namespace snug::samples
