// Decay of the phosphor: after time t, exp(-t / decay time) of its light is still to be emitted.
#ifndef VECTOR_BEAM_DECAY
#define VECTOR_BEAM_DECAY

uniform float decay_time = 30.0;  // @range 0.02 2000  @limit 0.001 1000000  @scale log  @label "Decay time"  @unit "ms"  @group "Phosphor"  @photo decay
                                  // @help "Time after which 37 % of the phosphor's light is left. After 2.3 times as long, 10 % is left. A longer time leaves longer trails. A still picture stays as bright."

const float default_decay_time = 30.0;  // ms

float decay_seconds() {
    return 0.001 * decay_time;
}

#endif
