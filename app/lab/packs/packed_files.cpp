#include "lab/packs/packed_files.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/portable/source_notice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

namespace fs = std::filesystem;

namespace {
bool is_hidden(const fs::path& path) {
    return path.filename().string().starts_with('.');
}

// Copies that editors leave.
bool is_backup(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.ends_with('~') || name.ends_with(".bak") || name.ends_with(".orig") ||
           name.ends_with(".swp");
}

Result<std::vector<fs::path>> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;
        if (is_hidden(entry->path())) {
            entry.disable_recursion_pending();
        } else if (entry->symlink_status(ignored).type() == fs::file_type::regular &&
                   !is_backup(entry->path())) {
            files.push_back(entry->path());
        }
    }
    if (error)
        return fail({folder, 0, fmt::format("can't be read: {}", error.message())});
    return files;
}

// All files that a look reads, absolute.
std::set<fs::path> files_read(const Look& look) {
    std::set<fs::path> files;
    const auto add = [&](const fs::path& file) {
        std::error_code error;
        if (!file.empty() && fs::is_regular_file(file, error))
            files.insert(fs::absolute(file).lexically_normal());
    };
    for (const fs::path& file : look.files)
        add(file);
    for (const Image& image : look.images) {
        add(image.file);
        for (const fs::path& face : image.faces)
            add(face);
    }
    return files;
}

// LICENSE, COPYING.txt, LICENCE-MIT.
bool is_license(const fs::path& file) {
    const std::string name = to_lower(file.filename().string());
    return name.starts_with("license") || name.starts_with("licence") ||
           name.starts_with("copying");
}

std::vector<fs::path> licenses_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;
        if (is_license(entry->path()) &&
            entry->symlink_status(ignored).type() == fs::file_type::regular)
            files.push_back(entry->path());
    }
    return files;
}

bool is_below(const fs::path& file, const fs::path& folder) {
    const fs::path relative = file.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

// Where the look finds an include without its folder: "noise.glsl"; "": nowhere.
fs::path place_of_include(const fs::path& file, const fs::path& folder,
                          const IncludeFolders& includes) {
    std::vector<fs::path> places{folder.parent_path() / "include"};
    places.insert(places.end(), includes.named.begin(), includes.named.end());
    for (const fs::path& place : places)
        if (const fs::path whole = fs::absolute(place).lexically_normal(); is_below(file, whole))
            return file.lexically_relative(whole);
    return {};
}

Result<void> add_own_files(const Look& look, const fs::path& folder, const Library& library,
                           LookFiles& made) {
    const auto add = [&](const fs::path& place, const fs::path& file) {
        made.files.emplace((made.look.folder / place).generic_string(), file);
    };
    const auto own = files_in(folder);
    if (!own)
        return fail(own.error());
    for (const fs::path& file : *own)
        add(file.lexically_relative(folder), file);
    for (const fs::path& file : files_read(look)) {
        if (is_below(file, folder) || library.is_shipped(file))
            continue;
        const fs::path place = place_of_include(file, folder, library.roots().include_folders());
        if (place.empty())
            return fail({file, 0,
                         fmt::format("is read by {}, but is outside its folder. Move it into {}.",
                                     made.look.id, folder.string())});
        add(place, file);
    }
    return {};
}

fs::path home_folder() {
    const char* const home = std::getenv("HOME");
    return home ? fs::path(home).lexically_normal() : fs::path();
}

// The folder that contains all files.
fs::path common_folder(const std::set<fs::path>& files) {
    fs::path common = files.begin()->parent_path();
    for (const fs::path& file : files)
        while (!is_below(file, common))
            common = common.parent_path();
    return common;
}

Result<void> add_foreign_files(const Look& look, const fs::path& manifest, const Library& library,
                               LookFiles& made) {
    std::set<fs::path> files = files_read(look);
    files.insert(manifest);
    std::erase_if(files, [&](const fs::path& file) { return library.is_shipped(file); });
    const fs::path common = common_folder(files);
    // Otherwise the names of the user's private folders would be in the pack.
    if (common == common.root_path() || is_below(home_folder(), common))
        return fail({manifest, 0,
                     fmt::format("reads files in distant folders. Move them into one folder below "
                                 "{}.",
                                 common.string())});
    for (const fs::path& file : files)
        made.files.emplace((made.look.folder / file.lexically_relative(common)).generic_string(),
                           file);
    for (const fs::path& folder : {common, manifest.parent_path()})
        for (const fs::path& file : licenses_in(folder))
            made.files.emplace(
                (made.look.folder / file.lexically_relative(common)).generic_string(), file);
    made.look.file = manifest.lexically_relative(common).generic_string();
    return {};
}

// Shaders and includes state their licence in comments. Pictures and JSON have no comments.
Result<std::vector<PackedSource>> sources_of(const LookFiles& made) {
    constexpr std::array endings{".frag", ".vert", ".glsl", ".slang", ".slangp",
                                 ".inc",  ".h",    ".fs",   ".vs",    ".params"};
    std::vector<PackedSource> sources;
    for (const auto& [path, file] : made.files) {
        const std::string ending = to_lower(file.extension().string());
        if (std::ranges::find(endings, ending) == endings.end())
            continue;
        const auto text = read_bytes(file);
        if (!text)
            return fail(text.error());
        SourceNotice notice = source_notice(*text);
        sources.push_back({path, std::move(notice.license), std::move(notice.text)});
    }
    return sources;
}
}  // namespace

Result<LookFiles> files_of_look(const Look& look, const Library& library) {
    const fs::path manifest = fs::absolute(look.manifest).lexically_normal();
    LookFiles made;
    made.look = {look.id, look.name, look.author, look.license, "shaders/" + look.id};
    made.look.is_shipped = library.is_shipped(manifest);
    const bool is_own = manifest.filename() == "look.json";
    auto added = is_own ? add_own_files(look, manifest.parent_path(), library, made)
                        : add_foreign_files(look, manifest, library, made);
    if (!added)
        return fail(added.error());
    auto sources = sources_of(made);
    if (!sources)
        return fail(sources.error());
    made.sources = std::move(*sources);
    return made;
}
