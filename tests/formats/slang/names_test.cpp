#include "formats/slang/names.h"

#include <doctest/doctest.h>

namespace {
using Of = SlangPicture::Of;

const SlangNames names({"", "Blur", "UserPass"}, {"mask", "Source2"});

SlangPicture meant(std::string_view sampler) {
    const auto found = names.find(sampler);
    REQUIRE_MESSAGE(found.has_value(), sampler);
    return *found;
}

SlangPicture measured(std::string_view member) {
    const auto found = names.find_size(member);
    REQUIRE_MESSAGE(found.has_value(), member);
    return *found;
}
}  // namespace

TEST_CASE("built-in samplers are original, source, outputs, feedback and textures") {
    CHECK(meant("Original") == SlangPicture{Of::original, 0});
    CHECK(meant("Source") == SlangPicture{Of::source, 0});
    CHECK(meant("OriginalHistory0") == SlangPicture{Of::original, 0});
    CHECK(meant("OriginalHistory12") == SlangPicture{Of::original, 12});
    CHECK(meant("PassOutput3") == SlangPicture{Of::output, 3});
    CHECK(meant("PassFeedback0") == SlangPicture{Of::feedback, 0});
    CHECK(meant("User1") == SlangPicture{Of::image, 1});
}

TEST_CASE("aliases in the chain name passes, their feedback and textures") {
    CHECK(meant("Blur") == SlangPicture{Of::output, 1});
    CHECK(meant("BlurFeedback") == SlangPicture{Of::feedback, 1});
    CHECK(meant("mask") == SlangPicture{Of::image, 0});
    CHECK(measured("BlurSize") == SlangPicture{Of::output, 1});
    CHECK(measured("BlurFeedbackSize") == SlangPicture{Of::feedback, 1});
    CHECK(measured("maskSize") == SlangPicture{Of::image, 0});
    // "User" with a number would be a texture; "Source" alone would be the source.
    CHECK(meant("UserPass") == SlangPicture{Of::output, 2});
    CHECK(meant("Source2") == SlangPicture{Of::image, 1});
}

TEST_CASE("the number in a size's name follows Size") {
    CHECK(measured("OriginalSize") == SlangPicture{Of::original, 0});
    CHECK(measured("SourceSize") == SlangPicture{Of::source, 0});
    CHECK(measured("OriginalHistorySize2") == SlangPicture{Of::original, 2});
    CHECK(measured("PassOutputSize3") == SlangPicture{Of::output, 3});
    CHECK(measured("PassFeedbackSize1") == SlangPicture{Of::feedback, 1});
    CHECK(measured("UserSize0") == SlangPicture{Of::image, 0});
    for (const char* wrong : {"PassOutput3Size", "SourceSize2", "Size", "FeedbackSize", "blurSize"})
        CHECK_FALSE(names.find_size(wrong));
}

TEST_CASE("unknown names have no meaning") {
    for (const char* wrong : {"", "Feedback", "PassOutput", "PassOutput-1", "PassOutput1x",
                              "PassOutput99999999999", "original", "History1"})
        CHECK_FALSE(names.find(wrong));
    CHECK(find_slang_member("FrameCounter") == nullptr);
    CHECK(find_slang_member("FrameCount")->kind == BuiltIn::source_frame_index);
}
