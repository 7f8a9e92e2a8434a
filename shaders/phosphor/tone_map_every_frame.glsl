#ifndef PHOSPHOR_TONE_MAP_EVERY_FRAME
#define PHOSPHOR_TONE_MAP_EVERY_FRAME

uniform bool tone_map_every_frame = false;  // @label "Tone map every frame"  @group "Article"
                                            // @help "The article's example of what not to do: light is squeezed into 0 to 1 in each frame before it is kept, and not once at the end, so that traces turn flat."

#endif
