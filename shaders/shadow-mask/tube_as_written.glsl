// The article's mask. A cell is read at its left edge, even columns at their lower edge. Stripes
// are three times as bright, which does not compensate for their borders.
struct CellsAsWritten {
    vec2 corner;  // px where the picture is read
    vec3 mask;
};

CellsAsWritten cells_as_written(vec2 px, float size, float border, float stagger_height) {
    vec2 cell = px / size;
    vec2 stripe = cell * vec2(3.0, 1.0);
    vec2 stagger = vec2(0.0, stagger_height * mod(floor(cell.x), 2.0));
    float index = mod(floor(stripe.x), 3.0);
    vec3 mask = vec3(index == 0.0, index == 1.0, index == 2.0) * 3.0;
    vec2 inside = fract(stripe + stagger) * 2.0 - 1.0;
    vec2 bright = 1.0 - inside * inside * border;
    return CellsAsWritten(floor(cell + stagger) * size, mask * bright.x * bright.y);
}
