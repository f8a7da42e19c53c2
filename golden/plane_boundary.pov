// What lies within 1e-10 of a plane is inside of it: a lid in the plane that clips it, a plane cut by its own copy and by
// its own inverse, a turned slab whose faces stand twice. Seen from far away, so that points are not exact.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location 100 * <30, 40, -50> look_at 0 right 80 * x up 60 * y }
light_source { <3000, 9000, -8000>, 1 parallel point_at 0 }
background { rgb <0, 0, 1> }
#default { finish { ambient .2 diffuse .8 } }
box { <-12, -16, -12>, <12, 0, 12> clipped_by { plane { -y, 0 } } pigment { rgb 1 } translate -22 * x }
#declare Slope = plane { y, 0 rotate -75 * x translate -4 * z };
#declare Window = box { <-10, -10, -50>, <10, 40, 50> };
intersection { object { Slope } object { Slope } bounded_by { Window } clipped_by { Window } pigment { rgb x } }
intersection { object { Slope } object { Slope inverse } clipped_by { Window } pigment { rgb y } translate 22 * x }
#declare Slab = intersection { plane { x, 6 } plane { -x, 6 } plane { y, 2 } plane { -y, 2 } plane { z, 9 } plane { -z, 9 } rotate <20, 50, 10> };
intersection { object { Slab } object { Slab } pigment { rgb <1, 1, 0> } translate <4, -16, -14> }
