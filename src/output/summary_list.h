// The numbers of summary.txt and summary.json: both are made from one list.
#pragma once

#include <string>
#include <vector>

namespace vibroimpact::output {

class SummaryList {
public:
  /// A number in the SI unit `unit`. `remark` says in one line what it counts; may be empty.
  void add(const std::string &name, double value, const std::string &unit,
           const std::string &remark = "");
  /// What a result says in words, on one or more lines.
  void add_note(const std::string &name, const std::string &text);
  void append(const SummaryList &other);

  /// Of a file without units: every number by itself, see derived::plain_factor().
  void remove_units();

  /// For summary.txt: `name = value [unit]` and two blanks before a remark, numbers with 12
  /// significant digits; `# name: text` for notes.
  std::string text() const;
  /// For summary.json: {"values": {"name": {"value": 2.95, "unit": "Hz"}}, "notes": {"name":
  /// "text"}}, with "remark" where there is one; numbers as json_number() has them.
  std::string json() const;

private:
  struct Entry {
    std::string name;
    double value = 0;
    std::string unit; ///< empty: a note
    std::string words;
  };
  std::vector<Entry> entries_;
};

} // namespace vibroimpact::output
