#include "signals/patterns/pixel_art.h"

#include "signals/patterns/hash.h"
#include "signals/patterns/pixel_canvas.h"
#include "signals/patterns/resampled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace {
constexpr Extent native{320, 240};
constexpr int horizon = 146;
constexpr int quay = 204;  // edge between water and stones
constexpr double tau = 2.0 * std::numbers::pi;

enum Paint : PixelCanvas::Index {
    night,     // a
    indigo,    // b
    violet,    // c
    plum,      // d
    rose,      // e
    orange,    // f
    peach,     // g
    cream,     // h
    deep_sea,  // i
    sea,       // j
    foam,      // k
    stone,     // l
    shade,     // m
    wood,      // n
    red,       // o
    moss,      // p
};

const std::vector<PixelCanvas::Color> palette{
    0x120c26, 0x241a4e, 0x4a2474, 0x8a3480, 0xd2546e, 0xf58a52, 0xffbe6e, 0xfff0c0,
    0x16264e, 0x2a4a7c, 0x7aa8c8, 0x6a6480, 0x3a3552, 0x70422e, 0xc03440, 0x2c4a3c,
};

/// Six frames per second, enough for the water and the cat's tail.
int tick_of(double seconds) {
    return static_cast<int>(std::floor(seconds * 6.0 + 1e-6));
}

void draw_sky(PixelCanvas& canvas, int tick) {
    constexpr std::array<Paint, 6> steps{indigo, violet, plum, rose, orange, peach};
    for (int y = 0; y < horizon; ++y)
        for (int x = 0; x < canvas.width(); ++x) {
            const double down = std::pow(static_cast<double>(y) / horizon, 1.15) * 5.0;
            const auto step = std::min<std::size_t>(4, static_cast<std::size_t>(down));
            canvas.dithered(x, y, steps[step], steps[step + 1], down - static_cast<double>(step));
        }
    for (std::uint32_t i = 0; i < 70; ++i) {
        const int x = static_cast<int>(320.0 * hash_to_unit(i, 1));
        const int y = static_cast<int>(72.0 * hash_to_unit(i, 2) * hash_to_unit(i, 3));
        const bool twinkles = (tick / 2 + static_cast<int>(hash_of(i, 4) % 11)) % 11 == 0;
        canvas.set(x, y, twinkles ? plum : i % 3 == 0 ? cream : foam);
    }
    for (int y = -11; y <= 11; ++y)  // a crescent moon
        for (int x = -11; x <= 11; ++x)
            if (std::hypot(x, y) < 11.4 && std::hypot(x + 5, y + 3) > 10.2)
                canvas.set(262 + x, 30 + y, cream);
}

void draw_sun(PixelCanvas& canvas) {
    constexpr int x = 118;
    constexpr int y = 128;
    constexpr int radius = 33;
    for (int row = -radius; row <= radius; ++row) {
        const int half = static_cast<int>(std::sqrt(radius * radius - row * row));
        // Bars of haze, wider towards the horizon.
        const bool is_haze = row > -4 && (row + 4) % 7 < 1 + (row + 4) / 9;
        for (int column = -half; !is_haze && column <= half; ++column)
            canvas.dithered(x + column, y + row, cream, peach,
                            std::clamp((row + 22.0) / 40.0, 0.0, 1.0));
    }
}

void draw_cloud(PixelCanvas& canvas, int x, int y, int length, Paint color) {
    for (int row = 0; row < 4; ++row) {
        const int inset = std::abs(row - 2) * (length / 7) + row;
        for (int column = inset; column < length - inset; ++column)
            if (row > 0 || column % 5 != 0)
                canvas.set(x + column, y + row, color);
    }
}

double ridge(double x, std::uint32_t key) {
    double height = 0.0;
    double scale = 1.0;
    for (double step = 64.0; step >= 4.0; step /= 2.0, scale *= 0.5) {
        const double position = x / step;
        const auto left = static_cast<std::uint32_t>(position);
        const double part = position - left;
        const double low = hash_to_unit(left, key, static_cast<std::uint32_t>(step));
        const double high = hash_to_unit(left + 1, key, static_cast<std::uint32_t>(step));
        height += scale * (low + (high - low) * part);
    }
    return height;
}

void draw_hills(PixelCanvas& canvas) {
    for (int x = 0; x < canvas.width(); ++x) {
        const double far_side = std::abs(x - 118) / 200.0;  // lower at the sun
        const int far_top =
            horizon - static_cast<int>(8.0 + 20.0 * far_side * ridge(x, 7) + 6.0 * ridge(x, 7));
        for (int y = far_top; y < horizon; ++y)
            canvas.dithered(x, y, plum, rose, 0.55 * (y - far_top) / (horizon - far_top));
        const double near_side = std::max(0.0, std::abs(x - 130) / 190.0 - 0.3);
        const int near_top = horizon - static_cast<int>(34.0 * near_side * ridge(x, 19));
        for (int y = near_top; y < horizon; ++y)
            canvas.set(x, y, violet);
    }
}

void draw_sea(PixelCanvas& canvas, int tick) {
    for (int y = horizon; y < quay; ++y) {
        const double down = static_cast<double>(y - horizon) / (quay - horizon);
        for (int x = 0; x < canvas.width(); ++x)
            canvas.dithered(x, y, sea, deep_sea, 0.15 + 0.9 * down);
        // Short waves: longer and more widely spaced in the foreground.
        const int length = 3 + static_cast<int>(9.0 * down);
        for (int i = 0; i < 11; ++i) {
            const auto key = static_cast<std::uint32_t>(y * 16 + i);
            if (hash_to_unit(key, static_cast<std::uint32_t>(tick / 3)) > 0.34)
                continue;
            const int x = static_cast<int>(340.0 * hash_to_unit(key, 5)) - 10 + tick / 3 % 2;
            for (int column = 0; column < length; ++column)
                canvas.set(x + column, y, i % 4 == 0 ? plum : sea);
        }
        // The reflection of the sun on the water.
        const double spread = 24.0 + 26.0 * down;
        for (int i = 0; i < 9; ++i) {
            const auto key = static_cast<std::uint32_t>(y * 32 + i);
            const auto now = static_cast<std::uint32_t>(tick / 2);
            const double off = hash_to_unit(key, now) + hash_to_unit(key, now, 1) - 1.0;
            if (hash_to_unit(key, now, 2) < 0.25 + 0.4 * down)
                continue;
            const int x = 118 + static_cast<int>(spread * off);
            for (int column = 0; column < length; ++column)
                canvas.set(x + column, y,
                           std::abs(off) < 0.25  ? cream
                           : std::abs(off) < 0.5 ? peach
                                                 : orange);
        }
    }
}

void draw_boat(PixelCanvas& canvas, int tick) {
    constexpr std::array<std::string_view, 24> boat{
        "...........a..........", "..........ahh.........", "..........ahhg........",
        ".........hahhg........", ".........hahhgg.......", "........hhahhhg.......",
        "........hhahhhgg......", ".......hhhahhhhg......", ".......hhhahhhhgg.....",
        "......hhhhahhhhhg.....", "......hhhhahhhhhgg....", ".....hhhhhahhhhhhg....",
        ".....ghhhhahhhhhhgg...", "....ghhhhhahhhhhhhg...", "....gghhhhahhhhhhhgg..",
        "...ggghhhhaooooooooo..", "...gggghhhahhhhhhhhgg.", "..gggggghhahhhhhhhhhg.",
        "..........a...........", "nnnnnnnnnnnnnnnnnnnnnn", ".ohhhhhhhhhhhhhhhhhho.",
        "..nnnnnnnnnnnnnnnnnn..", "...naaaaaaaaaaaaaan...", "....aaaaaaaaaaaaaa....",
    };
    const int bob = static_cast<int>(std::lround(std::sin(tick * tau / 18.0)));
    canvas.sprite(176, 137 + bob, boat);
    for (int row = 0; row < 14; ++row)  // reflection in the water
        for (int column = 0; column < 18 - row; ++column)
            if ((row * 7 + column * 3 + tick) % 5 != 0 && row % 3 != 1)
                canvas.set(179 + column + row / 2 + (row + tick / 2) % 2, 162 + bob + row,
                           row < 4 ? wood : violet);
}

void draw_gulls(PixelCanvas& canvas, int tick) {
    constexpr std::array<std::array<int, 2>, 4> pixels{{{66, 62}, {79, 55}, {93, 64}, {214, 74}}};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto [x, y] = pixels[i];
        const int wing = (tick / 2 + static_cast<int>(i)) % 4 == 0 ? 1 : -1;
        canvas.set(x, y, night);
        for (int side : {-1, 1}) {
            canvas.set(x + side, y - 1, night);
            canvas.set(x + 2 * side, y - 1 + (wing < 0 ? -1 : 0), night);
            canvas.set(x + 3 * side, y - 1 + (wing < 0 ? -1 : 1), night);
        }
    }
}

void draw_light_beam(PixelCanvas& canvas, int x, int y, int tick) {
    const double turn = std::sin(tick * tau / 48.0);
    for (int column = 4; column < 150; ++column) {
        const int half = 1 + column / 9;
        for (int row = -half; row <= half; ++row) {
            const int px = x - column;
            const int py = y + row - static_cast<int>(column * 0.22 * turn);
            const double share =
                0.5 * (1.0 - column / 150.0) * (1.0 - std::abs(row) / (half + 1.0));
            if (py >= 0 && py < horizon)
                canvas.dithered(px, py, static_cast<Paint>(canvas.at(px, py)), peach, share);
        }
    }
}

void draw_lighthouse(PixelCanvas& canvas, int tick) {
    constexpr int x = 282;
    constexpr int top = 64;
    draw_light_beam(canvas, x, top + 5, tick);
    for (int row = 0; row < 46; ++row) {  // the rock
        const int half = 8 + row / 2 + static_cast<int>(7.0 * ridge(row * 3.0 + 40.0, 3));
        for (int column = -half; column <= half; ++column)
            canvas.dithered(x + column, 132 + row, shade, night,
                            0.25 + 0.5 * (column + half) / (2.0 * half) + 0.2 * ((row / 5) % 2));
    }
    for (int row = 12; row < 72; ++row) {  // the tower, wider at the bottom
        const int half = 7 + row / 14;
        const bool is_red = (row / 12) % 2 == 0;
        for (int column = -half; column <= half; ++column) {
            const double round = static_cast<double>(column) / half;
            if (is_red)
                canvas.dithered(x + column, top + row, red, violet, std::max(0.0, round));
            else
                canvas.dithered(x + column, top + row, cream, stone, std::max(0.0, 0.2 + round));
        }
    }
    canvas.rectangle(x - 2, top + 34, 4, 5, night);
    canvas.rectangle(x - 2, top + 58, 5, 9, night);
    canvas.rectangle(x - 9, top + 11, 19, 2, night);  // the gallery
    for (int column = -9; column <= 9; column += 3)
        canvas.set(x + column, top + 10, night);
    canvas.rectangle(x - 9, top + 9, 19, 1, night);
    canvas.rectangle(x - 5, top + 1, 11, 8, peach);  // the lamp
    canvas.rectangle(x - 2, top + 2, 5, 6, cream);
    for (int column : {-5, -2, 2, 5})
        canvas.rectangle(x + column, top + 1, 1, 8, night);
    for (int row = 0; row < 6; ++row)
        canvas.rectangle(x - row, top - 5 + row, 2 * row + 1, 1, red);
    canvas.line(x, top - 10, x, top - 5, night);
}

void draw_house(PixelCanvas& canvas, int tick) {
    constexpr int x = 6;
    constexpr int top = 132;
    for (int row = 0; row < 74; ++row)
        for (int column = 0; column < 66; ++column)
            canvas.dithered(x + column, top + row, plum, violet, 0.3 + 0.5 * column / 66.0);
    for (int row = 0; row < 26; ++row)  // the roof
        for (int column = -6 + row / 3; column < 72 - row; ++column)
            canvas.set(x + column, top - row,
                       (row % 4 == 0 || (column + row) % 9 == 0) ? night : red);
    canvas.rectangle(x + 12, top - 36, 9, 24, shade);
    canvas.rectangle(x + 11, top - 38, 11, 3, night);
    for (int i = 0; i < 5; ++i) {  // smoke
        const double age = std::fmod(i * 4.0 + tick * 0.5, 20.0);
        canvas.disc(x + 17 + age * 0.9 + 2.0 * std::sin(age * 0.7 + i), top - 42 - age * 1.6,
                    1.0 + age / 6.0, age < 10.0 ? stone : plum);
    }
    for (const auto& [left, up] : {std::pair{10, 14}, {40, 14}, {10, 44}}) {
        canvas.rectangle(x + left - 1, top + up - 1, 18, 18, night);
        for (int row = 0; row < 16; ++row)
            for (int column = 0; column < 16; ++column)
                canvas.dithered(x + left + column, top + up + row, cream, orange, row / 18.0);
        canvas.rectangle(x + left + 7, top + up, 2, 16, wood);
        canvas.rectangle(x + left, top + up + 7, 16, 2, wood);
        canvas.rectangle(x + left - 2, top + up + 17, 20, 2, stone);
    }
    constexpr std::array<std::string_view, 6> flowers{"..o..g..o.e.", ".ooppeppoope",
                                                      "pppopppepppp", "nnnnnnnnnnnn",
                                                      ".nnnnnnnnnn.", "..nnnnnnnn.."};
    canvas.sprite(x + 12, top + 30, flowers);
    canvas.sprite(x + 42, top + 30, flowers);
    canvas.rectangle(x + 39, top + 42, 18, 32, wood);  // the door
    canvas.rectangle(x + 41, top + 44, 14, 30, night);
    canvas.rectangle(x + 42, top + 45, 12, 29, wood);
    canvas.set(x + 51, top + 60, peach);
}

void draw_quay(PixelCanvas& canvas) {
    for (int y = quay; y < canvas.height(); ++y)
        for (int x = 0; x < canvas.width(); ++x) {
            const int row = (y - quay) / 9;
            const int along =
                x + (row % 2) * 13 + static_cast<int>(hash_of(static_cast<std::uint32_t>(row)) % 5);
            const bool is_joint = (y - quay) % 9 == 8 || along % 26 == 0;
            const auto brick = static_cast<std::uint32_t>(along / 26 * 64 + row);
            if (is_joint)
                canvas.set(x, y, night);
            else
                canvas.dithered(x, y, hash_to_unit(brick) < 0.5 ? shade : stone, shade,
                                0.35 + 0.016 * (y - quay));
        }
    canvas.rectangle(0, quay, canvas.width(), 1, rose);  // light on the edge
    for (int x = 0; x < canvas.width(); ++x)
        if (hash_to_unit(static_cast<std::uint32_t>(x), 77) < 0.3)
            canvas.set(x, quay + 1, orange);
}

void draw_lantern(PixelCanvas& canvas) {
    constexpr int x = 96;
    for (int row = -26; row <= 26; ++row)
        for (int column = -26; column <= 26; ++column) {
            const double away = std::hypot(row, column) / 26.0;
            const int px = x + column;
            const int py = 146 + row;
            if (away < 1.0)
                canvas.dithered(px, py, static_cast<Paint>(canvas.at(px, py)), orange,
                                0.55 * (1.0 - away) * (1.0 - away));
        }
    canvas.rectangle(x - 1, 152, 3, 55, night);
    canvas.rectangle(x - 3, 204, 7, 4, night);
    canvas.rectangle(x - 5, 140, 11, 12, night);
    canvas.rectangle(x - 4, 141, 9, 10, peach);
    canvas.rectangle(x - 2, 142, 5, 8, cream);
    canvas.rectangle(x - 3, 138, 7, 2, night);
    canvas.rectangle(x, 136, 1, 2, night);
}

void draw_cat(PixelCanvas& canvas, int tick) {
    constexpr std::array<std::string_view, 22> cat{
        "..aa......aa..", "..afa....afa..", "..affaaaaffa..", "..affffffffa..", "..afffnffnfa..",
        "..afffnffnfa..", "..affffffffa..", "...affffffa...", "....aaffaa....", "...afffffna...",
        "..afffffffna..", "..affnfffnna..", ".affffffffnna.", ".afnnffffnnna.", ".affffffffnna.",
        "afffnffffnnnna", "affffffffffnna", "afnnfffffffnna", "affffffffffnna", "afffffafffffna",
        "affffaaaffffna", ".aaaa...aaaaa.",
    };
    constexpr int x = 150;
    constexpr int y = quay - 18;
    // The tail hangs over the edge, and its tip sways.
    const double sway = std::sin(tick * tau / 15.0);
    for (int i = 0; i < 19; ++i) {
        const int along = x + 12 + i / 2 + static_cast<int>(std::lround(sway * i * i / 90.0));
        const int down = quay + 2 + static_cast<int>(std::lround(i - 0.028 * i * i));
        canvas.rectangle(along - 1, down - 1, 5, 3, night);
    }
    for (int i = 0; i < 19; ++i) {
        const int along = x + 12 + i / 2 + static_cast<int>(std::lround(sway * i * i / 90.0));
        const int down = quay + 2 + static_cast<int>(std::lround(i - 0.028 * i * i));
        canvas.rectangle(along, down, 3, 1, i % 6 < 2 ? wood : orange);
    }
    canvas.sprite(x, y, cat);
}

void draw_things(PixelCanvas& canvas) {
    constexpr std::array<std::string_view, 17> barrel{
        "...aaaaaaaaa...", ".aannnnnnnnnaa.", "annnnnnnnnnnnna", "aaannnnnnnnnaaa",
        "afnaaaaaaaaanna", "anfnnnannnannna", "annfnnannnannna", "alllllllllllmma",
        "ammmmmmmmmmmmma", "anfnnnannnannna", "anfnnnannnannna", "annfnnannnannna",
        "alllllllllllmma", "ammmmmmmmmmmmma", "anfnnnannnannna", ".aannnnnnnnnaa.",
        "...aaaaaaaaa...",
    };
    canvas.sprite(214, quay - 9, barrel);
    canvas.sprite(231, quay - 5, barrel);
    canvas.rectangle(252, quay - 12, 10, 16, night);  // a bollard and its rope
    canvas.rectangle(253, quay - 11, 8, 14, shade);
    canvas.rectangle(250, quay - 14, 14, 4, night);
    canvas.rectangle(251, quay - 13, 12, 2, stone);
    for (int i = 0; i < 40; ++i) {
        const int sag = static_cast<int>(std::lround(0.012 * i * (40 - i)));
        canvas.set(264 + i, quay - 6 + sag, peach);
        canvas.set(264 + i, quay - 5 + sag, wood);
    }
}

Picture drawn_harbour(Extent extent, double seconds) {
    const int tick = tick_of(seconds);
    PixelCanvas canvas(native, palette);
    draw_sky(canvas, tick);
    draw_sun(canvas);
    draw_cloud(canvas, 22, 84, 60, rose);
    draw_cloud(canvas, 138, 70, 84, plum);
    draw_cloud(canvas, 168, 96, 66, orange);
    draw_cloud(canvas, 58, 108, 46, peach);
    draw_hills(canvas);
    draw_sea(canvas, tick);
    draw_gulls(canvas, tick);
    draw_lighthouse(canvas, tick);
    draw_boat(canvas, tick);
    draw_house(canvas, tick);
    draw_quay(canvas);
    draw_lantern(canvas);
    draw_things(canvas);
    draw_cat(canvas, tick);
    return resampled(canvas.picture(), extent);
}
}  // namespace

Pattern harbour_pattern() {
    return {{"harbour", "Pixel art: harbour",
             "A harbour at dusk and its onlooker, in 320 x 240 pixels and sixteen colours.", true},
            native,
            drawn_harbour};
}
