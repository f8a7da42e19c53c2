//! about: glass spheres that overlap by 10^X, at last touch
//! extremity: 10^X
//! steps: -6 to -16 by -2, -400
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at 0 angle 50 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
#declare Gap = pow(10, X);
plane { y, -1 pigment { checker rgb .2 rgb .8 } finish { ambient 0 diffuse 1 } }
#declare Look = texture { pigment { rgbf .95 } finish { ambient 0 diffuse .1 reflection .1 } }
merge { sphere { -x * (1 - Gap), 1 } sphere { x * (1 - Gap), 1 } texture { Look } interior { ior 1.5 } }
