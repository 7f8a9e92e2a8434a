#ifndef PHOSPHOR_BLOOM_SIZE
#define PHOSPHOR_BLOOM_SIZE

uniform float bloom_size = 0.5;    // @range 0.25 1  @limit 0.0625 1  @label "Resolution"  @unit "of the picture"  @group "Bloom"
                                   // @help "Size of the picture that is blurred. The glow is as wide at any size; a smaller one is softer and faster. 0.5 is the article's."

#endif
