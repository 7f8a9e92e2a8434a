#include "formats/effect/built_in_value.h"

#include <doctest/doctest.h>

namespace {
class Host final : public HostValues {
public:
    HostSize target() override { return {"size"}; }
    HostSize output() override { return {"whole.xy", "whole"}; }
    HostSize source() override { return {"source"}; }
    HostSize raster() override { return {"raster"}; }
    HostSize input(const Input& input) override { return {"size_of_" + input.name}; }
    std::string frames_before() override { return "n"; }
    std::string time() override { return "t"; }
    std::string time_before() override { return "before"; }
    std::string time_delta() override { return "dt"; }
    std::string date() override { return {}; }
    std::string press() override { return pressed; }

    std::string pressed;
};

std::string value_of(BuiltIn kind, const NumberType& type, const Pass& pass = {}) {
    Host host;
    return built_in_value({"u", kind}, type, pass, host);
}

constexpr NumberType one{};
constexpr NumberType whole{Scalar::integer, 1, 1};
constexpr NumberType two{Scalar::floating, 2, 1};
constexpr NumberType four{Scalar::floating, 4, 1};
}  // namespace

// Frame n + 1 is the current one. Both numbers are taken modulo the pass's own number.
TEST_CASE("frames are counted from 1 and from 0, modulo the number of the pass") {
    CHECK(value_of(BuiltIn::frame, whole) == "n + 1");
    CHECK(value_of(BuiltIn::frame_index, whole) == "n");
    Pass pass;
    pass.frame_modulo = 4;
    CHECK(value_of(BuiltIn::frame, whole, pass) == "((n + 1) % 4)");
    CHECK(value_of(BuiltIn::frame_index, whole, pass) == "((n) % 4)");
}

TEST_CASE("values get the type of their uniform") {
    CHECK(value_of(BuiltIn::frame, one) == "float(n + 1)");
    CHECK(value_of(BuiltIn::target_size, two) == "size");
    CHECK(value_of(BuiltIn::output_size, {Scalar::integer, 2, 1}) == "ivec2(whole.xy)");
}

TEST_CASE("an extent is the host's own, or made of a size") {
    CHECK(value_of(BuiltIn::output_extent, four) == "whole");
    CHECK(value_of(BuiltIn::target_extent, four) == "vec4(size, 1.0 / size)");
}

TEST_CASE("what a host does not give is 0") {
    CHECK(value_of(BuiltIn::mouse, two) == "vec2(0.0, 0.0)");
    CHECK(value_of(BuiltIn::press, four) == "vec4(0.0, 0.0, 0.0, 0.0)");
    CHECK(value_of(BuiltIn::date_from_0, four) == "vec4(0.0, 0.0, 0.0, 0.0)");
}

TEST_CASE("the mouse of a host is its position and its button") {
    Host host;
    host.pressed = "iMouse";
    CHECK(built_in_value({"u", BuiltIn::mouse}, two, {}, host) == "iMouse.xy");
    CHECK(built_in_value({"u", BuiltIn::press}, four, {}, host) == "iMouse");
}
