#ifndef CAFFEINE_AS_WRITTEN
#define CAFFEINE_AS_WRITTEN

uniform bool as_written = false;  // @label "Original article"  @group "Article"
                                  // @help "Uses the original article's method, mistakes included. The lamp counts twice. The point on the lamp and the bounce share one random number. The lens is darker at its rim."

#endif
