#include "lab/media/read_ahead.h"

#include <doctest/doctest.h>

namespace {
Picture gray(float value) {
    return {{1, 1}, 3, Encoding::linear, std::vector<float>(3, value)};
}

/// Reads everything that is requested, with the number as the value.
std::vector<std::int64_t> read_all(ReadAhead& pictures, std::optional<std::int64_t> count) {
    std::vector<std::int64_t> numbers;
    while (const auto number = pictures.next_to_read()) {
        numbers.push_back(*number);
        pictures.add(*number, gray(static_cast<float>(*number)), count);
    }
    return numbers;
}
}  // namespace

TEST_CASE("the requested picture is read first, then the next few") {
    ReadAhead pictures(100, false);
    pictures.request(7);
    CHECK_FALSE(pictures.is_ready());
    CHECK(pictures.requested() == nullptr);
    CHECK(read_all(pictures, 100) == std::vector<std::int64_t>{7, 8, 9, 10, 11, 12, 13, 14});
    REQUIRE(pictures.is_ready());
    CHECK(pictures.requested()->pixels[0] == 7.0f);
    pictures.request(8);
    CHECK(read_all(pictures, 100) == std::vector<std::int64_t>{15});
    pictures.request(7);  // was removed
    CHECK_FALSE(pictures.is_ready());
}

TEST_CASE("after its end a film loops or holds its last picture") {
    ReadAhead pictures(3, true);
    pictures.request(4);
    CHECK(read_all(pictures, 3) == std::vector<std::int64_t>{1, 2, 0});
    CHECK(pictures.requested()->pixels[0] == 1.0f);
    pictures.set_loop(false);
    CHECK(pictures.requested()->pixels[0] == 2.0f);
}

TEST_CASE("an unreadable picture shows the previous one") {
    ReadAhead pictures(std::nullopt, false);
    pictures.add(0, gray(0.5f), std::nullopt);
    pictures.add(1, std::nullopt, std::nullopt);
    pictures.request(1);
    CHECK(pictures.requested()->pixels[0] == 0.5f);
    pictures.add(2, std::nullopt, 2);  // the end
    pictures.request(2);
    CHECK(pictures.requested()->pixels[0] == 0.5f);
}

TEST_CASE("a film without pictures is ready and shows none") {
    ReadAhead pictures(0, true);
    pictures.request(5);
    CHECK(pictures.is_ready());
    CHECK(pictures.requested() == nullptr);
    CHECK_FALSE(pictures.next_to_read().has_value());
}
