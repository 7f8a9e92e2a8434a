#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A folder that the file dialog offers.
struct Place {
    std::string name;
    std::filesystem::path folder;

    bool operator==(const Place&) const = default;
};

/// The user's folders of the desktop.
enum class UserFolder { desktop, documents, music, pictures, videos };

/// The folders that a user-dirs.dirs file of xdg-user-dirs names. Lines that are not
/// XDG_NAME_DIR="$HOME/..." or an absolute path are skipped, as are folders equal to `home`, which
/// mean that there is none.
std::vector<Place> parse_user_folders(std::string_view text, const std::filesystem::path& home);

/// Home and the folders of the desktop that exist, then mounted drives.
std::vector<Place> desktop_places(const std::filesystem::path& home);

/// The folder of the desktop, or `home` if it does not exist.
std::filesystem::path user_folder(UserFolder which, const std::filesystem::path& home);
