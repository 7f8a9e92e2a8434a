#include "lab/files/places.h"

#include "base/file.h"
#include "base/text.h"
#include "lab/files/folder_listing.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace fs = std::filesystem;

namespace {
struct KnownFolder {
    UserFolder which;
    std::string_view variable;
    const char* name;  // in English, also its default below the home folder
};
constexpr std::array known_folders{
    KnownFolder{UserFolder::desktop, "XDG_DESKTOP_DIR", "Desktop"},
    KnownFolder{UserFolder::documents, "XDG_DOCUMENTS_DIR", "Documents"},
    KnownFolder{UserFolder::music, "XDG_MUSIC_DIR", "Music"},
    KnownFolder{UserFolder::pictures, "XDG_PICTURES_DIR", "Pictures"},
    KnownFolder{UserFolder::videos, "XDG_VIDEOS_DIR", "Videos"}};

// The value of a shell assignment in double quotes; "": not one.
std::string quoted_value(std::string_view text) {
    text = trim(text);
    if (text.size() < 2 || text.front() != '"' || text.back() != '"')
        return {};
    std::string value;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        i += text[i] == '\\' && i + 2 < text.size() ? 1 : 0;
        value += text[i];
    }
    return value;
}

fs::path folder_of_value(const std::string& value, const fs::path& home) {
    constexpr std::string_view home_variable = "$HOME";
    if (value == home_variable || value.starts_with("$HOME/"))
        return (home.string() + value.substr(home_variable.size()));
    return value.starts_with('/') ? fs::path(value) : fs::path();
}

fs::path without_last_slash(const fs::path& folder) {
    const fs::path normal = folder.lexically_normal();
    return normal.has_filename() ? normal : normal.parent_path();
}

std::vector<Place> configured_folders(const fs::path& home) {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const fs::path folder = config && *config == '/' ? fs::path(config) : home / ".config";
    const auto text = read_text(folder / "user-dirs.dirs");
    return text ? parse_user_folders(*text, home) : std::vector<Place>();
}

// The named folder, or its default below the home folder.
fs::path folder_of(const KnownFolder& known, const std::vector<Place>& configured,
                   const fs::path& home) {
    const auto found = std::ranges::find(configured, known.name, &Place::name);
    return found == configured.end() ? home / known.name : found->folder;
}

// Drives that the desktop has mounted for this user.
std::vector<Place> drives() {
    std::vector<Place> found;
    const char* user = std::getenv("USER");
    if (!user || !*user)
        return found;
    for (const fs::path& parent : {fs::path("/media") / user, fs::path("/run/media") / user}) {
        std::error_code error;
        for (fs::directory_iterator drive(parent, error), end; !error && drive != end;
             drive.increment(error))
            found.push_back({drive->path().filename().string(), drive->path()});
    }
    std::ranges::sort(found, {}, &Place::name);
    return found;
}
}  // namespace

std::vector<Place> parse_user_folders(std::string_view text, const fs::path& home) {
    std::vector<Place> places;
    for (const std::string_view line : split_lines(text)) {
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos)
            continue;
        const auto known =
            std::ranges::find(known_folders, trim(line.substr(0, equals)), &KnownFolder::variable);
        if (known == known_folders.end())
            continue;
        const fs::path folder =
            without_last_slash(folder_of_value(quoted_value(line.substr(equals + 1)), home));
        if (!folder.empty() && folder != without_last_slash(home))
            places.push_back({known->name, folder});
    }
    return places;
}

std::vector<Place> desktop_places(const fs::path& home) {
    std::vector<Place> places{{"Home", home}};
    const std::vector<Place> configured = configured_folders(home);
    for (const KnownFolder& known : known_folders)
        if (const fs::path folder = folder_of(known, configured, home); is_folder(folder))
            places.push_back({known.name, folder});
    for (Place& drive : drives())
        places.push_back(std::move(drive));
    return places;
}

fs::path user_folder(UserFolder which, const fs::path& home) {
    const auto known = std::ranges::find(known_folders, which, &KnownFolder::which);
    const fs::path folder = folder_of(*known, configured_folders(home), home);
    return is_folder(folder) ? folder : home;
}
