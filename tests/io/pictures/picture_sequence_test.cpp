#include "io/pictures/picture_sequence.h"

#include "io/pictures/picture_file.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace {
Picture level(float value, Extent extent = {2, 1}) {
    const auto count =
        3 * static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height);
    return {extent, 3, Encoding::linear, std::vector<float>(count, value)};
}

void save(const TemporaryFolder& folder, const char* name, const Picture& picture) {
    REQUIRE(save_picture(picture, folder / name).has_value());
}

float value_at(PictureReader& reader, std::int64_t number) {
    const auto picture = reader.read(number);
    REQUIRE(picture.has_value());
    REQUIRE(picture->has_value());
    return (**picture).pixels.front();
}
}  // namespace

TEST_CASE("a sequence runs from its lowest to its highest number") {
    const TemporaryFolder folder;
    save(folder, "f_0009.exr", level(9));
    save(folder, "f_0010.exr", level(10));
    save(folder, "f_0011.exr", level(11));
    save(folder, "f_12.exr", level(12));   // different number of digits
    save(folder, "g_0008.exr", level(8));  // different name
    const auto reader = open_sequence(folder / "f_%04d.exr");
    REQUIRE(reader.has_value());
    CHECK((*reader)->count() == 3);
    CHECK(value_at(**reader, 2) == 11.0f);
    CHECK(value_at(**reader, 0) == 9.0f);
    CHECK_FALSE((*reader)->read(3).value().has_value());
    CHECK(is_sequence_name("f_%d.png"));
    CHECK(is_sequence_name("100%_%03d.png") == false);
    CHECK_FALSE(is_sequence_name("f_%s.png"));
    CHECK_FALSE(is_sequence_name("100%.png"));
}

TEST_CASE(
    "missing, mismatched and damaged pictures of a sequence give errors, and the others load") {
    const TemporaryFolder folder;
    save(folder, "1.exr", level(1));
    save(folder, "3.exr", level(3));
    save(folder, "4.exr", level(4, {4, 1}));
    folder.write("5.exr", "no picture");
    const auto reader = open_sequence(folder / "%d.exr");
    REQUIRE(reader.has_value());
    const auto problem = [&](std::int64_t number) {
        const auto read = (*reader)->read(number);
        REQUIRE_FALSE(read.has_value());
        return read.error().front().message;
    };
    CHECK(value_at(**reader, 0) == 1.0f);
    CHECK(problem(1) == "picture 2 is missing. The sequence has 4 pictures, numbered 1 to 5.");
    CHECK(value_at(**reader, 2) == 3.0f);
    CHECK(problem(3) == "expected 2 x 1 px like the start of the sequence, got 4 x 1 px");
    CHECK_FALSE(problem(4).empty());
    CHECK(open_sequence(folder / "none_%d.png").error().front().message ==
          "no numbered pictures match this name");
    CHECK_FALSE(open_sequence(folder / "nowhere" / "f_%d.png").has_value());
}
