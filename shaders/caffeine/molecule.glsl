// Caffeine: 24 atoms as spheres. Positions from R. Terrell's "Caffeine path tracing demo &
// tutorial", 2018, in angstrom. Radii are covalent radii (B. Cordero et al., Dalton Trans. 2008,
// 2832).
#ifndef CAFFEINE_MOLECULE
#define CAFFEINE_MOLECULE

uniform mat4 u_view;  // rotation of the molecule by the mouse

uniform float atom_scale = 1.2;                      // @range 0.5 2.5  @limit 0.05 10  @label "Atom size"  @unit "× radius"  @group "Molecule"
                                                     // @help "Size of the spheres relative to the covalent radii of the atoms. From about 2, they merge."
uniform float carbon_radius = 0.73;    // @range 0 2  @limit 0 10  @label "Carbon radius"  @unit "Å"  @group "Molecule"
                                       // @help "Covalent radius of carbon, before Atom size. 0 removes the carbon atoms."
uniform float hydrogen_radius = 0.31;  // @range 0 2  @limit 0 10  @label "Hydrogen radius"  @unit "Å"  @group "Molecule"
                                       // @help "Covalent radius of hydrogen, before Atom size. 0 removes the hydrogen atoms."
uniform float nitrogen_radius = 0.71;  // @range 0 2  @limit 0 10  @label "Nitrogen radius"  @unit "Å"  @group "Molecule"
                                       // @help "Covalent radius of nitrogen, before Atom size. 0 removes the nitrogen atoms."
uniform float oxygen_radius = 0.66;    // @range 0 2  @limit 0 10  @label "Oxygen radius"  @unit "Å"  @group "Molecule"
                                       // @help "Covalent radius of oxygen, before Atom size. 0 removes the oxygen atoms."
uniform vec3 carbon_color = vec3(0.565, 0.565, 0.565);    // @color  @label "Carbon colour"  @group "Molecule"
                                                          // @help "Colour of the carbon atoms."
uniform vec3 hydrogen_color = vec3(1.0, 1.0, 1.0);        // @color  @label "Hydrogen colour"  @group "Molecule"
                                                          // @help "Colour of the hydrogen atoms."
uniform vec3 nitrogen_color = vec3(0.188, 0.314, 0.973);  // @color  @label "Nitrogen colour"  @group "Molecule"
                                                          // @help "Colour of the nitrogen atoms."
uniform vec3 oxygen_color = vec3(1.0, 0.051, 0.051);      // @color  @label "Oxygen colour"  @group "Molecule"
                                                          // @help "Colour of the oxygen atoms."

const int hydrogen = 0;
const int carbon = 1;
const int nitrogen = 2;
const int oxygen = 3;

struct Ray {
    vec3 origin;
    vec3 direction;  // of length 1
};

/// The nearest intersection of a ray so far.
struct Hit {
    float away;  // distance along the ray
    vec3 center;  // of the sphere; in the molecule's axes while its atoms are tested
    int what;
};

vec3 color_of_atom(int element) {
    return element == hydrogen ? hydrogen_color
         : element == carbon   ? carbon_color
         : element == nitrogen ? nitrogen_color
                               : oxygen_color;
}

// Distance at which a ray enters a sphere; below 0 if it does not. It is computed from the point of
// the ray that is nearest to the centre. This keeps precision for small, distant spheres (E. Haines
// et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019).
float sphere_entry(Ray ray, vec3 center, float radius) {
    vec3 from_center = ray.origin - center;
    float back = dot(from_center, ray.direction);
    vec3 beside = from_center - back * ray.direction;
    float inside = radius * radius - dot(beside, beside);
    return inside < 0.0 ? -1.0 : -back - sqrt(inside);
}

void meet_sphere(Ray ray, int what, float radius, vec3 center, inout Hit hit) {
    float away = sphere_entry(ray, center, radius);
    if (away > 0.0 && away < hit.away)
        hit = Hit(away, center, what);
}

// Transforms the ray into the molecule's axes, instead of each atom out of them.
void meet_molecule(Ray world, inout Hit hit) {
    mat3 turn = mat3(u_view);
    Ray ray = Ray(world.origin * turn, world.direction * turn);
    float h = hydrogen_radius * atom_scale;
    float c = carbon_radius * atom_scale;
    float n = nitrogen_radius * atom_scale;
    float o = oxygen_radius * atom_scale;
    Hit own = hit;
    meet_sphere(ray, hydrogen, h, vec3(-3.3804130, -1.1272367, 0.5733036), own);
    meet_sphere(ray, nitrogen, n, vec3(0.9668296, -1.0737425, -0.8198227), own);
    meet_sphere(ray, carbon, c, vec3(0.0567293, 0.8527195, 0.3923156), own);
    meet_sphere(ray, nitrogen, n, vec3(-1.3751742, -1.0212243, -0.0570552), own);
    meet_sphere(ray, carbon, c, vec3(-1.2615018, 0.2590713, 0.5234135), own);
    meet_sphere(ray, carbon, c, vec3(-0.3068337, -1.6836331, -0.7169344), own);
    meet_sphere(ray, carbon, c, vec3(1.1394235, 0.1874122, -0.2700900), own);
    meet_sphere(ray, nitrogen, n, vec3(0.5602627, 2.0839095, 0.8251589), own);
    meet_sphere(ray, oxygen, o, vec3(-0.4926797, -2.8180554, -1.2094732), own);
    meet_sphere(ray, carbon, c, vec3(-2.6328073, -1.7303959, -0.0060953), own);
    meet_sphere(ray, oxygen, o, vec3(-2.2301338, 0.7988624, 1.0899730), own);
    meet_sphere(ray, hydrogen, h, vec3(2.5496990, 2.9734977, 0.6229590), own);
    meet_sphere(ray, carbon, c, vec3(2.0527432, -1.7360887, -1.4931279), own);
    meet_sphere(ray, hydrogen, h, vec3(-2.4807715, -2.7269528, 0.4882631), own);
    meet_sphere(ray, hydrogen, h, vec3(-3.0089039, -1.9025254, -1.0498023), own);
    meet_sphere(ray, hydrogen, h, vec3(2.9176101, -1.8481516, -0.7857866), own);
    meet_sphere(ray, hydrogen, h, vec3(2.3787863, -1.1211917, -2.3743655), own);
    meet_sphere(ray, hydrogen, h, vec3(1.7189877, -2.7489920, -1.8439205), own);
    meet_sphere(ray, carbon, c, vec3(-0.1518450, 3.0970046, 1.5348347), own);
    meet_sphere(ray, carbon, c, vec3(1.8934096, 2.1181245, 0.4193193), own);
    meet_sphere(ray, nitrogen, n, vec3(2.2861252, 0.9968439, -0.2440298), own);
    meet_sphere(ray, hydrogen, h, vec3(-0.1687028, 4.0436553, 0.9301094), own);
    meet_sphere(ray, hydrogen, h, vec3(0.3535322, 3.2979060, 2.5177747), own);
    meet_sphere(ray, hydrogen, h, vec3(-1.2074498, 2.7537592, 1.7203047), own);
    if (own.away < hit.away)
        hit = Hit(own.away, turn * own.center, own.what);
}

#endif
