#ifndef PHOSPHOR_TONE_MAP_EVERY_FRAME
#define PHOSPHOR_TONE_MAP_EVERY_FRAME

uniform bool tone_map_every_frame = false;  // @label "Tone map every frame"  @group "Article"
                                            // @help "The article's example of what not to do. Light is compressed to 0 to 1 in each frame before it is stored, instead of once at the end, so traces turn flat."

#endif
