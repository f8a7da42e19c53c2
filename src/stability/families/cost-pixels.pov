//! about: a picture of 10^X pixels
//! extremity: 10^X
//! steps: 4 5 6 7
//! picture: of so many pixels
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
sphere { 0, 3 pigment { rgb 1 } finish { specular .5 } }
plane { y, -3 pigment { checker rgb 1 rgb 0 } finish { reflection .2 } }
