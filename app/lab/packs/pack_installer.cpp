#include "lab/packs/pack_installer.h"

#include "base/file.h"
#include "formats/look/loaded_look.h"
#include "formats/pack/pack_format.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/preset_update.h"
#include "io/files/atomic_file.h"
#include "io/files/atomic_folder.h"
#include "io/files/zip.h"
#include "io/pictures/png_encoder.h"
#include "lab/library/look_templates.h"
#include "lab/packs/pack_limits.h"
#include "lab/storage/media.h"
#include "model/look/stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace fs = std::filesystem;

namespace {
using Status = InstalledItem::Status;

bool have_equal_bytes(const fs::path& one, const fs::path& other) {
    std::error_code error;
    if (fs::file_size(one, error) != fs::file_size(other, error) || error)
        return false;
    // Files of up to 2 GB: not read into memory.
    std::ifstream a(one, std::ios::binary);
    std::ifstream b(other, std::ios::binary);
    using Bytes = std::istreambuf_iterator<char>;
    return a && b && std::equal(Bytes(a), Bytes(), Bytes(b), Bytes());
}

// The files in a folder by relative path.
std::set<fs::path> names_in(const fs::path& folder) {
    std::set<fs::path> names;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->is_regular_file(error))
            names.insert(entry->path().lexically_relative(folder));
    return names;
}

// The files of a look; its picture is not part of it.
std::set<fs::path> files_of(const fs::path& look) {
    std::set<fs::path> names = names_in(look);
    names.erase(picture_name);
    return names;
}

bool have_equal_files(const fs::path& one, const fs::path& other) {
    const std::set<fs::path> names = files_of(one);
    return names == files_of(other) && std::ranges::all_of(names, [&](const fs::path& name) {
               return have_equal_bytes(one / name, other / name);
           });
}

Result<void> write_plain_picture(const fs::path& file) {
    constexpr Extent extent{240, 135};
    constexpr std::uint8_t dark_gray = 32;
    const std::vector<std::uint8_t> rgb(std::size_t{3} * 240 * 135, dark_gray);
    const auto png = encode_png(extent, rgb);
    return png ? write_atomically(file, *png) : fail(png.error());
}

/// Moves files to the user's folder. Its destructor removes them, unless keep() was called.
class Moves {
public:
    Moves() = default;
    Moves(const Moves&) = delete;
    Moves& operator=(const Moves&) = delete;
    ~Moves() {
        std::error_code error;
        for (const fs::path& path : m_made)
            fs::remove_all(path, error);
    }

    // The target must not exist.
    Result<void> move(const fs::path& from, const fs::path& to) {
        std::error_code error;
        make_folders(to.parent_path());
        if (fs::exists(fs::symlink_status(to, error)))
            return fail({to, 0, "appeared while the pack was installed. Install it again."});
        fs::rename(from, to, error);
        if (error)
            return fail({to, 0, fmt::format("can't be created: {}", error.message())});
        m_made.push_back(to);
        return {};
    }
    void keep() { m_made.clear(); }

private:
    void make_folders(const fs::path& folder) {
        std::error_code error;
        fs::path first;  // of the new folders
        for (fs::path one = folder; !one.empty() && !fs::exists(one, error);
             one = one.parent_path())
            first = one;
        fs::create_directories(folder, error);
        if (!first.empty())
            m_made.push_back(first);
    }

    std::vector<fs::path> m_made;
};

fs::path numbered(const fs::path& name, int number) {
    return number == 1 ? name
                       : fs::path(fmt::format("{}-{}{}", name.stem().string(), number,
                                              name.extension().string()));
}

// A preset of looks that were renamed. The names of a stack's values begin with those of its looks.
Preset moved_to(Preset preset, const std::map<std::string, std::string>& ids) {
    const std::vector<std::string> before = look_ids(preset.look);
    std::vector<std::string> after = before;
    for (std::string& id : after)
        if (const auto renamed = ids.find(id); renamed != ids.end())
            id = renamed->second;
    const std::vector<std::string> old_keys = stack_keys(before);
    const std::vector<std::string> new_keys = stack_keys(after);
    const auto moved_key = [&](const std::string& key) {
        const auto place = std::ranges::find(old_keys, key) - old_keys.begin();
        return place < std::ssize(old_keys) ? new_keys[static_cast<std::size_t>(place)] : key;
    };
    const auto moved_names = [&](const auto& named) {
        std::remove_cvref_t<decltype(named)> result;
        for (const auto& [name, value] : named) {
            const std::size_t slash = name.find('/');
            const bool has_key = before.size() > 1 && slash != name.npos;
            result.emplace(has_key ? moved_key(name.substr(0, slash)) + name.substr(slash) : name,
                           value);
        }
        return result;
    };
    preset.values = moved_names(preset.values);
    preset.modulations = moved_names(preset.modulations);
    for (std::string& key : preset.bypass)
        key = moved_key(key);
    preset.look = fmt::format("{}", fmt::join(after, "+"));
    return preset;
}

/// Installs one pack from the folder that it was extracted to.
class Installer {
public:
    Installer(const fs::path& folder, const Library& library, PackManifest manifest)
        : m_folder(folder), m_library(library), m_manifest(std::move(manifest)) {}

    Result<InstalledPack> install();

private:
    Result<void> check() const;
    Result<void> install_look(const PackedLook& look);
    Result<void> install_preset(const PackedPreset& packed);
    Result<void> install_media(const PackedPreset& packed, const Preset& preset);
    Result<void> install_file(const fs::path& content, const fs::path& target);
    bool is_in_library(const fs::path& place) const;
    bool is_in_library_with(const fs::path& place, const fs::path& content) const;

    const fs::path& m_folder;
    const Library& m_library;
    PackManifest m_manifest;
    InstalledPack m_installed;
    std::map<std::string, std::string> m_ids;  // of renamed looks, by their id in the pack
    Moves m_moves;
};

// Whether one of the roots has something at a place, such as "shaders/glow".
bool Installer::is_in_library(const fs::path& place) const {
    std::error_code error;
    return std::ranges::any_of(m_library.roots().all(), [&](const fs::path& root) {
        return fs::exists(root / place, error);
    });
}

bool Installer::is_in_library_with(const fs::path& place, const fs::path& content) const {
    std::error_code error;
    return std::ranges::any_of(m_library.roots().all(), [&](const fs::path& root) {
        return fs::is_directory(content, error) ? have_equal_files(root / place, content)
                                                : have_equal_bytes(root / place, content);
    });
}

Result<void> Installer::check() const {
    std::set<std::string> ids;
    std::error_code error;
    for (const PackedLook& look : m_manifest.looks) {
        const fs::path manifest =
            m_folder / look.folder / (look.file.empty() ? "look.json" : look.file);
        if (look.id.find_first_of("+#") != look.id.npos || !ids.insert(look.id).second)
            return fail({pack_file, 0, fmt::format("'{}' can't be the id of a look", look.id)});
        if (!fs::is_regular_file(manifest, error))
            return fail({pack_file, 0, fmt::format("the look '{}' is missing", look.id)});
    }
    for (const PackedPreset& packed : m_manifest.presets) {
        const auto preset = load_preset(m_folder / packed.file);
        if (!preset)
            return fail({packed.file, preset.error().front().line, preset.error().front().message});
        if (preset->look != packed.look)
            return fail({packed.file, 0,
                         fmt::format("is for '{}', not for '{}'", preset->look, packed.look)});
    }
    return {};
}

Result<void> Installer::install_look(const PackedLook& look) {
    InstalledItem item{look.name.empty() ? look.id : look.name, look.id};
    const auto here = m_library.find_look(look.id);
    fs::path folder = m_folder / look.folder;
    int number = 1;
    while (is_in_library(fs::path("shaders") / numbered(look.id, number)) &&
           !is_in_library_with(fs::path("shaders") / numbered(look.id, number), folder))
        ++number;
    if (look.is_shipped && here && here->is_shipped)
        number = 1;
    item.id = numbered(look.id, number).string();
    item.status = number > 1 ? Status::renamed : Status::added;
    if (item.id != look.id)
        m_ids[look.id] = item.id;
    if (is_in_library(fs::path("shaders") / item.id)) {
        item.status = Status::present;
        m_installed.looks.push_back(std::move(item));
        return {};
    }
    std::error_code error;
    if (!look.file.empty() && item.id != look.id)  // a look of another program is named by its file
        fs::rename(folder / look.file,
                   (folder / look.file).replace_filename(foreign_file_name(item.id)), error);
    if (error)
        return fail({look.file, 0, fmt::format("can't be renamed: {}", error.message())});
    if (!look.thumbnail.empty())
        fs::rename(m_folder / look.thumbnail, folder / picture_name, error);
    // Without a picture, the list of looks would draw the look before the user opens it.
    if (!fs::exists(folder / picture_name, error))
        if (auto written = write_plain_picture(folder / picture_name); !written)
            return written;
    m_installed.looks.push_back(item);
    return m_moves.move(folder, m_library.roots().user / "shaders" / item.id);
}

// A file that presets name. The first preset moves it.
Result<void> Installer::install_file(const fs::path& content, const fs::path& target) {
    std::error_code error;
    if (!fs::exists(target, error))
        return m_moves.move(content, target);
    if (have_equal_bytes(target, content))
        return {};
    return fail({target, 0, "is another file of this name. Rename it, and install again."});
}

// The file that a preset names, or the folder of such files, next to it.
Result<void> Installer::install_media(const PackedPreset& packed, const Preset& preset) {
    std::set<fs::path> entries;
    const fs::path folder = m_folder / fs::path(packed.file).parent_path();
    const auto add = [&](const fs::path& named) {
        const fs::path inside = named.lexically_normal();
        std::error_code error;
        if (inside.empty() || inside.is_absolute() || *inside.begin() == ".." || inside == ".")
            return;
        if (fs::exists(folder / *inside.begin(), error))
            entries.insert(*inside.begin());
    };
    add(media_file_of(preset));
    for (const auto& [name, value] : preset.values)
        add(value.path);
    for (const fs::path& entry : entries) {
        const fs::path content = folder / entry;
        std::error_code error;
        const fs::path target = m_library.roots().user / "presets" / preset.look / entry;
        if (!fs::is_directory(content, error)) {
            if (auto added = install_file(content, target); !added)
                return added;
            continue;
        }
        for (const fs::path& name : names_in(content))
            if (auto added = install_file(content / name, target / name); !added)
                return added;
    }
    return {};
}

Result<void> Installer::install_preset(const PackedPreset& packed) {
    const fs::path file = m_folder / packed.file;
    auto text = read_text(file);
    auto preset = load_preset(file);
    if (!text || !preset)
        return fail(text ? preset.error() : text.error());
    const Preset moved = moved_to(*preset, m_ids);
    if (moved != *preset)
        if (auto written = write_atomically(file, updated_preset_text(*text, moved, nullptr));
            !written)
            return written;
    const fs::path folder = fs::path("presets") / moved.look;
    const fs::path name = fs::path(packed.file).filename();
    int number = 1;
    while (is_in_library(folder / numbered(name, number)) &&
           !is_in_library_with(folder / numbered(name, number), file))
        ++number;
    const fs::path place = folder / numbered(name, number);
    InstalledItem item{preset->name.empty() ? name.stem().string() : preset->name,
                       fmt::format("{}/{}", moved.look, place.stem().string()),
                       number > 1 ? Status::renamed : Status::added};
    if (is_in_library(place)) {
        item.status = Status::present;
        m_installed.presets.push_back(std::move(item));
        return {};
    }
    if (auto media = install_media(packed, moved); !media)
        return media;
    m_installed.presets.push_back(std::move(item));
    return m_moves.move(file, m_library.roots().user / place);
}

Result<InstalledPack> Installer::install() {
    if (auto good = check(); !good)
        return fail(good.error());
    m_installed.name = m_manifest.name;
    for (const PackedLook& look : m_manifest.looks)
        if (auto installed = install_look(look); !installed)
            return fail(installed.error());
    for (const PackedPreset& preset : m_manifest.presets)
        if (auto installed = install_preset(preset); !installed)
            return fail(installed.error());
    m_moves.keep();
    return std::move(m_installed);
}

// The errors of files in a pack name the pack.
Diagnostics in_pack(Diagnostics problems, const fs::path& pack, const fs::path& folder) {
    for (Diagnostic& problem : problems) {
        const fs::path inside = problem.file.lexically_relative(folder);
        const bool is_inside = !inside.empty() && *inside.begin() != "..";
        if (is_inside || problem.file.is_relative())
            problem = {pack, 0,
                       fmt::format("{}{}: {}", (is_inside ? inside : problem.file).string(),
                                   problem.line > 0 ? fmt::format(":{}", problem.line) : "",
                                   problem.message)};
    }
    return problems;
}

std::string counted(std::size_t count, std::string_view one) {
    return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

std::string counts(const std::vector<InstalledItem>& looks,
                   const std::vector<InstalledItem>& presets, bool is_present) {
    const auto count = [&](const std::vector<InstalledItem>& items) {
        return static_cast<std::size_t>(
            std::ranges::count_if(items, [&](const InstalledItem& item) {
                return (item.status == Status::present) == is_present;
            }));
    };
    const std::size_t of_looks = count(looks);
    const std::size_t of_presets = count(presets);
    if (of_looks > 0 && of_presets > 0)
        return counted(of_looks, "look") + " and " + counted(of_presets, "preset");
    return of_looks > 0     ? counted(of_looks, "look")
           : of_presets > 0 ? counted(of_presets, "preset")
                            : std::string();
}
}  // namespace

Result<InstalledPack> install_pack(const fs::path& pack, const Library& library) {
    // On the disk of the user's folder, so that everything can be moved there at once.
    auto scratch = AtomicFolder::create(library.roots().user / "pack");
    if (!scratch)
        return fail(scratch.error());
    const fs::path folder = scratch->path();
    if (auto extracted = unzip(pack, folder, pack_limits); !extracted)
        return fail(extracted.error());
    const auto text = read_text(folder / pack_file);
    if (!text)
        return fail({pack, 0, fmt::format("is not a pack of Afterglow: it has no {}", pack_file)});
    auto manifest = parse_pack(*text, folder / pack_file);
    if (!manifest)
        return fail(in_pack(manifest.error(), pack, folder));
    auto installed = Installer(folder, library, std::move(*manifest)).install();
    return installed ? std::move(installed) : fail(in_pack(installed.error(), pack, folder));
}

std::string summary(const InstalledPack& installed) {
    const std::string added = counts(installed.looks, installed.presets, false);
    const std::string present = counts(installed.looks, installed.presets, true);
    if (added.empty())
        return fmt::format("You already have everything in '{}'.", installed.name);
    std::string text = fmt::format("Installed '{}': {}.", installed.name, added);
    if (!present.empty())
        text += fmt::format(" You already had {}.", present);
    return text;
}
