#include "formats/portable/media_names.h"

#include "io/temporary_folder.h"
#include "signals/patterns/generated_picture.h"

#include <doctest/doctest.h>

TEST_CASE("names of files have no characters with a meaning in paths") {
    CHECK(safe_name("game-1_a.png") == "game-1_a.png");
    CHECK(safe_name("../../etc/passwd") == "-.-..-etc-passwd");
    CHECK(safe_name(".hidden") == "-hidden");
    CHECK(safe_name("a b\n\"<") == "a-b---");
    CHECK(safe_name("") == "unnamed");
    CHECK(safe_name("crt/mask") == "crt-mask");
}

TEST_CASE("a file has one copy, and equal names get numbers") {
    MediaNames media;
    CHECK(media.add("/one/a.png") == "media/a.png");
    CHECK(media.add("/two/a.png") == "media/a-2.png");
    CHECK(media.add("/one/a.png") == "media/a.png");
    CHECK(media.files().size() == 2);
    CHECK(media.files().at("media/a-2.png") == "/two/a.png");
}

TEST_CASE("a source keeps its settings, and a sequence all its pictures") {
    const TemporaryFolder folder;
    for (const char* name : {"f_0001.png", "f_0002.png", "f_0010.png", "f_x.png"})
        folder.write(name, "");
    MediaNames media;
    CHECK(media.add_source("pattern:smpte,fit=whole") == "media/smpte.png,fit=whole");
    CHECK(media.generated().at("media/smpte.png").picture == *made_picture("pattern:smpte"));
    CHECK(media.add_source("/a/game.png,fit=whole") == "media/game.png,fit=whole");
    CHECK(media.add_source((folder / "f_%04d.png").string() + ",rate=25") ==
          "media/f_-04d/f_%04d.png,rate=25");
    CHECK(media.files().size() == 4);
    CHECK(media.files().at("media/f_-04d/f_0010.png") == folder / "f_0010.png");
}

TEST_CASE("a scene is copied with the files of its items, and none from outside its folder") {
    const TemporaryFolder folder;
    const auto scene = folder.write("my ship.json", R"({"format": "afterglow-scene", "version": 1,
        "items": [{"shape": "wireframe", "file": "parts/cube.obj"}, {"shape": "text", "text": "A"},
                  {"shape": "svg", "file": "../logo.svg"}, {"shape": "svg", "file": "/etc/passwd"}]})");
    MediaNames media;
    CHECK(media.add_signal(scene) == "media/my-ship/my-ship.json");
    CHECK(media.files() == std::map<std::string, std::filesystem::path>{
                               {"media/my-ship/my-ship.json", scene},
                               {"media/my-ship/parts/cube.obj", folder / "parts/cube.obj"}});
    CHECK(media.add_signal("/a/song.wav") == "media/song.wav");
    CHECK(media.add_source("solid:sky") == "media/sky.png");
}
