#include "graph/executor/row_pace.h"

#include "about.h"

TEST_CASE("the first band has the minimum height") {
    CHECK(RowPace().rows_for(1.0, 720) == 2);
    CHECK(RowPace().rows_for(1.0, 1) == 1);
}

TEST_CASE("a band has the even height that fits its time at the previous pace") {
    RowPace pace;
    pace.note(100, 0.1);  // 0.001 s per row
    CHECK(pace.rows_for(0.0505, 720) == 50);
    CHECK(pace.rows_for(0.0515, 720) == 50);
    CHECK(pace.rows_for(0.0, 720) == 2);
    CHECK(pace.rows_for(0.05, 51) == 51);  // the last row is included, not left over
    CHECK(pace.rows_for(0.05, 30) == 30);
}

TEST_CASE("bands grow gradually, as later rows may take longer") {
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

TEST_CASE("cheap rows at the end of a pass do not make the next first band too large") {
    RowPace pace;
    pace.note(100, 0.19);  // the expensive rows
    pace.note(100, 0.01);
    pace.end_draw();  // 0.001 s per row on average
    CHECK(pace.rows_for(0.02, 200) == 20);
    pace.note(20, 0.08);                   // expensive again
    CHECK(pace.rows_for(0.02, 180) == 4);  // 4.5 rounded down
}
