//! about: a camera 10^X above a sphere and 10^X below a shell, at last upon both
//! extremity: 10^X
//! steps: -8 to -16 by -1, -400
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
#declare H = pow(10, X);
camera { location <0, 1, 0> look_at <5, 0, 8> angle 70 }
light_source { <0, 6, 0>, 1 }
background { rgb <.1, .2, .3> }
sphere { 0, 1 - H pigment { rgb <1, .5, .2> } finish { ambient 0 diffuse 1 } }
plane { y, -2 pigment { checker rgb .2 rgb .8 } finish { ambient 0 diffuse 1 } }
sphere { <5, 0, 8>, 2 pigment { rgb <.2, .5, 1> } finish { ambient 0 diffuse 1 } }
