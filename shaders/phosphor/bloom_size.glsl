#ifndef PHOSPHOR_BLOOM_SIZE
#define PHOSPHOR_BLOOM_SIZE

uniform float bloom_size = 0.5;    // @range 0.25 1  @limit 0.0625 1  @label "Resolution"  @unit "× render size"  @group "Bloom"  @when bloom_intensity > 0
                                   // @help "Size of the picture that is blurred. The glow has the same width at any resolution. A lower resolution is softer and faster. 0.5 is the article's."

#endif
