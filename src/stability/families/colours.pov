//! about: a pigment of 10^X under two lights of which one takes away what the other gives too much
//! extremity: 10^X
//! steps: 0 3 6 10 20 37 38 39 100 200 300 308
//! truth: the picture with Right declared
#version 3.7;
global_settings { assumed_gamma 1 }
// Whatever is too much for a picture is as bright as it can be, and never no number.
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
sphere { <0, .2, 0>, 1 pigment { #ifdef (Right) rgb 1 #else rgbf <1, 1, 1, 0> #end } finish { ambient 0 diffuse 1 } }
sphere { <-9, 9, 90>, 1 pigment { rgbf <pow(10, X), 1, 1, pow(10, X)> } finish { ambient 1 phong 1 phong_size pow(10, X) specular 1 roughness pow(10, -X) brilliance pow(10, X) } }
plane { y, -1 pigment { checker rgb .2 rgb .8 } finish { ambient 0 diffuse 1 } }
