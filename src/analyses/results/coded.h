// Kinds that stand as numbers in results: number and words from one table.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>

namespace vibroimpact::analyses {

template <class Kind> struct Coded {
  Kind kind;
  int number;
  const char *words;
};

/// Of the first entry of this kind; every kind has one.
template <class Kind, std::size_t n> int code_of(const Coded<Kind> (&table)[n], Kind kind) {
  return std::find_if(std::begin(table), std::end(table),
                      [kind](const Coded<Kind> &entry) { return entry.kind == kind; })
      ->number;
}

/// For the description of the field: "0 lower end of the key, 1 ...".
template <class Kind, std::size_t n> std::string meaning_of(const Coded<Kind> (&table)[n]) {
  std::string text;
  for (const Coded<Kind> &entry : table)
    text += (text.empty() ? "" : ", ") + std::to_string(entry.number) + " " + entry.words;
  return text;
}

} // namespace vibroimpact::analyses
