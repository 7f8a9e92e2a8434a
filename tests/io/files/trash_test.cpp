// Checked against the Trash specification 1.0 of freedesktop.org.
#include "io/files/trash.h"

#include "base/file.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <optional>
#include <regex>

namespace fs = std::filesystem;

namespace {
/// Sets XDG_DATA_HOME during its lifetime.
class DataHome {
public:
    explicit DataHome(const fs::path& folder) {
        if (const char* current = std::getenv("XDG_DATA_HOME"))
            m_before = current;
        setenv("XDG_DATA_HOME", folder.c_str(), 1);
    }
    ~DataHome() {
        if (m_before)
            setenv("XDG_DATA_HOME", m_before->c_str(), 1);
        else
            unsetenv("XDG_DATA_HOME");
    }
    DataHome(const DataHome&) = delete;
    DataHome& operator=(const DataHome&) = delete;

private:
    std::optional<std::string> m_before;
};
}  // namespace

TEST_CASE("a file is moved to the trash with its path and date, and is restored") {
    const TemporaryFolder folder;
    const DataHome home(folder / "data");
    const fs::path file = folder.write("My pr\xc3\xa4set 50%.json", "{}");
    const auto trashed = move_to_trash(file);
    REQUIRE(trashed.has_value());
    CHECK_FALSE(fs::exists(file));
    CHECK(trashed->file == folder / "data/Trash/files/My pr\xc3\xa4set 50%.json");
    CHECK(trashed->info == folder / "data/Trash/info/My pr\xc3\xa4set 50%.json.trashinfo");
    const std::string info = read_text(trashed->info).value();
    const std::string place = "Path=" + folder.path().string() + "/My%20pr%C3%A4set%2050%25.json\n";
    CHECK(info.starts_with("[Trash Info]\n" + place));
    CHECK(std::regex_search(
        info, std::regex("\nDeletionDate=\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d\n$")));

    REQUIRE(restore_from_trash(*trashed).has_value());
    CHECK(read_text(file) == "{}");
    CHECK_FALSE(fs::exists(trashed->file));
    CHECK_FALSE(fs::exists(trashed->info));
}

TEST_CASE("files with the same name stay separate in the trash") {
    const TemporaryFolder folder;
    const DataHome home(folder / "data");
    std::vector<TrashedFile> all;
    for (const char* text : {"first", "second"}) {
        const auto trashed = move_to_trash(folder.write("a.json", text));
        REQUIRE(trashed.has_value());
        all.push_back(*trashed);
    }
    CHECK(all[0].file != all[1].file);
    CHECK(read_text(all[0].file) == "first");
    CHECK(read_text(all[1].file) == "second");
    REQUIRE(restore_from_trash(all[0]).has_value());
    const auto taken = restore_from_trash(all[1]);
    REQUIRE_FALSE(taken.has_value());  // another file exists at its path
    CHECK(read_text(all[1].file) == "second");
}

TEST_CASE("a file that cannot be moved to the trash stays, and the error names it") {
    const TemporaryFolder folder;
    const DataHome home(folder / "data");
    const auto missing = move_to_trash(folder / "gone.json");
    REQUIRE_FALSE(missing.has_value());
    CHECK(missing.error().front().file == folder / "gone.json");
}
