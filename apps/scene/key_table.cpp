#include "apps/scene/key_table.h"

#include "mesh/text.h"

namespace scanlight::apps {

namespace {

std::string joined(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "'" : " or '") + name + "'";
    return list;
}

void expect_known(const Table& table, const std::vector<std::string>& known, const Where& where) {
    for (const Entry& entry : table) {
        if (std::ranges::find(known, entry.name) != known.end()) continue;
        refuse_at(where.file, entry.place,
                  "unknown key " + in_quotes(entry.name) + " in " + where.table +
                      suggestion(entry.name, known));
    }
}

void expect_together(const Table& table, const KeyRules& rules, const Where& where) {
    for (const auto& [a, b] : rules.never_both) {
        if (find(table, a) == nullptr || find(table, b) == nullptr) continue;
        refuse_at(where.file, find(table, b)->place,
                  "'" + a + "' and '" + b + "' in one " + where.table + "; expected one of them");
    }
    for (const auto& [a, b] : rules.needs) {
        if (find(table, a) == nullptr || find(table, b) != nullptr) continue;
        refuse_at(where.file, find(table, a)->place,
                  "'" + a + "' without '" + b + "' in " + where.table);
    }
}

}  // namespace

void refuse_at(const std::string& file, const Place& place, const std::string& reason) {
    throw mesh::FileError(place_text(file, place) + ": " + reason);
}

std::string suggestion(const std::string& name, const std::vector<std::string>& known) {
    if (known.empty()) return "";
    // A name that goes on where a short one ends is nearer than any other: 'fov_deg' to 'fov'.
    const auto nearest = std::ranges::min_element(known, {}, [&](const std::string& other) {
        const bool goes_on = name.size() >= 3 && other.starts_with(name);
        return goes_on ? 0 : mesh::edit_distance(std::string_view(name).substr(0, 64), other);
    });
    return "; did you mean '" + *nearest + "'?";
}

void check_keys(const Table& table, const std::vector<std::string>& known, const KeyRules& rules,
                const Where& where) {
    expect_known(table, known, where);
    expect_together(table, rules, where);
    const auto is_there = [&](const std::string& name) { return find(table, name) != nullptr; };
    for (const auto& names : rules.one_of) {
        if (!std::ranges::any_of(names, is_there))
            refuse_at(where.file, where.place, where.table + " without " + joined(names));
    }
}

Stated stated(const Table& table, const Where& where) {
    Stated stated{place_text(where.file, where.place), {}};
    for (const Entry& entry : table)
        stated.values[entry.name] = place_text(where.file, entry.value.place);
    return stated;
}

}  // namespace scanlight::apps
