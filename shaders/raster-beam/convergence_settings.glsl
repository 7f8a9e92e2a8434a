// Convergence of the three guns, shared by the passes video and screen.
#ifndef RASTER_BEAM_CONVERGENCE
#define RASTER_BEAM_CONVERGENCE

uniform vec2 red_offset = vec2(0.0);   // @range -2 2  @limit -20 20  @label "Red offset"  @unit "lines of 240"  @group "Convergence"  @identity 0
                                       // @help "Where the red gun draws, to the right and up from green."
uniform vec2 blue_offset = vec2(0.0);  // @range -2 2  @limit -20 20  @label "Blue offset"  @unit "lines of 240"  @group "Convergence"  @identity 0
                                       // @help "Where the blue gun draws, to the right and up from green."
uniform float convergence_edge = 0.35; // @range 0 2  @limit -20 20  @label "Error at the edges"  @unit "lines of 240"  @group "Convergence"  @identity 0
                                       // @help "How far red and blue drift apart towards the edges. They meet in the middle, as on a well adjusted tube."

// Where red and blue are drawn at a place -1..1, to the right and up from green, in lines of 240.
vec2 drift_at(vec2 place) {
    return 0.5 * convergence_edge * place * dot(place, place);
}

vec2 red_at(vec2 place) {
    return red_offset + drift_at(place);
}

vec2 blue_at(vec2 place) {
    return blue_offset - drift_at(place);
}

#endif
