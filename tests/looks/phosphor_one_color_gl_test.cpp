// A phosphor of one colour stores one number per pixel and shows the same picture.
#include "looks/tube.h"
#include "model/picture/difference.h"

#include <doctest/doctest.h>

namespace {
Beam arc() {
    Beam beam;
    for (int i = 0; i < 200; ++i) {
        const float turn = static_cast<float>(i) / 40.0f;
        beam.push_back({0.7f * std::cos(turn), 0.6f * std::sin(2.0f * turn), 4.0f,
                        static_cast<float>(200 - i) / 12000.0f});
    }
    return beam;
}

Picture displayed(Tube& tube, const Values& values, bool is_one) {
    tube.restart(with(values, {{"one_color", Value(is_one ? 1.0 : 0.0)}}));
    for (int i = 0; i < 3; ++i)
        tube.draw(arc());
    return tube.target("composite");
}
}  // namespace

TEST_CASE("one colour shows the same picture from a single channel") {
    Tube tube({}, {96, 72});
    const Values common{{"beam_color", Value(std::vector<double>{0.3, 0.8, 0.1})},
                        {"dither", Value(0.0)}};
    for (const Values& values :
         {Values{}, Values{{"beam_kind", Value(1.0)}}, Values{{"bloom_kind", Value(1.0)}},
          Values{{"ceiling", Value(0.8)}},
          Values{{"aberration", Value(0.0)}, {"curvature", Value(0.0)}},
          Values{{"as_written", Value(1.0)}, {"ceiling", Value(1000.0)}}}) {
        CAPTURE(values.empty() ? "" : values.begin()->first);
        const Picture all = displayed(tube, with(common, values), false);
        const Picture one = displayed(tube, with(common, values), true);
        const auto apart = difference_between(all, one, 0.0);
        REQUIRE(apart.has_value());
        CHECK(apart->largest < 1e-4);
        const Picture persistence = tube.target("persistence");
        CHECK(persistence.channels == 1);
    }
}

TEST_CASE("the picture is the same whether or not the beam has its own target") {
    Tube apart({}, {96, 72});
    Tube onto({}, {96, 72});
    onto.look_at_the_last();
    const Values common{{"beam_color", Value(std::vector<double>{0.3, 0.8, 0.1})},
                        {"dither", Value(0.0)},
                        {"curvature", Value(0.1)}};
    for (const bool is_one : {false, true})
        for (const double ceiling : {0.8, 1000.0})
            for (const double as_written : {0.0, 1.0}) {
                CAPTURE(is_one);
                CAPTURE(ceiling);
                CAPTURE(as_written);
                const Values values =
                    with(common, {{"ceiling", Value(ceiling)}, {"as_written", Value(as_written)}});
                const Picture wanted = displayed(apart, values, is_one);
                const auto difference =
                    difference_between(wanted, displayed(onto, values, is_one), 0.0);
                CHECK_FALSE(apart.is_drawn_onto("beam"));
                REQUIRE(onto.is_drawn_onto("beam"));
                REQUIRE(difference.has_value());
                CHECK(difference->largest < 1e-4);
            }
}

TEST_CASE("a measured tube keeps its three terms, whatever the custom tube's settings") {
    Tube tube({}, {64, 64});
    const Values measured{{"tube", Value(9.0)}, {"dither", Value(0.0)}};
    CHECK(displayed(tube, measured, true) == displayed(tube, measured, false));
}
