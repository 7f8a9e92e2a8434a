// HDR signals compared with published values: ITU-R BT.2100, BT.2408 and BT.2087.
#include "model/picture/hdr.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
bool is_near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}
}  // namespace

TEST_CASE("PQ signals match the percentages of BT.2408, table 1 and annex 1") {
    struct Row {
        double nits;
        double percent;
    };
    for (const Row& row :
         {Row{0.0, 0.0}, Row{1.0, 15.0}, Row{10.0, 30.0}, Row{26.0, 38.0}, Row{100.0, 50.8},
          Row{203.0, 58.1}, Row{1000.0, 75.2}, Row{4000.0, 90.2}, Row{10000.0, 100.0}}) {
        CAPTURE(row.nits);
        CHECK(is_near(100.0 * pq_encode(row.nits), row.percent, 0.06));
        CHECK(is_near(pq_decode(pq_encode(row.nits)), row.nits, 1e-6 * (row.nits + 1.0)));
    }
}

TEST_CASE("HLG signals match BT.2408, table 1: grey 18 %, reference white and peak") {
    struct Row {
        double nits;
        double percent;
    };
    for (const Row& row : {Row{26.0, 38.0}, Row{203.0, 75.0}, Row{1000.0, 100.0}}) {
        CAPTURE(row.nits);
        for (const double one : hlg_encode({row.nits, row.nits, row.nits}, 1000.0))
            CHECK(is_near(100.0 * one, row.percent, 0.5));
    }
    // A display gives back the light, also of colours and other peaks.
    for (const double peak : {400.0, 1000.0, 2000.0})
        for (const Rgb& light : {Rgb{0.0, 0.0, 0.0}, {1.0, 20.0, 300.0}, {350.0, 30.0, 5.0}}) {
            const Rgb again = hlg_decode(hlg_encode(light, peak), peak);
            for (std::size_t i = 0; i < 3; ++i)
                CHECK(is_near(again[i], light[i], 1e-9 * peak));
        }
}

TEST_CASE("colours of BT.709 keep white and luminance in BT.2020") {
    const Rgb white = bt2020_of_bt709({1.0, 1.0, 1.0});
    for (const double one : white)
        CHECK(is_near(one, 1.0, 2e-4));
    // Luminance of the primaries: BT.709's coefficients.
    const std::array luminances{0.2126, 0.7152, 0.0722};
    for (std::size_t i = 0; i < 3; ++i) {
        Rgb light{};
        light[i] = 1.0;
        const Rgb moved = bt2020_of_bt709(light);
        CHECK(is_near(0.2627 * moved[0] + 0.6780 * moved[1] + 0.0593 * moved[2], luminances[i],
                      3e-4));
    }
}
