//! about: a sphere of radius 10^X with a small one on it, seen from beside
//! extremity: 10^X
//! steps: 7 to 12 by 1
//! truth: the first step
//! note: 10^12 is the end: a distance of 10^13 is held to 0.002 at best, as much as a pixel is wide here.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at <0, .6, 0> angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
#declare R = pow(10, X);
sphere { <0, -R, 0>, R pigment { rgb .8 } finish { ambient 0 diffuse 1 } }
sphere { <0, .5, 0>, .5 pigment { rgb 1 } finish { ambient 0 diffuse 1 reflection .3 } }
