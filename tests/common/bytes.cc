#include "common/bytes.h"

#include <gtest/gtest.h>

#include <limits>

namespace vibroimpact::bytes_tests {

enum class Kind : std::int8_t { one = 1, other = -3 };

struct Part {
  Kind kind = Kind::one;
  std::string text;
  std::optional<double> number;
  friend bool operator==(const Part &, const Part &) = default;
};
void members(auto &visit, As<Part> auto &part) { visit(part.kind, part.text, part.number); }

struct Whole {
  std::vector<Part> parts;
  Matrix matrix;
  Vector3 vector = Vector3::Zero();
  std::vector<std::complex<double>> values;
  std::vector<std::array<int, 2>> pairs;
  std::pair<bool, Index> both{};
  friend bool operator==(const Whole &, const Whole &) = default;
};
void members(auto &visit, As<Whole> auto &whole) {
  visit(whole.parts, whole.matrix, whole.vector, whole.values, whole.pairs, whole.both);
}

Whole example() {
  return {.parts = {{Kind::other, std::string("\0a\0", 3), -0.0}, {Kind::one, "", std::nullopt}},
          .matrix = (Matrix(2, 3) << 1, 2, 3, 4, 5, 6).finished(),
          .vector = {1e-300, std::numeric_limits<double>::infinity(), 3},
          .values = {{1, 2}, {3, -4}},
          .pairs = {{-1, 7}},
          .both = {true, -5}};
}

TEST(BytesTest, ComeBackAsTheValues) {
  Whole copy;
  unpack(packed(example()), copy);
  EXPECT_EQ(copy, example());
  copy.parts.assign(7, {});
  unpack(packed(Whole{}), copy);
  EXPECT_EQ(copy, Whole{});
}

// Kind, text of three letters, number; none of the lengths is that of the machine's types.
TEST(BytesTest, LieOneBehindTheOther) {
  EXPECT_EQ(packed(example().parts[0]), std::string("\xFD"
                                                    "\3\0\0\0\0\0\0\0"
                                                    "\0a\0"
                                                    "\1"
                                                    "\0\0\0\0\0\0\0\x80",
                                                    21));
}

TEST(BytesTest, NoShorterOrLongerBytesAreTaken) {
  const std::string bytes = packed(example());
  Whole copy;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(unpack(std::string_view(bytes).substr(0, size), copy), BytesError) << size;
  EXPECT_THROW(unpack(bytes + '\0', copy), BytesError);
}

// Without taking the memory that they tell of, or failing otherwise.
TEST(BytesTest, AnyDamagedByteGivesOtherValuesOrIsRefused) {
  const std::string bytes = packed(example());
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (const char other : {'\x80', '\xFF', '\1'}) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ other);
      Whole copy;
      try {
        unpack(damaged, copy);
        EXPECT_EQ(packed(copy), damaged) << i;
      } catch (const BytesError &) {
      }
    }
}

template <class Value> void expect_refused(const std::string &bytes) {
  Value value;
  EXPECT_THROW(unpack(bytes, value), BytesError);
}

TEST(BytesTest, ImpossibleLengthsAreRefused) {
  for (const std::uint64_t length : {std::uint64_t{1}, std::uint64_t{1} << 61, ~std::uint64_t{0}}) {
    expect_refused<std::string>(packed(length));
    expect_refused<std::vector<double>>(packed(length));
    expect_refused<std::vector<std::string>>(packed(length));
    expect_refused<Matrix>(packed(length, length));
  }
  expect_refused<Matrix>(packed(Index{1} << 32, Index{1} << 32, 1.0));
  expect_refused<Matrix>(packed(Index{-1}, Index{-1}, 1.0));
  expect_refused<Vector>(packed(Index{1}, Index{2}, 1.0, 1.0));
  expect_refused<Vector3>(packed(Index{2}, Index{1}, 1.0, 1.0));
  expect_refused<bool>("\2");
}

} // namespace vibroimpact::bytes_tests
