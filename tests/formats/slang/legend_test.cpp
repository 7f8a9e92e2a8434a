#include "formats/slang/legend.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace {
// Formatted as "Label: 0=off 1=on".
std::string read_legend(const std::string& text, int low, int high) {
    const SlangLegend legend = parse_slang_legend(text, low, high);
    std::string read = legend.label + ":";
    for (const Item& item : legend.items)
        read += fmt::format(" {}={}", item.value, item.label);
    return read;
}
}  // namespace

TEST_CASE("a legend in brackets names each value") {
    CHECK(read_legend("Beam (off, fast, exact)", 0, 2) == "Beam: 0=off 1=fast 2=exact");
    CHECK(read_legend("    Table [ None | Warm | Cold ]", 1, 3) == "Table: 1=None 2=Warm 3=Cold");
    CHECK(read_legend("Fix (a/b/c)", 0, 2) == "Fix: 0=a 1=b 2=c");
    CHECK(read_legend("Order (first; second, third)", 0, 1) == "Order: 0=first 1=second, third");
}

TEST_CASE("a legend may follow a dash or a colon") {
    CHECK(read_legend("Cover - ALL | TUBE- | GLASS", 0, 2) == "Cover: 0=ALL 1=TUBE- 2=GLASS");
    CHECK(read_legend("Deep - Blend: ADD | MUL", 0, 1) == "Deep - Blend: 0=ADD 1=MUL");
    CHECK(read_legend("Gamut: sRGB, P22, Trinitron", 0, 2) == "Gamut: 0=sRGB 1=P22 2=Trinitron");
    CHECK(read_legend("White: A (warm) | B (cold)", 0, 1) == "White: 0=A (warm) 1=B (cold)");
}

TEST_CASE("counting numbers are removed from the names") {
    CHECK(read_legend("Layout (0: RGB, 1: BGR)", 0, 1) == "Layout: 0=RGB 1=BGR");
    CHECK(read_legend("Lines [0 OFF | 1 ON]", 0, 1) == "Lines: 0=OFF 1=ON");
    CHECK(read_legend("Turn - -1:AUTO | UP | DOWN", -1, 1) == "Turn: -1=-1:AUTO 0=UP 1=DOWN");
    CHECK(read_legend("Out (0: sRGB, 1: 2.2 gamma)", 0, 1) == "Out: 0=sRGB 1=2.2 gamma");
    CHECK(read_legend("Phase: Auto | 2 phase | 3 phase", 1, 3) ==
          "Phase: 1=Auto 2=2 phase 3=3 phase");
    CHECK(read_legend("  0: OFF | 1: LINES | 2: BOTH", 0, 2) == ": 0=OFF 1=LINES 2=BOTH");
}

TEST_CASE("names with explicit numbers may skip values") {
    CHECK(read_legend("Mask: 0:Grey, 1-3:Slot, 5:Dots", -1, 6) ==
          "Mask: 0=Grey 1=Slot (1) 2=Slot (2) 3=Slot (3) 5=Dots");
    CHECK(read_legend("Mode (1=Full 2=Cold)", 0, 2) == "Mode: 1=Full 2=Cold");
    CHECK(read_legend("Tube (-2:Old -1:New 1:LCD)", -3, 3) == "Tube: -2=Old -1=New 1=LCD");
    CHECK(read_legend("Side (0-Auto, 1-Wide)", 0, 2) == "Side: 0=Auto 1=Wide");
    CHECK(read_legend("Tint (0=OFF, 1/2=Warm)", 0, 2) == "Tint: 0=OFF 1=Warm (1) 2=Warm (2)");
    CHECK(read_legend("Fix 1.0:Sun, 2:Moon/Star", 0, 2) == "Fix: 1=Sun 2=Moon/Star");
    CHECK(read_legend("Scan (0 = none)", 0, 4) == "Scan: 0=none");
}

TEST_CASE("names that do not match the values are not a legend") {
    CHECK(read_legend("Cover - ALL | TUBE", -2, 2) == "Cover - ALL | TUBE:");
    CHECK(read_legend("Filter (smooth, sharp)", 0, 4) == "Filter (smooth, sharp):");
    CHECK(read_legend("Rainbow (2-phase)", 0, 3) == "Rainbow (2-phase):");
    CHECK(read_legend("Ratio 4:3 16:9", 0, 4) == "Ratio 4:3 16:9:");
    CHECK(read_legend("Mode 3=a 1=b", 0, 3) == "Mode 3=a 1=b:");
    CHECK(read_legend("Bypass (Y/C)", 0, 1) == "Bypass (Y/C):");
    CHECK(read_legend("Triads 0: count", 1, 4) == "Triads 0: count:");
    CHECK(read_legend("Res (1-Native, 2/3-Low/+, 4/5-High/+)", 1, 5) ==
          "Res: 1=Native 2=Low/+ (2) 3=Low/+ (3) 4=High/+ (4) 5=High/+ (5)");
}

TEST_CASE("On/Off at the end is a switch") {
    CHECK(read_legend("Vignette On/Off", 0, 1) == "Vignette: 0=Off 1=On");
    CHECK(read_legend("Glow (ON/OFF)", 0, 1) == "Glow: 0=Off 1=On");
    CHECK(read_legend("Linear [ YES | NO ]", 0, 1) == "Linear: 0=YES 1=NO");
    CHECK(read_legend("Steps On/Off", 0, 2) == "Steps On/Off:");
}

TEST_CASE("without brackets, a list with exactly one name per value is a legend") {
    CHECK(read_legend("Palette Hercules/CGA/EGA", 0, 2) == "Palette: 0=Hercules 1=CGA 2=EGA");
    CHECK(read_legend("Dot Mask, Fine/Coarse/LCD", 0, 2) == "Dot Mask: 0=Fine 1=Coarse 2=LCD");
    CHECK(read_legend("Cable, Antenna, S-Video", 0, 2) == ": 0=Cable 1=Antenna 2=S-Video");
    CHECK(read_legend("SNES, Sega/PS1, PCE, A26", 1, 4) == ": 1=SNES 2=Sega/PS1 3=PCE 4=A26");
    CHECK(read_legend("Flat | Deep", 0, 1) == ": 0=Flat 1=Deep");
    CHECK(read_legend("Bend Mode  OFF | 2D | 3D", 0, 2) == "Bend Mode: 0=OFF 1=2D 2=3D");
    CHECK(read_legend("Morph Range 0-all 1-hor 2-vert", 0, 2) == "Morph Range: 0=all 1=hor 2=vert");
}

TEST_CASE("a list with another number of names is part of the label") {
    CHECK(read_legend("Palette Hercules/CGA/EGA", 0, 3) == "Palette Hercules/CGA/EGA:");
    CHECK(read_legend("Cable, Antenna, S-Video", 0, 4) == "Cable, Antenna, S-Video:");
    CHECK(read_legend("Red, Green", 0, 1) == "Red, Green:");
    CHECK(read_legend("Mix Y/C", 0, 1) == "Mix Y/C:");
    CHECK(read_legend("Morph 1-hor 2-vert", 0, 2) == "Morph 1-hor 2-vert:");
}
