#include "lab/packs/pack_contents.h"

#include "formats/look_format.h"
#include "formats/preset/preset_format.h"
#include "lab/library/open.h"
#include "lab/packs/packed_files.h"
#include "lab/packs/packed_presets.h"
#include "model/preset/preset.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
/// Collects the parts of a pack.
class Collector {
public:
    explicit Collector(const Library& library) : m_library(library), m_presets(library) {}

    Result<void> add(const std::string& argument);
    Result<PackContents> finish(const std::string& name);

private:
    Result<void> add_look(const StackPart& part);
    Result<void> add_presets(const Look& look, const std::string& id);

    const Library& m_library;
    PackContents m_contents;
    PackedPresets m_presets;
    std::vector<fs::path> m_added;  // manifests of looks, and files of presets
};

Result<void> Collector::add_look(const StackPart& part) {
    const LoadedLook loaded = load_look(part.path, m_library.roots().include_folders());
    if (!loaded.look)
        return fail(loaded.look.error());
    if (std::ranges::find(m_added, loaded.look->manifest) != m_added.end())
        return {};
    m_added.push_back(loaded.look->manifest);
    auto files = files_of_look(*loaded.look, m_library);
    if (!files)
        return fail(files.error());
    PackManifest& manifest = m_contents.manifest;
    if (std::ranges::find(manifest.looks, files->look.id, &PackedLook::id) != manifest.looks.end())
        return fail({loaded.look->manifest, 0,
                     fmt::format("another look called '{}' is in the pack already. Rename one.",
                                 files->look.id)});
    manifest.looks.push_back(std::move(files->look));
    manifest.sources.insert(manifest.sources.end(), files->sources.begin(), files->sources.end());
    m_contents.files.merge(files->files);
    m_contents.looks.emplace(loaded.look->id, *loaded.look);
    return {};
}

Result<void> Collector::add_presets(const Look& look, const std::string& id) {
    for (const PresetEntry& entry : m_library.presets(id)) {
        if (std::ranges::find(m_added, entry.file) != m_added.end())
            continue;
        m_added.push_back(entry.file);
        auto preset = load_preset(entry.file);
        if (!preset)
            return fail(preset.error());
        if (auto added = m_presets.add(std::move(*preset), entry.file, look); !added)
            return added;
    }
    return {};
}

Result<void> Collector::add(const std::string& argument) {
    const auto request = resolve(argument, m_library);
    if (!request)
        return fail(request.error());
    const LoadedLook loaded = load_requested(*request, m_library);
    if (!loaded.look)
        return fail(loaded.look.error());
    for (const StackPart& part : stack_of(*request))
        if (auto added = add_look(part); !added)
            return added;
    m_contents.looks.emplace(loaded.look->id, *loaded.look);
    if (request->preset)
        return m_presets.add(*request->preset, request->preset_file, *loaded.look);
    return add_presets(*loaded.look, loaded.look->id);
}

Result<PackContents> Collector::finish(const std::string& name) {
    auto presets = m_presets.finish(name);
    if (!presets)
        return fail(presets.error());
    m_contents.manifest.name = name;
    m_contents.manifest.presets = std::move(presets->presets);
    m_contents.texts = std::move(presets->texts);
    m_contents.preset_files = std::move(presets->originals);
    m_contents.files.merge(presets->media);
    return std::move(m_contents);
}
}  // namespace

Result<PackContents> pack_contents(const std::vector<std::string>& arguments,
                                   const std::string& name, const Library& library) {
    Collector collector(library);
    for (const std::string& argument : arguments)
        if (auto added = collector.add(argument); !added)
            return fail(added.error());
    return collector.finish(name);
}
