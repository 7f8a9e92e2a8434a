#include "glsl/text/shader_files.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <chrono>

namespace fs = std::filesystem;

namespace {
// The time must be the one of the file, because a recent stamp is not used.
std::optional<FileStamp> stamp_of_file(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    if (error)
        return std::nullopt;
    const auto seconds = std::chrono::floor<std::chrono::seconds>(
        std::chrono::file_clock::to_sys(time).time_since_epoch());
    return FileStamp{.bytes = fs::file_size(file), .modified = {seconds.count(), 0}};
}

std::string text_of(ShaderFiles& files, const fs::path& file) {
    const auto& read = files.read(file);
    return read ? read->text : read.error().front().message;
}
}  // namespace

TEST_CASE("a file stays the same during one reading, and is read again in the next") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.glsl", "float a;\r\n");
    const fs::path missing = folder / "b.glsl";
    ShaderFiles files;
    files.begin_reading();
    CHECK(text_of(files, file) == "float a;\n");
    CHECK_FALSE(files.exists(missing));

    folder.write("a.glsl", "float b;\n");  // the same size, within one tick of the file's clock
    folder.write("b.glsl", "float c;\n");
    CHECK(text_of(files, file) == "float a;\n");
    CHECK_FALSE(files.exists(missing));

    files.begin_reading();
    CHECK(text_of(files, file) == "float b;\n");
    CHECK(files.exists(missing));

    fs::remove(file);
    files.begin_reading();
    CHECK(text_of(files, file) == "file not found");
    CHECK(files.canonical_path(file).empty());
}

TEST_CASE("a link is resolved again at each reading") {
    const TemporaryFolder folder;
    fs::create_directories(folder / "in");
    folder.write("in/a.glsl", "float a;\n");
    folder.write("b.glsl", "float a;\n");
    const fs::path link = folder / "in/link.glsl";
    fs::create_symlink(folder / "in/a.glsl", link);
    ShaderFiles files;
    files.begin_reading();
    CHECK(files.read(link)->canonical == fs::canonical(folder / "in/a.glsl"));

    fs::remove(link);
    fs::create_symlink(folder / "b.glsl", link);
    files.begin_reading();
    CHECK(files.read(link)->canonical == fs::canonical(folder / "b.glsl"));  // the text is the same
}

TEST_CASE("an unchanged file is read once") {
    const TemporaryFolder folder;
    const fs::path shaders = fs::path(AFTERGLOW_SOURCE_DIR) / "shaders/include";
    const fs::path link = folder / "link.glsl";
    fs::create_symlink(shaders / "color.glsl", link);
    ShaderFiles files(stamp_of_file);
    files.begin_reading();
    const std::string color = text_of(files, link);
    CHECK(files.reads() == 1);

    files.begin_reading();
    CHECK(files.canonical_path(link) == fs::canonical(shaders / "color.glsl"));
    CHECK(text_of(files, link) == color);
    CHECK(files.reads() == 1);

    fs::remove(link);
    fs::create_symlink(shaders / "mask.glsl", link);
    files.begin_reading();
    CHECK(files.canonical_path(link) == fs::canonical(shaders / "mask.glsl"));
    CHECK(text_of(files, link) != color);
    CHECK(files.reads() == 2);

    files.begin_reading();  // nothing is read in this one
    files.begin_reading();
    CHECK(text_of(files, link) != color);
    CHECK(files.reads() == 3);
}

TEST_CASE("without stamps an unchanged file is read once per reading") {
    const fs::path file = fs::path(AFTERGLOW_SOURCE_DIR) / "shaders/include/color.glsl";
    ShaderFiles files;
    for (int reading = 1; reading < 3; ++reading) {
        files.begin_reading();
        files.read(file);
        files.read(file);
        CHECK(files.reads() == reading);
    }
}

TEST_CASE("directives of a file are parsed with its text") {
    const TemporaryFolder folder;
    ShaderFiles files;
    const auto& read = files.read(folder.write("a.glsl",
                                               "#pragma once\n"
                                               "#include \"one.glsl\"  // first\n"
                                               "#include <two>\n"
                                               "#include three\n"
                                               "#line 40\n"
                                               "float a;\n"));
    REQUIRE(read.has_value());
    CHECK(read->is_once);
    CHECK(read->unclosed_comment == 0);
    CHECK(read->text.find("pragma") == std::string::npos);
    CHECK(read->text.find("#line") == std::string::npos);
    REQUIRE(read->includes.size() == 3);
    CHECK(read->includes[0].file == "one.glsl");
    CHECK(read->includes[1].given == "two");
    CHECK_FALSE(read->includes[2].file.has_value());
    CHECK_FALSE(read->includes[2].given.has_value());
    CHECK(read->includes[2].line == 4);
}
