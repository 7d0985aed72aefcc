// Values as bytes and back: numbers, texts, lists, values that may be missing, dense matrices, and
// types that say once what they consist of,
//
//   void members(auto &visit, As<Graze> auto &graze) { visit(graze.guard, graze.position); }
//
// Numbers have the byte order of the machine; lengths are numbers of 8 bytes before what they
// count. Reading takes no more memory than the bytes there are ask for, whatever lengths they tell.
#pragma once

#include "common/linear_algebra.h"

#include <array>
#include <complex>
#include <concepts>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace vibroimpact {

/// A value of this type, constant or not.
template <class Given, class Type>
concept As = std::same_as<std::remove_const_t<Given>, Type>;

template <class T> inline constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <> inline constexpr bool is_plain<bool> = false; // not every byte is one
template <class T> inline constexpr bool is_plain<std::complex<T>> = true;
template <class T, std::size_t n> inline constexpr bool is_plain<std::array<T, n>> = is_plain<T>;

/// What is stored as it lies in memory.
template <class T>
concept Plain = is_plain<T>;

/// Appends values to bytes.
class Bytes {
public:
  /// Keeps a reference.
  explicit Bytes(std::string &bytes) : bytes_(bytes) {}

  template <class... Values> void operator()(const Values &...values) { (put(values), ...); }
  /// Without their count before them.
  template <Plain T> void numbers(const T *values, std::size_t count) {
    bytes_.append(reinterpret_cast<const char *>(values), count * sizeof(T));
  }

private:
  template <Plain T> void put(const T &value) { numbers(&value, 1); }
  void put(bool value) { put(static_cast<char>(value)); }
  void put(const std::string &text) {
    put(text.size());
    bytes_ += text;
  }
  template <class T> void put(const std::vector<T> &values) {
    put(values.size());
    if constexpr (Plain<T>)
      numbers(values.data(), values.size());
    else
      for (const T &value : values)
        put(value);
  }
  template <class T> void put(const std::optional<T> &value) {
    put(value.has_value());
    if (value)
      put(*value);
  }
  template <class T, class U> void put(const std::pair<T, U> &both) {
    (*this)(both.first, both.second);
  }
  template <Plain T, int rows, int columns, int options>
  void put(const Eigen::Matrix<T, rows, columns, options> &matrix) {
    (*this)(matrix.rows(), matrix.cols());
    numbers(matrix.data(), static_cast<std::size_t>(matrix.size()));
  }
  template <class T> void put(const T &value) { members(*this, value); }

  std::string &bytes_;
};

template <class... Values> std::string packed(const Values &...values) {
  std::string bytes;
  Bytes{bytes}(values...);
  return bytes;
}

/// Bytes that break off, or cannot be those of the values asked for.
class BytesError : public std::runtime_error {
public:
  explicit BytesError(const std::string &what = "bytes are missing or do not match their header")
      : runtime_error(what) {}
};

/// Takes values off the front of bytes. BytesError.
class Cursor {
public:
  explicit Cursor(std::string_view bytes) : left_(bytes) {}

  template <class... Values> void operator()(Values &...values) { (get(values), ...); }
  template <class Value> Value take() {
    Value value{};
    get(value);
    return value;
  }
  std::string_view take(std::size_t size) {
    check<char>(size);
    const std::string_view taken = left_.substr(0, size);
    left_.remove_prefix(size);
    return taken;
  }
  /// So many, without their count before them.
  template <Plain T> void numbers(std::vector<T> &values, std::size_t count) {
    check<T>(count);
    values.resize(count);
    copy(values.data(), count);
  }
  std::string_view rest() const { return left_; }

private:
  template <class T> void check(std::size_t count) const {
    if (count > left_.size() / sizeof(T))
      throw BytesError();
  }
  template <Plain T> void copy(T *values, std::size_t count) {
    const std::string_view taken = take(count * sizeof(T));
    if (count > 0)
      std::memcpy(values, taken.data(), taken.size());
  }

  template <Plain T> void get(T &value) { copy(&value, 1); }
  void get(bool &value) {
    const char byte = take<char>();
    if (byte != 0 && byte != 1)
      throw BytesError();
    value = byte == 1;
  }
  void get(std::string &text) { text = take(take<std::size_t>()); }
  template <class T> void get(std::vector<T> &values) {
    const auto count = take<std::size_t>();
    if constexpr (Plain<T>) {
      numbers(values, count);
    } else {
      values.clear();
      for (std::size_t i = 0; i < count; ++i)
        get(values.emplace_back());
    }
  }
  template <class T> void get(std::optional<T> &value) {
    value.reset();
    if (take<bool>())
      get(value.emplace());
  }
  template <class T, class U> void get(std::pair<T, U> &both) { (*this)(both.first, both.second); }
  template <Plain T, int rows, int columns, int options>
  void get(Eigen::Matrix<T, rows, columns, options> &matrix) {
    const auto height = take<Index>(), width = take<Index>();
    const bool fits = (rows == Eigen::Dynamic ? height >= 0 : height == rows) &&
                      (columns == Eigen::Dynamic ? width >= 0 : width == columns);
    if (!fits || (width > 0 && height > static_cast<Index>(left_.size() / sizeof(T)) / width))
      throw BytesError();
    matrix.resize(height, width);
    copy(matrix.data(), static_cast<std::size_t>(matrix.size()));
  }
  template <class T> void get(T &value) { members(*this, value); }

  std::string_view left_;
};

/// The bytes are those of these values and of nothing more. BytesError.
template <class... Values> void unpack(std::string_view bytes, Values &...values) {
  Cursor cursor(bytes);
  cursor(values...);
  if (!cursor.rest().empty())
    throw BytesError();
}

} // namespace vibroimpact
