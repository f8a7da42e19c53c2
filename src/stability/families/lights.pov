//! about: a light of 10^X on a pigment of 10^-X
//! extremity: 10^X
//! steps: 0 3 6 9 12 15 20 30 -3 -6 -9 -12 -15 -20 -30
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, rgb pow(10, X) }
background { rgb <.1, .2, .3> }
sphere { 0, 1 pigment { rgb pow(10, -X) } finish { ambient 0 diffuse 1 } }
plane { y, -1 pigment { checker rgb .2 * pow(10, -X) rgb .8 * pow(10, -X) } finish { ambient 0 diffuse 1 } }
