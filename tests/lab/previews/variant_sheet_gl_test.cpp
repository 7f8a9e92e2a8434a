// Filmstrips and contact sheets, drawn in the background.
#include "lab/previews/previews.h"
#include "lab/small_lab.h"

#include <cmath>

namespace {
constexpr const char* sheet_text = R"(#version 410 core
uniform sampler2D image;
uniform float red = 0.5;   // @range 0 1
uniform float green = 0.5; // @range 0 1  @label "Green light"
uniform int kind = 1;      // @items "None" "Some" "All"
uniform float size = 1.0;  // @range 0.1 10  @scale log
uniform vec2 place = vec2(0.0);
in vec2 uv;
out vec4 color;
void main() { color = vec4(red, green * float(kind), 0.0 * (texture(image, uv).r + size + place.x), 1.0); }
)";

class Laying : public SmallLab {
public:
    Laying() {
        write_by_rename("show.frag", sheet_text);
        REQUIRE(update_until([&] { return find_parameter(document().look(), "red"); }));
        update(5);
    }
    const VariantSheet& lay_out(const SheetRequest& request) {
        lab().frames().previews().sheet().begin(request);
        REQUIRE(update_until([&] { return !sheet().is_running(); }));
        return sheet();
    }
    const VariantSheet& sheet() { return lab().frames().previews().sheet(); }
    std::array<float, 4> color(std::size_t cell) {
        return gpu::read_pixel(sheet().cells()[cell].picture->texture(), 3, 3);
    }
};

// The sRGB encoding of light, as stored in an 8-bit picture.
double encoded(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

bool is_near_cell(float a, double b) {
    return std::abs(static_cast<double>(a) - b) <= 1.0 / 255.0;
}
}  // namespace

TEST_CASE("a filmstrip shows the look along a slider, and a click applies a value") {
    Laying small;
    const bool is_linear = small.document().look().output == Encoding::linear;
    const VariantSheet& strip = small.lay_out({.across = "red", .columns = 5});
    REQUIRE(strip.cells().size() == 5);
    CHECK(strip.columns() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
        const double light = static_cast<double>(i) / 4.0;
        CHECK(is_near_cell(small.color(i)[0], is_linear ? encoded(light) : light));
    }
    CHECK(strip.current(small.document()) == 2);
    small.lab().frames().previews().sheet().apply(3, *small.lab().work().document);
    CHECK(small.document().value(*find_parameter(small.document().look(), "red")) == Value(0.75));
    CHECK(small.document().history().undo_name() == "Apply Red 0.75");
    CHECK(strip.current(small.document()) == 3);
    small.update(2);
    CHECK_FALSE(small.sheet().is_running());  // applying a cell needs no new sheet
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.document().values().empty());
}

TEST_CASE("a contact sheet varies two parameters and is redrawn when others change") {
    Laying small;
    const VariantSheet& sheet =
        small.lay_out({.across = "red", .columns = 3, .down = "kind", .rows = 2});
    REQUIRE(sheet.cells().size() == 9);  // all items of a list are used
    CHECK(sheet.columns() == 3);
    CHECK(is_near_cell(small.color(0)[1], 0.0));
    CHECK(is_near_cell(small.color(7)[0], small.color(1)[0]));
    CHECK(is_near_cell(small.color(8)[0], 1.0));
    CHECK(sheet.cells()[8].values.caption == "Red 1, Kind: All");
    small.lab().frames().previews().sheet().apply(8, *small.lab().work().document);
    CHECK(small.document().values() == Values{{"kind", Value(2.0)}, {"red", Value(1.0)}});
    CHECK(small.document().history().past().size() == 1);

    small.lab().edit([](Document& document) { document.set_value("green", Value(0.0)); });
    small.lab().update(0.0);
    CHECK(small.sheet().is_running());
    REQUIRE(small.update_until([&] { return !small.sheet().is_running(); }));
    CHECK(is_near_cell(small.color(8)[1], 0.0));
}

TEST_CASE("the stops of an axis lie along its slider, and an invalid axis is reported") {
    Laying small;
    const Look& look = small.document().look();
    const auto axis = axis_along(look, *find_parameter(look, "size"), 3);
    REQUIRE(axis.has_value());
    CHECK(axis->stops[0].value == Value(0.1));
    CHECK(axis->stops[1].value == Value(1.0));
    CHECK(axis->stops[2].value == Value(10.0));
    const VariantSheet& none = small.lay_out({.across = "place"});
    CHECK(none.problem() == "Place: 'place' is not a single number and can't be swept");
    CHECK(small.lay_out({.across = "gone"}).problem() == "This look has no parameter \"gone\"");
    small.lab().frames().previews().sheet().cancel();
    CHECK(small.sheet().cells().empty());
    CHECK(small.sheet().problem().empty());
}
