#include "lab/packs/pack_writer.h"

#include "io/files/atomic_file.h"
#include "io/files/scratch_folder.h"
#include "io/files/zip.h"
#include "io/pictures/picture_file.h"
#include "lab/golden/golden_name.h"
#include "lab/library/look_templates.h"
#include "lab/offline/preset_thumbnail_renderer.h"
#include "lab/packs/pack_contents.h"
#include "lab/packs/pack_limits.h"

#include <fmt/format.h>

#include <optional>
#include <set>

namespace fs = std::filesystem;

namespace {
/// Draws thumbnails and writes them to the folder of a pack.
class ThumbnailWriter {
public:
    ThumbnailWriter(const Library& library, const PackContents& contents, const fs::path& folder)
        : m_library(library), m_contents(contents), m_folder(folder) {}

    /// `preset` "": the look itself. Returns the thumbnail's path in the pack; "": it could not be
    /// drawn.
    std::string write(const std::string& look, const fs::path& preset) {
        const auto found = m_contents.looks.find(look);
        if (found == m_contents.looks.end())
            return {};
        if (m_drawn != look)
            m_renderer.emplace(found->second, m_library, std::nullopt, Pace::full);
        m_drawn = look;
        std::string path = free_path(golden_name(look, preset.stem().string()));
        const auto picture = m_renderer->paint(preset, JobProgress());
        const auto saved =
            picture ? save_picture(*picture, m_folder / path) : fail(picture.error());
        if (saved)
            return path;
        m_paths.erase(path);
        m_warnings.push_back({preset.empty() ? fs::path(look) : preset, 0,
                              "has no thumbnail in the pack: " + to_string(saved.error().front()),
                              Severity::warning});
        return {};
    }
    std::size_t count() const { return m_paths.size(); }
    Diagnostics take_warnings() { return std::move(m_warnings); }

private:
    std::string free_path(const std::string& name) {
        std::string path = fmt::format("{}/{}.png", thumbnail_folder, name);
        for (int number = 2; !m_paths.insert(path).second; ++number)
            path = fmt::format("{}/{}-{}.png", thumbnail_folder, name, number);
        return path;
    }

    const Library& m_library;
    const PackContents& m_contents;
    const fs::path& m_folder;
    std::string m_drawn;  // the look of m_renderer
    std::optional<PresetThumbnailRenderer> m_renderer;
    std::set<std::string> m_paths;
    Diagnostics m_warnings;
};

// Before anything is copied.
Result<void> check_size(const PackContents& contents, const fs::path& pack) {
    std::uintmax_t bytes = 0;
    for (const auto& [path, file] : contents.files) {
        std::error_code error;
        if (const std::uintmax_t size = fs::file_size(file, error); !error)
            bytes += size;
    }
    if (bytes <= pack_limits.bytes && contents.files.size() <= pack_limits.files)
        return {};
    return fail({pack, 0,
                 fmt::format("would have {} files with {:.0f} MB. A pack can have {} files and "
                             "{:.0f} MB. Remove files that the look does not need.",
                             contents.files.size(), 1e-6 * static_cast<double>(bytes),
                             pack_limits.files, 1e-6 * static_cast<double>(pack_limits.bytes))});
}

Result<void> copy_files(const PackContents& contents, const fs::path& folder) {
    for (const auto& [path, file] : contents.files) {
        std::error_code error;
        fs::create_directories((folder / path).parent_path(), error);
        fs::copy_file(file, folder / path, error);
        if (error)
            return fail({file, 0, fmt::format("can't be copied: {}", error.message())});
    }
    for (const auto& [path, text] : contents.texts)
        if (auto written = write_atomically(folder / path, text); !written)
            return written;
    return {};
}

Result<void> cancelled() {
    return fail({{}, 0, "was cancelled"});
}

// A look with a picture of its own keeps that one.
Result<void> add_thumbnails(PackContents& contents, ThumbnailWriter& thumbnails,
                            const PackProgress& progress) {
    PackManifest& manifest = contents.manifest;
    const std::size_t all = manifest.looks.size() + manifest.presets.size();
    std::size_t done = 0;
    const auto goes_on = [&] {
        return progress(static_cast<double>(++done) / static_cast<double>(all));
    };
    for (PackedLook& look : manifest.looks) {
        if (!contents.files.contains(look.folder + "/" + picture_name))
            look.thumbnail = thumbnails.write(look.id, {});
        if (!goes_on())
            return cancelled();
    }
    for (std::size_t i = 0; i < manifest.presets.size(); ++i) {
        PackedPreset& preset = manifest.presets[i];
        if (!contents.preset_files[i].empty())
            preset.thumbnail = thumbnails.write(preset.look, contents.preset_files[i]);
        if (!goes_on())
            return cancelled();
    }
    return {};
}

}  // namespace

Result<WrittenPack> write_pack(const PackRequest& request, const Library& library,
                               const PackProgress& progress) {
    auto contents = pack_contents(request.looks, request.path.stem().string(), library);
    if (!contents)
        return fail(contents.error());
    if (auto fits = check_size(*contents, request.path); !fits)
        return fail(fits.error());
    const auto scratch = ScratchFolder::create();
    if (!scratch)
        return fail(scratch.error());
    const fs::path folder = scratch->path() / "pack";
    if (auto copied = copy_files(*contents, folder); !copied)
        return fail(copied.error());
    ThumbnailWriter thumbnails(library, *contents, folder);
    if (auto added = add_thumbnails(*contents, thumbnails, progress); !added)
        return fail(added.error());
    if (auto written = write_atomically(folder / pack_file, pack_to_json(contents->manifest));
        !written)
        return fail(written.error());
    // An existing file is replaced only by a pack that can be installed.
    const fs::path archive = scratch->path() / request.path.filename();
    auto zipped = zip_folder(folder, archive);
    if (zipped)
        zipped = check_zip(archive, pack_limits);
    if (!zipped)
        return fail(zipped.error());
    if (auto saved = copy_atomically(archive, request.path); !saved)
        return fail(saved.error());
    WrittenPack written;
    std::error_code error;
    written.files = contents->files.size() + contents->texts.size() + thumbnails.count() + 1;
    written.bytes = fs::file_size(request.path, error);
    written.manifest = std::move(contents->manifest);
    written.warnings = thumbnails.take_warnings();
    return written;
}
