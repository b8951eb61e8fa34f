#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "apps/scene/document.h"
#include "apps/scene/kinds.h"
#include "apps/scene/stated.h"

namespace scanlight::apps {

/// What a reference says of a key.
struct KeyInfo {
    std::string name;
    std::string words;     // what its value may be
    std::string fallback;  // what holds where it is not given
    std::string meaning;
    Json schema;
};

/// One key of a table of a scene file, and the part of `Owner` that it stands for.
template <class Owner>
struct Key {
    KeyInfo info;
    /// False if the value is none for this key.
    std::function<bool(Owner&, const Value&, const std::filesystem::path& folder)> set;
    /// As TOML; empty if nothing has to be said, for it is so anyway.
    std::function<std::string(const Owner&, const std::filesystem::path& folder)> get;
};

/// What keys must and must not stand together in one table.
struct KeyRules {
    std::vector<std::vector<std::string>> one_of;  // of each of these lists one at least
    std::vector<std::pair<std::string, std::string>> never_both{};
    std::vector<std::pair<std::string, std::string>> needs{};  // the first the second
};

template <class Owner>
struct KeyTable {
    std::vector<Key<Owner>> keys;
    KeyRules rules;
};

// ---- keys

/// Of a member, which `access` finds: `[](auto& owner) -> auto& { return owner.zoom; }`. What holds
/// without it is what a new owner has.
template <class Owner, class T, class Access>
Key<Owner> key(const std::string& name, const Kind<T>& kind, Access access,
               const std::string& meaning) {
    const Owner fresh{};
    const std::string fallback = kind.write(access(fresh), {});
    const auto set = [kind, access](Owner& owner, const Value& value,
                                    const std::filesystem::path& folder) {
        const auto read = kind.read(value, folder);
        if (read) access(owner) = *read;
        return read.has_value();
    };
    const auto get = [kind, access, fallback](const Owner& owner,
                                              const std::filesystem::path& folder) {
        const std::string text = kind.write(access(owner), folder);
        return text == fallback ? std::string() : text;
    };
    return {{name, kind.words, fallback, meaning, kind.schema}, set, get};
}

/// Of a member that is a std::optional.
template <class Owner, class T, class Access>
Key<Owner> optional_key(const std::string& name, const Kind<T>& kind, Access access,
                        const std::string& fallback, const std::string& meaning) {
    const auto set = [kind, access](Owner& owner, const Value& value,
                                    const std::filesystem::path& folder) {
        const auto read = kind.read(value, folder);
        if (read) access(owner) = *read;
        return read.has_value();
    };
    const auto get = [kind, access](const Owner& owner, const std::filesystem::path& folder) {
        const auto& value = access(owner);
        return value ? kind.write(*value, folder) : std::string();
    };
    return {{name, kind.words, fallback, meaning, kind.schema}, set, get};
}

/// The same key, which is written only where `holds(owner)`, and read by `use(owner, value)`.
template <class Owner, class T, class Use, class Holds, class Access>
Key<Owner> chosen_key(const std::string& name, const Kind<T>& kind, Use use, Holds holds,
                      Access access, const std::string& fallback, const std::string& meaning) {
    const auto set = [kind, use](Owner& owner, const Value& value,
                                 const std::filesystem::path& folder) {
        const auto read = kind.read(value, folder);
        if (read) use(owner, *read);
        return read.has_value();
    };
    const auto get = [kind, holds, access](const Owner& owner,
                                           const std::filesystem::path& folder) {
        return holds(owner) ? kind.write(access(owner), folder) : std::string();
    };
    return {{name, kind.words, fallback, meaning, kind.schema}, set, get};
}

// ---- tables

/// Where a table stands.
struct Where {
    std::string file;    // as messages call it
    std::string folder;  // from which its paths are meant
    std::string table;   // "[camera]"
    Place place;
};

/// Throws FileError at a place.
[[noreturn]] void refuse_at(const std::string& file, const Place& place, const std::string& reason);

/// "; did you mean 'color'?" for a name that is not one of these.
std::string suggestion(const std::string& name, const std::vector<std::string>& known);

/// Throws unless the keys of a table are known and go together.
void check_keys(const Table& table, const std::vector<std::string>& known, const KeyRules& rules,
                const Where& where);

/// Where a table and the values in it stand.
Stated stated(const Table& table, const Where& where);

template <class Owner>
void read_keys(const KeyTable<Owner>& keys, const Table& table, const Where& where, Owner& owner) {
    std::vector<std::string> known;
    for (const Key<Owner>& key : keys.keys)
        known.push_back(key.info.name);
    check_keys(table, known, keys.rules, where);
    for (const Key<Owner>& key : keys.keys) {
        const Entry* entry = find(table, key.info.name);
        if (entry == nullptr || key.set(owner, entry->value, where.folder)) continue;
        refuse_at(where.file, entry->value.place,
                  "'" + key.info.name + "': expected " + key.info.words + ", not " +
                      described(entry->value));
    }
    if constexpr (requires { owner.stated; }) owner.stated = stated(table, where);
}

/// A line for each key that has to be said.
template <class Owner>
std::string write_keys(const KeyTable<Owner>& keys, const Owner& owner,
                       const std::filesystem::path& folder) {
    std::string lines;
    for (const Key<Owner>& key : keys.keys) {
        const std::string text = key.get(owner, folder);
        if (!text.empty()) lines += key.info.name + " = " + text + "\n";
    }
    return lines;
}

}  // namespace scanlight::apps
