// The masks of colour tubes: transmission of red, green and blue at a point, averaged over a pixel.
// The mean of each channel over whole cells is 1, so a mask redistributes light without loss. Peaks
// are above 1. All lengths are in px of the tube, from its bottom left.
#ifndef AFTERGLOW_MASK
#define AFTERGLOW_MASK

const int mask_cells = 0;   // staggered cells of three stripes, dark towards their borders
const int mask_grille = 1;  // aperture grille: vertical stripes
const int mask_slot = 2;    // stripes cut by bridges, with every other column higher
const int mask_dots = 3;    // triads of dots in a hexagonal lattice

const float hexagon_row = 0.86602540378;  // distance of the rows of a hexagonal lattice, in pitches

struct Mask {
    int kind;
    float pitch;       // distance from one red to the next along a line
    float cell_height; // of cells and slots, in pitches
    float border;      // darkness between two stripes, 0..1; for dots, how small they are
    float stagger;     // upward offset of every other column of cells or slots, in cell heights
};

// |v|^power for an even power, from the square of v.
vec3 even_power(vec3 square, float power) {
    if (power == 2.0)
        return square;
    return power == 4.0 ? square * square : pow(square, vec3(0.5 * power));
}

// Integral from 0 to x of a row of bumps 1 wide, one per `period`. A bump is 1 - border |v|^power
// over its width, v = -1..1, scaled to the integral 1.
vec3 bumps_up_to(vec3 x, float period, float border, float power) {
    vec3 whole = floor(x / period);
    vec3 along = clamp(x - whole * period, 0.0, 1.0);
    vec3 v = 2.0 * along - 1.0;
    float ends = power + 1.0;
    vec3 part = along - 0.5 * border / ends * (v * even_power(v * v, power) + 1.0);
    return whole + part / (1.0 - border / ends);
}

// The mean of these bumps over `width` around x. The integral is exact, so no width causes moire.
vec3 bumps_over(vec3 x, float width, float period, float border, float power) {
    vec3 near = x - floor(x / period) * period;  // small numbers keep their precision
    vec3 low = bumps_up_to(near - 0.5 * width, period, border, power);
    return (bumps_up_to(near + 0.5 * width, period, border, power) - low) / width;
}

// Stripes of the three channels side by side. y is divided into cells. Every other column of cells
// is `stagger` of a cell higher. `across` is the horizontal position of each channel, `up` the
// vertical one of all.
vec3 striped_mask(Mask mask, vec3 across, float up, float pixel, vec2 power, float stagger) {
    const vec3 channel = vec3(0.0, 1.0, 2.0);
    vec3 x = 3.0 * across / mask.pitch;
    float width = 3.0 * pixel / mask.pitch;
    if (power.y == 0.0)  // all columns are alike
        return 3.0 * bumps_over(x - channel, width, 3.0, mask.border, power.x);
    vec3 even = bumps_over(x - channel, width, 6.0, mask.border, power.x);
    vec3 odd = bumps_over(x - channel - 3.0, width, 6.0, mask.border, power.x);
    float height = mask.pitch * mask.cell_height;
    vec3 rows = bumps_over(vec3(up / height, up / height + stagger, 0.0), pixel / height, 1.0,
                           mask.border, power.y);
    return 3.0 * (even * rows.x + odd * rows.y);
}

// As bumps_up_to, for bumps (1 - v^2)^2 with their middles at 0, period, ...
vec3 dots_up_to(vec3 x, float period, float diameter) {
    vec3 whole = floor(x / period + 0.5);
    vec3 v = clamp(2.0 * (x - whole * period) / diameter, -1.0, 1.0);
    vec3 square = v * v;
    return whole + 0.5 + 0.9375 * v * (1.0 - square * (2.0 / 3.0 - 0.2 * square));
}

vec3 dots_over(vec3 x, float width, float period, float diameter) {
    vec3 near = x - floor(x / period) * period;
    return (dots_up_to(near + 0.5 * width, period, diameter) -
            dots_up_to(near - 0.5 * width, period, diameter)) / width;
}

float dot_diameter(Mask mask) {
    return mix(1.0, 0.6, mask.border);  // pitches
}

// Round dots in a hexagonal lattice. A dot is the product of a horizontal and a vertical profile,
// so that its mean over a pixel is exact.
vec3 dotted_mask(Mask mask, vec3 across_px, float up_px, float pixel) {
    float width = pixel / mask.pitch;
    vec3 across = across_px / mask.pitch - vec3(0.0, 0.5, 0.0);
    vec3 up = up_px / mask.pitch - hexagon_row * vec3(0.0, 1.0, 2.0) / 3.0;
    float diameter = dot_diameter(mask);
    float rows = 2.0 * hexagon_row;
    vec3 even = dots_over(across, width, 1.0, diameter) * dots_over(up, width, rows, diameter);
    vec3 odd = dots_over(across - 0.5, width, 1.0, diameter) *
               dots_over(up - hexagon_row, width, rows, diameter);
    return hexagon_row * (even + odd);
}

// A pitch below 2 px cannot be shown. The mask fades to a uniform grey from 3 px down to 2 px.
float mask_visibility(float pitch, float pixel) {
    return clamp(pitch / pixel - 2.0, 0.0, 1.0);
}

// Transmission where each channel has its own horizontal position. `pixel` is the width of the
// picture's pixel there.
vec3 mask_light_across(Mask mask, vec3 across, float up, float pixel) {
    vec3 light;
    if (mask.kind == mask_cells)
        light = striped_mask(mask, across, up, pixel, vec2(2.0), mask.stagger);
    else if (mask.kind == mask_grille)
        light = striped_mask(mask, across, up, pixel, vec2(4.0, 0.0), 0.0);
    else if (mask.kind == mask_slot)
        light = striped_mask(mask, across, up, pixel, vec2(4.0, 12.0), mask.stagger);
    else
        light = dotted_mask(mask, across, up, pixel);
    return mix(vec3(1.0), light, mask_visibility(mask.pitch, pixel));
}

// Transmission at `at`.
vec3 mask_light(Mask mask, vec2 at, float pixel) {
    return mask_light_across(mask, vec3(at.x), at.y, pixel);
}

const int panel_pixels = 0;  // whole pixels
const int panel_rgb = 1;     // three subpixels from left to right
const int panel_bgr = 2;
const int panel_woled = 3;   // four: red, white, blue, green

// Transmission for a display with subpixels side by side: each channel is taken at the place where
// the display emits it. Its mean is still over a whole pixel, the distance of its subpixels.
vec3 mask_light_on_panel(Mask mask, vec2 at, float pixel, int panel) {
    vec3 shift = vec3(0.0);
    if (panel == panel_rgb)
        shift = vec3(-1.0, 0.0, 1.0) / 3.0;
    else if (panel == panel_bgr)
        shift = vec3(1.0, 0.0, -1.0) / 3.0;
    else if (panel == panel_woled)
        shift = vec3(-3.0, 3.0, 1.0) / 8.0;
    return mask_light_across(mask, at.x + pixel * shift, at.y, pixel);
}

// The largest transmission of any channel for small pixels. 1 over it is the mean of the bare mask.
float mask_peak(Mask mask) {
    float across = 3.0 / (1.0 - mask.border / (mask.kind == mask_cells ? 3.0 : 5.0));
    if (mask.kind == mask_cells)
        return across / (1.0 - mask.border / 3.0);
    if (mask.kind == mask_slot)
        return across / (1.0 - mask.border / 13.0);
    if (mask.kind == mask_grille)
        return across;
    float side = dot_diameter(mask) * 8.0 / 15.0;
    return hexagon_row / (side * side);
}

// The centre of the cell that contains `at`. Stripes without cells have only a horizontal centre.
vec2 mask_cell_centre(Mask mask, vec2 at) {
    vec2 cell = vec2(mask.pitch, mask.pitch * mask.cell_height);
    float column = floor(at.x / mask.pitch);
    float middle = (column + 0.5) * mask.pitch;
    if (mask.kind == mask_grille)
        return vec2(middle, at.y);
    if (mask.kind == mask_dots) {
        float row = floor(at.y / (hexagon_row * mask.pitch));
        float shift = 0.5 * mod(row, 2.0);
        return vec2(floor(at.x / mask.pitch - shift) + shift + 0.5, (row + 0.5) * hexagon_row) *
               mask.pitch;
    }
    float lifted = mask.stagger * mod(column, 2.0);  // as in striped_mask
    return vec2(middle, (floor(at.y / cell.y + lifted) + 0.5 - lifted) * cell.y);
}

#endif
