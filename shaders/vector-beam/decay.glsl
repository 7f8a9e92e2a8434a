// How the phosphor fades: the share exp(-t / decay time) of its light is still to come after t.
#ifndef VECTOR_BEAM_DECAY
#define VECTOR_BEAM_DECAY

uniform float decay_time = 30.0;  // @range 0.02 2000  @limit 0.001 1000000  @scale log  @label "Decay time"  @unit "ms"  @group "Phosphor"
                                  // @help "How long the phosphor glows: after this time 37 % of its light is still to come, after 2.3 times as long 10 %. A longer time leaves longer trails; a still picture stays as bright."

const float default_decay_time = 30.0;  // ms

float decay_seconds() {
    return 0.001 * decay_time;
}

#endif
