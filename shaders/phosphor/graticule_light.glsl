// The graticule's lines on this look's screen. Linear light.
#include "fit.glsl"
#include "graticule.glsl"
#include "reference_height.glsl"

#ifdef DRIVEN_BY_PICTURE
const float graticule = 0.0;  // only an oscilloscope has one
const ivec2 graticule_divisions = ivec2(1);

vec3 with_graticule(vec3 light, vec2 place, vec2 resolution) {
    return light;
}
#else
uniform float graticule = 0.15;  // @range 0 1  @limit 0 1  @label "Strength"  @group "Graticule"  @identity 0  @photo off
                                 // @help "How strongly the graticule lines show. 0 hides them."
uniform ivec2 graticule_divisions = ivec2(10, 10);  // @range 1 20 1  @limit 1 100  @label "Divisions"  @parts "Horizontal" "Vertical"  @group "Graticule"  @when graticule > 0
                                                    // @help "Number of divisions across and up. Most scopes have 10 by 8."
uniform int graticule_lines = 0;  // @items "Lit" "Dark"  @label "Line type"  @group "Graticule"  @when !as_written && graticule > 0
                                  // @help "Lit lines are engraved in the glass and glow in the light of lamps at its edge. Dark lines are printed inside the tube and hide the trace."
uniform vec3 graticule_color = vec3(0.45, 0.8, 0.55);  // @color  @label "Line colour"  @group "Graticule"  @when !as_written && graticule > 0 && graticule_lines == "Lit"
                                                       // @help "Colour of the lamps that light the graticule. Only used for lit lines."

// 1 on a line, 0 between lines. `place` is -1..1 on the glass.
float graticule_at(vec2 place, vec2 resolution) {
    vec2 divisions = vec2(graticule_divisions);
    vec2 signal_px = signal_size(resolution) * resolution;
    vec2 division_px = signal_px / (fit == 0 ? divisions : divisions.yy);
    vec2 in_divisions = 0.5 * place * resolution / division_px;
    float width = max(1.0, resolution.y / reference_height);
    return graticule_coverage(in_divisions, divisions, division_px, width);
}

vec3 with_graticule(vec3 light, vec2 place, vec2 resolution) {
    float line = graticule * graticule_at(place, resolution);
    if (graticule_lines == 1)
        return light * (1.0 - line);
    vec3 lamp = line * graticule_color;
    return light + lamp * (1.0 - min(light, 1.0));
}
#endif
