#include "lab/offline/export.h"

#include <doctest/doctest.h>

TEST_CASE("a part contains every frame of its seconds, and at least one") {
    const auto part = [](double start, double seconds, double fps) {
        const ExportPart made = part_of(start, seconds, fps);
        return std::pair(made.first, made.end);
    };
    CHECK(part(0.0, 1.0, 60.0) == std::pair<std::int64_t, std::int64_t>(0, 60));
    CHECK(part(0.5, 0.3, 20.0) == std::pair<std::int64_t, std::int64_t>(10, 16));
    CHECK(part(2.0, 1.0 / 60.0, 60.0) == std::pair<std::int64_t, std::int64_t>(120, 121));
    CHECK(part(0.0, 1.001, 60.0) == std::pair<std::int64_t, std::int64_t>(0, 61));
    CHECK(part(0.0, 1e-4, 24.0) == std::pair<std::int64_t, std::int64_t>(0, 1));
    CHECK(part(3600.0, 0.1, 59.94) == std::pair<std::int64_t, std::int64_t>(215784, 215790));
}
