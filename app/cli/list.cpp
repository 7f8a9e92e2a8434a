#include "cli/common.h"
#include "lab/library/catalog.h"

#include <nlohmann/json.hpp>

#include <array>
#include <iomanip>
#include <iostream>

namespace {
constexpr std::array list_examples{
    "afterglow list looks",
    "afterglow list signals",
    "afterglow list presets --json",
};

void print_json(const std::vector<CatalogEntry>& entries) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const CatalogEntry& entry : entries) {
        nlohmann::ordered_json line{{"id", entry.id}, {"name", entry.name}, {"about", entry.about}};
        if (!entry.look.empty())
            line["look"] = entry.look;
        if (!entry.file.empty())
            line["file"] = entry.file.string();
        list.push_back(std::move(line));
    }
    std::cout << list.dump(2) << '\n';
}

void print_table(const std::vector<CatalogEntry>& entries) {
    std::size_t width = 0;
    const auto key = [](const CatalogEntry& entry) {
        return entry.look.empty() ? entry.id : entry.look + "/" + entry.id;
    };
    for (const CatalogEntry& entry : entries)
        width = std::max(width, key(entry).size());
    for (const CatalogEntry& entry : entries)
        std::cout << std::left << std::setw(static_cast<int>(width) + 2) << key(entry) << entry.name
                  << (entry.about.empty() ? "" : ". ") << entry.about << '\n';
}

int list(const std::string& what, bool as_json, const DataFolders& data) {
    std::vector<CatalogEntry> entries;
    if (what == "signals") {
        entries = list_signals();
    } else if (what == "patterns") {
        entries = list_patterns();
    } else {
        const auto library = open_library(data);
        if (!library)
            return report(library.error());
        entries = what == "looks" ? list_looks(*library) : list_presets(*library);
    }
    as_json ? print_json(entries) : print_table(entries);
    return exit_done;
}
}  // namespace

/// afterglow list looks|presets|signals|patterns [--json]
Command add_list(CommandLine& program) {
    struct Arguments {
        std::string what;
        bool as_json = false;
    };
    Options options =
        program.add_verb("list", "List looks, presets, signals or test patterns", list_examples);
    auto arguments = std::make_shared<Arguments>();
    options.add("WHAT", arguments->what, "looks, presets, signals or patterns")
        .required()
        .one_of({"looks", "presets", "signals", "patterns"});
    options.add_flag("--json", arguments->as_json, "Print one JSON document");
    return [arguments](const DataFolders& data) {
        return list(arguments->what, arguments->as_json, data);
    };
}
