#include "lab/files/places.h"

#include "io/system/environment.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

TEST_CASE("the folders of user-dirs.dirs are read") {
    const auto places = parse_user_folders(
        "# comment\n"
        "XDG_DESKTOP_DIR=\"$HOME/Schreibtisch\"\n"
        "XDG_MUSIC_DIR=\"/data/my \\\"music\\\"\"\n"
        "XDG_PICTURES_DIR=\"$HOME/\"\n"
        "XDG_TEMPLATES_DIR=\"$HOME/t\"\n"
        "XDG_VIDEOS_DIR=films\n"
        "XDG_DOCUMENTS_DIR=\"relative\"\n"
        "nonsense\n",
        "/home/me");
    CHECK(places == std::vector<Place>{{"Desktop", "/home/me/Schreibtisch"},
                                       {"Music", "/data/my \"music\""}});
}

TEST_CASE("places are the folders that exist") {
    const TemporaryFolder home;
    std::filesystem::create_directories(home / "Music");
    std::filesystem::create_directories(home / "Bilder");
    home.write(".config/user-dirs.dirs", "XDG_PICTURES_DIR=\"$HOME/Bilder\"\n");
    unset_environment("XDG_CONFIG_HOME");
    unset_environment("USER");
    CHECK(desktop_places(home.path()) == std::vector<Place>{{"Home", home.path()},
                                                            {"Music", home / "Music"},
                                                            {"Pictures", home / "Bilder"}});
    CHECK(user_folder(UserFolder::pictures, home.path()) == home / "Bilder");
    CHECK(user_folder(UserFolder::videos, home.path()) == home.path());
}
