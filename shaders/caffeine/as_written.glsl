#ifndef CAFFEINE_AS_WRITTEN
#define CAFFEINE_AS_WRITTEN

uniform bool as_written = false;  // @label "As the article wrote it"  @group "Article"
                                  // @help "Draws by the article's method, mistakes included: the lamp counts twice, its light point and the bounce share one random number, the lens is darker at its rim."

#endif
