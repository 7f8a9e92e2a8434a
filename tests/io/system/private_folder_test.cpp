#include "io/system/private_folder.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace fs = std::filesystem;

TEST_CASE("a private folder is created once, and refused if others can write to it") {
    const TemporaryFolder parent;
    const fs::path folder = parent / "sockets";
    CHECK(make_private_folder(folder) == PrivateFolder::ready);
    CHECK(fs::status(folder).permissions() == fs::perms::owner_all);
    CHECK(make_private_folder(folder) == PrivateFolder::ready);
    fs::permissions(folder, fs::perms::all);
    CHECK(make_private_folder(folder) == PrivateFolder::not_private);
    CHECK(make_private_folder(parent.write("file", "")) == PrivateFolder::not_private);
    fs::create_directory_symlink(parent.path(), parent / "link");
    CHECK(make_private_folder(parent / "link") == PrivateFolder::not_private);
    CHECK(make_private_folder(parent / "missing/sockets") == PrivateFolder::not_created);
}
