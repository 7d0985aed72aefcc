#include "parameters/like.h"

#include "parameters/text.h"
#include "parameters/tree.h"

#include <algorithm>

namespace vibroimpact::parameters {

namespace {

using Entries = std::vector<ScannedEntry>;

const std::string like = "Like";

/// In JSON an empty one may be meant so.
bool is_section(const ScannedEntry &entry) {
  return entry.kind == ScannedEntry::Kind::section || entry.kind == ScannedEntry::Kind::empty;
}

Entries::iterator find(Entries &entries, const std::string &name) {
  return std::find_if(entries.begin(), entries.end(),
                      [&](const ScannedEntry &entry) { return entry.name == name; });
}

/// The order of the first, then what only the second has: the order of named sections is that of
/// masses, of axes and of files.
Entries merged(Entries taken, const Entries &own) {
  Entries more;
  for (const ScannedEntry &entry : own) {
    const auto same = find(taken, entry.name);
    if (same == taken.end())
      more.push_back(entry);
    else if (is_section(entry) && is_section(*same)) {
      ScannedEntry both = entry;
      both.entries = merged(same->entries, entry.entries);
      *same = std::move(both);
    } else
      *same = entry;
  }
  taken.insert(taken.end(), more.begin(), more.end());
  return taken;
}

/// The sections within one, all of which a key Like may name.
class Siblings {
public:
  Siblings(ScannedEntry &around, const Section &declared, const std::vector<std::string> &path)
      : around_(around), declared_(declared), path_(path) {}

  void resolve() {
    for (ScannedEntry &entry : around_.entries)
      resolve(entry);
    for (ScannedEntry &entry : around_.entries)
      if (const Section *below = declared_below(entry); below != nullptr && is_section(entry))
        Siblings(entry, *below, path_of(entry.name)).resolve();
  }

private:
  const Section *declared_below(const ScannedEntry &entry) const {
    const Section *fixed = declared_.find_subsection(entry.name);
    return fixed != nullptr ? fixed : kind_of(declared_, entry.name);
  }

  std::vector<std::string> path_of(const std::string &name) const {
    std::vector<std::string> path = path_;
    path.push_back(name);
    return path;
  }

  void resolve(ScannedEntry &entry) {
    const Section *kind = kind_of(declared_, entry.name);
    const auto key = find(entry.entries, like);
    if (kind == nullptr || !is_section(entry) || key == entry.entries.end())
      return;
    const ScannedEntry chosen = *key;
    if (std::find(open_.begin(), open_.end(), entry.name) != open_.end())
      refuse(entry, chosen,
             "the section is like itself: " + join(open_, " -> ") + " -> " + entry.name);
    ScannedEntry &other = source(entry, chosen, kind->name());
    open_.push_back(entry.name);
    resolve(other);
    open_.pop_back();
    entry.entries.erase(key);
    if (find(entry.entries, like) != entry.entries.end())
      refuse(entry, chosen, "this key is set twice");
    entry.entries = merged(other.entries, entry.entries);
  }

  ScannedEntry &source(const ScannedEntry &entry, const ScannedEntry &chosen,
                       const std::string &kind) {
    const auto found = find(around_.entries, kind + " " + chosen.value);
    if (found != around_.entries.end() && is_section(*found))
      return *found;
    std::vector<std::string> known;
    for (const ScannedEntry &other : around_.entries)
      if (other.name.starts_with(kind + " ") && other.name != entry.name)
        known.push_back(other.name.substr(kind.size() + 1));
    const std::string near = suggestion(chosen.value, known);
    refuse(entry, chosen,
           "there is no '" + kind + " " + chosen.value + "' beside '" + entry.name + "'" +
               (!near.empty()   ? near
                : known.empty() ? ""
                                : "; possible are: " + join(known, ", ")));
  }

  [[noreturn]] void refuse(const ScannedEntry &entry, const ScannedEntry &key,
                           const std::string &problem) const {
    std::vector<std::string> path = path_of(entry.name);
    path.push_back(like);
    refuse_value(key.origin, path, key.value, problem);
  }

  ScannedEntry &around_;
  const Section &declared_;
  std::vector<std::string> path_;
  std::vector<std::string> open_; ///< names of the sections being resolved
};

} // namespace

void take_over_entries(ScannedEntry &file, const Section &declarations) {
  Siblings(file, declarations, {}).resolve();
}

} // namespace vibroimpact::parameters
