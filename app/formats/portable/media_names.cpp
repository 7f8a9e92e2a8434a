#include "formats/portable/media_names.h"

#include "formats/scene/scene_file.h"
#include "io/pictures/frame_names.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/generated_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace fs = std::filesystem;

std::string safe_name(const std::string& name) {
    std::string safe;
    for (const char letter : name)
        safe += std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' ||
                        letter == '_' || (letter == '.' && !safe.empty())
                    ? letter
                    : '-';
    return safe.empty() ? "unnamed" : safe;
}

std::string MediaNames::add(const fs::path& file) {
    for (const auto& [copy, original] : m_files)
        if (original == file)
            return copy;
    const fs::path name = safe_name(file.filename().string());
    std::string copy = "media/" + name.string();
    for (int number = 2; m_files.contains(copy) || m_generated.contains(copy); ++number)
        copy =
            fmt::format("media/{}-{}{}", name.stem().string(), number, name.extension().string());
    m_files.emplace(copy, file);
    return copy;
}

// The copies have the names of the pictures, in a folder of their own.
std::string MediaNames::add_sequence(const fs::path& names) {
    constexpr int most_numbers = 100000;
    const std::string folder = fmt::format("media/{}/", safe_name(names.stem().string()));
    const auto parsed = parse_frame_names(names.string());
    std::error_code error;
    for (int number = 0; number < most_numbers; ++number)
        if (const fs::path file = parsed->name(number); fs::exists(file, error))
            m_files.emplace(folder + file.filename().string(), file);
    return folder + names.filename().string();
}

Result<std::string> MediaNames::add_source(const std::string& source) {
    auto spec = parse_source(source);
    if (!spec || spec->picture.empty())
        return source;
    if (made_name(spec->picture)) {
        auto copy = add_generated(spec->picture);
        if (!copy)
            return fail(copy.error());
        spec->picture = std::move(*copy);
        return to_string(*spec);
    }
    const auto names = parse_frame_names(spec->picture);
    spec->picture =
        names && names->is_sequence() ? add_sequence(spec->picture) : add(spec->picture);
    return to_string(*spec);
}

Result<std::string> MediaNames::add_generated(const std::string& name) {
    if (const auto known = m_generated_paths.find(name); known != m_generated_paths.end())
        return known->second;
    const auto picture = made_picture(name);
    if (!picture)
        return fail(picture.error());
    auto file = exact_picture_file(*picture);
    if (!file)
        return fail(file.error());
    const std::string stem = safe_name(std::string(*made_name(name)));
    std::string path = fmt::format("media/{}{}", stem, file->extension);
    for (int number = 2; m_files.contains(path) || m_generated.contains(path); ++number)
        path = fmt::format("media/{}-{}{}", stem, number, file->extension);
    m_generated.emplace(path, std::move(*file));
    m_generated_paths.emplace(name, path);
    return path;
}

std::string MediaNames::add_signal(const fs::path& file) {
    const auto others = is_scene_file(file) ? files_of_scene(file) : std::vector<fs::path>();
    if (others.empty())
        return add(file);
    const std::string folder = fmt::format("media/{}/", safe_name(file.stem().string()));
    for (const fs::path& other : others)
        m_files.emplace(folder + other.generic_string(), file.parent_path() / other);
    std::string copy = folder + safe_name(file.filename().string());
    m_files.emplace(copy, file);
    return copy;
}
