#include "cli/common.h"
#include "cli/progress.h"
#include "lab/packs/pack_installer.h"
#include "lab/packs/pack_writer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <iostream>

using Json = nlohmann::ordered_json;

namespace {
constexpr std::array pack_examples{
    "afterglow pack mine.json -o mine.afterglow",
    "afterglow pack crt crt-geom.slangp -o tubes.afterglow",
    "afterglow pack --install tubes.afterglow",
};

struct PackArguments {
    std::vector<std::string> looks;
    std::string output;
    std::string install;
    bool as_json = false;
};

void print_pack_json(const Json& json) {
    std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

const char* name_of(InstalledItem::Status status) {
    switch (status) {
        case InstalledItem::Status::added:
            return "added";
        case InstalledItem::Status::renamed:
            return "renamed";
        case InstalledItem::Status::present:
            return "present";
    }
    return "";
}

Json items_json(const std::vector<InstalledItem>& items) {
    Json json = Json::array();
    for (const InstalledItem& item : items)
        json.push_back({{"id", item.id}, {"name", item.name}, {"status", name_of(item.status)}});
    return json;
}

int install(const PackArguments& arguments, const Library& library) {
    const auto installed = install_pack(arguments.install, library);
    if (!installed)
        return report(installed.error());
    if (arguments.as_json) {
        print_pack_json({{"name", installed->name},
                         {"looks", items_json(installed->looks)},
                         {"presets", items_json(installed->presets)}});
        return exit_done;
    }
    std::cout << summary(*installed) << '\n';
    for (const auto* const items : {&installed->looks, &installed->presets})
        for (const InstalledItem& item : *items)
            std::cout << fmt::format("  {:<8} {}\n", name_of(item.status), item.id);
    return exit_done;
}

Json contents_json(const WrittenPack& written) {
    Json looks = Json::array();
    for (const PackedLook& look : written.manifest.looks)
        looks.push_back({{"id", look.id}, {"license", look.license}});
    Json presets = Json::array();
    for (const PackedPreset& preset : written.manifest.presets)
        presets.push_back({{"look", preset.look}, {"file", preset.file}});
    return {{"files", written.files},
            {"bytes", written.bytes},
            {"looks", std::move(looks)},
            {"presets", std::move(presets)}};
}

int write(const PackArguments& arguments, const Library& library) {
    const auto written = [&] {
        constexpr int percent = 100;
        Progress progress(Progress::Kind::rendering_pictures, percent);
        return write_pack({arguments.looks, arguments.output}, library, [&](double share) {
            progress.show(static_cast<int>(share * percent));
            return true;
        });
    }();
    if (!written)
        return report(written.error());
    warn(written->warnings);
    if (arguments.as_json)
        print_pack_json(contents_json(*written));
    else
        std::cout << fmt::format("{}: looks: {}, presets: {}, files: {}, {:.1f} MB\n",
                                 arguments.output, written->manifest.looks.size(),
                                 written->manifest.presets.size(), written->files,
                                 1e-6 * static_cast<double>(written->bytes));
    return exit_done;
}

int pack(const PackArguments& arguments, const DataFolders& data) {
    const bool installs = !arguments.install.empty();
    if (installs && !(arguments.looks.empty() && arguments.output.empty()))
        throw UsageError("--install takes no LOOK and no --output");
    if (!installs && (arguments.looks.empty() || arguments.output.empty()))
        throw UsageError("give a LOOK and --output NAME.afterglow, or --install NAME.afterglow");
    if (!installs)
        check_ending("--output", arguments.output, {std::string(pack_extension)});
    const auto library = open_library(data);
    if (!library)
        return report(library.error());
    return installs ? install(arguments, *library) : write(arguments, *library);
}
}  // namespace

/// afterglow pack LOOK... -o NAME.afterglow
Command add_pack(CommandLine& program) {
    Options options = program.add_verb(
        "pack",
        "Pack looks and presets into one file, or install such a file\n\n"
        "A pack has the looks with their licences, all their presets, the sounds and pictures of "
        "these presets, and thumbnails. Installing never overwrites a file.",
        pack_examples);
    auto arguments = std::make_shared<PackArguments>();
    options.add("LOOK", arguments->looks,
                "Look (name or folder), stack (phosphor+crt), shader of another program, or preset "
                "(file, PNG or line of text)");
    options.add("-o,--output FILE", arguments->output, "Pack to write: NAME.afterglow");
    options.add("--install FILE", arguments->install,
                "Add the looks and presets of a pack to your folder");
    options.add_flag("--json", arguments->as_json, "Print one JSON document");
    return [arguments](const DataFolders& data) { return pack(*arguments, data); };
}
