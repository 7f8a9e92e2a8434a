#include "base/font_file.h"

#include <array>
#include <cstdlib>
#include <mutex>

namespace {
struct OwnFonts {
    std::mutex mutex;
    std::string folder;  // "": none
};

OwnFonts& own_fonts() {
    static OwnFonts fonts;
    return fonts;
}
}  // namespace

void set_own_fonts(const std::filesystem::path& folder) {
    const std::lock_guard lock(own_fonts().mutex);
    own_fonts().folder = folder.string() + '/';
}

std::string find_font_file(std::initializer_list<const char*> names) {
    const std::string own = [] {
        const std::lock_guard lock(own_fonts().mutex);
        return own_fonts().folder;
    }();
    const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
    const std::array folders{std::string("/usr/share/fonts/opentype/inter/"),
                             std::string("/usr/share/fonts/truetype/inter/"),
                             std::string("/usr/share/fonts/inter/"),
                             std::string("/usr/share/fonts/truetype/dejavu/"),
                             std::string("/usr/share/fonts/TTF/"),
                             std::string("/usr/share/fonts/dejavu-sans-fonts/"),
                             std::string("/usr/share/fonts/dejavu-sans-mono-fonts/"),
                             std::string("/usr/share/fonts/dejavu/"),
                             home + "/.local/share/fonts/",
                             std::string("/System/Library/Fonts/"),
                             own};
    for (const char* name : names)
        for (const std::string& folder : folders)
            if (std::error_code error; std::filesystem::is_regular_file(folder + name, error))
                return folder + name;
    return {};
}
