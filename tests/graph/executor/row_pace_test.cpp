#include "graph/executor/row_pace.h"

#include "about.h"

TEST_CASE("the first band is as small as can be") {
    CHECK(RowPace().rows_for(1.0, 720) == 2);
    CHECK(RowPace().rows_for(1.0, 1) == 1);
}

TEST_CASE("a band is as high as its time allows at the pace of the one before, and even") {
    RowPace pace;
    pace.note(100, 0.1);  // a thousandth each
    CHECK(pace.rows_for(0.0505, 720) == 50);
    CHECK(pace.rows_for(0.0515, 720) == 50);
    CHECK(pace.rows_for(0.0, 720) == 2);
    CHECK(pace.rows_for(0.05, 51) == 51);  // no row of its own for what is left over
    CHECK(pace.rows_for(0.05, 30) == 30);
}

TEST_CASE("bands grow step by step: the rows to come may take longer") {
    RowPace pace;
    pace.note(2, 1e-6);
    CHECK(pace.rows_for(1.0, 720) == 16);
    pace.note(16, 1e-6);
    CHECK(pace.rows_for(1.0, 720) == 128);
    pace.note(128, 1e-6);
    CHECK(pace.rows_for(1.0, 720) == 720);
    pace.note(720, 1.0);
    CHECK(pace.rows_for(0.02, 720) == 14);
}

TEST_CASE("after light rows at its end a pass does not begin with too many") {
    RowPace pace;
    pace.note(100, 0.19);  // the heavy ones
    pace.note(100, 0.01);
    pace.end_draw();  // a thousandth each, by and large
    CHECK(pace.rows_for(0.02, 200) == 20);
    pace.note(20, 0.08);                   // heavy again
    CHECK(pace.rows_for(0.02, 180) == 4);  // and a half
}
